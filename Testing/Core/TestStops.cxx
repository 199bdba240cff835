// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Work can be stopped at any question, and asks often enough; what can be stopped has the bits of
// what cannot.

#include "InterruptedExecution.h"
#include "InterruptedLoops.h"
#include "Methods.h"
#include "OddThreads.h"
#include "Points/InputNeighbors.h"
#include "Points/PointNeighbors.h"
#include "Points/PointNormals.h"
#include "Points/ReleasedVotingTensor.h"
#include "RandomMeshes.h"
#include "SpatialOrder.h"
#include "VotingClouds.h"

#include <numeric>
#include <random>

namespace
{

/// Says yes a number of times, and then no.
class Patience : public Execution
{
public:
  explicit Patience(std::size_t yes)
    : Yes(yes)
  {
  }

  bool Proceed(double) override { return this->Questions++ < this->Yes; }

  std::size_t Questions = 0;

private:
  std::size_t Yes;
};

/// Tries work(execution) with ever more patience until it is done; returns how often it asked.
template <typename Work>
std::size_t StopEverywhere(Work work)
{
  for (std::size_t yes = 0;; ++yes)
  {
    Patience patience(yes);
    if (work(patience))
    {
      return patience.Questions;
    }
    EXPECT_GT(patience.Questions, yes);
  }
}

/// A grid, full of ties, in any order.
Buffer<Vec3> ShuffledGrid(int side)
{
  Buffer<Vec3> points;
  for (int i = 0; i < side * side * side; ++i)
  {
    points.push_back(Vec3(i % side, i / side % side, i / side / side));
  }
  std::shuffle(points.begin(), points.end(), std::mt19937(3));
  return points;
}

struct Entry
{
  int Key;
  std::size_t Number;
};

}

TEST(Stops, SortsAsTheStandardLibrary)
{
  std::mt19937 generator(5);
  auto less = [](const Entry& a, const Entry& b) { return a.Key < b.Key; };
  for (const std::size_t count : { 0, 1, 65536, 65537, 200001, 400000 })
  {
    Buffer<Entry> values(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      values[i] = { static_cast<int>(generator() % 1000), i };
    }
    Buffer<Entry> expected = values;
    std::stable_sort(expected.begin(), expected.end(), less);
    OddThreads threads(3);
    ASSERT_TRUE(SortStably(values, less, threads, 0.0));
    for (std::size_t i = 0; i < count; ++i)
    {
      ASSERT_EQ(values[i].Number, expected[i].Number) << i << " of " << count;
    }
  }
}

TEST(Stops, PiecesCoverALoopOnce)
{
  for (const std::size_t count : { 0, 1, 63, 1000, 70001 })
  {
    for (const std::size_t grain : { 1, 100, 4096 })
    {
      Execution serial;
      InterruptedExecution pieces(serial, 0.0, 1.0);
      std::vector<int> times(count, 0);
      pieces.For(
        count,
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t i = begin; i < end; ++i)
          {
            ++times[i];
          }
        },
        grain);
      EXPECT_EQ(times, std::vector<int>(count, 1)) << count << " " << grain;
    }
  }
}

// On many threads, small loops as well.
TEST(Stops, PiecesGrowToHaveManyShares)
{
  class Shares : public Execution
  {
  public:
    void For(std::size_t count, const Body& body, std::size_t grain) override
    {
      this->Most = std::max(this->Most, count / grain);
      body(0, count);
    }
    std::size_t Most = 0;
  };
  for (const std::size_t grain : { 1, 256 })
  {
    Shares shares;
    InterruptedExecution pieces(shares, 0.0);
    pieces.For(
      20000, [](std::size_t, std::size_t) {}, grain);
    EXPECT_GE(shares.Most, 32u) << grain;
  }
}

TEST(Stops, NeighboursOfTheInput)
{
  const Buffer<Vec3> points = ShuffledGrid(9);
  OddThreads threads(3);
  const OrderedPoints ordered(points, threads);
  for (const std::size_t count : { std::size_t(1), std::size_t(9), std::size_t(5000) })
  {
    const NeighborGraph expected = NearestPoints(points, count, threads);
    const NeighborGraph graph = NearestOfInput(ordered, count, threads);
    EXPECT_EQ(graph.Offsets, expected.Offsets);
    EXPECT_EQ(graph.Ids, expected.Ids);
  }
  const NeighborGraph expected = PointsWithinRadius(points, 2.0, NoIndex, threads);
  const NeighborGraph graph = BallsOfInput(ordered, 2.0, threads);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    Buffer<Index> numbers;
    for (const Index place : graph.Row(ordered.Places[i]))
    {
      numbers.push_back(ordered.Numbers[place]);
    }
    const Span<Index> row = expected.Row(i);
    ASSERT_EQ(numbers, Buffer<Index>(row.begin(), row.end())) << i;
  }
  EXPECT_EQ(NearestOfInput(OrderedPoints({}, threads), 3, threads).NumberOfRows(), 0u);
  EXPECT_EQ(NearestOfInput(OrderedPoints({ points[0] }, threads), 3, threads).NumberOfIds(), 0u);
}

