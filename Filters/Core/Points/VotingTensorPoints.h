// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file VotingTensorPoints.h
 * @brief Normal voting tensors with binary eigenvalues, feature classes, restricted quadric update.
 *
 * S. K. Yadav, U. Reitebuch, M. Skrodzki, E. Zimmermann, K. Polthier, "Constraint-based point set
 * denoising using normal voting tensor and restricted quadratic error metrics", Computers and
 * Graphics 74, 2018.
 */

#ifndef SurfaceDenoising_VotingTensorPoints_h
#define SurfaceDenoising_VotingTensorPoints_h

#include "PointOperator.h"
#include "PointUpdate.h"

namespace SurfaceDenoising
{

struct VotingTensorPointsSettings
{
  double AngleThreshold = 0.45102681179626236; ///< radians: who votes; acos(0.9)
  double EigenvalueThreshold = 0.25;           ///< tau
  double Damping = 3.0;                        ///< d
  double Step = 0.1;                           ///< alpha of flat points
  double FlatNormalScale =
    0.35; ///< of exp(-(|n_i - n_j| / sigma)^2) in the update of flat points, a chord
  double FlatSpatialScale = 1.5;                   ///< of exp(-(d / sigma)^2), in spacings
  PointScheme FlatScheme = PointScheme::OwnHeight; ///< of flat points: own or balanced heights
  double EigenvalueCut = 0.05;                     ///< of the quadric fits
  bool Unoriented = false;
};

std::unique_ptr<PointOperator> MakeVotingTensorPoints(const VotingTensorPointsSettings& settings);

}

#endif
