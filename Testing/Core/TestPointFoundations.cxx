// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
// Worked numbers of what methods for point sets are made of.

#include "NormalFilter.h"
#include "PointFixtures.h"
#include "Points/PlaneFit.h"
#include "Points/PointNeighbors.h"
#include "Points/PointNormals.h"
#include "Points/PointPatches.h"
#include "Points/PointUpdate.h"
#include "SpatialOrder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace SurfaceDenoising;

namespace
{

constexpr double Digits = 1e-6;

void ExpectNear(const Vec3& found, const Vec3& expected, double tolerance = Digits)
{
  EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), tolerance)
    << found.transpose() << " instead of " << expected.transpose();
}

/// The engine on the five points: exp(-d^2 / sigma_d^2) exp(-|n_i - n_j|^2 / sigma^2).
class FivePointFilter
{
public:
  FivePointFilter(double sigmaD, double sigma, bool own, NormalArgument argument)
    : Points(FivePoints())
    , Filter(this->Points.Neighbors, Settings(sigmaD, sigma, own, argument))
  {
    Execution serial;
    this->Filter.SetGeometry({ this->Points.Positions, this->Ones, 1e-12 }, serial);
  }

  Vec3 MoveFirst(PointScheme scheme)
  {
    Execution serial;
    Buffer<Vec3> displacements;
    const Buffer<Vec3>& n = this->Points.Normals;
    PointUpdateSettings update;
    update.Scheme = scheme;
    ComputeDisplacements(this->Filter, { n, n, n, n }, this->Points.Positions, update,
      displacements, serial);
    return this->Points.Positions[0] + displacements[0];
  }

  PointSet Points;
  Buffer<double> Ones = Buffer<double>(5, 1.0);
  NormalFilter Filter;

private:
  static NormalFilterSettings Settings(double sigmaD, double sigma, bool own,
    NormalArgument argument)
  {
    NormalFilterSettings settings;
    settings.Norm = L2Norm{ 1.0 };
    if (sigma > 0.0)
    {
      settings.Norm = GaussianNorm{ sigma / std::sqrt(2.0) };
    }
    settings.Argument = argument;
    settings.SpatialSigma = sigmaD / std::sqrt(2.0);
    settings.Weighting = SiteWeight::Uniform;
    settings.IncludeOwn = own;
    return settings;
  }
};

}

TEST(PointFoundations, PlaneOfFivePoints)
{
  PlaneSum sum;
  for (const Vec3& p : FivePoints().Positions)
  {
    sum.Add(p);
  }
  const Plane plane = sum.Fit();
  ExpectNear(plane.Centre, Vec3(0.0, 0.0, 0.04));
  ExpectNear(plane.Variances, Vec3(0.008357, 0.4, 0.402043));
  const double sign = plane.Normal[2] < 0.0 ? -1.0 : 1.0;
  ExpectNear(sign * plane.Normal, Vec3(-0.050934, -0.050934, 0.997402));
}

TEST(PointFoundations, NoPlane)
{
  PlaneSum sum;
  EXPECT_TRUE(sum.Fit().Normal.isZero(0.0));
  sum.Add(Vec3(1.0, 2.0, 3.0));
  sum.Add(Vec3(1.0, 2.0, 3.0));
  EXPECT_TRUE(sum.Fit().Normal.isZero(0.0));
  for (int i = 0; i < 9; ++i)
  {
    sum.Add(Vec3(1.0, 2.0, 3.0) + 0.37 * i * Vec3(0.3, -0.7, 0.1));
  }
  EXPECT_TRUE(sum.Fit().Normal.isZero(0.0));
  EXPECT_TRUE(FitRobustPlane({}, {}, {}).Normal.isZero(0.0));
}

TEST(PointFoundations, RobustPlaneOfSixPoints)
{
  const std::vector<Vec3> points = { Vec3(1.0, 0.0, 0.1), Vec3(-1.0, 0.0, -0.1),
    Vec3(0.0, 1.0, 0.05), Vec3(0.0, -1.0, 0.05), Vec3(1.0, 1.0, 0.0), Vec3(-1.0, -1.0, 1.0) };
  const std::vector<double> weights(6, 1.0);
  const std::vector<std::pair<int, Vec3>> normals = { { 0, Vec3(0.093844, 0.224438, 0.969959) },
    { 1, Vec3(0.080775, 0.152147, 0.985052) }, { 2, Vec3(0.060752, 0.114292, 0.991588) },
    { 3, Vec3(0.044950, 0.095855, 0.994380) }, { 10, Vec3(0.031682, 0.082098, 0.996121) } };
  for (const auto& row : normals)
  {
    const Plane plane = FitRobustPlane(points, weights, { 0.01, row.first });
    ExpectNear(plane.Normal[2] < 0.0 ? Vec3(-plane.Normal) : plane.Normal, row.second);
  }
}

