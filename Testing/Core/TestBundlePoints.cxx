// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
// Guidance, nodes and steps of the filter with bundles of normals: worked numbers, small examples.

#include "BundleExamples.h"
#include "Points/BundleNodes.h"
#include "Points/FeatureCandidates.h"
#include "Points/NormalBundles.h"
#include "Points/PointPatches.h"
#include "Points/PointUpdate.h"

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

/// A unit vector with this chord to the z axis.
Vec3 AtChord(double chord)
{
  const double angle = 2.0 * std::asin(0.5 * chord);
  return Vec3(std::sin(angle), 0.0, std::cos(angle));
}

}

TEST(PointPatches, WorkedPatches)
{
  const PointPatch even = JudgePatch({ Unit(0, 0, 1), Unit(0.1, 0, 1), Unit(0, 0.1, 1) });
  EXPECT_NEAR(even.Inconsistency, 0.058246, Digits);
  ExpectVector(even.Mean, 0.033241, 0.033241, 0.998894);
  const PointPatch bent = JudgePatch({ Unit(0, 0, 1), Unit(0.1, 0, 1), Unit(1, 0, 0) });
  EXPECT_NEAR(bent.Inconsistency, 0.700316, Digits);
  ExpectVector(bent.Mean, 0.482671, 0.0, 0.875802);
}

TEST(PointPatches, PatchesEndWhereNormalsDoNotAgree)
{
  const NeighborGraph graph = Rows({ { 1, 2 }, { 0, 2 }, { 0, 1 } });
  const Buffer<Vec3> normals = { Unit(0, 0, 1), Unit(0.1, 0, 1), Unit(1, 0, 0) };
  Execution serial;
  Buffer<Vec3> guidance;
  ComputePointPatches(graph, normals, { 2, 0.9, false, -1.0 }, guidance, serial);
  ExpectVector(guidance[0], 0.482671, 0.0, 0.875802);
  ComputePointPatches(graph, normals, { 2, 0.9, false, 0.9 }, guidance, serial);
  EXPECT_LT((guidance[0] - (normals[0] + normals[1]).normalized()).norm(), 1e-15);
  EXPECT_EQ(guidance[2], normals[2]);
}

TEST(NormalBundles, WorkedWeightsOfTheFilter)
{
  // A site without weight of its own whose three neighbours have these distances and guides.
  const NeighborGraph graph = Rows({ { 1, 2, 3 }, {}, {}, {} });
  const Buffer<Vec3> positions = { Vec3(0, 0, 0), Vec3(0.1, 0, 0), Vec3(0, 0.2, 0),
    Vec3(0, 0, 0.2) };
  const Buffer<Vec3> guides = { Vec3(0, 0, 1), Vec3(0, 0, 1), AtChord(0.1), AtChord(1.0) };
  const Buffer<Vec3> normals = { Vec3(0, 0, 1), Unit(0, 0, 1), Unit(0.1, 0, 1), Unit(1, 0, 0) };
  const Buffer<double> ones(4, 1.0);
  NormalFilterSettings settings;
  settings.Norm = GaussianNorm{ 0.3 / std::sqrt(2.0) };
  settings.SpatialSigma = 0.5 / std::sqrt(2.0);
  NormalFilter filter(graph, settings);
  Execution serial;
  filter.SetGeometry({ positions, ones, 0.0 }, serial);
  const NormalFilter::Fields fields{ normals, guides, guides, normals };
  filter.VisitWeights(fields, serial,
    [](std::size_t i, const double* weights)
    {
      if (i == 0)
      {
        EXPECT_NEAR(weights[0], 0.960789, Digits);
        EXPECT_NEAR(weights[1], 0.762532, Digits);
        EXPECT_NEAR(weights[2], 0.000013, Digits);
      }
    });
  Buffer<Vec3> filtered;
  filter.Sweep(fields, filtered, serial);
  ExpectVector(filtered[0], 0.044090, 0.0, 0.999028);
}

TEST(NormalBundles, WorkedStepsToAnEdge)
{
  // The noisy point at the edge of six; its own normal is along y, where nothing is looked at.
  Buffer<Vec3> positions = { Vec3(0.1, 0.5, 0.15), Vec3(-1, 0, 0), Vec3(-1, 1, 0), Vec3(-2, 0, 0),
    Vec3(0, 0, -1), Vec3(0, 1, -1), Vec3(0, 0, -2) };
  const Vec3 up(0, 0, 1);
  const Vec3 right(1, 0, 0);
  const Buffer<Vec3> normals = { Vec3(0, 1, 0), up, up, up, right, right, right };
  const NeighborGraph graph = Rows({ { 1, 2, 3, 4, 5, 6 }, {}, {}, {}, {}, {}, {} });
  NormalFilterSettings settings;
  settings.Norm = L2Norm{ 1.0 };
  settings.Weighting = SiteWeight::Uniform;
  NormalFilter filter(graph, settings);
  const Buffer<double> ones(7, 1.0);
  Execution serial;
  filter.SetGeometry({ positions, ones, 0.0 }, serial);
  const double x[] = { 0.083333, 0.069444, 0.057870 };
  const double z[] = { 0.125000, 0.104167, 0.086806 };
  Buffer<Vec3> steps;
  for (int k = 0; k < 3; ++k)
  {
    ComputeDisplacements(filter, { normals, normals, normals, normals }, positions, {}, steps,
      serial);
    positions[0] += steps[0];
    EXPECT_NEAR(positions[0][0], x[k], Digits);
    EXPECT_NEAR(positions[0][2], z[k], Digits);
  }
}

