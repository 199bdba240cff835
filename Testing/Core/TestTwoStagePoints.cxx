// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
// Two-stage filters of points against a textbook version.

#include "NoisyClouds.h"
#include "Points/PointMethods.h"
#include "TextbookTwoStagePoints.h"

#include <gtest/gtest.h>

using namespace SurfaceDenoising;

namespace
{

/// A noisy cloud with noisy normals.
PointCloud MakeCloud(SurfaceCloud clean)
{
  AddNoise(clean.Positions, 0.2 * clean.Spacing, 1);
  AddNoise(clean.Normals, 0.15, 2);
  PointCloud cloud;
  cloud.Positions = clean.Positions;
  for (const Vec3& n : clean.Normals)
  {
    cloud.Normals.push_back(n.normalized());
  }
  return cloud;
}

TextbookPoints::Cloud ForTextbook(const PointCloud& cloud)
{
  return { { cloud.Positions.begin(), cloud.Positions.end() },
    { cloud.Normals.begin(), cloud.Normals.end() } };
}

void ExpectSame(const PointCloud& found, const TextbookPoints::Cloud& expected, double tolerance)
{
  double place = 0.0;
  double normal = 0.0;
  for (std::size_t i = 0; i < found.Positions.size(); ++i)
  {
    place = std::max(place, (found.Positions[i] - expected.Points[i]).norm());
    normal = std::max(normal, (found.Normals[i] - expected.Normals[i]).norm());
  }
  EXPECT_LT(place, tolerance);
  EXPECT_LT(normal, tolerance);
}

PointDenoisingSettings GivenNormals(PointDenoisingSettings settings)
{
  settings.Normals.Source = NormalSource::Given;
  settings.Normals.Orientation = NormalOrientation::Keep;
  return settings;
}

PointCloud Denoise(PointCloud cloud, const PointDenoisingSettings& settings)
{
  PointDenoisingReport report;
  Execution serial;
  EXPECT_TRUE(DenoisePoints(cloud, GivenNormals(settings), report, serial));
  return cloud;
}

std::vector<PointCloud> Clouds()
{
  return { MakeCloud(SphereCloud(400)), MakeCloud(CubeCloud(9)), MakeCloud(WedgeCloud(14, 8)) };
}

double Gauss(double x, double sigma) { return std::exp(-x * x / (2.0 * sigma * sigma)); }

}

TEST(TwoStagePoints, ComposedFilterIsThatOfTheTextbook)
{
  for (const PointCloud& cloud : Clouds())
  {
    TextbookPoints::Cloud expected = ForTextbook(cloud);
    const double s = TextbookPoints::Spacing(expected.Points);
    const auto neighbors = TextbookPoints::Nearest(expected.Points, 16);
    TextbookPoints::Stage stage;
    stage.Weight = [](double x) { return Gauss(x, 0.2); };
    stage.SpatialSigma = 1.5 * s;
    TextbookPoints::FilterNormals(expected, neighbors, stage, 2, false, false, false);
    stage.Own = false;
    TextbookPoints::MovePoints(expected, neighbors, stage, TextbookPoints::Step::Gradient, 1.0,
      0.05, 5, false);
    ExpectSame(Denoise(cloud, ComposedPoints()), expected, 1e-10);
  }
}

TEST(TwoStagePoints, RollingNormalsAreThoseOfTheTextbook)
{
  for (const bool unoriented : { false, true })
  {
    for (PointCloud cloud : Clouds())
    {
      for (std::size_t i = 0; unoriented && i < cloud.Normals.size(); i += 3)
      {
        cloud.Normals[i] = -cloud.Normals[i];
      }
      PointDenoisingSettings settings = SettingsOf(PointMethod::RollingPointNormal);
      std::get<TwoStageSettings>(settings.Operator).Unoriented = unoriented;
      TextbookPoints::Cloud expected = ForTextbook(cloud);
      const double s = TextbookPoints::Spacing(expected.Points);
      const auto neighbors = TextbookPoints::Nearest(expected.Points, 30);
      TextbookPoints::Stage stage;
      stage.Weight = [](double x) { return std::exp(-x * x / (0.35 * 0.35)); };
      stage.SpatialSigma = 1.55 * s / std::sqrt(2.0);
      TextbookPoints::FilterNormals(expected, neighbors, stage, 4, true, true, unoriented);
      stage.Own = false;
      TextbookPoints::MovePoints(expected, neighbors, stage, TextbookPoints::Step::Gradient, 1.0,
        0.05, 10, unoriented);
      ExpectSame(Denoise(cloud, settings), expected, 1e-10);
    }
  }
}