TEST(Stops, TheReleasedProgramLeavesItsInput)
{
  SurfaceCloud cloud = SphereCloud(700);
  AddNoise(cloud.Positions, 0.1 * cloud.Spacing, 5);
  ReleasedVotingTensorSettings settings;
  settings.Iterations = 2;
  Buffer<Vec3> result;
  const std::size_t questions = StopEverywhere(
    [&](Execution& execution)
    {
      Buffer<Vec3> positions = cloud.Positions;
      Buffer<Vec3> normals;
      ReleasedVotingTensorReport report;
      if (DenoiseAsReleased(positions, normals, settings, report, execution))
      {
        result = positions;
        return true;
      }
      EXPECT_EQ(positions, cloud.Positions);
      EXPECT_TRUE(normals.empty());
      return false;
    });
  EXPECT_GT(questions, 12u);
  EXPECT_NE(result, cloud.Positions);
}

TEST(Stops, OrderIsThatOfThePointsWhateverTheAnswer)
{
  Buffer<Vec3> points = ShuffledGrid(7);
  points.push_back(Vec3(std::nan(""), 0.0, 0.0));
  const std::size_t questions = StopEverywhere(
    [&](Execution& execution)
    {
      Buffer<Index> order = FindPointOrder(points, {}, execution);
      std::sort(order.begin(), order.end());
      Buffer<Index> all(points.size() - 1);
      std::iota(all.begin(), all.end(), Index(0));
      EXPECT_EQ(order, all);
      return execution.Proceed(1.0);
    });
  EXPECT_GT(questions, 6u);
}

// Many thousand edges are a fraction of a second.
TEST(Stops, OrientationAsksNowAndThen)
{
  const Buffer<Vec3> points = ShuffledGrid(40);
  Execution serial;
  const OrderedPoints ordered(points, serial);
  const NeighborGraph nearest = NearestOrderedPoints(ordered.Positions, 10, serial);
  Buffer<Vec3> normals(points.size(), Vec3(0.0, 0.0, -1.0));
  Patience endless(1000000);
  EXPECT_EQ(OrientNormals(ordered.Positions, nearest, normals, endless, 0.0), 1u);
  EXPECT_GT(endless.Questions, 3 * nearest.NumberOfIds() / 200000);

  Buffer<Vec3> fitted;
  Patience more(1000000);
  EXPECT_TRUE(ReleasedStartNormals(ordered.Positions, nearest, fitted, more, 0.0, 1.0));
  EXPECT_GT(more.Questions, 3 * nearest.NumberOfIds() / 200000);

  for (const std::size_t yes : { 0, 3, 7, 12 })
  {
    Buffer<Vec3> untouched(points.size(), Vec3(0.0, 0.0, -1.0));
    Patience patience(yes);
    EXPECT_EQ(OrientNormals(ordered.Positions, nearest, untouched, patience, 0.0), 0u);
    EXPECT_EQ(untouched, Buffer<Vec3>(points.size(), Vec3(0.0, 0.0, -1.0)));
  }
}

// Of more than a million faces, every loop over the faces asks.
TEST(LargeMeshQuality, AsksWithinSweeps)
{
  MeshDenoisingSettings settings = SettingsOf(Method::BilateralNormal);
  settings.NormalIterations = 1;
  settings.VertexIterations = 0;
  TriangleMesh mesh = PlaneSheet(720, 3);
  Buffer<Vec3> normals;
  MeshDenoisingReport report;
  Patience patient(std::size_t(-1));
  ASSERT_TRUE(DenoiseMesh(mesh, normals, settings, report, patient));
  EXPECT_GT(patient.Questions, 100u);
  for (const std::size_t yes : { std::size_t(4), patient.Questions / 2, patient.Questions - 2 })
  {
    Patience patience(yes);
    EXPECT_FALSE(DenoiseMesh(mesh, normals, settings, report, patience)) << yes;
    EXPECT_EQ(patience.Questions, yes + 1);
    normals.clear();
  }
}
