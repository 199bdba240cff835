// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
// Candidates for features, their skeleton, and clusters of normals.

#include "BundleExamples.h"
#include "PointFixtures.h"
#include "Points/FeatureCandidates.h"
#include "Points/MedialSkeleton.h"
#include "Points/NormalClusters.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace SurfaceDenoising;

namespace
{

NormalClusters Cluster(const std::vector<Vec3>& normals, const NormalClusterSettings& settings = {})
{
  NormalClusters clusters;
  ClusterNormals(normals, normals[0], settings, clusters);
  return clusters;
}

}

TEST(FeatureCandidates, ScoresOfTheFivePoints)
{
  const PointSet points = FivePoints();
  Execution serial;
  auto score = [&](double sigma) {
    return SimilarityScores(points.Neighbors, points.Positions, points.Normals, sigma, serial)[0];
  };
  EXPECT_NEAR(score(0.3), 0.525596, 1e-6);
  EXPECT_NEAR(score(0.1), 0.045133, 1e-6);
}

TEST(FeatureCandidates, PointsWithoutNormalOrNeighborsAreNone)
{
  PointSet points = FivePoints();
  Execution serial;
  points.Normals[0].setZero();
  points.Neighbors = Rows({ { 1, 2, 3, 4 }, {}, { 3 }, { 2 }, { 2 } });
  Buffer<unsigned char> features;
  EXPECT_TRUE(FindFeatures(points, {}, features, serial, 0.0, 1.0));
  EXPECT_EQ(features, (Buffer<unsigned char>{ 0, 0, 1, 1, 1 }));
}

TEST(FeatureCandidates, TheSkeletonLeavesOutWhatIsAside)
{
  // Far more candidates than the skeleton has points, and one on its own.
  PointSet points = ExactWedge(1200, 3);
  points.Normals[5 + 1200 * 4] = Unit(0.0, 1.0, 0.2);
  Execution serial;
  FeatureCandidateSettings settings;
  Buffer<unsigned char> all;
  Buffer<unsigned char> near;
  ASSERT_TRUE(FindFeatures(points, settings, all, serial, 0.0, 1.0));
  settings.SkeletonRadius = 2.0;
  ASSERT_TRUE(FindFeatures(points, settings, near, serial, 0.0, 1.0));
  EXPECT_TRUE(all[5 + 1200 * 4]);
  for (std::size_t i = 0; i < points.Size(); ++i)
  {
    EXPECT_LE(near[i], all[i]);
    const Vec3& p = points.Positions[i];
    // At the ends of the edge the skeleton is shorter.
    if (all[i] && p[0] + p[2] > -1.0 && p[1] > 5.0 && p[1] < 1194.0)
    {
      EXPECT_TRUE(near[i]) << p.transpose();
    }
  }
}

TEST(MedialSkeleton, GathersInTheMiddle)
{
  // A noisy tube along x.
  Buffer<Vec3> cloud;
  for (int i = 0; i < 500; ++i)
  {
    const double a = 2.399963229728653 * i;
    cloud.push_back(Vec3(0.04 * i, 0.5 * std::cos(a), 0.5 * std::sin(a)));
  }
  MedialSkeletonSettings settings;
  settings.Radius = 2.0;
  Buffer<Vec3> skeleton;
  Execution serial;
  ASSERT_TRUE(FindMedialSkeleton(cloud, settings, skeleton, serial, 0.0, 1.0));
  ASSERT_EQ(skeleton.size(), 250u);
  double least = 20.0;
  double most = 0.0;
  for (const Vec3& x : skeleton)
  {
    EXPECT_LT(std::hypot(x[1], x[2]), x[0] > 1.0 && x[0] < 19.0 ? 0.25 : 0.5) << x.transpose();
    least = std::min(least, x[0]);
    most = std::max(most, x[0]);
  }
  EXPECT_LT(least, 1.0);
  EXPECT_GT(most, 19.0);
}

TEST(MedialSkeleton, FewOrCoincidentPoints)
{
  Execution serial;
  Buffer<Vec3> skeleton;
  ASSERT_TRUE(FindMedialSkeleton({}, {}, skeleton, serial, 0.0, 1.0));
  EXPECT_TRUE(skeleton.empty());
  const Buffer<Vec3> same(70, Vec3(1.0, 2.0, 3.0));
  ASSERT_TRUE(FindMedialSkeleton(same, {}, skeleton, serial, 0.0, 1.0));
  EXPECT_EQ(skeleton, Buffer<Vec3>(50, Vec3(1.0, 2.0, 3.0)));
}

