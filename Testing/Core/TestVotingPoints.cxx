// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Voting tensors on point sets, worked out by hand.

#include "PointFixtures.h"
#include "Points/PlaneFit.h"
#include "Points/PointUpdate.h"
#include "Points/VotingTensorPoints.h"
#include "VotingTensor.h"

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

/// Point 0 sees all others, which see nothing.
struct Star
{
  Buffer<Vec3> Positions;
  Buffer<Vec3> Normals;

  NormalFilter::Fields Fields() const
  {
    return { this->Normals, this->Normals, this->Normals, this->Normals };
  }

  NeighborGraph Graph() const
  {
    NeighborGraph graph;
    const std::size_t others = this->Positions.size() - 1;
    graph.Offsets.assign(this->Positions.size() + 1, others);
    graph.Offsets[0] = 0;
    for (std::size_t j = 1; j <= others; ++j)
    {
      graph.Ids.push_back(static_cast<Index>(j));
    }
    return graph;
  }

  /// Where one step takes point 0.
  Vec3 Moved(const NormalFilterSettings& weights, const PointUpdateSettings& update) const
  {
    Execution serial;
    const NeighborGraph graph = this->Graph();
    const Buffer<double> ones(this->Positions.size(), 1.0);
    NormalFilter filter(graph, weights);
    filter.SetGeometry({ this->Positions, ones, 0.0 }, serial);
    Buffer<Vec3> moves;
    ComputeDisplacements(filter, this->Fields(), this->Positions, update, moves, serial);
    return this->Positions[0] + moves[0];
  }
};

NormalFilterSettings AllAlike()
{
  NormalFilterSettings settings;
  settings.Norm = L2Norm{ 1.0 };
  return settings;
}

/// E6: a point near the edge of two faces, and three points of each.
Star Wedge(const Buffer<Vec3>& normals)
{
  Star star;
  star.Positions = { Vec3(0.1, 0.5, 0.15), Vec3(-1.0, 0.0, 0.0), Vec3(-1.0, 1.0, 0.0),
    Vec3(-2.0, 0.0, 0.0), Vec3(0.0, 0.0, -1.0), Vec3(0.0, 1.0, -1.0), Vec3(0.0, 0.0, -2.0) };
  star.Normals = normals;
  star.Normals.insert(star.Normals.begin(), Vec3(1.0, 0.0, 1.0));
  for (Vec3& normal : star.Normals)
  {
    normal.normalize();
  }
  return star;
}

Star ExactWedge()
{
  const Vec3 up(0.0, 0.0, 1.0);
  const Vec3 right(1.0, 0.0, 0.0);
  return Wedge({ up, up, up, right, right, right });
}

Star TiltedWedge()
{
  return Wedge({ Vec3(0.1, 0.0, 1.0), Vec3(-0.1, 0.0, 1.0), Vec3(0.0, 0.1, 1.0),
    Vec3(1.0, 0.0, 0.1), Vec3(1.0, 0.1, 0.0), Vec3(1.0, 0.0, -0.1) });
}

FeatureClass ClassOf(const std::vector<Vec3>& points)
{
  Vec3 centre(0.0, 0.0, 0.0);
  for (const Vec3& p : points)
  {
    centre += p / static_cast<double>(points.size());
  }
  PlaneSum sum;
  for (const Vec3& p : points)
  {
    sum.Add(p - centre);
  }
  return ClassifyVariances(sum.Fit().Variances, 0.25);
}

}

TEST(VotingPoints, NormalOfTheFivePoints)
{
  PointSet points = FivePoints();
  Execution serial;
  EXPECT_TRUE(MakeVotingTensorPoints({})->Run(points, serial, 0.0, 1.0));
  ExpectVector(points.Normals[0], 0.008250, -0.008250, 0.999932);
  EXPECT_EQ(points.Classes[0], FeatureClass::Flat);
}

TEST(VotingPoints, NormalOfAnEdge)
{
  Star star;
  star.Positions.assign(3, Vec3(0.0, 0.0, 0.0));
  star.Normals = { Vec3(1.0, 0.1, 1.0).normalized(), Vec3(1.0, 0.0, 0.0), Vec3(0.0, 0.0, 1.0) };
  const NeighborGraph graph = star.Graph();
  const Buffer<double> ones(3, 1.0);
  NormalFilter filter(graph, AllAlike());
  Execution serial;
  filter.SetGeometry({ star.Positions, ones, 0.0 }, serial);
  Buffer<Vec3> filtered;
  VoteOnNormals(filter, star.Fields(), star.Positions, { 0.25, 3.0, false, EigenvalueUnit::Trace },
    filtered, serial);
  ExpectVector(filtered[0], 0.706115, 0.052959, 0.706115);
}

TEST(VotingPoints, ClassesFromVariances)
{
  const Buffer<Vec3> five = FivePoints().Positions;
  EXPECT_EQ(ClassOf({ five.begin(), five.end() }), FeatureClass::Flat);
  std::vector<Vec3> strip;
  for (int y = 0; y < 5; ++y)
  {
    strip.push_back(Vec3(0.0, y, y % 2 == 0 ? 0.01 : -0.01));
  }
  EXPECT_EQ(ClassOf(strip), FeatureClass::Edge);
  EXPECT_EQ(ClassOf({ Vec3(1.0, 1.0, 1.0), Vec3(1.0, -1.0, -1.0), Vec3(-1.0, 1.0, -1.0),
              Vec3(-1.0, -1.0, 1.0) }),
    FeatureClass::Corner);

  // On the threshold: neither below nor above.
  EXPECT_EQ(ClassifyVariances(Vec3(0.0, 3.0, 4.0), 0.6), FeatureClass::Corner);
  EXPECT_EQ(ClassifyVariances(Vec3(0.0, 3.0, 4.0), 0.61), FeatureClass::Edge);
  EXPECT_EQ(ClassifyVariances(Vec3(0.0, 3.0, 4.0), 0.59), FeatureClass::Flat);
  EXPECT_EQ(ClassifyVariances(Vec3(0.0, 3.0, 4.0), 0.9), FeatureClass::Corner);
  EXPECT_EQ(ClassifyVariances(Vec3(0.0, 0.0, 0.0), 0.25), FeatureClass::Corner);
}

