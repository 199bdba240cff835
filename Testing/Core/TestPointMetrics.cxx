// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CompareMeshes.h"
#include "LineAngles.h"
#include "PointMetrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace SurfaceDenoising;

namespace
{

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

Execution Serial;

Buffer<double> Values(std::initializer_list<double> values)
{
  return Buffer<double>(values.begin(), values.end());
}

Buffer<Vec3> RandomPoints(std::size_t count, std::uint32_t seed)
{
  PortableRandom random(seed);
  Buffer<Vec3> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    points.push_back(random.Uniform() * random.Direction());
  }
  return points;
}

PointSetDistances Compare(const Buffer<Vec3>& points, const Buffer<Vec3>& reference)
{
  return ComparePointSets(FindNearestPoints(reference, points, Serial).Distances,
    FindNearestPoints(points, reference, Serial).Distances, Serial);
}

/// The formulas without a tree.
PointSetDistances TryAll(const Buffer<Vec3>& points, const Buffer<Vec3>& reference)
{
  auto nearest = [](const Vec3& p, const Buffer<Vec3>& set)
  {
    double best = Infinity;
    for (const Vec3& q : set)
    {
      best = std::min(best, (p - q).norm());
    }
    return best;
  };
  PointSetDistances all{ 0.0, 0.0, 0.0, 0.0, 0.0 };
  for (const Vec3& p : points)
  {
    const double d = nearest(p, reference);
    all.Chamfer += 0.5 * d / static_cast<double>(points.size());
    all.SquaredChamfer += d * d / static_cast<double>(points.size());
    all.ToReference = std::max(all.ToReference, d);
  }
  for (const Vec3& q : reference)
  {
    const double d = nearest(q, points);
    all.Chamfer += 0.5 * d / static_cast<double>(reference.size());
    all.SquaredChamfer += d * d / static_cast<double>(reference.size());
    all.FromReference = std::max(all.FromReference, d);
  }
  all.Hausdorff = std::max(all.ToReference, all.FromReference);
  return all;
}

void ExpectNear(const PointSetDistances& a, const PointSetDistances& b)
{
  EXPECT_NEAR(a.Chamfer, b.Chamfer, 1e-14);
  EXPECT_NEAR(a.SquaredChamfer, b.SquaredChamfer, 1e-14);
  EXPECT_NEAR(a.ToReference, b.ToReference, 1e-14);
  EXPECT_NEAR(a.FromReference, b.FromReference, 1e-14);
  EXPECT_NEAR(a.Hausdorff, b.Hausdorff, 1e-14);
}

}

TEST(PointMetrics, PointsAgainstTheCornersOfASquare)
{
  const Buffer<Vec3> points{ Vec3(0.0, 0.0, 0.1), Vec3(1.0, 0.0, -0.2), Vec3(0.0, 1.0, 0.05) };
  const Buffer<Vec3> square{ Vec3(0.0, 0.0, 0.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0),
    Vec3(1.0, 1.0, 0.0) };
  const NearestElements there = FindNearestPoints(square, points, Serial);
  EXPECT_EQ(there.Numbers, (Buffer<Index>{ 0, 1, 2 }));
  const NearestElements back = FindNearestPoints(points, square, Serial);
  EXPECT_EQ(back.Numbers, (Buffer<Index>{ 0, 1, 2, 2 }));
  EXPECT_NEAR(back.Distances[3], 1.001249, 1e-6);

  const PointSetDistances distances = Compare(points, square);
  EXPECT_NEAR(distances.Chamfer, 0.227239, 1e-6);
  EXPECT_NEAR(distances.SquaredChamfer, 0.281250, 1e-6);
  EXPECT_NEAR(distances.ToReference, 0.2, 1e-6);
  EXPECT_NEAR(distances.FromReference, 1.001249, 1e-6);
  EXPECT_NEAR(distances.Hausdorff, 1.001249, 1e-6);
}

