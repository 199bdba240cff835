// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PointFixtures.h"
#include "Points/ImplicitSurface.h"
#include "Points/MovingLeastSquares.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace SurfaceDenoising;

namespace
{

constexpr double Digits = 1e-6;

void ExpectVector(const Vec3& actual, double x, double y, double z, double tolerance = Digits)
{
  EXPECT_NEAR(actual[0], x, tolerance);
  EXPECT_NEAR(actual[1], y, tolerance);
  EXPECT_NEAR(actual[2], z, tolerance);
}

std::vector<Vec3> RelativeTo(const Vec3& place, const Buffer<Vec3>& points)
{
  std::vector<Vec3> relative;
  for (const Vec3& p : points)
  {
    relative.push_back(p - place);
  }
  return relative;
}

/// On z = 0.1 x^2 + 0.05 x y - 0.02 y^2 over a grid of this size, in steps of 1.
Buffer<Vec3> Saddle(int size)
{
  Buffer<Vec3> points;
  for (int x = -size; x <= size; ++x)
  {
    for (int y = -size; y <= size; ++y)
    {
      points.push_back(Vec3(x, y, 0.1 * x * x + 0.05 * x * y - 0.02 * y * y));
    }
  }
  return points;
}

/// The five points with h = 2 for all of them.
class ImplicitFivePoints : public testing::Test
{
protected:
  ImplicitFivePoints()
    : Points(FivePoints())
  {
    this->Settings.FilterScale = std::sqrt(3.14159265358979323846);
    this->Settings.NormalScale = 0.8;
    for (std::size_t j = 0; j < 5; ++j)
    {
      this->Surface.Add(this->Points.Positions[j], this->Points.Normals[j], 2.0);
    }
  }

  ImplicitValue Evaluate(const Vec3& x, int fits)
  {
    this->Settings.MaximumFits = fits;
    return this->Surface.Evaluate(x, this->Settings);
  }

  /// Point 0 after some projections.
  PointSet Projected(int projections)
  {
    PointSet points = this->Points;
    this->Settings.MaximumFits = 3;
    this->Settings.MaximumProjections = projections;
    Execution serial;
    EXPECT_TRUE(MakeRobustImplicitMLS(this->Settings)->Run(points, serial, 0.0, 1.0));
    return points;
  }

  PointSet Points;
  RobustImplicitMLSSettings Settings;
  ImplicitSurface Surface;
};

}

TEST(MovingLeastSquares, PlaneOfTheFivePoints)
{
  const Buffer<Vec3> points = FivePoints().Positions;
  const Vec3 x = points[0];
  const MovingFit fit = FitMovingSurface(RelativeTo(x, points), 1.5, 0, 1);
  const double side = fit.Normal[2] < 0.0 ? -1.0 : 1.0;
  ExpectVector(x + fit.Reference.Centre, 0.002406, 0.003939, 0.057547);
  ExpectVector(side * fit.Normal, -0.051221, -0.050074, 0.997431);
  ExpectVector(x + fit.Place, 0.007294, 0.007131, 0.057959);
  EXPECT_EQ(fit.Degree, 0);
}

TEST(MovingLeastSquares, QuadricsAreFittedExactly)
{
  const Vec3 x(0.0, 0.0, 0.3);
  const std::vector<Vec3> around = RelativeTo(x, Saddle(1));
  const MovingFit fit = FitMovingSurface(around, 1.5, 2, 1);
  ExpectVector(x + fit.Reference.Centre, 0.0, 0.0, 0.045685);
  EXPECT_EQ(fit.Degree, 2);
  for (const int rounds : { 1, 5 })
  {
    const MovingFit exact = FitMovingSurface(around, 1.5, 2, rounds);
    ExpectVector(x + exact.Place, 0.0, 0.0, 0.0, 1e-12);
    ExpectVector(exact.Normal * (exact.Normal[2] < 0.0 ? -1.0 : 1.0), 0.0, 0.0, 1.0, 1e-12);
  }
}

