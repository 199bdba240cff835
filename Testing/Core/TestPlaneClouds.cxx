// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Moving robust PCA, tensor regions and likelihoods on clouds: against the textbook, without signs,
// on many threads, on clouds that have no surface.

#include "OddThreads.h"
#include "Points/PointDenoising.h"
#include "RandomClouds.h"
#include "TextbookPlanePoints.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace SurfaceDenoising;

namespace
{

/// A method, and the same by the textbook.
struct Method
{
  std::string Name;
  std::function<std::unique_ptr<PointOperator>()> Make;
  std::function<std::vector<int>(PlaneTextbook::Cloud&, const PlaneTextbook::Rows&)> Textbook;
  double Radius; ///< of the neighbourhood, in spacings; 0: the nearest points
  int Count;
};

Method PCA(const std::string& name, const MovingRobustPCASettings& s)
{
  return { name, [s] { return MakeMovingRobustPCA(s); },
    [s](PlaneTextbook::Cloud& cloud, const PlaneTextbook::Rows& rows)
    {
      PlaneTextbook::MovingRobustPCA(cloud, rows,
        { s.NormalAngle, s.Rounds, s.Regularization, s.Fidelity });
      return std::vector<int>();
    },
    0.0, 20 };
}

Method Regions(const std::string& name, const TensorRegionsSettings& s)
{
  return { name, [s] { return MakeTensorRegions(s); },
    [s](PlaneTextbook::Cloud& cloud, const PlaneTextbook::Rows& rows)
    {
      return PlaneTextbook::TensorRegions(cloud, rows,
        { s.Range, s.BendFactor, s.FeatureThreshold, s.RegionThreshold,
          static_cast<std::size_t>(s.LeastMembers), s.QuadricAtFeatures });
    },
    3.5, 25 };
}

Method Likelihood(const std::string& name, const LikelihoodPointsSettings& s)
{
  const double share = s.Scheme == PointScheme::OwnHeight ? 1.0
    : s.Scheme == PointScheme::NeighborHeight             ? 0.0
                                                          : 0.5;
  return { name, [s] { return MakeLikelihoodPoints(s); },
    [s, share](PlaneTextbook::Cloud& cloud, const PlaneTextbook::Rows& rows)
    {
      PlaneTextbook::Likelihoods(cloud, rows,
        { s.FeatureSharpening, s.LeastAngle, s.LikelihoodInNormals, share, s.Radius });
      return std::vector<int>();
    },
    s.Radius, 16 };
}

std::vector<Method> Methods()
{
  LikelihoodPointsSettings ball;
  ball.Radius = 3.0;
  ball.Scheme = PointScheme::OwnHeight;
  ball.LikelihoodInNormals = true;
  LikelihoodPointsSettings sharp;
  sharp.FeatureSharpening = 0.9;
  sharp.LeastAngle = 0.3;
  sharp.Scheme = PointScheme::NeighborHeight;
  TensorRegionsSettings other;
  other.Range = 3.0;
  other.BendFactor = 5.0;
  other.FeatureThreshold = 0.05;
  other.RegionThreshold = 0.8;
  other.LeastMembers = 7;
  other.QuadricAtFeatures = true;
  return { PCA("PCA", MovingRobustPCASettings()),
    PCA("NarrowPCA", { 0.1, 4, 0.05, 0.5 }), // many uniform patches
    Regions("Regions", TensorRegionsSettings()), Regions("OtherRegions", other),
    Likelihood("Likelihood", LikelihoodPointsSettings()), Likelihood("BallLikelihood", ball),
    Likelihood("SharpLikelihood", sharp) };
}

NeighborGraph Neighbors(const Method& method, const PointSet& points)
{
  Execution serial;
  return method.Radius > 0.0
    ? PointsWithinRadius(points.Positions, method.Radius * points.Spacing, method.Count, serial)
    : NearestPoints(points.Positions, method.Count, serial);
}

void RenewNeighbors(const Method& method, PointSet& points, PointOperator& filter)
{
  Execution serial;
  points.Neighbors = Neighbors(method, points);
  filter.Renew(points, serial);
}

/// A cloud with normals of plane fits and random signs, ready for an operator.
PointSet Prepare(Buffer<Vec3> positions, double spacing, bool localScale = false)
{
  Execution serial;
  std::mt19937 random(9);
  PointSet points;
  const NeighborGraph nearest = NearestPoints(positions, 16, serial);
  points.Normals = PlaneFitNormals(positions, nearest, 16, serial);
  for (Vec3& n : points.Normals)
  {
    n = random() % 2 == 0 ? n : Vec3(-n);
  }
  points.Spacing = spacing;
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    points.Spacings.push_back(
      localScale ? spacing * (0.8 + 0.4 * static_cast<double>(random() % 1000) / 1000.0) : spacing);
  }
  points.LocalScale = localScale;
  points.Start = points.Positions = std::move(positions);
  points.Status.assign(points.Size(), PointStatus::Filtered);
  return points;
}