TEST(BundleNodes, FeaturesHaveTheirPlanes)
{
  const PointSet points = ExactWedge(12, 6);
  Execution serial;
  Buffer<unsigned char> features;
  ASSERT_TRUE(FindFeatures(points, {}, features, serial, 0.0, 1.0));
  const BundleNodes nodes = MakeBundles(points, features, {}, serial);
  for (std::size_t i = 0; i < points.Size(); ++i)
  {
    const double away = -points.Positions[i][0] - points.Positions[i][2];
    ASSERT_EQ(nodes.CountAt(i), away < 1.0 ? 2u : 1u);
    EXPECT_EQ(nodes.Points[nodes.First[i]], i);
    if (away > 1.0)
    {
      EXPECT_EQ(nodes.Normals[nodes.First[i]], points.Normals[i]);
    }
    else
    {
      const Vec3& a = nodes.Normals[nodes.First[i]];
      const Vec3& b = nodes.Normals[nodes.First[i] + 1];
      EXPECT_LT((a + b - Vec3(1.0, 0.0, 1.0)).norm(), 1e-12);
      EXPECT_LT(std::abs(a.dot(b)), 1e-12);
    }
  }
}

TEST(BundleNodes, PlanesThatPassFarAwayAreNotTheirs)
{
  const PointSet points = ExactWedge(12, 6);
  Execution serial;
  const Buffer<unsigned char> features(points.Size(), 1);
  BundleSettings settings;
  auto countAt = [&](double reach, const Vec3& place)
  {
    settings.Reach = reach;
    const BundleNodes nodes = MakeBundles(points, features, settings, serial);
    const auto found = std::find(points.Positions.begin(), points.Positions.end(), place);
    return nodes.CountAt(found - points.Positions.begin());
  };
  EXPECT_EQ(countAt(0.75, Vec3(-0.5, 6.0, 0.0)), 2u);
  EXPECT_EQ(countAt(0.45, Vec3(-0.5, 6.0, 0.0)), 1u);
  EXPECT_EQ(countAt(0.75, Vec3(-1.5, 6.0, 0.0)), 1u);
  EXPECT_EQ(countAt(1.6, Vec3(-1.5, 6.0, 0.0)), 2u);
  EXPECT_EQ(countAt(0.0, Vec3(-2.5, 6.0, 0.0)), 2u);
}

TEST(BundleNodes, NeighborsAreMatchedByDirection)
{
  BundleNodes nodes;
  nodes.First = { 0, 1, 3, 4 };
  nodes.Points = { 0, 1, 1, 2 };
  nodes.Normals = { Unit(1, 0, 0.2), Vec3(0, 0, 1), Vec3(-1, 0, 0), Vec3(0, 1, 0) };
  nodes.Graph.Offsets = { 0, 2, 4, 6, 8 };
  const NeighborGraph neighbors = Rows({ { 1, 2 }, { 0, 2 }, { 1, 0 } });
  Execution serial;
  MatchNodes(neighbors, nodes.Normals, false, nodes, serial);
  EXPECT_EQ(nodes.Graph.Ids, (Buffer<Index>{ 1, 3, 0, 3, 0, 3, 1, 0 }));
  MatchNodes(neighbors, nodes.Normals, true, nodes, serial);
  EXPECT_EQ(nodes.Graph.Ids, (Buffer<Index>{ 2, 3, 0, 3, 0, 3, 1, 0 }));
  const Buffer<Vec3> other(4, Vec3(-1.0, 0.0, 0.0));
  MatchNodes(neighbors, other, false, nodes, serial);
  EXPECT_EQ(nodes.Graph.Ids, (Buffer<Index>{ 2, 3, 0, 3, 0, 3, 2, 0 }));
}

TEST(NormalBundles, PointsNearAnEdgeMoveOntoIt)
{
  PointSet points = ExactWedge(20, 8);
  Execution serial;
  NormalBundlesSettings settings;
  settings.PointIterations = 30;
  ASSERT_TRUE(MakeNormalBundles(settings)->Run(points, serial, 0.0, 1.0));
  for (std::size_t i = 0; i < points.Size(); ++i)
  {
    const Vec3& before = points.Start[i];
    const Vec3& p = points.Positions[i];
    if (before[0] + before[2] > -1.0)
    {
      EXPECT_EQ(points.Classes[i], FeatureClass::Edge);
      EXPECT_LT(std::hypot(p[0], p[2]), 0.02);
      EXPECT_LT((points.Normals[i] - Unit(1, 0, 1)).norm(), 1e-6);
    }
    else
    {
      EXPECT_EQ(points.Classes[i], FeatureClass::Flat);
      EXPECT_LT((p - before).norm(), 0.02);
    }
    EXPECT_NEAR(p[1], before[1], 1e-9);
  }
}
