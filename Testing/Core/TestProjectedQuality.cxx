// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ProjectedClouds.h"

namespace
{

/// Root mean square distances from the surface, in spacings: of all points and, on a wedge, of
/// those within two spacings of the edge.
struct Distances
{
  double All = 0.0;
  double Near = 0.0;
};

Distances Measure(const SurfaceCloud& clean, const Buffer<Vec3>& positions)
{
  Distances distances;
  double near = 0.0;
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    const double distance = clean.DistanceOf(positions[i]) / clean.Spacing;
    const bool isNear = std::hypot(clean.Positions[i][0], clean.Positions[i][2]) <= 2.0;
    distances.All += distance * distance;
    distances.Near += isNear ? distance * distance : 0.0;
    near += isNear ? 1.0 : 0.0;
  }
  distances.All = std::sqrt(distances.All / static_cast<double>(positions.size()));
  distances.Near = std::sqrt(distances.Near / std::max(near, 1.0));
  return distances;
}

/// With normals from fits, and signs as they should be.
Distances Denoised(const SurfaceCloud& clean, double noise, const PointOperatorSettings& method,
  NormalSource source = NormalSource::PlaneFit)
{
  SurfaceCloud cloud = clean;
  AddNoise(cloud.Positions, noise * cloud.Spacing, 1);
  PointDenoisingSettings settings = Settings(method);
  settings.Normals.Source = source; // given normals tell the side
  return Measure(clean, Denoise(cloud.Positions, cloud.Normals, settings).Positions);
}

MovingLeastSquaresSettings PlaneOnly()
{
  MovingLeastSquaresSettings settings;
  settings.Degree = 0;
  settings.PlaneRounds = 1;
  return settings;
}

}

TEST(ProjectedQuality, NoisyPlane)
{
  SurfaceCloud plane = WedgeCloud(50, 50);
  plane.Positions.resize(2500); // one face
  plane.Normals.resize(2500);
  plane.DistanceOf = [](const Vec3& p) { return p[2]; };
  EXPECT_NEAR(Denoised(plane, 0.1, PlaneOnly()).All, 0.028, 0.003);
  EXPECT_NEAR(Denoised(plane, 0.1, MovingLeastSquaresSettings()).All, 0.046, 0.005);
  EXPECT_NEAR(Denoised(plane, 0.1, RobustImplicitMLSSettings()).All, 0.042, 0.004);
}

TEST(ProjectedQuality, NoisySphere)
{
  const SurfaceCloud sphere = SphereCloud(2400);
  EXPECT_NEAR(Denoised(sphere, 0.28, PlaneOnly()).All, 0.114, 0.012);
  EXPECT_NEAR(Denoised(sphere, 0.28, MovingLeastSquaresSettings()).All, 0.123, 0.013);
  EXPECT_NEAR(Denoised(sphere, 0.28, RobustImplicitMLSSettings()).All, 0.139, 0.014);
}

TEST(ProjectedQuality, NoisyCube)
{
  const SurfaceCloud cube = CubeCloud(20);
  EXPECT_NEAR(Denoised(cube, 0.28, PlaneOnly()).All, 0.171, 0.017);
  EXPECT_NEAR(Denoised(cube, 0.28, MovingLeastSquaresSettings()).All, 0.142, 0.015);
  EXPECT_NEAR(Denoised(cube, 0.28, RobustImplicitMLSSettings()).All, 0.147, 0.015);
}

/// Moving least squares rounds the edge, the robust implicit function mends what noise there is.
TEST(ProjectedQuality, NoisyWedge)
{
  const SurfaceCloud wedge = WedgeCloud(40, 20);
  const RobustImplicitMLSSettings robust;
  EXPECT_GT(Denoised(wedge, 0.1, PlaneOnly()).Near, 0.2);
  EXPECT_LT(Denoised(wedge, 0.1, robust).Near, 0.105);
  EXPECT_LT(Denoised(wedge, 0.1, robust, NormalSource::RobustFit).Near, 0.065);
  EXPECT_LT(Denoised(wedge, 0.3, robust).Near, 0.2);
  EXPECT_LT(Denoised(wedge, 0.3, robust).All, 0.15);
}
