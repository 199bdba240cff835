// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file BilateralVertices.h
 * @brief Bilateral filtering of vertex positions along their normals.
 *
 * S. Fleishman, I. Drori, D. Cohen-Or, "Bilateral mesh denoising", ACM TOG 22(3), 2003. With the
 * heights h_q = n_v . (q - p_v) of the vertices q around v over its tangent plane,
 *
 *   p_v += n_v sum_q K(|q - p_v|, s_c) K(h_q, s_s) h_q / sum_q K(|q - p_v|, s_c) K(h_q, s_s)
 *
 * with Gaussians K(x, s) = exp(-x^2 / (2 s^2)), over the vertices within 2 s_c that are reached
 * along edges, p_v among them. Both scales are taken from the surface around each vertex.
 */

#ifndef SurfaceDenoising_BilateralVertices_h
#define SurfaceDenoising_BilateralVertices_h

#include "../PreparedMesh.h"

namespace SurfaceDenoising
{

struct BilateralVerticesSettings
{
  int Iterations = 5;
  double SpatialScale = 1.0; ///< s_c in lengths of the shortest edge at the vertex
  double RangeScale = 1.0;   ///< s_s in standard deviations of |h| around the vertex
  bool FixBoundary = true;
};

/// Moves the vertices of a mesh that has been prepared. Returns false if the execution stops.
bool FilterVerticesBilaterally(PreparedMesh& prepared, const BilateralVerticesSettings& settings,
  Execution& execution);

}

#endif