TEST(TwoStagePoints, BilateralFilterIsThatOfTheTextbook)
{
  for (const PointCloud& cloud : Clouds())
  {
    PointDenoisingSettings settings = SettingsOf(PointMethod::BilateralPoint);
    settings.Neighborhood.Kind = PointNeighborhood::Nearest;
    settings.Neighborhood.Count = 25;
    std::get<TwoStageSettings>(settings.Operator).Points.NormScale = 0.4;
    settings.OuterIterations = 2;
    TextbookPoints::Cloud expected = ForTextbook(cloud);
    const double s = TextbookPoints::Spacing(expected.Points);
    for (int outer = 0; outer < 2; ++outer)
    {
      const auto neighbors = TextbookPoints::Nearest(expected.Points, 25);
      TextbookPoints::Stage stage;
      stage.Weight = [s](double x) { return Gauss(x, 0.4 * s); };
      stage.Argument = TextbookPoints::Measure::Height;
      stage.SpatialSigma = s;
      TextbookPoints::FitNormals(expected, neighbors, stage);
      TextbookPoints::MovePoints(expected, neighbors, stage, TextbookPoints::Step::Own, 1.0, 0.05,
        1, false);
    }
    ExpectSame(Denoise(cloud, settings), expected, 1e-9);
  }
}

TEST(TwoStagePoints, ArgumentsAndNormsAreThoseOfTheTextbook)
{
  struct Row
  {
    NormalArgument Argument;
    TextbookPoints::Measure Measure;
    double Scale; ///< in units of the argument
    int Power;    ///< of the spacing that the scale is multiplied by
  };
  const std::vector<Row> rows = { { NormalArgument::Chord, TextbookPoints::Measure::Chord, 0.3, 0 },
    { NormalArgument::Angle, TextbookPoints::Measure::Angle, 0.3, 0 },
    { NormalArgument::DirectionalCurvature, TextbookPoints::Measure::Curvature, 0.3, -1 },
    { NormalArgument::NormalGradient, TextbookPoints::Measure::Gradient, 0.3, -1 },
    { NormalArgument::Height, TextbookPoints::Measure::Height, 0.5, 1 } };
  const PointCloud cloud = MakeCloud(CubeCloud(8));
  for (const Row& row : rows)
  {
    for (int norm = 0; norm < NumberOfNorms; ++norm)
    {
      const NormId id = static_cast<NormId>(norm);
      PointDenoisingSettings settings = ComposedPoints();
      TwoStageSettings& t = std::get<TwoStageSettings>(settings.Operator);
      t.Normals.Norm = t.Points.Norm = id;
      t.Normals.NormScale = t.Points.NormScale = row.Scale;
      t.Normals.Argument = t.Points.Argument = row.Argument;
      t.Data = PointNormalData::Original;
      t.PointIterations = 2;
      TextbookPoints::Cloud expected = ForTextbook(cloud);
      const double s = TextbookPoints::Spacing(expected.Points);
      const auto neighbors = TextbookPoints::Nearest(expected.Points, 16);
      const ErrorNorm g = MakeErrorNorm(id, row.Scale * std::pow(s, row.Power));
      TextbookPoints::Stage stage;
      stage.Weight = [&g](double x) { return Weight(g, x); };
      stage.Argument = row.Measure;
      stage.SpatialSigma = 1.5 * s;
      TextbookPoints::FilterNormals(expected, neighbors, stage, 2, false, true, false);
      stage.Own = false;
      TextbookPoints::MovePoints(expected, neighbors, stage, TextbookPoints::Step::Gradient, 1.0,
        0.05, 2, false);
      SCOPED_TRACE(std::string(NameOf(g)) + " " + std::to_string(static_cast<int>(row.Argument)));
      ExpectSame(Denoise(cloud, settings), expected, 1e-8);
    }
  }
}

TEST(TwoStagePoints, SchemesAreThoseOfTheTextbook)
{
  for (const int scheme : { 0, 1, 2, 3, 4 })
  {
    for (const bool unoriented : { false, true })
    {
      PointCloud cloud = MakeCloud(CubeCloud(8));
      for (std::size_t i = 0; unoriented && i < cloud.Normals.size(); i += 3)
      {
        cloud.Normals[i] = -cloud.Normals[i];
      }
      PointDenoisingSettings settings = ComposedPoints();
      TwoStageSettings& t = std::get<TwoStageSettings>(settings.Operator);
      t.NormalIterations = 0;
      t.PointIterations = 3;
      t.Update.Scheme = static_cast<PointScheme>(scheme);
      t.Update.Step = 0.7;
      t.Unoriented = unoriented;
      TextbookPoints::Cloud expected = ForTextbook(cloud);
      TextbookPoints::Stage stage;
      stage.Weight = [](double x) { return Gauss(x, 0.2); };
      stage.SpatialSigma = 1.5 * TextbookPoints::Spacing(expected.Points);
      stage.Own = false;
      TextbookPoints::MovePoints(expected, TextbookPoints::Nearest(expected.Points, 16), stage,
        static_cast<TextbookPoints::Step>(scheme), 0.7, 0.05, 3, unoriented);
      SCOPED_TRACE(scheme);
      ExpectSame(Denoise(cloud, settings), expected, 1e-10);
    }
  }
}

