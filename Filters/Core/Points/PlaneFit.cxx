// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlaneFit.h"

#include "Vectorize.h"

#include <algorithm>
#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// The points of a robust fit, ready for many sums with changing weights.
struct PreparedPoints
{
  std::vector<double> X;
  std::vector<double> Y;
  std::vector<double> Z;
  std::vector<PlaneSum::Moments> Moments;
  std::vector<double> Weights; ///< memory for those of a round

  void Take(const std::vector<Vec3>& points)
  {
    const std::size_t count = points.size();
    this->X.resize(count);
    this->Y.resize(count);
    this->Z.resize(count);
    this->Moments.resize(count);
    this->Weights.resize(count);
    for (std::size_t j = 0; j < count; ++j)
    {
      const Vec3& p = points[j];
      this->X[j] = p[0];
      this->Y[j] = p[1];
      this->Z[j] = p[2];
      this->Moments[j] = { 1.0, p[0], p[1], p[2], p[0] * p[0], p[0] * p[1], p[0] * p[2],
        p[1] * p[1], p[1] * p[2], p[2] * p[2], 0.0, 0.0 };
    }
  }
};

/// weights = given / max(|residuals|, least).
SURFACEDENOISING_VECTORIZED
void WeighByResiduals(const PreparedPoints& points, const double* given, const Plane& plane,
  double least, double* weights)
{
  const double a = plane.Normal[0];
  const double b = plane.Normal[1];
  const double c = plane.Normal[2];
  const double d = plane.Normal.dot(plane.Centre);
  const double* x = points.X.data();
  const double* y = points.Y.data();
  const double* z = points.Z.data();
  for (std::size_t j = 0, count = points.X.size(); j < count; ++j)
  {
    weights[j] = given[j] / std::max(std::abs(a * x[j] + b * y[j] + c * z[j] - d), least);
  }
}

/// All moments of a point side by side: the order of the sums is that of the points.
SURFACEDENOISING_VECTORIZED
void SumMoments(const PlaneSum::Moments* moments, const double* weights, std::size_t count,
  PlaneSum::Moments& sums)
{
  PlaneSum::Moments s = {};
  for (std::size_t j = 0; j < count; ++j)
  {
    const double w = weights[j];
    for (std::size_t k = 0; k < s.size(); ++k)
    {
      s[k] += w * moments[j][k];
    }
  }
  sums = s;
}

Plane FitWeighted(const PreparedPoints& points, const double* weights)
{
  PlaneSum::Moments sums;
  SumMoments(points.Moments.data(), weights, points.Moments.size(), sums);
  return PlaneSum(sums).Fit();
}

}

bool PlaneSum::FindCovariance(Plane& plane, Mat3& covariance, double& rounding) const
{
  const Moments& s = this->Sums;
  if (!(s[0] > 0.0))
  {
    return false;
  }
  plane.Centre = Vec3(s[1], s[2], s[3]) / s[0];
  Mat3 second;
  second << s[4], s[5], s[6], s[5], s[7], s[8], s[6], s[8], s[9];
  covariance = second / s[0] - plane.Centre * plane.Centre.transpose();
  // What is left of the second moments after the mean is taken off has errors of their last digits.
  rounding = std::max(1e-14 * second.trace() / s[0], 1e-300);
  return covariance.allFinite();
}

Plane PlaneSum::Fit() const
{
  Plane plane;
  Mat3 covariance;
  double rounding;
  if (this->FindCovariance(plane, covariance, rounding))
  {
    const LeastAxis system = FindLeastAxis(covariance);
    plane.Variances = system.Values.cwiseMax(0.0);
    if (system.Values[1] > rounding)
    {
      plane.Normal = system.Vector;
    }
  }
  return plane;
}

Plane PlaneSum::FitAxes() const
{
  Plane plane;
  Mat3 covariance;
  double rounding;
  if (this->FindCovariance(plane, covariance, rounding))
  {
    const Eigensystem system = Decompose(covariance);
    plane.Variances = system.Values.cwiseMax(0.0);
    if (system.Values[1] > rounding)
    {
      plane.Normal = system.Vectors.col(0);
    }
    if (system.Values[2] > rounding)
    {
      plane.Along = system.Vectors.col(2);
    }
  }
  return plane;
}

Plane FitRobustPlane(const std::vector<Vec3>& points, const std::vector<double>& weights,
  const RobustPlaneSettings& settings)
{
  static thread_local PreparedPoints prepared;
  prepared.Take(points);
  Plane plane = FitWeighted(prepared, weights.data());
  for (int round = 0; round < settings.Rounds && !plane.Normal.isZero(0.0); ++round)
  {
    WeighByResiduals(prepared, weights.data(), plane, settings.Regularization,
      prepared.Weights.data());
    const Plane next = FitWeighted(prepared, prepared.Weights.data());
    if (next.Normal.isZero(0.0))
    {
      break;
    }
    const double cosine = std::abs(next.Normal.dot(plane.Normal));
    plane = next;
    if (1.0 - cosine < 1e-10)
    {
      break;
    }
  }
  return plane;
}

}
