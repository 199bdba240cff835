// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file CoincidentVertices.h
 * @brief Finds seams: vertices that were stored more than once.
 */

#ifndef SurfaceDenoising_CoincidentVertices_h
#define SurfaceDenoising_CoincidentVertices_h

#include "TriangleMesh.h"

namespace SurfaceDenoising
{

struct CoincidentVertex
{
  Index Vertex;
  Index Original; ///< the vertex with the lowest number at exactly the same place
};

/**
 * Vertices on the boundary that have the same coordinates as another one there. Files with a
 * texture or with sharp normals store a vertex once per chart, STL files once per face: the surface
 * looks closed but its faces do not know one another. Only the boundary is searched, because inside
 * a surface there are no seams.
 */
std::vector<CoincidentVertex> FindCoincidentVertices(const TriangleMesh& mesh,
  const Buffer<unsigned char>& boundary);

}

#endif