TEST(MovingLeastSquares, QuadricsInAnyDirectionAreFittedExactly)
{
  Buffer<Vec3> points = Saddle(2);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Vec3(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
  for (Vec3& p : points)
  {
    p = turn * p;
  }
  const Vec3 x = turn * Vec3(0.0, 0.0, 0.3);
  const MovingFit fit = FitMovingSurface(RelativeTo(x, points), 2.5, 2, 5);
  EXPECT_LT((x + fit.Place).norm(), 1e-12);
  EXPECT_NEAR(std::abs(fit.Normal.dot(turn.col(2))), 1.0, 1e-12);
}

TEST(MovingLeastSquares, TheDegreeFallsUntilThePointsDetermineThePolynomial)
{
  const Vec3 x(0.0, 0.0, 0.3);
  auto fit = [&](const Buffer<Vec3>& points)
  { return FitMovingSurface(RelativeTo(x, points), 1.5, 2, 5); };
  const Buffer<Vec3> nine = Saddle(1);
  EXPECT_EQ(fit(Buffer<Vec3>(nine.begin(), nine.begin() + 7)).Degree, 2);
  EXPECT_EQ(fit(Buffer<Vec3>(nine.begin(), nine.begin() + 6)).Degree, 1);
  EXPECT_EQ(fit(Buffer<Vec3>(nine.begin(), nine.begin() + 4)).Degree, 1);
  EXPECT_EQ(fit(Buffer<Vec3>(nine.begin(), nine.begin() + 3)).Degree, 0);

  // On two straight lines a^2 is a, and the value in between could be anything.
  Buffer<Vec3> lines;
  for (int k = -4; k <= 4; ++k)
  {
    lines.push_back(Vec3(-1.0, 0.4 * k, 0.1));
    lines.push_back(Vec3(1.0, 0.4 * k, 0.1));
  }
  const MovingFit between = fit(lines);
  EXPECT_EQ(between.Degree, 1);
  EXPECT_NEAR(between.Place[2], -0.2, 1e-12);
}

TEST(MovingLeastSquares, TheFirstDegreeTakesTheSlopeAlone)
{
  Buffer<Vec3> plane;
  for (const Vec3& p : Saddle(2))
  {
    plane.push_back(Vec3(p[0], p[1], 0.25 * p[0] - 0.5 * p[1]));
  }
  const Vec3 x(0.1, 0.2, 0.3);
  const MovingFit fit = FitMovingSurface(RelativeTo(x, plane), 1.5, 1, 5);
  const Vec3 normal = Vec3(-0.25, 0.5, 1.0).normalized();
  EXPECT_EQ(fit.Degree, 1);
  EXPECT_NEAR(std::abs(fit.Normal.dot(normal)), 1.0, 1e-14);
  EXPECT_NEAR((x + fit.Place).dot(normal), 0.0, 1e-14);
  EXPECT_NEAR(fit.Place.cross(normal).norm(), 0.0, 1e-14);
}

TEST(MovingLeastSquares, PointsThatDefineNoPlane)
{
  for (const std::vector<Vec3>& around :
    { std::vector<Vec3>(), std::vector<Vec3>(9, Vec3(0.0, 0.0, 0.0)),
      std::vector<Vec3>{ Vec3(0.0, 0.0, 0.0), Vec3(1.0, 2.0, 3.0), Vec3(2.0, 4.0, 6.0) },
      std::vector<Vec3>{ Vec3(0.0, 0.0, 0.0), Vec3(1e9, 0.0, 0.0), Vec3(0.0, 1e9, 0.0) } })
  {
    for (const double h : { 1.5, 0.0 })
    {
      const MovingFit fit = FitMovingSurface(around, h, 2, 5);
      EXPECT_TRUE(fit.Normal.isZero(0.0));
      EXPECT_TRUE(fit.Place.isZero(0.0));
    }
  }
}

TEST_F(ImplicitFivePoints, FitsOfTheWorkedExample)
{
  const Vec3 x = this->Points.Positions[0];
  const ImplicitValue first = this->Evaluate(x, 1);
  EXPECT_NEAR(first.Value, 0.060753, Digits);
  ExpectVector(first.Gradient, 0.065026, 0.109946, 0.869419);
  EXPECT_NEAR(first.Weight, 2.192052, Digits);
  const ImplicitValue second = this->Evaluate(x, 2);
  EXPECT_NEAR(second.Value, 0.051099, Digits);
  ExpectVector(second.Gradient, -0.048581, 0.107741, 0.954977);
  EXPECT_NEAR(second.Weight, 1.774222, Digits);
  const ImplicitValue third = this->Evaluate(x, 3);
  EXPECT_NEAR(third.Value, 0.052476, Digits);
  ExpectVector(third.Gradient, -0.056993, 0.108761, 0.961702);
  EXPECT_NEAR(third.Weight, 1.794299, Digits);
}

TEST_F(ImplicitFivePoints, FitsEndWhenTheGradientStays)
{
  const Vec3 x = this->Points.Positions[0];
  EXPECT_EQ(this->Evaluate(x, 3).Value, this->Evaluate(x, 30).Value);
}

TEST_F(ImplicitFivePoints, WithoutResiduals)
{
  this->Settings.ResidualScale = 0.0;
  const ImplicitValue third = this->Evaluate(this->Points.Positions[0], 3);
  EXPECT_NEAR(third.Value, 0.056994, Digits);
  ExpectVector(third.Gradient, -0.056505, 0.115804, 0.960444);
}

TEST_F(ImplicitFivePoints, TheFirstFitHasTheGradientOfItsValue)
{
  const Vec3 x(0.1, -0.05, 0.22);
  const Vec3 gradient = this->Evaluate(x, 1).Gradient;
  ExpectVector(gradient, 0.091969, 0.070344, 0.851039);
  constexpr double step = 1e-5;
  for (int k = 0; k < 3; ++k)
  {
    const Vec3 aside = step * Vec3::Unit(k);
    const double difference =
      this->Evaluate(x + aside, 1).Value - this->Evaluate(x - aside, 1).Value;
    EXPECT_NEAR(difference / (2.0 * step), gradient[k], 1e-9);
  }
}

TEST_F(ImplicitFivePoints, ProjectionsOfTheWorkedExample)
{
  ExpectVector(this->Projected(1).Positions[0], 0.003085, -0.005887, 0.147946);
  ExpectVector(this->Projected(2).Positions[0], 0.003178, -0.006066, 0.146347);
  ExpectVector(this->Projected(3).Positions[0], 0.003181, -0.006072, 0.146297);
}

TEST_F(ImplicitFivePoints, ProjectionsEndAtTheLimit)
{
  // The same balls, but projections end earlier or later.
  for (const double spacing : { 1.0, 1e-3 })
  {
    this->Points.Spacings.assign(5, spacing);
    this->Settings.FilterScale = std::sqrt(3.14159265358979323846) / spacing;
    const PointSet limit = this->Projected(15);
    const double tolerance = spacing < 1.0 ? Digits : 1e-5;
    EXPECT_NEAR(limit.Positions[0][2], 0.146296, tolerance);
    ExpectVector(limit.Normals[0], -0.057641, 0.111320, 0.992112, tolerance);
  }
}

TEST_F(ImplicitFivePoints, OutsideAllBallsThereIsNothing)
{
  EXPECT_EQ(this->Evaluate(Vec3(0.0, 0.0, 2.3), 3).Weight, 0.0);
  EXPECT_EQ(this->Evaluate(Vec3(100.0, 0.0, 0.0), 3).Weight, 0.0);
  // Just inside one: it alone tells.
  const ImplicitValue one = this->Evaluate(Vec3(2.9999999, 0.0, 0.1), 3);
  EXPECT_GT(one.Weight, 0.0);
  EXPECT_NEAR((one.Gradient - this->Points.Normals[1]).norm(), 0.0, 1e-12);
}
