// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file MovingLeastSquares.h
 * @brief Projects points onto a smooth surface fitted to their neighbours: the baseline.
 *
 * M. Alexa, J. Behr, D. Cohen-Or, S. Fleishman, D. Levin, C. Silva, "Computing and Rendering Point
 * Set Surfaces", IEEE TVCG 9(1), 2003.
 *
 * For a point x, its neighbours p_j and x itself, with the foot q = x to start with:
 *
 *   plane       w_j = exp(-|p_j - q|^2 / h^2),  c and n of the weighted plane fit (PlaneFit.h),
 *               q = x - (n . (x - c)) n, again until q stays within 1e-6 h
 *   polynomial  with orthonormal u, v, n and a_j = u . (p_j - q), b_j = v . (p_j - q):
 *               min sum w_j (g(a_j, b_j) - n . (p_j - q))^2,  w_j for the last q
 *   result      x' = q + g(0, 0) n,  n' = normalise(n - g_a(0, 0) u - g_b(0, 0) v)
 *
 * The paper minimises over plane and foot together; repeated plane fits are the usual substitute.
 * No normals are needed; a normal that is there tells the side of the result.
 *
 * A polynomial of full degree needs more points than coefficients, or it smooths nothing, and they
 * must not lie on a conic section: the degree falls until the points determine the polynomial.
 */

#ifndef SurfaceDenoising_MovingLeastSquares_h
#define SurfaceDenoising_MovingLeastSquares_h

#include "PlaneFit.h"
#include "PointOperator.h"

namespace SurfaceDenoising
{

struct MovingLeastSquaresSettings
{
  int Degree =
    2; ///< of the polynomial: 0 (the plane alone), 1 or 2; lower if there are too few points
  double Bandwidth =
    0.0; ///< h of exp(-d^2 / h^2) in spacings; 0: half the distance of the last neighbour
  int PlaneRounds = 5; ///< at most, of the reference plane
};

/// A surface fitted around a place, relative to that place. Lengths are absolute.
struct MovingFit
{
  Plane Reference;                   ///< the zero normal if the points define no plane
  Vec3 Foot = Vec3(0.0, 0.0, 0.0);   ///< q
  int Degree = 0;                    ///< of the polynomial that was fitted
  Vec3 Place = Vec3(0.0, 0.0, 0.0);  ///< x'
  Vec3 Normal = Vec3(0.0, 0.0, 0.0); ///< n', on either side
};

/// Fits to points relative to the place that is projected, with h as a length.
MovingFit FitMovingSurface(const std::vector<Vec3>& around, double h, int degree, int planeRounds);

std::unique_ptr<PointOperator> MakeMovingLeastSquares(const MovingLeastSquaresSettings& settings);

}

#endif