TEST(PointFoundations, GradientStep)
{
  ExpectNear(
    FivePointFilter(1.0, 0.5, false, NormalArgument::Chord).MoveFirst(PointScheme::Gradient),
    Vec3(0.003245, 0.007106, 0.102427));
  FivePointFilter plain(0.0, 0.0, false, NormalArgument::Chord);
  ExpectNear(plain.MoveFirst(PointScheme::Gradient), Vec3(-0.002388, 0.005593, 0.100163));

  // All normals upright: z and the energy fall in every step.
  Execution serial;
  plain.Points.Normals.assign(5, Vec3(0.0, 0.0, 1.0));
  const Buffer<Vec3>& n = plain.Points.Normals;
  Buffer<Vec3> d;
  ComputeDisplacements(plain.Filter, { n, n, n, n }, plain.Points.Positions, PointUpdateSettings(),
    d, serial);
  const std::vector<double> z = { 0.066667, 0.05, 0.033333, 0.033333, 0.016667 };
  for (std::size_t i = 0; i < 5; ++i)
  {
    EXPECT_NEAR(plain.Points.Positions[i][2] + d[i][2], z[i], Digits);
  }
}

TEST(PointFoundations, HeightsOnASphere)
{
  // Two points of a sphere of radius 3, an angle of 0.4 apart.
  Buffer<Vec3> positions = { 3.0 * Vec3(0.0, 0.0, 1.0),
    3.0 * Vec3(std::sin(0.4), 0.0, std::cos(0.4)) };
  const Buffer<Vec3> normals = { positions[0] / 3.0, positions[1] / 3.0 };
  Execution serial;
  const NeighborGraph graph = NearestPoints(positions, 1, serial);
  NormalFilterSettings settings;
  settings.Norm = L2Norm{ 1.0 };
  settings.Weighting = SiteWeight::Uniform;
  NormalFilter filter(graph, settings);
  const Buffer<double> ones(2, 1.0);
  filter.SetGeometry({ positions, ones, 1e-12 }, serial);
  const std::vector<std::pair<PointScheme, double>> rows = { { PointScheme::OwnHeight, -0.236817 },
    { PointScheme::NeighborHeight, 0.236817 }, { PointScheme::BalancedHeight, 0.0 } };
  for (const auto& row : rows)
  {
    PointUpdateSettings update;
    update.Scheme = row.first;
    Buffer<Vec3> d;
    ComputeDisplacements(filter, { normals, normals, normals, normals }, positions, update, d,
      serial);
    EXPECT_NEAR(d[0].dot(normals[0]), row.second, row.second == 0.0 ? 1e-15 : Digits);
  }
}

TEST(PointFoundations, BilateralHeights)
{
  // Upright normals, r = 1.5 and r' = 0.6: Gaussians of a third of them.
  const std::vector<std::pair<bool, double>> rows = { { true, 0.159377 }, { false, 0.026323 } };
  for (const auto& row : rows)
  {
    FivePointFilter filter(0.5 * std::sqrt(2.0), 0.2 * std::sqrt(2.0), row.first,
      NormalArgument::Height);
    filter.Points.Normals.assign(5, Vec3(0.0, 0.0, 1.0));
    ExpectNear(filter.MoveFirst(PointScheme::OwnHeight), Vec3(0.0, 0.0, row.second));
  }
}

TEST(PointFoundations, RollingNormals)
{
  FivePointFilter five(1.0, 0.5, true, NormalArgument::Chord);
  Execution serial;
  const Buffer<Vec3> data = five.Points.Normals;
  Buffer<Vec3> guide(5, Vec3(0.0, 0.0, 0.0));
  Buffer<Vec3> filtered;
  auto roll = [&]
  {
    five.Filter.Sweep({ data, guide, guide, data }, filtered, serial);
    guide = filtered;
  };
  roll();
  const std::vector<Vec3> first = { Vec3(0.170185, -0.015954, 0.985283),
    Vec3(0.207156, -0.015759, 0.978181), Vec3(0.023598, 0.047601, 0.998588),
    Vec3(0.018999, -0.113231, 0.993387), Vec3(0.774706, 0.007577, 0.632276) };
  for (std::size_t i = 0; i < 5; ++i)
  {
    ExpectNear(guide[i], first[i]);
  }
  roll();
  ExpectNear(guide[0], Vec3(0.043173, -0.014757, 0.998959));
  roll();
  ExpectNear(guide[0], Vec3(0.018412, -0.016493, 0.999694));
  ExpectNear(guide[4], Vec3(0.980060, 0.000013, 0.198701));
  five.Filter.Sweep(data, filtered, serial);
  ExpectNear(filtered[0], Vec3(0.015229, -0.014015, 0.999786));
}

TEST(PointFoundations, SpanningTreeOrientsNormals)
{
  const Buffer<Vec3> points = { Vec3(0.0, 0.0, 0.0), Vec3(1.0, 0.0, 0.1), Vec3(2.0, 0.0, 0.3),
    Vec3(3.0, 0.0, 0.2) };
  Buffer<Vec3> normals = { Vec3(0.0, 0.0, 1.0), Vec3(-0.1, 0.0, -1.0), Vec3(0.2, 0.0, -1.0),
    Vec3(0.0, 0.0, 1.0) };
  for (Vec3& n : normals)
  {
    n.normalize();
  }
  Execution serial;
  EXPECT_EQ(OrientNormals(points, NearestPoints(points, 3, serial), normals, serial, 0.0), 1u);
  for (const Vec3& n : normals)
  {
    EXPECT_GT(n[2], 0.0);
  }
}

