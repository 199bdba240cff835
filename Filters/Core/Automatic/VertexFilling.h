// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file VertexFilling.h
 * @brief Positions for vertices whose own are of no use.
 */

#ifndef SurfaceDenoising_VertexFilling_h
#define SurfaceDenoising_VertexFilling_h

#include "../TriangleMesh.h"

namespace SurfaceDenoising
{

/**
 * The vertices that are not marked as fixed go to the middle of their neighbours, in small steps,
 * and from there to where they fit the robustly filtered normals of the faces around them. Fixed
 * ones keep their positions to the bit. rings are those of VertexRings. Returns false if the
 * execution asked to stop.
 */
bool FillVertices(TriangleMesh& mesh, const CompressedRows& stars, const CompressedRows& rings,
  const EdgeCensus& edges, const Buffer<unsigned char>& fixed, Execution& execution);

}

#endif
