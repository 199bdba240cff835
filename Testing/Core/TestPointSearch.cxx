// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// The search in runs of ordered points finds what a search tree finds, to the order of ties.

#include "KdTree.h"
#include "OddThreads.h"
#include "Points/PointNeighbors.h"
#include "Points/PointRuns.h"
#include "SpatialOrder.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

using namespace SurfaceDenoising;

namespace
{

enum class Shape
{
  Sheet,    ///< noisy, with outliers far and near
  Grid,     ///< full of ties
  Uneven,   ///< densities that differ by a million
  Doubled,  ///< every place twice
  Line,     ///< no area
  OnePlace, ///< all points coincide
  TwoHeaps,
  Unseen, ///< a sheet, a third of whose points are in one place and another third near it
};

Buffer<Vec3> MakePoints(Shape shape, std::size_t count)
{
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> even(-1.0, 1.0);
  Buffer<Vec3> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double a = even(generator);
    const double b = even(generator);
    const double c = even(generator);
    switch (shape)
    {
      case Shape::Sheet:
        points.push_back(i % 40 == 0 ? Vec3(a, 20.0 * b, c) : Vec3(a, b, 0.01 * c));
        break;
      case Shape::Grid:
        points.push_back(Vec3(double(i % 16), double(i / 16 % 16), double(i / 256)));
        break;
      case Shape::Uneven:
        points.push_back(std::pow(10.0, 6.0 * b) * Vec3(a, c, 0.0));
        break;
      case Shape::Doubled:
        points.push_back(i % 2 == 1 ? points.back() : Vec3(a, b, c));
        break;
      case Shape::Line:
        points.push_back(Vec3(a, 0.0, 0.0));
        break;
      case Shape::OnePlace:
        points.push_back(Vec3(1.0, 2.0, 3.0));
        break;
      case Shape::TwoHeaps:
        points.push_back(i % 3 == 0 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 0.0, 0.0));
        break;
      case Shape::Unseen:
        points.push_back(double(i % 3 > 0 ? 1e-3 * double(i % 3 - 1) : 1.0) * Vec3(a, b, 0.01 * c));
        break;
    }
  }
  return points;
}

Buffer<Vec3> Ordered(const Buffer<Vec3>& points, Execution& execution)
{
  Buffer<Index> order = FindPointOrder(points, {}, execution);
  FormRuns(points, order, execution);
  return Gather(points, order);
}

class PointSearch : public testing::TestWithParam<std::tuple<Shape, std::size_t>>
{
protected:
  std::size_t Size() const { return std::get<1>(this->GetParam()); }
  Buffer<Vec3> Given() const { return MakePoints(std::get<0>(this->GetParam()), this->Size()); }

  Execution Serial;
  OddThreads Threads{ 3 };
};

TEST_P(PointSearch, RunsRearrangeTheOrder)
{
  const Buffer<Vec3> points = this->Given();
  Buffer<Index> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  FormRuns(points, order, this->Threads);
  Buffer<Index> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < sorted.size(); ++i)
  {
    ASSERT_EQ(sorted[i], i);
  }
}

TEST_P(PointSearch, NearestOfAll)
{
  const Buffer<Vec3> points = Ordered(this->Given(), this->Serial);
  for (const std::size_t count : { std::size_t(1), std::size_t(16), std::size_t(150) })
  {
    const NeighborGraph graph = NearestOrderedPoints(points, count, this->Threads);
    ASSERT_EQ(graph.NumberOfRows(), points.size());
    const std::size_t wanted = std::min(count, points.size() - 1);
    std::vector<std::pair<double, Index>> others;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const Span<Index> row = graph.Row(i);
      ASSERT_EQ(row.size(), wanted);
      others.clear();
      for (Index j = 0; j < points.size(); ++j)
      {
        if (j != i)
        {
          others.emplace_back((points[j] - points[i]).squaredNorm(), j);
        }
      }
      std::partial_sort(others.begin(), others.begin() + std::ptrdiff_t(wanted), others.end());
      for (std::size_t k = 0; k < wanted; ++k)
      {
        ASSERT_NE(row[k], i);
        const double square = (points[row[k]] - points[i]).squaredNorm();
        ASSERT_EQ(square, others[k].first) << i << " " << k;
        // Of more points at one place than are wanted, any will do.
        if (square > 0.0)
        {
          ASSERT_EQ(row[k], others[k].second) << i << " " << k;
        }
      }
    }
  }
}

TEST_P(PointSearch, BallsAsInATree)
{
  const Buffer<Vec3> points = Ordered(this->Given(), this->Serial);
  const KdTree tree(points);
  for (const double radius : { 0.0, 0.1, 1.0 })
  {
    const std::size_t limits[] = { 5, 60 };
    const NeighborGraph graphs[] = { PointsWithinRadius(points, radius, limits[0], this->Threads),
      PointsWithinRadius(points, radius, limits[1], this->Threads) };
    std::vector<Index> found;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      tree.Within(points[i], radius, found);
      found.erase(std::remove(found.begin(), found.end(), Index(i)), found.end());
      for (const int k : { 1, 0 })
      {
        found.resize(std::min(found.size(), limits[k]));
        const Span<Index> row = graphs[k].Row(i);
        ASSERT_EQ(std::vector<Index>(row.begin(), row.end()), found) << i << " " << radius;
      }
    }
  }
}

TEST_P(PointSearch, ThreadsDoNotMatter)
{
  const Buffer<Vec3> points = Ordered(this->Given(), this->Threads);
  EXPECT_EQ(points, Ordered(this->Given(), this->Serial));
  EXPECT_EQ(NearestOrderedPoints(points, 16, this->Threads).Ids,
    NearestOrderedPoints(points, 16, this->Serial).Ids);
}

INSTANTIATE_TEST_SUITE_P(Clouds, PointSearch,
  testing::Combine(testing::Values(Shape::Sheet, Shape::Grid, Shape::Uneven, Shape::Doubled,
                     Shape::Line, Shape::OnePlace, Shape::TwoHeaps, Shape::Unseen),
    testing::Values(std::size_t(1), std::size_t(2), std::size_t(17), std::size_t(1500))));

TEST(PointSearch, AnyOrderIsCorrect)
{
  Execution serial;
  const Buffer<Vec3> points = MakePoints(Shape::Uneven, 500);
  const NeighborGraph graph = NearestOrderedPoints(points, 7, serial);
  const NeighborGraph expected = NearestPoints(points, 7, serial);
  EXPECT_EQ(graph.Ids, expected.Ids);
  EXPECT_EQ(NearestOrderedPoints({}, 7, serial).NumberOfRows(), 0u);
  EXPECT_EQ(PointsWithinRadius({}, 1.0, 7, serial).NumberOfRows(), 0u);
  EXPECT_EQ(PointsWithinRadius(points, -1.0, 7, serial).NumberOfIds(), 0u);
}

// Squared distances that underflow all count as zero or as equal, but rows are full.
TEST(PointSearch, TinyCoordinates)
{
  Execution serial;
  Buffer<Vec3> points = MakePoints(Shape::Sheet, 300);
  for (Vec3& p : points)
  {
    p *= 1e-161;
  }
  const NeighborGraph graph = NearestOrderedPoints(points, 16, serial);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    std::vector<Index> row(graph.Row(i).begin(), graph.Row(i).end());
    std::sort(row.begin(), row.end());
    EXPECT_EQ(std::unique(row.begin(), row.end()), row.end());
    EXPECT_LT(row.back(), points.size());
  }
}

}
