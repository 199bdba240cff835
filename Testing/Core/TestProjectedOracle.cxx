// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ProjectedClouds.h"
#include "TextbookProjectedPoints.h"

namespace
{

Textbook::Cloud ToTextbook(const Buffer<Vec3>& positions, const Buffer<Vec3>& normals)
{
  return { { positions.begin(), positions.end() }, { normals.begin(), normals.end() } };
}

void ExpectSame(const PointCloud& actual, const Textbook::Cloud& expected, double tolerance)
{
  double position = 0.0;
  double normal = 0.0;
  for (std::size_t i = 0; i < expected.Points.size(); ++i)
  {
    position = std::max(position, (actual.Positions[i] - expected.Points[i]).norm());
    normal = std::max(normal, (actual.Normals[i] - expected.Normals[i]).norm());
  }
  EXPECT_LT(position, tolerance);
  EXPECT_LT(normal, tolerance);
}

}

TEST(ProjectedOracle, MovingLeastSquaresIsThatOfTheTextbook)
{
  for (const SurfaceCloud& cloud : Clouds())
  {
    const Textbook::Cloud given = ToTextbook(cloud.Positions, cloud.Normals);
    for (const int degree : { 0, 1, 2 })
    {
      for (const int rounds : { 1, 5 })
      {
        MovingLeastSquaresSettings settings;
        settings.Degree = degree;
        settings.PlaneRounds = rounds;
        ExpectSame(Denoise(cloud.Positions, cloud.Normals, Settings(settings)),
          Textbook::MovingLeastSquares(given, 30, 0.0, degree, rounds), 1e-9);
      }
    }
  }
}

TEST(ProjectedOracle, BandwidthsAreInSpacings)
{
  const SurfaceCloud cloud = Noisy(SphereCloud(500), 0.2);
  MovingLeastSquaresSettings settings;
  settings.Bandwidth = 1.3;
  Execution serial;
  PointCloud result{ cloud.Positions, cloud.Normals, {}, {} };
  PointDenoisingReport report;
  ASSERT_TRUE(DenoisePoints(result, Settings(settings, 20), report, serial));
  EXPECT_NEAR(report.Spacing, cloud.Spacing, 0.2 * cloud.Spacing);
  ExpectSame(result,
    Textbook::MovingLeastSquares(ToTextbook(cloud.Positions, cloud.Normals), 20,
      1.3 * report.Spacing, 2, 5),
    1e-9);
}

TEST(ProjectedOracle, RobustImplicitIsThatOfTheTextbook)
{
  for (const SurfaceCloud& cloud : Clouds())
  {
    const Textbook::Cloud given = ToTextbook(cloud.Positions, cloud.Normals);
    for (const double residual : { 0.0, 0.5 })
    {
      for (const double scale : { 1.4, 3.0 })
      {
        RobustImplicitMLSSettings settings;
        settings.FilterScale = scale;
        settings.ResidualScale = residual;
        ExpectSame(Denoise(cloud.Positions, cloud.Normals, Settings(settings)),
          Textbook::RobustImplicit(given, given.Points, { scale, 0.75, residual, 3, 15, false }),
          1e-9);
      }
    }
    const Buffer<Vec3> flipped = Flipped(cloud.Normals);
    ExpectSame(Denoise(cloud.Positions, flipped, Settings(Unoriented())),
      Textbook::RobustImplicit(ToTextbook(cloud.Positions, flipped), given.Points,
        { 3.0, 0.75, 0.5, 3, 15, true }),
      1e-9);
  }
}

/// Every tenth point is far outside, so that projections go beyond what was gathered at first, and
/// half of the plane has a hundredth of the points.
TEST(ProjectedOracle, RobustImplicitOfUnevenPointsIsThatOfTheTextbook)
{
  std::mt19937 generator(9);
  std::uniform_real_distribution<double> coordinate(0.0, 1.0);
  Buffer<Vec3> positions;
  Buffer<Vec3> normals;
  for (int i = 0; i < 1000; ++i)
  {
    const double side = i < 900 ? 0.1 : 1.0;
    const double x = side * coordinate(generator);
    const double y = side * coordinate(generator);
    positions.push_back(Vec3(x, y, 0.005 * coordinate(generator)));
    positions.back()[2] += i % 10 == 0 ? 0.01 + 0.1 * coordinate(generator) : 0.0;
    normals.push_back(
      Vec3(coordinate(generator) - 0.5, coordinate(generator) - 0.5, 1.0).normalized());
  }
  const Textbook::Cloud given = ToTextbook(positions, normals);
  for (const double scale : { 2.0, 4.0 })
  {
    RobustImplicitMLSSettings settings;
    settings.FilterScale = scale;
    ExpectSame(Denoise(positions, normals, Settings(settings)),
      Textbook::RobustImplicit(given, given.Points, { scale, 0.75, 0.5, 3, 15, false }), 1e-9);
  }
}

TEST(ProjectedOracle, SpacingsOfTheBeginningServeAllOuterIterations)
{
  const SurfaceCloud cloud = Noisy(CubeCloud(8), 0.2);
  Textbook::Cloud expected = ToTextbook(cloud.Positions, cloud.Normals);
  PointDenoisingSettings settings = Settings(RobustImplicitMLSSettings());
  settings.OuterIterations = 3;
  for (int outer = 0; outer < 3; ++outer)
  {
    expected = Textbook::RobustImplicit(expected,
      { cloud.Positions.begin(), cloud.Positions.end() }, Textbook::ImplicitParameters());
  }
  ExpectSame(Denoise(cloud.Positions, cloud.Normals, settings), expected, 1e-9);
}
