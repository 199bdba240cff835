// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file MovingRobustPCA.h
 * @brief Robust planes through overlapping neighbourhoods; points go where the planes agree.
 *
 * E. Mattei, A. Castrodad, "Point Cloud Denoising via Moving RPCA", Computer Graphics Forum 36(8),
 * 2017. Reconstructed from what the abstract and the survey say.
 */

#ifndef SurfaceDenoising_MovingRobustPCA_h
#define SurfaceDenoising_MovingRobustPCA_h

#include "PointOperator.h"

namespace SurfaceDenoising
{

struct MovingRobustPCASettings
{
  double NormalAngle = 0.39269908169872414; ///< sigma of exp(-(theta / sigma)^2), radians
  int Rounds = 10;                          ///< of the robust fit, at most
  double Regularization = 0.01; ///< residuals of the fit count as at least this, in spacings
  double Fidelity = 0.0;        ///< lambda, the weight of the point's own position
};

std::unique_ptr<PointOperator> MakeMovingRobustPCA(const MovingRobustPCASettings& settings);

}

#endif
