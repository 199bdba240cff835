// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Worked numbers of moving robust PCA, tensor regions and likelihoods, and their parts.

#include "PointFixtures.h"
#include "Points/LikelihoodPoints.h"
#include "Points/MovingRobustPCA.h"
#include "Points/NormalTensor.h"
#include "Points/RowPlanes.h"
#include "SymmetricEigen.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace SurfaceDenoising;

namespace
{

constexpr double Digits = 1e-6; // the numbers are printed with six
constexpr double Pi = 3.14159265358979323846;

void ExpectNear(const Vec3& actual, const Vec3& expected, double tolerance = Digits)
{
  EXPECT_LT((actual - expected).cwiseAbs().maxCoeff(), tolerance)
    << actual.transpose() << " instead of " << expected.transpose();
}

/// M6: five points near a plane and one that is not.
std::vector<Vec3> SixPoints()
{
  return { Vec3(1.0, 0.0, 0.1), Vec3(-1.0, 0.0, -0.1), Vec3(0.0, 1.0, 0.05), Vec3(0.0, -1.0, 0.05),
    Vec3(1.0, 1.0, 0.0), Vec3(-1.0, -1.0, 1.0) };
}

double SumOfDistances(const std::vector<Vec3>& points, const Plane& plane)
{
  double sum = 0.0;
  for (const Vec3& p : points)
  {
    sum += std::abs(plane.HeightOf(p));
  }
  return sum;
}

/// The weights of a row, that of the point itself first.
std::vector<double> RowWeights(const NormalFilter& filter, const Buffer<Vec3>& centre,
  const Buffer<Vec3>& normals, std::size_t row)
{
  std::vector<double> found;
  Execution serial;
  filter.VisitWeights({ normals, centre, normals, normals }, serial,
    [&](std::size_t i, const double* weights)
    {
      if (i == row)
      {
        found.assign(weights, weights + filter.Neighbors().Row(i).size() + 1);
      }
    });
  return found;
}

void ExpectWeights(const std::vector<double>& actual, const std::vector<double>& expected)
{
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t k = 0; k < actual.size(); ++k)
  {
    EXPECT_NEAR(actual[k], expected[k], Digits) << k;
  }
}

NormalFilterSettings ArcSettings(double sigma, double c)
{
  NormalFilterSettings settings;
  settings.Norm = GaussianNorm{ sigma / std::sqrt(2.0) };
  settings.Argument = NormalArgument::BentArc;
  settings.BendFactor = c;
  settings.Weighting = SiteWeight::Uniform;
  settings.IncludeOwn = true;
  settings.Unoriented = true;
  return settings;
}

}

TEST(PlanePoints, LeastAxis)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int k = 0; k < 2000; ++k)
  {
    Mat3 root;
    for (int e = 0; e < 9; ++e)
    {
      root.data()[e] = any(random);
    }
    // Flat ones, lines, and anything between, of all sizes.
    root.col(0) *= std::pow(10.0, 4.0 * any(random) - 4.0);
    root.col(1) *= std::pow(10.0, 2.0 * any(random) - 2.0);
    const Mat3 a = std::pow(10.0, 20.0 * any(random)) * (root * root.transpose());
    const LeastAxis fast = FindLeastAxis(a);
    const Eigensystem full = Decompose(a);
    const double gap = (full.Values[1] - full.Values[0]) / a.trace();
    EXPECT_LT(fast.Vector.cross(full.Vectors.col(0)).norm() * gap, 5e-15);
    EXPECT_NEAR(fast.Vector.norm(), 1.0, 1e-14);
    EXPECT_NEAR(fast.Values[0] / a.trace(), full.Values[0] / a.trace(), 5e-15);
    EXPECT_NEAR(fast.Values[1] / a.trace(), full.Values[1] / a.trace(), 1e-8);
    EXPECT_NEAR(fast.Values.sum() / a.trace(), 1.0, 5e-15);
  }
}

TEST(PlanePoints, LeastAxisOfDegenerateMatrices)
{
  const Mat3 line = Vec3(1.0, 2.0, 3.0) * Vec3(1.0, 2.0, 3.0).transpose();
  for (const Mat3& a :
    { Mat3(Mat3::Zero()), Mat3(Mat3::Identity()), line, Mat3(line + 1e-17 * Mat3::Identity()) })
  {
    const LeastAxis axis = FindLeastAxis(a);
    EXPECT_NEAR(axis.Vector.norm(), 1.0, 1e-14);
    EXPECT_LT((a * axis.Vector - axis.Values[0] * axis.Vector).norm(), 1e-13);
    EXPECT_NEAR(axis.Values.sum(), a.trace(), 1e-13);
  }
}