TEST(PointFoundations, PartsPointOutwards)
{
  Buffer<Vec3> points;
  Buffer<Vec3> normals;
  Buffer<Vec3> outwards;
  for (const double x : { 0.0, 10.0 })
  {
    for (int i = 0; i < 200; ++i)
    {
      const double z = 1.0 - (2.0 * i + 1.0) / 200.0;
      const double r = std::sqrt(1.0 - z * z);
      const Vec3 n(r * std::cos(2.4 * i), r * std::sin(2.4 * i), z);
      points.push_back(n + Vec3(x, 0.0, 0.0));
      outwards.push_back(n);
      normals.push_back(i % 3 == 0 ? n : Vec3(-n));
    }
  }
  Execution serial;
  EXPECT_EQ(OrientNormals(points, NearestPoints(points, 8, serial), normals, serial, 0.0), 2u);
  EXPECT_EQ(normals, outwards);
}

TEST(PointFoundations, SpacingOfAGrid)
{
  Buffer<Vec3> points;
  for (int i = 0; i < 30; ++i)
  {
    for (int j = 0; j < 30; ++j)
    {
      points.push_back(Vec3(2.0 * i, 2.0 * j, 0.0));
    }
  }
  Execution serial;
  const NeighborGraph nearest = NearestPoints(points, 20, serial);
  const Buffer<double> spacings = PointSpacings(points, nearest, serial);
  // The 16th nearest point of a square grid is at sqrt(5) spacings.
  EXPECT_NEAR(spacings[15 * 30 + 15], 2.0 * std::sqrt(5.0 * 3.14159265358979323846 / 16.0), 1e-12);
}

TEST(PointFoundations, FirstNeighborsAndBalls)
{
  const PointSet five = FivePoints();
  Execution serial;
  const NeighborGraph two = FirstNeighbors(five.Neighbors, 2, serial);
  for (std::size_t i = 0; i < 5; ++i)
  {
    ASSERT_EQ(two.Row(i).size(), 2u);
    EXPECT_EQ(two.Row(i)[1], five.Neighbors.Row(i)[1]);
  }
  const NeighborGraph ball = PointsWithinRadius(five.Positions, 1.02, 100, serial);
  EXPECT_EQ(std::vector<Index>(ball.Row(0).begin(), ball.Row(0).end()),
    (std::vector<Index>{ 1, 2, 3 }));
  EXPECT_EQ(PointsWithinRadius(five.Positions, 1.02, 2, serial).Row(0).size(), 2u);
}

TEST(PointFoundations, OrderIsThatOfPlaces)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Buffer<Vec3> points = { Vec3(1.0, 1.0, 1.0), Vec3(0.0, 0.0, 0.0), Vec3(nan, 0.0, 0.0),
    Vec3(1.0, 0.0, 0.0), Vec3(1.0, 1.0, 1.0) };
  const Buffer<Vec3> vectors = { Vec3(1.0, 0.0, 0.0), Vec3(0.0, 0.0, 0.0), Vec3(0.0, 0.0, 0.0),
    Vec3(0.0, 0.0, 0.0), Vec3(0.0, 0.0, 0.0) };
  Execution serial;
  EXPECT_EQ(FindPointOrder(points, vectors, serial), (Buffer<Index>{ 1, 3, 4, 0 }));
  EXPECT_EQ(FindPointOrder(points, {}, serial), (Buffer<Index>{ 1, 3, 0, 4 }));
  EXPECT_TRUE(FindPointOrder({}, {}, serial).empty());
}

TEST(PointFoundations, PatchesWithTheLeastDifferencesGuide)
{
  Buffer<Vec3> normals = { Vec3(0.0, 0.0, 1.0), Vec3(0.1, 0.0, 1.0), Vec3(0.0, 0.1, 1.0),
    Vec3(1.0, 0.0, 0.0) };
  for (Vec3& n : normals)
  {
    n.normalize();
  }
  NeighborGraph graph;
  graph.Offsets = { 0, 2, 4, 6, 8 };
  graph.Ids = { 1, 2, 0, 3, 0, 1, 0, 1 };
  Execution serial;
  Buffer<Vec3> guidance;
  ComputePointPatches(graph, normals, { 2, 0.7, false }, guidance, serial);
  ExpectNear(guidance[0], Vec3(0.033241, 0.033241, 0.998894));
  // The patch of point 1 mixes two faces: it takes that of point 0.
  ExpectNear(guidance[1], Vec3(0.033241, 0.033241, 0.998894));
  // Nobody around agrees with point 3: its own patch is all it has.
  ExpectNear(guidance[3], Vec3(0.482671, 0.0, 0.875802));
}
