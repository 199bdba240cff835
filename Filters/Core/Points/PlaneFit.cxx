// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlaneFit.h"

#include <algorithm>
#include <cmath>

namespace SurfaceDenoising
{

Plane PlaneSum::Fit() const
{
  Plane plane;
  if (!(this->Weight > 0.0))
  {
    return plane;
  }
  plane.Centre = this->First / this->Weight;
  const std::array<double, 6>& s = this->Second;
  Mat3 second;
  second << s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5];
  const Mat3 covariance = second / this->Weight - plane.Centre * plane.Centre.transpose();
  if (!covariance.allFinite())
  {
    return plane;
  }
  const Eigensystem system = Decompose(covariance);
  plane.Variances = system.Values.cwiseMax(0.0);
  // What is left of the second moments after the mean is taken off has errors of their last digits.
  const double rounding = 1e-14 * second.trace() / this->Weight;
  if (system.Values[1] > std::max(rounding, 1e-300))
  {
    plane.Normal = system.Vectors.col(0);
  }
  if (system.Values[2] > std::max(rounding, 1e-300))
  {
    plane.Along = system.Vectors.col(2);
  }
  return plane;
}

Plane FitRobustPlane(const std::vector<Vec3>& points, const std::vector<double>& weights,
  const RobustPlaneSettings& settings)
{
  PlaneSum start;
  for (std::size_t j = 0; j < points.size(); ++j)
  {
    start.Add(points[j], weights[j]);
  }
  Plane plane = start.Fit();
  for (int round = 0; round < settings.Rounds && !plane.Normal.isZero(0.0); ++round)
  {
    PlaneSum sum;
    for (std::size_t j = 0; j < points.size(); ++j)
    {
      sum.Add(points[j],
        weights[j] / std::max(std::abs(plane.HeightOf(points[j])), settings.Regularization));
    }
    const Plane next = sum.Fit();
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