TEST(PlanePoints, Axes)
{
  PlaneSum line;
  PlaneSum flat;
  for (int k = -3; k <= 3; ++k)
  {
    line.Add(Vec3(k, 2.0 * k, 0.0));
    flat.Add(Vec3(k, 2.0 * k, 0.0));
    flat.Add(Vec3(0.2 * k, -0.1 * k, 0.0));
  }
  EXPECT_TRUE(line.Fit().Normal.isZero(0.0));
  EXPECT_TRUE(line.FitAxes().Normal.isZero(0.0));
  EXPECT_NEAR(std::abs(line.FitAxes().Along.dot(Vec3(1.0, 2.0, 0.0))), std::sqrt(5.0), 1e-12);
  EXPECT_NEAR(std::abs(flat.Fit().Normal[2]), 1.0, 1e-15);
  EXPECT_NEAR(std::abs(flat.FitAxes().Normal[2]), 1.0, 1e-15);
  EXPECT_LT((flat.Fit().Variances - flat.FitAxes().Variances).norm(), 1e-13);
}

TEST(PlanePoints, Transpose)
{
  CompressedRows rows;
  rows.Offsets = { 0, 2, 2, 5, 6 };
  rows.Ids = { 4, 1, 0, 1, 3, 1 };
  const CompressedRows columns = Transpose(rows, 5);
  EXPECT_EQ(columns.Offsets, (Buffer<std::uint64_t>{ 0, 1, 4, 4, 5, 6 }));
  EXPECT_EQ(columns.Ids, (Buffer<Index>{ 2, 0, 2, 3, 2, 0 }));
  EXPECT_EQ(Transpose(CompressedRows(), 2).NumberOfRows(), 2u);
}

TEST(PlanePoints, RobustPlaneOfSixPoints)
{
  const std::vector<Vec3> points = SixPoints();
  struct Round
  {
    int Rounds;
    Vec3 Centre;
    Vec3 Normal;
    double Sum;
  };
  const Round rounds[] = {
    { 0, Vec3(0.0, 0.0, 0.183333), Vec3(0.093844, 0.224438, 0.969959), 1.444865 },
    { 1, Vec3(0.774909, 0.124329, 0.099783), Vec3(0.080775, 0.152147, 0.985052), 1.289345 },
    { 2, Vec3(0.659914, 0.345507, 0.080607), Vec3(0.060752, 0.114292, 0.991588), 1.220977 },
    { 3, Vec3(0.584010, 0.579150, 0.060084), Vec3(0.044950, 0.095855, 0.994380), 1.193256 },
    { 10, Vec3(0.624769, 0.616698, 0.052118), Vec3(0.031682, 0.082098, 0.996121), 1.195345 },
  };
  for (const Round& round : rounds)
  {
    const Plane plane = FitRobustPlane(points, std::vector<double>(6, 1.0), { 0.01, round.Rounds });
    ExpectNear(plane.Centre, round.Centre);
    ExpectNear(plane.Normal[2] < 0.0 ? Vec3(-plane.Normal) : plane.Normal, round.Normal);
    EXPECT_NEAR(SumOfDistances(points, plane), round.Sum, Digits);
  }
}

TEST(PlanePoints, TrustOfSixPoints)
{
  const std::vector<Vec3> points = SixPoints();
  const Plane plane = FitRobustPlane(points, std::vector<double>(6, 1.0), { 0.01, 10 });
  const double sign = plane.Normal[2] < 0.0 ? -1.0 : 1.0;
  const double expected[] = { 0.008955, -0.253634, 0.009565, -0.154631, -0.008559, 0.760001 };
  Buffer<double> residuals;
  for (std::size_t j = 0; j < points.size(); ++j)
  {
    residuals.push_back(plane.HeightOf(points[j]));
    EXPECT_NEAR(sign * residuals[j], expected[j], Digits);
  }
  ExpectNear(points[0] - residuals[0] * plane.Normal, Vec3(0.999716, -0.000735, 0.091080));
  const double limit = TrustLimit(residuals, 0.01);
  EXPECT_NEAR(limit, 0.365155, Digits);
  EXPECT_NEAR(0.760001 - limit, 0.394846, 2.0 * Digits);

  Buffer<double> small = { 1e-5, -1e-5, 1e-6 };
  EXPECT_EQ(TrustLimit(small, 0.01), 0.01);
}

TEST(PlanePoints, WeightsBySimilarNormals)
{
  const PointSet points = FivePoints();
  NormalFilter filter(points.Neighbors, WeightsBySimilarNormals(Pi / 8.0));
  const Buffer<double> ones(5, 1.0);
  Execution serial;
  filter.SetGeometry({ points.Positions, ones, 0.0 }, serial);
  ExpectWeights(RowWeights(filter, points.Normals, points.Normals, 0),
    { 1.0, 0.776724, 0.879864, 0.776724, 0.000005 });
}

