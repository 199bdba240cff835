// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file LikelihoodPoints.h
 * @brief Feature-aware filtering with the likelihood of points and the intensity of features.
 *
 * With the spatial weights f_ij = exp(-4 d_ij^2 / r_i^2), d_ij = |p_j - p_i|, where r_i is the
 * distance of the last neighbour, an outer iteration is
 *
 *   1. o_i is the height of i over the plane that fits it and its neighbours best with f_ij; the
 *      likelihood of i is l_i = exp(-o_i^2 / s^2), s^2 = 2 mean o_i^2 over all points. (It is 1 if
 *      s is zero. Points without a plane count as o_i = 0.)
 *   2. F_i = 1.5 (l2 + l3), the intensity of the feature, from the tensor of the normals with f_ij
 *      (NormalTensor.h).
 *   3. n_i' = normalise( sum_j f_ij exp(-(theta_ij / sigma_i)^2) n_j ) over i and its neighbours,
 *      with the angle theta_ij between the normals, whatever their signs, and sigma_i the standard
 *      deviation of the angles at i about their mean, at least two degrees.
 *   4. With heights h_ij = n_i' . (p_j - p_i) and sigma_i' = (1 - beta F_i) sqrt(mean_j h_ij^2),
 *      i moves by its balanced height (PointUpdate.h) with the weights
 *      l_j f_ij exp(-(h_ij / sigma_i')^2), its own l_i among them: unlikely points do not attract
 *      others, and at features heights matter more.
 *
 * Method (c) of the survey: Li et al. 2009, "Feature-preserving denoising of point-sampled
 * surfaces". The weights of 3. and the parts (likelihood from moving least squares, feature
 * intensity, filtered normals, one filter that combines them) are what the survey tells; the
 * formulas of 1., 2. and 4. are reconstructed.
 */

#ifndef SurfaceDenoising_LikelihoodPoints_h
#define SurfaceDenoising_LikelihoodPoints_h

#include "PointOperator.h"
#include "PointUpdate.h"

namespace SurfaceDenoising
{

struct LikelihoodPointsSettings
{
  double FeatureSharpening = 0.5;                   ///< beta, in [0, 1]
  double LeastAngle = 0.03490658503988659;          ///< floor of sigma_i, radians
  bool LikelihoodInNormals = false;                 ///< step 3 with a factor l_j
  PointScheme Scheme = PointScheme::BalancedHeight; ///< OwnHeight, NeighborHeight or BalancedHeight
  /// r_i for all points, in spacings, for neighbours in a ball of that radius; 0: as above.
  double Radius = 0.0;
};

std::unique_ptr<PointOperator> MakeLikelihoodPoints(const LikelihoodPointsSettings& settings);

}

#endif
