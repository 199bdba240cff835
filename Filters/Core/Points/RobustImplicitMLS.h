// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file RobustImplicitMLS.h
 * @brief Projects points onto the zero set of a robust implicit function.
 *
 * A. C. Oztireli, G. Guennebaud, M. Gross, "Feature Preserving Point Set Surfaces based on
 * Non-Linear Kernel Regression", Computer Graphics Forum 28(2), 2009.
 *
 * Every point j is a sample with a ball of radius h_j around it, FilterScale * 2 / sqrt(pi) * s_j
 * with its own spacing s_j whatever the scale of other lengths. At a place x, over the samples
 * whose balls contain it,
 *
 *   phi_j   = (1 - |x - p_j|^2 / h_j^2)^4,    f_j = n_j . (x - p_j)
 *   alpha_j = exp(-((f_j - f) / (sigma_r h_j))^2) exp(-(|n_j - g| / sigma_n)^2),  at first 1
 *   f = sum alpha_j phi_j f_j / W,   W = sum alpha_j phi_j
 *   g = (sum alpha_j grad phi_j (f_j - f) + sum alpha_j phi_j n_j) / W
 *
 * with f and g of the fit before in alpha, until g changes by less than sqrt(0.001). The first fit
 * is plain implicit moving least squares, and g its gradient; later ones hold alpha constant. Then
 * x becomes x - f g / |g| until |f| is below 1e-4 of rho_i = 2 / sqrt(pi) s_i (the local one, so
 * that dense parts are as exact as others), and the normal is g / |g|.
 *
 * The samples are the points as they are when an outer iteration begins: all points are projected
 * on their own. Points without a normal are no samples and stay, as do those that end outside all
 * balls. sigma_r = 0 leaves the residuals out, as a popular implementation does.
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