TEST(VotingPoints, FlatStepOfTheFivePoints)
{
  // exp(-8 |n_i - n_j|^2 / r^2 - 4 d^2 / r^2) with r = 2 is exp(-(|n_i - n_j| / 0.7071)^2 - d^2).
  const PointSet five = FivePoints();
  const Star star{ five.Positions, five.Normals };
  NormalFilterSettings weights;
  weights.Norm = GaussianNorm{ 0.5 };
  weights.SpatialSigma = std::sqrt(0.5);
  PointUpdateSettings update;
  update.Scheme = PointScheme::OwnHeight;
  update.Step = 0.1;
  ExpectVector(star.Moved(weights, update), 0.0, 0.0, 0.183180);
}

TEST(VotingPoints, EdgeInItsCrossSection)
{
  PointUpdateSettings update;
  update.Scheme = PointScheme::QuadricFit;
  update.EigenvalueCut = 1e-6;
  const Buffer<Vec3> lines(7, Vec3(0.0, 1.0, 0.0));
  update.Lines = &lines;
  ExpectVector(ExactWedge().Moved(AllAlike(), update), 0.0, 0.5, 0.0, 1e-14);
  ExpectVector(TiltedWedge().Moved(AllAlike(), update), 0.026490, 0.500000, -0.009934);
}

TEST(VotingPoints, OwnPlaneInTheCrossSection)
{
  Star star = ExactWedge();
  star.Normals[0] = Vec3(0.0, 0.6, 0.8);
  NormalFilterSettings weights = AllAlike();
  weights.IncludeOwn = true;
  PointUpdateSettings update;
  update.Scheme = PointScheme::QuadricFit;
  const Buffer<Vec3> lines(7, Vec3(0.0, 1.0, 0.0));
  update.Lines = &lines;
  // Three planes z = 0, and 0.64 of one that the point is on already.
  ExpectVector(star.Moved(weights, update), 0.0, 0.5, 0.15 * 0.64 / 3.64, 1e-14);
}

TEST(VotingPoints, CornerByAllPlanes)
{
  PointUpdateSettings update;
  update.Scheme = PointScheme::QuadricFit;
  update.EigenvalueCut = 1e-6;
  ExpectVector(TiltedWedge().Moved(AllAlike(), update), 0.047144, 0.376238, -0.022392);
  // The planes do not tell where the point is along the edge: it stays there.
  update.EigenvalueCut = 0.05;
  EXPECT_NEAR(TiltedWedge().Moved(AllAlike(), update)[1], 0.5, 0.02);
  ExpectVector(ExactWedge().Moved(AllAlike(), update), 0.0, 0.5, 0.0, 1e-14);
}

TEST(VotingPoints, RanksTellHowManyPlanesMeet)
{
  Star star = ExactWedge();
  star.Normals[6] = Vec3(0.0, 1.0, 0.0);
  const Buffer<double> ones(7, 1.0);
  const NeighborGraph graph = star.Graph();
  Execution serial;
  auto rankOf = [&](double cut, const Buffer<Vec3>* lines)
  {
    NormalFilter filter(graph, AllAlike());
    filter.SetGeometry({ star.Positions, ones, 0.0 }, serial);
    PointUpdateSettings update;
    update.Scheme = PointScheme::QuadricFit;
    update.EigenvalueCut = cut;
    update.Lines = lines;
    Buffer<Vec3> moves;
    Buffer<unsigned char> ranks;
    EXPECT_EQ(
      ComputeDisplacements(filter, star.Fields(), star.Positions, update, moves, serial, &ranks),
      6u);
    EXPECT_EQ(ranks[3], 0); // no neighbour
    return static_cast<int>(ranks[0]);
  };
  // The eigenvalues are 3, 2, and 1.
  EXPECT_EQ(rankOf(0.3, nullptr), 3);
  EXPECT_EQ(rankOf(0.4, nullptr), 2);
  EXPECT_EQ(rankOf(0.7, nullptr), 1);
  const Buffer<Vec3> lines(7, Vec3(0.0, 1.0, 0.0));
  EXPECT_EQ(rankOf(0.0, &lines), 2);
}

TEST(VotingPoints, PlanesThatPassFarAwayWeighLess)
{
  const Star star = TiltedWedge();
  const NeighborGraph graph = star.Graph();
  const Buffer<double> ones(7, 1.0);
  NormalFilterSettings settings;
  settings.Norm = GaussianNorm{ 0.5 };
  settings.Argument = NormalArgument::NeighborHeight;
  NormalFilter filter(graph, settings);
  Execution serial;
  filter.SetGeometry({ star.Positions, ones, 0.0 }, serial);
  filter.VisitWeights(star.Fields(), serial,
    [&](std::size_t i, const double* weights)
    {
      for (const Index j : graph.Row(i))
      {
        const double height = star.Normals[j].dot(star.Positions[j] - star.Positions[i]);
        EXPECT_NEAR(*weights++, std::exp(-2.0 * height * height), 1e-14);
      }
    });
  EXPECT_TRUE(IsLength(NormalArgument::NeighborHeight));
}
