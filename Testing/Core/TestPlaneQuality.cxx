// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// How near the surface moving robust PCA, tensor regions and likelihoods bring noisy points, with
// the settings of the table of methods. Bounds are half as much again as the mean of twelve clouds.

#include "NoisyClouds.h"
#include "Points/PointMethods.h"

#include <gtest/gtest.h>

using namespace SurfaceDenoising;

namespace
{

/// Root mean squares of distances from the surface, in spacings.
struct Distances
{
  double Near = 0.0; ///< of points at most two spacings from the edge
  double Far = 0.0;
};

/// Positions after a method, with normals of plain plane fits, which are blunt at edges, or sharp.
Buffer<Vec3> Denoise(Buffer<Vec3> positions, PointMethod method, NormalSource source)
{
  PointDenoisingSettings settings = PointMethods()[static_cast<std::size_t>(method)].Settings;
  settings.Normals.Source = source;
  PointCloud cloud;
  cloud.Positions = std::move(positions);
  PointDenoisingReport report;
  Execution serial;
  EXPECT_TRUE(DenoisePoints(cloud, settings, report, serial));
  EXPECT_EQ(report.Kept, 0u);
  return cloud.Positions;
}

Distances OnWedge(double noise, PointMethod method, NormalSource source)
{
  const SurfaceCloud wedge = WedgeCloud(40, 20);
  const Buffer<Vec3>& clean = wedge.Positions;
  Buffer<Vec3> positions = clean;
  AddNoise(positions, noise, 7);
  positions = Denoise(positions, method, source);
  Distances sums;
  double near = 0.0;
  for (std::size_t i = 0; i < clean.size(); ++i)
  {
    const double d = wedge.DistanceOf(positions[i]);
    const bool atEdge = std::hypot(clean[i][0], clean[i][2]) <= 2.0;
    (atEdge ? sums.Near : sums.Far) += d * d;
    near += atEdge ? 1.0 : 0.0;
  }
  return { std::sqrt(sums.Near / near),
    std::sqrt(sums.Far / (static_cast<double>(clean.size()) - near)) };
}

double OnSphere(double noise, PointMethod method)
{
  Buffer<Vec3> positions = SphereCloud(2400).Positions;
  AddNoise(positions, noise * 0.0724, 7);
  double squares = 0.0;
  for (const Vec3& p : Denoise(positions, method, NormalSource::RobustFit))
  {
    squares += (p.norm() - 1.0) * (p.norm() - 1.0);
  }
  return std::sqrt(squares / 2400.0) / 0.0724;
}

void ExpectBelow(const Distances& distances, double near, double far)
{
  EXPECT_LT(distances.Near, 1.5 * near);
  EXPECT_LT(distances.Far, 1.5 * far);
}

}

TEST(PlaneQuality, MovingRobustPCA)
{
  const PointMethod method = PointMethod::MovingRobustPCA;
  ExpectBelow(OnWedge(0.1, method, NormalSource::PlaneFit), 0.024, 0.018);
  ExpectBelow(OnWedge(0.1, method, NormalSource::RobustFit), 0.025, 0.018);
  ExpectBelow(OnWedge(0.3, method, NormalSource::PlaneFit), 0.081, 0.058);
  ExpectBelow(OnWedge(0.3, method, NormalSource::RobustFit), 0.092, 0.058);
  EXPECT_LT(OnSphere(0.3, method), 1.5 * 0.06);
}

TEST(PlaneQuality, TensorRegions)
{
  const PointMethod method = PointMethod::TensorPoint;
  ExpectBelow(OnWedge(0.1, method, NormalSource::PlaneFit), 0.039, 0.024);
  ExpectBelow(OnWedge(0.1, method, NormalSource::RobustFit), 0.038, 0.024);
  ExpectBelow(OnWedge(0.3, method, NormalSource::PlaneFit), 0.125, 0.071);
  ExpectBelow(OnWedge(0.3, method, NormalSource::RobustFit), 0.117, 0.071);
  EXPECT_LT(OnSphere(0.3, method), 1.5 * 0.065);
}

/// The filter averages normals: edges are as sharp as the normals that it starts with.
TEST(PlaneQuality, Likelihoods)
{
  const PointMethod method = PointMethod::FeatureAwarePoint;
  EXPECT_GT(OnWedge(0.1, method, NormalSource::PlaneFit).Near, 0.1);
  ExpectBelow(OnWedge(0.1, method, NormalSource::RobustFit), 0.043, 0.035);
  ExpectBelow(OnWedge(0.3, method, NormalSource::RobustFit), 0.155, 0.105);
  EXPECT_LT(OnSphere(0.3, method), 1.5 * 0.107);
}