struct Shape
{
  std::string Name;
  Buffer<Vec3> Positions;
  double Spacing;
};

std::vector<Shape> Shapes()
{
  std::vector<Shape> shapes = { { "Sphere", SpherePoints(500), 0.16 },
    { "Cube", CubePoints(9), 2.0 / 9.0 }, { "Wedge", WedgePoints(20, 12), 1.0 } };
  unsigned seed = 1;
  for (Shape& shape : shapes)
  {
    AddNoise(shape.Positions, 0.2 * shape.Spacing, seed++);
  }
  return shapes;
}

class PlaneClouds : public testing::TestWithParam<Method>
{
protected:
  /// Two outer iterations.
  PointSet Run(PointSet points, Execution& execution) const
  {
    const auto filter = GetParam().Make();
    for (int outer = 0; outer < 2; ++outer)
    {
      RenewNeighbors(GetParam(), points, *filter);
      EXPECT_TRUE(filter->Run(points, execution, 0.0, 1.0));
    }
    return points;
  }

  PointSet Run(PointSet points) const
  {
    Execution serial;
    return this->Run(std::move(points), serial);
  }
};

INSTANTIATE_TEST_SUITE_P(All, PlaneClouds, testing::ValuesIn(Methods()),
  [](const auto& method) { return method.param.Name; });

double LargestDifference(const Buffer<Vec3>& a, const std::vector<Vec3>& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < b.size(); ++i)
  {
    largest = std::max(largest, (a[i] - b[i]).norm());
  }
  return largest;
}

bool Identical(const Buffer<Vec3>& a, const Buffer<Vec3>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)) == 0;
}

}

TEST_P(PlaneClouds, AsInTheTextbook)
{
  for (const Shape& shape : Shapes())
  {
    for (const bool localScale : { false, true })
    {
      SCOPED_TRACE(shape.Name + (localScale ? ", local scale" : ""));
      Execution serial;
      PointSet points = Prepare(shape.Positions, shape.Spacing, localScale);
      PlaneTextbook::Cloud cloud{ { points.Positions.begin(), points.Positions.end() },
        { points.Normals.begin(), points.Normals.end() },
        { points.Spacings.begin(), points.Spacings.end() } };
      const auto filter = GetParam().Make();
      for (int outer = 0; outer < 2; ++outer)
      {
        RenewNeighbors(GetParam(), points, *filter);
        ASSERT_TRUE(filter->Run(points, serial, 0.0, 1.0));
        const std::vector<int> classes = GetParam().Textbook(cloud,
          GetParam().Radius > 0.0
            ? PlaneTextbook::Ball(cloud.Points, GetParam().Radius * shape.Spacing, GetParam().Count)
            : PlaneTextbook::Nearest(cloud.Points, GetParam().Count));
        EXPECT_LT(LargestDifference(points.Positions, cloud.Points), 1e-9 * shape.Spacing);
        EXPECT_LT(LargestDifference(points.Normals, cloud.Normals), 1e-9);
        EXPECT_GT(LargestDifference(points.Start, cloud.Points), 0.1 * shape.Spacing);
        ASSERT_EQ(points.Classes.size(), classes.size());
        for (std::size_t i = 0; i < classes.size(); ++i)
        {
          ASSERT_EQ(static_cast<int>(points.Classes[i]), classes[i]) << i;
        }
      }
    }
  }
}

TEST_P(PlaneClouds, SignsDoNotMatter)
{
  for (const Shape& shape : Shapes())
  {
    PointSet points = Prepare(shape.Positions, shape.Spacing);
    const PointSet first = this->Run(points);
    std::mt19937 random(4);
    std::vector<bool> turned;
    for (Vec3& n : points.Normals)
    {
      turned.push_back(random() % 2 == 0);
      n = turned.back() ? Vec3(-n) : n;
    }
    const PointSet second = this->Run(points);
    EXPECT_TRUE(Identical(first.Positions, second.Positions)) << shape.Name;
    for (std::size_t i = 0; i < turned.size(); ++i)
    {
      const Vec3 expected = turned[i] ? Vec3(-first.Normals[i]) : first.Normals[i];
      // Those of regions are on the side of another point.
      EXPECT_LT(
        std::min((second.Normals[i] - expected).norm(), (second.Normals[i] + expected).norm()),
        1e-15);
    }
  }
}

