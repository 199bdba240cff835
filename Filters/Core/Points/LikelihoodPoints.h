// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file LikelihoodPoints.h
 * @brief Feature-aware filtering with the likelihood of points and the intensity of features.
 *
 * Method (c) of the survey, Li et al. 2009, reconstructed.
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
  bool LikelihoodInNormals = false;                 ///< normals of unlikely points count less
  PointScheme Scheme = PointScheme::BalancedHeight; ///< OwnHeight, NeighborHeight or BalancedHeight
};

std::unique_ptr<PointOperator> MakeLikelihoodPoints(const LikelihoodPointsSettings& settings);

}

#endif
