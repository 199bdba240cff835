// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Near sharp edges, robust methods leave at most half of the distance that moving least squares
// leave: as they come with little noise, and with settings for the noise with much.

#include "NoisyClouds.h"
#include "Points/PointMethods.h"

#include <gtest/gtest.h>

using namespace SurfaceDenoising;

namespace
{

/// The mean distance of points at most two spacings from an edge, in spacings.
double NearEdges(const SurfaceCloud& clean, double noise, const PointDenoisingSettings& settings)
{
  PointCloud cloud;
  cloud.Positions = clean.Positions;
  AddNoise(cloud.Positions, noise * clean.Spacing, 7);
  PointDenoisingReport report;
  Execution serial;
  EXPECT_TRUE(DenoisePoints(cloud, settings, report, serial));
  const bool isWedge = clean.Spacing == 1.0;
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < clean.Positions.size(); ++i)
  {
    const Vec3& p = clean.Positions[i];
    Vec3 inside = Vec3::Ones() - p.cwiseAbs(); // of a cube
    std::sort(inside.data(), inside.data() + 3);
    const double fromEdge = isWedge ? std::hypot(p[0], p[2]) : std::hypot(inside[0], inside[1]);
    if (fromEdge <= 2.0 * clean.Spacing)
    {
      sum += std::abs(clean.DistanceOf(cloud.Positions[i])) / clean.Spacing;
      count += 1.0;
    }
  }
  return sum / count;
}

double LeastSquares(const SurfaceCloud& clean, double noise)
{
  return NearEdges(clean, noise, SettingsOf(PointMethod::MovingLeastSquares));
}

/// The composer with large neighbourhoods, above all for the normals that it starts with.
PointDenoisingSettings ForNoise(int neighbors, int forNormals)
{
  PointDenoisingSettings settings = ComposedPoints();
  settings.Neighborhood.Count = neighbors;
  settings.Normals.NumberOfNeighbors = forNormals;
  auto& stages = std::get<TwoStageSettings>(settings.Operator);
  stages.Normals.NormScale = 0.3;
  stages.Normals.SpatialScale = 3.0;
  stages.NormalIterations = 10;
  stages.Points.SpatialScale = 3.0;
  stages.PointIterations = 10;
  return settings;
}

}

TEST(EdgeQuality, LittleNoise)
{
  for (const SurfaceCloud& cloud : { WedgeCloud(40, 20), CubeCloud(20) })
  {
    const double least = LeastSquares(cloud, 0.15);
    EXPECT_LT(NearEdges(cloud, 0.15, ComposedPoints()), least / 2.0);
    EXPECT_LT(NearEdges(cloud, 0.15, SettingsOf(PointMethod::MovingRobustPCA)), least / 2.0);
    EXPECT_LT(NearEdges(cloud, 0.15, SettingsOf(PointMethod::GuidedPointNormal)), least / 2.0);
    EXPECT_LT(NearEdges(cloud, 0.15, SettingsOf(PointMethod::VotingTensorPoint)), least / 1.8);
  }
}

TEST(EdgeQuality, NoiseOfHalfASpacing)
{
  const PointDenoisingSettings settings = ForNoise(40, 40);
  EXPECT_LT(NearEdges(WedgeCloud(40, 20), 0.5, settings),
    LeastSquares(WedgeCloud(40, 20), 0.5) / 2.0);
  EXPECT_LT(NearEdges(CubeCloud(20), 0.5, settings), LeastSquares(CubeCloud(20), 0.5) / 2.0);
}

TEST(EdgeQuality, NoiseOfASpacing)
{
  const PointDenoisingSettings settings = ForNoise(120, 80);
  EXPECT_LT(NearEdges(WedgeCloud(40, 20), 1.0, settings),
    LeastSquares(WedgeCloud(40, 20), 1.0) / 2.0);
  EXPECT_LT(NearEdges(CubeCloud(20), 1.0, settings), LeastSquares(CubeCloud(20), 1.0) / 2.0);
}

/// Patches that end at edges guide better than those that reach beyond.
TEST(EdgeQuality, PatchesThatEndAtEdges)
{
  PointDenoisingSettings settings = ForNoise(30, 30);
  auto& stages = std::get<TwoStageSettings>(settings.Operator);
  stages.Guidance = PointGuidance::Patch;
  const double within = NearEdges(WedgeCloud(40, 20), 0.15, settings);
  stages.Patch.MemberAgreement = -1.0;
  EXPECT_LT(2.0 * within, NearEdges(WedgeCloud(40, 20), 0.15, settings));
}
