// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file VertexRings.h
 * @brief Which vertices are joined by an edge.
 */

#ifndef SurfaceDenoising_VertexRings_h
#define SurfaceDenoising_VertexRings_h

#include "../TriangleMesh.h"

namespace SurfaceDenoising
{

/// The vertices at the other ends of the edges of every vertex, each once.
CompressedRows VertexRings(const TriangleMesh& mesh, const CompressedRows& stars,
  Execution& execution);

/// Sums of the area vectors of the faces around every vertex, to which those of the ring are added
/// so many times: the normals of noisy stars tilt.
Buffer<Vec3> SmoothNormals(const TriangleMesh& mesh, const CompressedRows& stars,
  const CompressedRows& rings, int rounds, Execution& execution);

}

#endif
