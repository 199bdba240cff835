// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OddThreads.h"
#include "Points/BallTree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace SurfaceDenoising;

namespace
{

struct Balls
{
  Buffer<Vec3> Centres;
  Buffer<double> Radii;
};

/// Radii over three orders of magnitude, some 0 and some below.
Balls RandomBalls(std::size_t count)
{
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  Balls balls;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = coordinate(generator);
    const double y = coordinate(generator);
    balls.Centres.push_back(Vec3(x, y, coordinate(generator)));
    balls.Radii.push_back(i % 10 == 0 ? 0.0
        : i % 10 == 1                 ? -1.0
                                      : std::pow(10.0, 1.5 * coordinate(generator) - 1.5));
  }
  return balls;
}

std::vector<Index> Visited(const BallTree& tree, const Vec3& place, double margin)
{
  std::vector<Index> visited;
  tree.Visit(place, margin, [&](Index j) { visited.push_back(j); });
  return visited;
}

std::vector<Index> LookedAt(const Balls& balls, const Vec3& place, double margin)
{
  std::vector<Index> found;
  for (std::size_t j = 0; j < balls.Centres.size(); ++j)
  {
    if (balls.Radii[j] > 0.0 && (place - balls.Centres[j]).norm() < balls.Radii[j] + margin)
    {
      found.push_back(static_cast<Index>(j));
    }
  }
  return found;
}

}

TEST(BallTree, FindsWhatLookingAtAllBallsFinds)
{
  Execution serial;
  OddThreads threads(3);
  for (const std::size_t count : { 0, 1, 7, 8, 9, 64, 65, 1000 })
  {
    const Balls balls = RandomBalls(count);
    const BallTree tree(balls.Centres, balls.Radii, serial);
    const BallTree same(balls.Centres, balls.Radii, threads);
    for (const Vec3& place : RandomBalls(200).Centres)
    {
      for (const double margin : { 0.0, 0.05 })
      {
        const std::vector<Index> expected = LookedAt(balls, 1.5 * place, margin);
        EXPECT_EQ(Visited(tree, 1.5 * place, margin), expected);
        EXPECT_EQ(Visited(same, 1.5 * place, margin), expected);
      }
    }
  }
}

TEST(BallTree, TheRadiusItselfIsOutside)
{
  Execution serial;
  const Buffer<Vec3> centres{ Vec3(0.0, 0.0, 0.0), Vec3(2.0, 0.0, 0.0) };
  const Buffer<double> radii{ 1.0, 1.5 };
  const BallTree tree(centres, radii, serial);
  EXPECT_EQ(Visited(tree, Vec3(1.0, 0.0, 0.0), 0.0), std::vector<Index>{ 1 });
  EXPECT_EQ(Visited(tree, Vec3(-0.5, 0.0, 0.0), 0.0), std::vector<Index>{ 0 });
  EXPECT_TRUE(Visited(tree, Vec3(std::nan(""), 0.0, 0.0), 1.0).empty());
}