TEST(TwoStagePoints, RandomSignsChangeNothingWithoutOrientation)
{
  for (const PointGuidance guidance : { PointGuidance::None, PointGuidance::Rolling })
  {
    for (const PointNormalOperator operation :
      { PointNormalOperator::Average, PointNormalOperator::Diffusion,
        PointNormalOperator::VotingTensor, PointNormalOperator::PlaneFit })
    {
      PointDenoisingSettings settings = ComposedPoints();
      TwoStageSettings& t = std::get<TwoStageSettings>(settings.Operator);
      t.Guidance = guidance;
      t.Operator = operation;
      t.Unoriented = true;
      PointCloud cloud = MakeCloud(CubeCloud(8));
      const PointCloud expected = Denoise(cloud, settings);
      for (std::size_t i = 0; i < cloud.Normals.size(); i += 2)
      {
        cloud.Normals[i] = -cloud.Normals[i];
      }
      const PointCloud found = Denoise(cloud, settings);
      for (std::size_t i = 0; i < cloud.Normals.size(); ++i)
      {
        ASSERT_LT((found.Positions[i] - expected.Positions[i]).norm(), 1e-12);
        ASSERT_NEAR(std::abs(found.Normals[i].dot(expected.Normals[i])), 1.0, 1e-12);
      }
    }
  }
}

TEST(TwoStagePoints, TakesItsScaleFromTheData)
{
  PointDenoisingSettings settings = ComposedPoints();
  std::get<TwoStageSettings>(settings.Operator).Normals.NormScale = 0.0;
  PointCloud cloud = MakeCloud(CubeCloud(12));
  PointDenoisingReport report;
  Execution serial;
  ASSERT_TRUE(DenoisePoints(cloud, GivenNormals(settings), report, serial));
  EXPECT_GT(report.NormScale, 0.05);
  EXPECT_LT(report.NormScale, 0.3);
  EXPECT_FALSE(report.NoNoiseFound);

  PointCloud clean;
  clean.Positions = WedgeCloud(12, 10).Positions;
  clean.Normals = WedgeCloud(12, 10).Normals;
  const Buffer<Vec3> before = clean.Positions;
  ASSERT_TRUE(DenoisePoints(clean, GivenNormals(settings), report, serial));
  EXPECT_TRUE(report.NoNoiseFound);
  EXPECT_EQ(clean.Positions, before);
}

// Whatever unit the argument has.
TEST(TwoStagePoints, ScaleFromTheDataDoesNotDependOnUnits)
{
  const PointCloud cloud = MakeCloud(CubeCloud(8));
  PointCloud large = cloud;
  for (Vec3& p : large.Positions)
  {
    p *= 1024.0; // exact
  }
  for (const NormalArgument argument : { NormalArgument::Chord, NormalArgument::Angle,
         NormalArgument::DirectionalCurvature, NormalArgument::NormalGradient,
         NormalArgument::Height, NormalArgument::BentArc, NormalArgument::NeighborHeight })
  {
    SCOPED_TRACE(static_cast<int>(argument));
    PointDenoisingSettings settings = ComposedPoints();
    TwoStageSettings& t = std::get<TwoStageSettings>(settings.Operator);
    t.Normals.NormScale = 0.0;
    t.Normals.Argument = argument;
    for (const ScaleEstimator estimator :
      { ScaleEstimator::MedianAbsoluteDeviation, ScaleEstimator::HalfNormal })
    {
      t.Estimator = estimator;
      PointCloud one = cloud;
      PointCloud other = large;
      PointDenoisingReport report;
      PointDenoisingReport reportOfLarge;
      Execution serial;
      ASSERT_TRUE(DenoisePoints(one, GivenNormals(settings), report, serial));
      ASSERT_TRUE(DenoisePoints(other, GivenNormals(settings), reportOfLarge, serial));
      EXPECT_GT(report.NormScale, 0.0);
      EXPECT_NEAR(reportOfLarge.NormScale / report.NormScale, 1.0, 1e-9);
      for (std::size_t i = 0; i < cloud.Positions.size(); ++i)
      {
        ASSERT_LT((other.Positions[i] / 1024.0 - one.Positions[i]).norm(), 1e-9);
      }
    }
  }
}
