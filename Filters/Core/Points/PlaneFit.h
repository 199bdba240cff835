// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PlaneFit.h
 * @brief The plane that fits weighted points best.
 *
 * The centre is c = sum w_j p_j / sum w_j, the normal the eigenvector of the smallest eigenvalue of
 * C = sum w_j (p_j - c) (p_j - c)^T / sum w_j. H. Hoppe, T. DeRose, T. Duchamp, J. McDonald, W.
 * Stuetzle, "Surface reconstruction from unorganized points", SIGGRAPH 1992.
 */

#ifndef SurfaceDenoising_PlaneFit_h
#define SurfaceDenoising_PlaneFit_h

#include "SymmetricEigen.h"

#include <vector>

namespace SurfaceDenoising
{

struct Plane
{
  Vec3 Centre = Vec3(0.0, 0.0, 0.0); ///< relative to the same place as the points
  Vec3 Normal = Vec3(0.0, 0.0, 0.0); ///< zero if the points do not define a plane
  Vec3 Along = Vec3(0.0, 0.0, 0.0); ///< where the points extend most, on a line as well; of FitAxes
  Vec3 Variances = Vec3(0.0, 0.0, 0.0); ///< eigenvalues of C, ascending; see FindLeastAxis

  double HeightOf(const Vec3& p) const { return this->Normal.dot(p - this->Centre); }
};

/// Sums up points for a fit. Give them relative to a place nearby, or digits are lost.
class PlaneSum
{
public:
  /// Of 1, x, y, z, xx, xy, xz, yy, yz, zz; the others make it a whole number of vectors.
  using Moments = std::array<double, 12>;

  PlaneSum() = default;
  explicit PlaneSum(const Moments& sums)
    : Sums(sums)
  {
  }

  void Add(const Vec3& p, double weight = 1.0)
  {
    const Vec3 wp = weight * p;
    this->Sums[0] += weight;
    this->Sums[1] += wp[0];
    this->Sums[2] += wp[1];
    this->Sums[3] += wp[2];
    this->Sums[4] += wp[0] * p[0];
    this->Sums[5] += wp[0] * p[1];
    this->Sums[6] += wp[0] * p[2];
    this->Sums[7] += wp[1] * p[1];
    this->Sums[8] += wp[1] * p[2];
    this->Sums[9] += wp[2] * p[2];
  }

  double TotalWeight() const { return this->Sums[0]; }

  /// No plane (a zero normal) without weight, and for points that lie at one place or on a line:
  /// the two larger variances must be above the rounding of the smallest.
  Plane Fit() const;

  /// The same with the direction Along and all digits of the variances, which takes longer.
  Plane FitAxes() const;

private:
  bool FindCovariance(Plane& plane, Mat3& covariance, double& rounding) const;

  Moments Sums = {};
};

struct RobustPlaneSettings
{
  double Regularization = 0.0; ///< residuals count as at least this, a length above 0
  int Rounds = 10;             ///< at most
};

/**
 * The plane with the least weighted sum of distances, sum_j w_j |n . (p_j - c)|, by iteratively
 * reweighted least squares: from the weighted fit on, weights are w_j / max(|r_j|, Regularization)
 * with the residuals r_j of the round before. Ends early when the normal stays. Without a plane to
 * start from there is none.
 */
Plane FitRobustPlane(const std::vector<Vec3>& points, const std::vector<double>& weights,
  const RobustPlaneSettings& settings);

}

#endif
