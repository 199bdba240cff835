// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "KdTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

using namespace SurfaceDenoising;

namespace
{

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

Buffer<Vec3> RandomPoints(std::size_t count)
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  Buffer<Vec3> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = coordinate(generator);
    const double y = coordinate(generator);
    points.push_back(Vec3(x, y, coordinate(generator)));
  }
  return points;
}

/// Points of a 6 x 6 x 6 grid of spacing 1: full of ties.
Buffer<Vec3> GridPoints()
{
  Buffer<Vec3> points;
  for (int i = 0; i < 216; ++i)
  {
    points.push_back(Vec3(i % 6, (i / 6) % 6, i / 36));
  }
  return points;
}

/// All points by distance from the query, then by number: what a tree must find, without a tree.
std::vector<Index> Sorted(const Buffer<Vec3>& points, const Vec3& query)
{
  std::vector<Index> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = static_cast<Index>(i);
  }
  std::stable_sort(order.begin(), order.end(),
    [&](Index a, Index b)
    { return (points[a] - query).squaredNorm() < (points[b] - query).squaredNorm(); });
  return order;
}

void ExpectSameAsSorting(const Buffer<Vec3>& points, std::size_t count, double radius)
{
  const KdTree tree(points);
  std::vector<Index> found;
  for (const Vec3& query : points)
  {
    std::vector<Index> expected = Sorted(points, query);
    const auto outside = std::find_if(expected.begin(), expected.end(),
      [&](Index i) { return (points[i] - query).squaredNorm() > radius * radius; });
    tree.Within(query, radius, found);
    EXPECT_EQ(found, std::vector<Index>(expected.begin(), outside));

    expected.resize(count);
    tree.Nearest(query, count, found);
    EXPECT_EQ(found, expected);
  }
}

}

TEST(KdTree, FindsWhatSortingFinds) { ExpectSameAsSorting(RandomPoints(500), 13, 0.3); }

TEST(KdTree, TiesGoToTheLowestNumbersAndTheRadiusIsIncluded)
{
  ExpectSameAsSorting(GridPoints(), 5, 1.0);
  ExpectSameAsSorting(GridPoints(), 20, 2.0);
}

TEST(KdTree, CoincidentPoints)
{
  const Buffer<Vec3> points(100, Vec3(1.0, 2.0, 3.0));
  const KdTree tree(points);
  std::vector<Index> found;
  tree.Nearest(Vec3(0.0, 0.0, 0.0), 3, found);
  EXPECT_EQ(found, (std::vector<Index>{ 0, 1, 2 }));
  tree.Within(points[0], 0.0, found);
  EXPECT_EQ(found.size(), 100u);
}

TEST(KdTree, FewerPointsThanAskedFor)
{
  std::vector<Index> found{ 99 };
  const KdTree none((Buffer<Vec3>()));
  none.Nearest(Vec3(0.0, 0.0, 0.0), 3, found);
  EXPECT_TRUE(found.empty());
  none.Within(Vec3(0.0, 0.0, 0.0), 3.0, found);
  EXPECT_TRUE(found.empty());

  const KdTree two({ Vec3(1.0, 0.0, 0.0), Vec3(0.0, 0.0, 0.0) });
  two.Nearest(Vec3(0.0, 0.0, 0.0), 3, found);
  EXPECT_EQ(found, (std::vector<Index>{ 1, 0 }));
  two.Nearest(Vec3(0.0, 0.0, 0.0), 0, found);
  EXPECT_TRUE(found.empty());
  two.Within(Vec3(0.0, 0.0, 0.0), -1.0, found);
  EXPECT_TRUE(found.empty());
}

TEST(KdTree, PointsThatAreNotFiniteAreNeitherFoundNorFind)
{
  Buffer<Vec3> points = GridPoints();
  points[0].x() = NotANumber;
  points[1].y() = std::numeric_limits<double>::infinity();
  const KdTree tree(points);
  std::vector<Index> found;
  tree.Nearest(Vec3(0.0, 0.0, 0.0), 1000, found);
  EXPECT_EQ(found.size(), 214u);
  EXPECT_EQ(*std::min_element(found.begin(), found.end()), 2u);
  tree.Nearest(points[0], 3, found);
  EXPECT_TRUE(found.empty());
  tree.Within(points[1], 3.0, found);
  EXPECT_TRUE(found.empty());
}