TEST(PointMetrics, TreesFindWhatTryingAllFinds)
{
  const Buffer<Vec3> points = RandomPoints(300, 5);
  const Buffer<Vec3> reference = RandomPoints(200, 6);
  const PointSetDistances distances = Compare(points, reference);
  ExpectNear(distances, TryAll(points, reference));
  EXPECT_GT(std::abs(distances.ToReference - distances.FromReference), 1e-3);
}

TEST(PointMetrics, PointsThatAreNowhereDoNotCount)
{
  Buffer<Vec3> points = RandomPoints(30, 5);
  Buffer<Vec3> reference = RandomPoints(20, 6);
  const PointSetDistances expected = TryAll(points, reference);
  points.insert(points.begin(), Vec3(NotANumber, 0.0, 0.0));
  points.push_back(Vec3(0.0, -Infinity, 0.0));
  points.push_back(Vec3(0.0, 0.0, 1e150));
  reference.insert(reference.begin(), Vec3(1e200, 0.0, 0.0));
  reference.insert(reference.begin(), Vec3(1e101, 0.0, 0.0));
  ExpectNear(Compare(points, reference), expected);
  const NearestElements nearest = FindNearestPoints(reference, points, Serial);
  EXPECT_EQ(nearest.Numbers[0], NoIndex);
  EXPECT_EQ(nearest.Numbers[31], NoIndex);
  EXPECT_EQ(nearest.Numbers[32], NoIndex);
  EXPECT_TRUE(std::isnan(nearest.Distances[0]));
  EXPECT_GE(nearest.Numbers[1], 2u) << "numbers are those of all points";
}

TEST(PointMetrics, EmptySetsHaveNoDistance)
{
  const Buffer<Vec3> points = RandomPoints(3, 5);
  const Buffer<Vec3> nowhere{ Vec3(0.0, 0.0, NotANumber), Vec3(1e101, 0.0, 0.0) };
  for (const PointSetDistances& distances : { Compare(points, {}), Compare({}, points),
         Compare({}, {}), Compare(nowhere, points), Compare(points, nowhere) })
  {
    EXPECT_TRUE(std::isnan(distances.Chamfer));
    EXPECT_TRUE(std::isnan(distances.SquaredChamfer));
    EXPECT_TRUE(std::isnan(distances.ToReference));
    EXPECT_TRUE(std::isnan(distances.FromReference));
    EXPECT_TRUE(std::isnan(distances.Hausdorff));
  }
}

TEST(PointMetrics, Variation)
{
  EXPECT_NEAR(Variation(Values({ 1.0, 1.0, 1.2, 0.8 }), Serial), 0.141421, 1e-6);
  EXPECT_NEAR(Variation(Values({ 10.0, NotANumber, 10.0, 12.0, 8.0 }), Serial), 0.141421, 1e-6);
  EXPECT_EQ(Variation(Values({ 3.0, 3.0 }), Serial), 0.0);
  EXPECT_EQ(Variation(Values({ 3.0 }), Serial), 0.0);
  EXPECT_TRUE(std::isnan(Variation(Values({ 0.0, 0.0 }), Serial)));
  EXPECT_TRUE(std::isnan(Variation(Values({ -1.0, 1.0 }), Serial)));
  EXPECT_TRUE(std::isnan(Variation(Values({ NotANumber }), Serial)));
  EXPECT_TRUE(std::isnan(Variation({}, Serial)));
}

TEST(PointMetrics, NearestSpacings)
{
  const Vec3 x(1.0, 0.0, 0.0);
  const Buffer<Vec3> points{ 0.0 * x, 1.0 * x, 3.0 * x, NotANumber * x, 7.0 * x, 1e150 * x };
  const Buffer<double> spacings = NearestSpacings(points, Serial);
  ASSERT_EQ(spacings.size(), 6u);
  EXPECT_EQ(spacings[0], 1.0);
  EXPECT_EQ(spacings[1], 1.0);
  EXPECT_EQ(spacings[2], 2.0);
  EXPECT_TRUE(std::isnan(spacings[3]));
  EXPECT_EQ(spacings[4], 4.0);
  EXPECT_TRUE(std::isnan(spacings[5]));

  EXPECT_EQ(NearestSpacings({ x, x, x, 2.0 * x }, Serial), Values({ 0.0, 0.0, 0.0, 1.0 }));
  EXPECT_TRUE(std::isnan(NearestSpacings({ x }, Serial)[0]));
  EXPECT_TRUE(NearestSpacings({}, Serial).empty());
}

