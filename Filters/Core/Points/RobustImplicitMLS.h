// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file RobustImplicitMLS.h
 * @brief Projects points onto the zero set of a robust implicit function.
 *
 * A. C. Oztireli, G. Guennebaud, M. Gross, "Feature Preserving Point Set Surfaces based on
 * Non-Linear Kernel Regression", Computer Graphics Forum 28(2), 2009.
 */

#ifndef SurfaceDenoising_RobustImplicitMLS_h
#define SurfaceDenoising_RobustImplicitMLS_h

#include "PointOperator.h"

namespace SurfaceDenoising
{

struct RobustImplicitMLSSettings
{
  double FilterScale =
    3.0; ///< h_j over rho_j = 2 r_k(j) / sqrt(k), k = 16, that is 2 / sqrt(pi) s_j
  double NormalScale = 0.75;   ///< sigma_n of exp(-(|n_j - g| / sigma_n)^2); useful are 0.5 to 1.5
  double ResidualScale = 0.5;  ///< sigma_r over h_j; 0: residuals do not count
  int MaximumFits = 3;         ///< per evaluation
  int MaximumProjections = 15; ///< per point
  bool Unoriented = false;     ///< normals are turned to the side of that of the projected point
};

std::unique_ptr<PointOperator> MakeRobustImplicitMLS(const RobustImplicitMLSSettings& settings);

}

#endif