TEST_P(PlaneClouds, ThreadsDoNotMatter)
{
  OddThreads threads(5);
  for (const Shape& shape : Shapes())
  {
    const PointSet points = Prepare(shape.Positions, shape.Spacing, true);
    const PointSet serial = this->Run(points);
    const PointSet parallel = this->Run(points, threads);
    EXPECT_TRUE(Identical(serial.Positions, parallel.Positions)) << shape.Name;
    EXPECT_TRUE(Identical(serial.Normals, parallel.Normals)) << shape.Name;
    EXPECT_EQ(serial.Classes, parallel.Classes) << shape.Name;
  }
}

TEST_P(PlaneClouds, StopsWhenAsked)
{
  struct Impatient : Execution
  {
    bool Proceed(double) override { return ++this->Asked < this->Limit; }
    int Asked = 0;
    int Limit = 1;
  };
  const Shape shape = Shapes()[0];
  for (const int limit : { 1, 2, 3 })
  {
    PointSet points = Prepare(shape.Positions, shape.Spacing);
    const auto filter = GetParam().Make();
    RenewNeighbors(GetParam(), points, *filter);
    Impatient impatient;
    impatient.Limit = limit;
    EXPECT_FALSE(filter->Run(points, impatient, 0.0, 1.0));
    EXPECT_EQ(impatient.Asked, limit);
  }
}

TEST_P(PlaneClouds, CloudsWithoutSurface)
{
  std::mt19937 random(2);
  std::vector<Shape> shapes(7);
  shapes[0].Name = "One point";
  shapes[0].Positions = { Vec3(1.0, 2.0, 3.0) };
  shapes[1].Name = "Two points";
  shapes[1].Positions = { Vec3(0.0, 0.0, 0.0), Vec3(1.0, 0.0, 0.0) };
  for (int k = 0; k < 60; ++k)
  {
    const double t = 0.1 * k;
    shapes[2].Positions.push_back(Vec3(1.0, 2.0, 3.0));
    shapes[3].Positions.push_back(Vec3(t, 2.0 * t, -t));
    shapes[4].Positions.push_back(Vec3(k / 3 % 5, k / 15, 0.0)); // each three times
    shapes[5].Positions.push_back(Vec3(k % 8, k / 8, 0.0));
    shapes[6].Positions.push_back(1e-80 * Vec3(k % 8, k / 8, random() % 3));
  }
  for (std::size_t s = 0; s < shapes.size(); ++s)
  {
    for (const bool without : { false, true })
    {
      SCOPED_TRACE(std::to_string(s) + (without ? " without normals" : ""));
      PointSet points = Prepare(shapes[s].Positions, s == 6 ? 1e-80 : 1.0);
      if (without)
      {
        points.Normals.assign(points.Size(), Vec3(0.0, 0.0, 0.0));
      }
      const PointSet result = this->Run(points);
      for (std::size_t i = 0; i < result.Size(); ++i)
      {
        ASSERT_TRUE(result.Positions[i].allFinite() && result.Normals[i].allFinite()) << i;
        if (s < 4)
        {
          ASSERT_EQ(result.Positions[i], points.Positions[i]);
          ASSERT_EQ(result.Status[i], PointStatus::Kept);
        }
        if (s == 4 || s == 5)
        {
          ASSERT_LT((result.Positions[i] - points.Positions[i]).norm(), 1e-12);
        }
      }
    }
  }
}

/// Rows may be empty although the operator is asked.
TEST_P(PlaneClouds, NoNeighbors)
{
  const Shape shape = Shapes()[0];
  PointSet points = Prepare(shape.Positions, shape.Spacing);
  points.Neighbors.Offsets.assign(points.Size() + 1, 0);
  const auto filter = GetParam().Make();
  Execution serial;
  filter->Renew(points, serial);
  ASSERT_TRUE(filter->Run(points, serial, 0.0, 1.0));
  EXPECT_TRUE(Identical(points.Positions, points.Start));
  EXPECT_EQ(points.Status[0], PointStatus::Kept);
}