TEST(PointNormals, AngleBetweenLines)
{
  const Vec3 z(0.0, 0.0, 1.0);
  auto degrees = [&](double x, double y, double height)
  { return AngleBetweenLines(Vec3(x, y, height), z).Degrees; };
  auto flipped = [&](double x, double y, double height)
  { return AngleBetweenLines(Vec3(x, y, height), z).Flipped; };
  EXPECT_EQ(degrees(0.0, 0.0, -1.0), 0.0);
  EXPECT_NEAR(degrees(0.1, 0.0, 1.0), 5.710593, 1e-6);
  EXPECT_DOUBLE_EQ(degrees(1.0, 0.0, -1.0), 45.0);
  EXPECT_DOUBLE_EQ(degrees(0.0, 3.0, 0.0), 90.0);
  EXPECT_TRUE(flipped(1.0, 0.0, -1.0));
  EXPECT_FALSE(flipped(1.0, 0.0, 1.0));
  EXPECT_FALSE(flipped(0.0, 3.0, 0.0));
  // Small angles keep their digits whichever way the normal points.
  const double tiny = 1e-9 * 180.0 / std::acos(-1.0);
  EXPECT_NEAR(degrees(1e-9, 0.0, -1.0), tiny, 1e-20);
  EXPECT_TRUE(std::isnan(degrees(0.0, 0.0, 0.0)));
}

TEST(PointNormals, Summary)
{
  LineAngles angles;
  angles.Degrees = Values({ 0.0, 10.0, NotANumber, 20.0, 6.0 });
  angles.Flipped.assign({ 1, 0, 1, 1, 0 });
  const LineAngleSummary summary = Summarize(angles, Serial);
  EXPECT_DOUBLE_EQ(summary.Mean, 9.0);
  EXPECT_DOUBLE_EQ(summary.RootMeanSquare, std::sqrt(536.0 / 4.0));
  EXPECT_DOUBLE_EQ(summary.ShareWithin10, 0.5) << "10 degrees are not below 10";
  EXPECT_EQ(summary.Flipped, 2.0);
  const LineAngleSummary none = Summarize(LineAngles(), Serial);
  EXPECT_TRUE(std::isnan(none.Mean) && std::isnan(none.RootMeanSquare));
  EXPECT_TRUE(std::isnan(none.ShareWithin10) && std::isnan(none.Flipped));
}

TEST(PointNormals, AgainstPoints)
{
  const Buffer<Vec3> normals{ Vec3(0.0, 0.0, -1.0), Vec3(0.1, 0.0, 1.0), Vec3(1.0, 0.0, 1.0),
    Vec3(0.0, 0.0, 1.0) };
  const Buffer<Vec3> expected{ Vec3(1.0, 0.0, 0.0), Vec3(0.0, 0.0, 1.0) };
  const LineAngles angles = CompareWithPoints(normals, { 1, 1, 1, NoIndex }, expected, Serial);
  EXPECT_TRUE(std::isnan(angles.Degrees[3]));
  const LineAngleSummary summary = Summarize(angles, Serial);
  EXPECT_NEAR(summary.Mean, 16.903531, 1e-6);
  EXPECT_NEAR(summary.RootMeanSquare, 26.189125, 1e-6);
  EXPECT_NEAR(summary.ShareWithin10, 0.666667, 1e-6);
  EXPECT_EQ(summary.Flipped, 1.0);
}
