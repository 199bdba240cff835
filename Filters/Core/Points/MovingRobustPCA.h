// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file MovingRobustPCA.h
 * @brief Robust planes through overlapping neighbourhoods; points go where the planes agree.
 *
 * The patch of point i are i and its neighbours j. They are a plane (c_i, n_i) with small errors
 * and, in some columns, gross ones:
 *
 *   1. (c_i, n_i) = argmin sum_j w_ij |n . (p_j - c)|,  w_ij = exp(-(theta_ij / sigma)^2)
 *      with the angle theta_ij between the normals of the iteration before, whatever their signs;
 *      see PlaneFit.h. All w_ij are 1 if fewer than four of them are above 0.001.
 *   2. r_ij = n_i . (p_j - c_i),  t_i = max(3 * 1.4826 median_j |r_ij|, epsilon).
 *      What exceeds t_i is the sparse error: the patch trusts j with v_ij = w_ij, or 0 if
 *      |r_ij| > t_i.
 *   3. p_j' = (l p_j + sum_i v_ij (p_j - r_ij n_i)) / (l + sum_i v_ij) over all patches i that
 *      contain j. If none of them trusts j, its own moves it: p_j' = p_j - r_jj n_j.
 *   4. n_j is the normal of the patch of j, on the side where it was.
 *
 * Normals need no orientation. E. Mattei, A. Castrodad, "Point Cloud Denoising via Moving RPCA",
 * Computer Graphics Forum 36(8), 2017. The weights are those of the paper; the rest is the smallest
 * algorithm with the properties that the abstract names: overlapping subspaces of two dimensions,
 * a weighted sum of distances, a term for gross errors, averages over the overlaps.
 */

#ifndef SurfaceDenoising_MovingRobustPCA_h
#define SurfaceDenoising_MovingRobustPCA_h

#include "PointOperator.h"

namespace SurfaceDenoising
{

struct MovingRobustPCASettings
{
  double NormalAngle = 0.39269908169872414; ///< sigma, radians; pi / 12 to pi / 6
  int Rounds = 10;                          ///< of the robust fit, at most
  double Regularization = 0.01; ///< epsilon, in spacings; residuals of the fit count as at least it
  double Fidelity = 0.0;        ///< l, the weight of the point's own position, from 0
};

/**
 * t_i: the residual up to which a patch trusts its members. Residuals are overwritten by their
 * absolute values in another order.
 */
double TrustLimit(Buffer<double>& residuals, double epsilon);

std::unique_ptr<PointOperator> MakeMovingRobustPCA(const MovingRobustPCASettings& settings);

}

#endif