TEST(NormalClusters, AsManyAsThereAreDirections)
{
  const std::vector<Vec3> up = { Unit(0.1, 0, 1), Unit(0, 0.1, 1), Unit(-0.1, -0.1, 1) };
  const std::vector<Vec3> right = { Unit(1, 0.1, 0), Unit(1, 0, 0.1), Unit(1, -0.1, -0.1) };
  const std::vector<Vec3> back = { Unit(0, 1, 0.1), Unit(0.1, 1, 0) };
  std::vector<Vec3> normals = up;
  EXPECT_EQ(Cluster(normals).Of, (std::vector<int>{ 0, 0, 0 }));
  EXPECT_LT((Cluster(normals).Centres[0] - (up[0] + up[1] + up[2]).normalized()).norm(), 1e-15);
  normals.insert(normals.end(), right.begin(), right.end());
  const NormalClusters two = Cluster(normals);
  ASSERT_EQ(two.Centres.size(), 2u);
  EXPECT_EQ(two.Of[0], two.Of[2]);
  EXPECT_EQ(two.Of[3], 1 - two.Of[0]);
  EXPECT_LT((two.Centres[two.Of[3]] - (right[0] + right[1] + right[2]).normalized()).norm(), 1e-15);
  normals.insert(normals.end(), back.begin(), back.end());
  EXPECT_EQ(Cluster(normals).Centres.size(), 3u);
  NormalClusterSettings settings;
  settings.Maximum = 2; // none that is apart from the others
  EXPECT_EQ(Cluster(normals, settings).Centres.size(), 1u);
  settings.Separation = 0.0;
  EXPECT_EQ(Cluster(normals, settings).Centres.size(), 2u);
  settings.Maximum = 1;
  EXPECT_EQ(Cluster(normals, settings).Centres.size(), 1u);
}

TEST(NormalClusters, TheAngleIsFromMemberToCentre)
{
  NormalClusterSettings settings;
  settings.Angle = 0.3;
  auto count = [&](double angle)
  {
    return Cluster({ Vec3(0, 0, 1), Vec3(std::sin(angle), 0, std::cos(angle)) }, settings)
      .Centres.size();
  };
  EXPECT_EQ(count(0.59), 1u);
  EXPECT_EQ(count(0.61), 2u);
}

TEST(NormalClusters, NormalsOfACurvedSurfaceAreNoClusters)
{
  std::vector<Vec3> disc;
  std::vector<Vec3> line;
  for (int k = 0; k < 40; ++k)
  {
    const double r = std::sqrt((k + 0.5) / 40.0);
    disc.push_back(Unit(r * std::cos(2.4 * k), r * std::sin(2.4 * k), 1.0));
    line.push_back(Unit(k / 20.0 - 1.0, 0.0, 1.0));
  }
  NormalClusterSettings settings;
  settings.Maximum = 2;
  for (const std::vector<Vec3>& normals : { disc, line })
  {
    settings.Separation = 4.0;
    const NormalClusters one = Cluster(normals, settings);
    EXPECT_EQ(one.Centres.size(), 1u);
    EXPECT_EQ(one.Of, std::vector<int>(40, 0));
    settings.Separation = 1.2;
    EXPECT_EQ(Cluster(normals, settings).Centres.size(), 2u);
  }
}

TEST(NormalClusters, AxesHaveNoSigns)
{
  NormalClusterSettings settings;
  settings.Unoriented = true;
  const std::vector<Vec3> normals = { Unit(0.1, 0, 1), Unit(0, 0.1, 1), Unit(1, 0.1, 0),
    Unit(1, 0, 0.2), Unit(-0.1, 0, 1) };
  const NormalClusters plain = Cluster(normals, settings);
  EXPECT_EQ(plain.Centres.size(), 2u);
  for (unsigned mask = 0; mask < 32; ++mask)
  {
    std::vector<Vec3> flipped = normals;
    for (unsigned k = 0; k < 5; ++k)
    {
      flipped[k] *= (mask >> k) & 1 ? -1.0 : 1.0;
    }
    const NormalClusters found = Cluster(flipped, settings);
    EXPECT_EQ(found.Of, plain.Of);
    for (std::size_t c = 0; c < plain.Centres.size(); ++c)
    {
      EXPECT_EQ(found.Centres[c].cwiseAbs(), plain.Centres[c].cwiseAbs());
    }
  }
}

TEST(NormalClusters, OppositeNormalsHaveNoMean)
{
  const NormalClusters found = Cluster({ Vec3(0, 0, 1), Vec3(0, 0, -1) });
  EXPECT_EQ(found.Centres.size(), 2u);
  // Clusters without members are left out.
  NormalClusterSettings settings;
  settings.Angle = -1.0;
  EXPECT_EQ(Cluster({ Vec3(0, 0, 1), Vec3(0, 0, 1) }, settings).Centres.size(), 1u);
}
