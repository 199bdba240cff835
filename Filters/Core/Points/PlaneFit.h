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
  Vec3 Centre = Vec3(0.0, 0.0, 0.0);    ///< relative to the same place as the points
  Vec3 Normal = Vec3(0.0, 0.0, 0.0);    ///< zero if the points do not define a plane
  Vec3 Along = Vec3(0.0, 0.0, 0.0);     ///< where the points extend most, on a line as well
  Vec3 Variances = Vec3(0.0, 0.0, 0.0); ///< eigenvalues of C, ascending

  double HeightOf(const Vec3& p) const { return this->Normal.dot(p - this->Centre); }
};

/// Sums up points for a fit. Give them relative to a place nearby, or digits are lost.
class PlaneSum
{
public:
  void Add(const Vec3& p, double weight = 1.0)
  {
    const Vec3 wp = weight * p;
    this->Weight += weight;
    this->First += wp;
    this->Second[0] += wp[0] * p[0];
    this->Second[1] += wp[0] * p[1];
    this->Second[2] += wp[0] * p[2];
    this->Second[3] += wp[1] * p[1];
    this->Second[4] += wp[1] * p[2];
    this->Second[5] += wp[2] * p[2];
  }

  double TotalWeight() const { return this->Weight; }

  /// No plane (a zero normal) without weight, and for points that lie at one place or on a line:
  /// the two larger variances must be above the rounding of the smallest.
  Plane Fit() const;

private:
  double Weight = 0.0;
  Vec3 First = Vec3(0.0, 0.0, 0.0);
  std::array<double, 6> Second = {};
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
