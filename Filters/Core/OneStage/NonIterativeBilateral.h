// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file NonIterativeBilateral.h
 * @brief Vertices become robust means of what the faces around them predict, once.
 *
 * T. R. Jones, F. Durand, M. Desbrun, "Non-iterative, feature-preserving mesh smoothing", ACM TOG
 * 22(3), 2003. Face f with centroid c_f, area A_f and smoothed normal m_f predicts for a vertex at
 * p the position P_f(p) = p - m_f (m_f . (p - c_f)) on its plane. The vertex becomes
 *
 *   p' = sum_f A_f K(|c_f - p|, s_f) K(|P_f(p) - p|, s_g) P_f(p) / sum_f A_f K K
 *
 * with Gaussians K(x, s) = exp(-x^2 / (2 s^2)), over the faces within 2 s_f. The normals m_f are
 * those of a mollified surface, whose vertices are means of the same centroids with the weights
 * A_f K(|c_f - p|, s_f / 2).
 */

#ifndef SurfaceDenoising_NonIterativeBilateral_h
#define SurfaceDenoising_NonIterativeBilateral_h

#include "../PreparedMesh.h"

namespace SurfaceDenoising
{

struct NonIterativeBilateralSettings
{
  double SpatialScale = 1.0; ///< s_f in mean edge lengths
  double RangeScale = 1.0;   ///< s_g in mean edge lengths
  bool FixBoundary = true;
};

/// The unit normals of the mollified surface, zero where a face has no area. scale is the mean edge
/// length, spatialScale s_f as a length.
void MollifyNormals(const TriangleMesh& mesh, const CompressedRows& stars, double scale,
  double spatialScale, const FaceGeometry& faces, Buffer<Vec3>& normals, Execution& execution);

/// The predicted position of vertices; faces has the smoothed normals. Scales are lengths. fixed,
/// if not empty, has 1 for vertices that stay.
void PredictVertices(const TriangleMesh& mesh, const CompressedRows& stars,
  const FaceGeometry& faces, double spatialScale, double rangeScale,
  const Buffer<unsigned char>& fixed, Buffer<Vec3>& predicted, Execution& execution);

/// Moves the vertices of a mesh that has been prepared. Returns false if the execution stops.
bool FilterVerticesByPrediction(PreparedMesh& prepared,
  const NonIterativeBilateralSettings& settings, Execution& execution);

}

#endif
