// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file SurfaceNoise.h
 * @brief How noisy a surface is, from the surface alone.
 *
 * A polynomial is fitted to the heights of the vertices around each vertex, in a frame of the
 * smoothed normals, and predicts the height of the vertex itself. White noise of deviation sigma
 * leaves a residual r of variance sigma^2 (1 + g), g the variance of the prediction for sigma = 1:
 * r / sqrt(1 + g) has the deviation sigma whatever the polynomial and the neighbourhood. The shape
 * of the surface does not: it is missed less by a cubic on two rings (s) than by a quadric on three
 * (t). So the difference tells shape from noise,
 *
 *   sigma^2 = max(0, s^2 - (t^2 - s^2) / 4).
 *
 * s and t are the lower quartiles of |r| / sqrt(1 + g) over those of a normal distribution.
 * Features are on the upper side and do not count as long as most of the surface has none.
 *
 * Measured, estimated over true deviation for Gaussian noise along the normals of 0.05, 0.1, 0.3,
 * 0.5 and 1 mean edge lengths (Noise.h, one seed each):
 *
 *   sphere, 1,620 faces    1.03  1.02  1.04  1.04  1.01
 *   another sphere         1.18  1.14  1.17  1.13  1.03
 *   Fandisk                1.41  1.22  1.04  1.05  1.03
 *   Anchor, 7,600 faces    1.40  1.21  0.99  1.00  0.97
 *   bunny                  0.99  1.01  1.01  1.00  0.92
 *   armadillo              0.99  1.02  1.03  1.02  0.97
 *
 * Weak noise between many features is found too strong. Of noise in all directions, the part along
 * the normals is found about 15% too weak where it folds the surface. Most of 25 clean models of
 * both kinds give 0, the others up to 0.034 mean edge lengths, but a femur with the steps of its
 * scan 0.07 and a coarse knot 0.06. The tests of SurfaceNoise repeat it on generated shapes.
 */

#ifndef SurfaceDenoising_SurfaceNoise_h
#define SurfaceDenoising_SurfaceNoise_h

#include "../TriangleMesh.h"

namespace SurfaceDenoising
{

struct SurfaceNoise
{
  double Deviation = 0.0; ///< sigma of the displacements along the normals, a length
  /// The same in mean edge lengths of the surface without the noise, l0^2 = l^2 - 1.56 sigma^2:
  /// noise makes edges longer. At most 2.
  double Level = 0.0;
  /// Median over the faces of the root mean square angle by which that noise turns them, atan(sigma
  /// sqrt(sum 1 / h_i^2)) with the heights h_i of the triangle; degrees, in [0, 90).
  double NormalAngle = 0.0;
  double SpikeShare = 0.0; ///< of the vertices that have faces: marked by FindSpikes
  std::size_t Samples = 0; ///< vertices with a fit; without any, all of the above but spikes is 0
};

/**
 * Estimates the noise of a mesh without seams (see PreparedMesh). Vertices on boundaries and those
 * with fewer than 12 others within two rings have no fit. Turned, moved, scaled and renumbered
 * meshes have the same noise, to rounding.
 */
SurfaceNoise EstimateNoise(const TriangleMesh& mesh, const CompressedRows& stars,
  Execution& execution);

}

#endif
