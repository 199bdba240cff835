// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Moving robust PCA, tensor regions and likelihoods on clouds: against the textbook, without signs,
// on many threads, on clouds that have no surface.

#include "OddThreads.h"
#include "PlaneMethods.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace SurfaceDenoising;

namespace
{

class PlaneClouds : public testing::TestWithParam<PlaneMethod>
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

INSTANTIATE_TEST_SUITE_P(All, PlaneClouds, testing::ValuesIn(PlaneMethods()),
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
  for (const int limit : { 1, 2 })
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