TEST(PlanePoints, PatchesOfFewCountTheSame)
{
  const PointSet points = FivePoints();
  const std::vector<double> four = { 1.0, 0.5, 0.002, 0.0011, 0.0 };
  const std::vector<double> three = { 1.0, 0.5, 0.002, 0.0009, 0.0 };
  WeightedPatch patch;
  patch.Take(points.Positions, 2, points.Neighbors.Row(2), four.data());
  EXPECT_FALSE(patch.Uniform);
  EXPECT_EQ(patch.Weights, four);
  EXPECT_EQ(patch.Points[0], Vec3(0.0, 0.0, 0.0));
  EXPECT_EQ(patch.Points[3], points.Positions[points.Neighbors.Row(2)[2]] - points.Positions[2]);
  patch.Take(points.Positions, 2, points.Neighbors.Row(2), three.data());
  EXPECT_TRUE(patch.Uniform);
  EXPECT_EQ(patch.Weights, std::vector<double>(5, 1.0));
}

TEST(PlanePoints, TensorsOfNormals)
{
  const PointSet five = FivePoints();
  NormalFilterSettings settings;
  settings.Norm = L2Norm{ 1.0 };
  NormalFilter filter(five.Neighbors, settings);
  const std::vector<double> halves(4, 0.5);
  const Vec3 x(1.0, 0.0, 0.0);
  const Vec3 y(0.0, 1.0, 0.0);
  const Vec3 z(0.0, 0.0, 1.0);
  const Vec3 none(0.0, 0.0, 0.0);
  auto values = [&](const Buffer<Vec3>& normals)
  { return NormalTensorValues(filter, normals, 0, halves.data()); };
  ExpectNear(values({ x, z, z, -z, z }), Vec3(1.0, 0.0, 0.0), 1e-12);
  ExpectNear(values({ y, z, x, -z, x }), Vec3(0.5, 0.5, 0.0), 1e-12);
  ExpectNear(values({ y, z, x, -y, none }), Vec3(1.0, 1.0, 1.0) / 3.0, 1e-12);
  ExpectNear(values({ y, z, z, (x + z).normalized(), (x + z).normalized() }),
    Vec3(0.853553, 0.146447, 0.0));
  ExpectNear(values({ y, none, none, none, none }), none, 1e-12);
  EXPECT_NEAR(FeatureIntensity(Vec3(0.854017, 0.139128, 0.006855)), 0.218975, Digits);
}

TEST(PlanePoints, ArcsOfFivePoints)
{
  const PointSet points = FivePoints();
  const double delta = 1.018723;
  NormalFilter filter(points.Neighbors, ArcSettings(4.0 * delta, 11.198431 * std::pow(delta, 4)));
  const Buffer<double> ones(5, 1.0);
  Execution serial;
  filter.SetGeometry({ points.Positions, ones, 1e-9 }, serial);
  std::vector<double> weights = RowWeights(filter, points.Normals, points.Normals, 0);
  ExpectWeights(weights, { 1.0, 0.914887, 0.926355, 0.913966, 0.317144 });
  weights[0] = 0.0; // the numbers are those without the point itself
  const Vec3 values = NormalTensorValues(filter, points.Normals, 0, weights.data());
  ExpectNear(values, Vec3(0.875805, 0.110709, 0.013486));
  EXPECT_NEAR(values[0] - values[1], 0.765096, Digits);
  EXPECT_NEAR(values[1] - values[2], 0.097222, Digits);
}

/// Two points of a circle of radius 2, 60 degrees apart.
TEST(PlanePoints, ArcOfCircle)
{
  const Buffer<Vec3> normals = { Vec3(1.0, 0.0, 0.0), Vec3(0.5, std::sqrt(0.75), 0.0) };
  const Buffer<Vec3> positions = { 2.0 * normals[0], 2.0 * normals[1] };
  NeighborGraph graph;
  graph.Offsets = { 0, 1, 2 };
  graph.Ids = { 1, 0 };
  const Buffer<double> ones(2, 1.0);
  Execution serial;
  for (const auto& expected : { std::make_pair(11.198431, 0.638182),
         std::make_pair(4.863417, 0.704585), std::make_pair(0.0, 0.760214) })
  {
    NormalFilter filter(graph, ArcSettings(4.0, expected.first));
    filter.SetGeometry({ positions, ones, 1e-9 }, serial);
    ExpectWeights(RowWeights(filter, normals, normals, 0), { 1.0, expected.second });
  }
}

TEST(PlanePoints, LikelihoodsOfFivePoints)
{
  PointSet points = FivePoints();
  // The neighbours less than 2 away, for the radius 2.
  points.Neighbors.Offsets = { 0, 4, 7, 10, 13, 16 };
  points.Neighbors.Ids = { 1, 2, 3, 4, 0, 3, 4, 0, 3, 4, 0, 1, 2, 0, 1, 2 };
  LikelihoodPointsSettings settings;
  settings.Radius = 2.0;
  settings.Scheme = PointScheme::OwnHeight;
  const auto filter = MakeLikelihoodPoints(settings);
  Execution serial;
  filter->Renew(points, serial);
  EXPECT_TRUE(filter->Run(points, serial, 0.0, 1.0));
  ExpectNear(points.Normals[0], Vec3(0.015277, -0.014183, 0.999783));
  ExpectNear(points.Positions[0], Vec3(-0.001930, 0.001792, 0.073684));
}
