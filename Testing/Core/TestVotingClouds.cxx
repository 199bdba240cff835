// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Voting tensors on noisy point sets: against the textbook, whatever the signs of normals, threads
// and degenerate input.

#include "OddThreads.h"
#include "TextbookVotingPoints.h"
#include "VotingClouds.h"

namespace
{

std::vector<SurfaceCloud> Clouds()
{
  return { Noisy(SphereCloud(700), 0.2), Noisy(Blended(CubeCloud(11)), 0.1),
    Noisy(Blended(WedgeCloud(20, 10)), 0.1), Noisy(Blended(WedgeCloud(20, 10)), 0.3) };
}

/// Returns how often points were on edges or corners.
std::size_t ExpectTextbook(PointSet points, const VotingTensorPointsSettings& settings)
{
  VotingTextbook::Parameters parameters;
  parameters.Cosine = std::cos(settings.AngleThreshold);
  parameters.Tau = settings.EigenvalueThreshold;
  parameters.Damping = settings.Damping;
  parameters.Alpha = settings.Step;
  parameters.SigmaN = settings.FlatNormalScale;
  parameters.SigmaD = settings.FlatSpatialScale;
  parameters.Balanced = settings.FlatScheme == PointScheme::BalancedHeight;
  parameters.Cut = settings.EigenvalueCut;
  parameters.SigmaP = settings.PlaneScale;
  parameters.Unoriented = settings.Unoriented;
  parameters.Limit = points.MaximumDisplacement;

  VotingTextbook::Cloud cloud;
  cloud.Points.assign(points.Positions.begin(), points.Positions.end());
  cloud.Normals.assign(points.Normals.begin(), points.Normals.end());
  cloud.Start = cloud.Points;
  std::vector<std::vector<int>> rows(points.Size());
  for (std::size_t i = 0; i < points.Size(); ++i)
  {
    cloud.Spacings.push_back(points.SpacingAt(i));
    rows[i].assign(points.Neighbors.Row(i).begin(), points.Neighbors.Row(i).end());
  }
  std::size_t features = 0;
  for (int iteration = 0; iteration < 4; ++iteration)
  {
    const std::vector<int> classes = VotingTextbook::Iterate(cloud, rows, parameters);
    Iterate(points, settings, 1);
    for (std::size_t i = 0; i < points.Size(); ++i)
    {
      EXPECT_LT((points.Normals[i] - cloud.Normals[i]).norm(), 1e-9) << "point " << i;
      EXPECT_LT((points.Positions[i] - cloud.Points[i]).norm(), 1e-9) << "point " << i;
      if (classes[i] >= 0)
      {
        EXPECT_EQ(static_cast<int>(points.Classes[i]), classes[i]);
        features += classes[i] > 0;
      }
      else
      {
        EXPECT_EQ(points.Status[i], PointStatus::Kept);
      }
    }
  }
  return features;
}

}

TEST(VotingClouds, AgreeWithTheTextbook)
{
  std::size_t features = 0;
  for (const SurfaceCloud& cloud : Clouds())
  {
    PointSet points = ToPointSet(cloud, 3.5);
    VotingTensorPointsSettings settings;
    features += ExpectTextbook(points, settings);
    settings.PlaneScale = 0.0;
    features += ExpectTextbook(points, settings);
    points.MaximumDisplacement = 0.7 * cloud.Spacing;
    settings.EigenvalueCut = 0.2;
    settings.EigenvalueThreshold = 0.15;
    settings.FlatScheme = PointScheme::BalancedHeight;
    features += ExpectTextbook(points, settings);
    points.LocalScale = true;
    settings.PlaneScale = 0.5;
    settings.AngleThreshold = 0.7;
    settings.Step = 0.4;
    settings.Damping = 1.0;
    features += ExpectTextbook(points, settings);
    settings.Unoriented = true;
    for (std::size_t i = 0; i < points.Size(); i += 3)
    {
      points.Normals[i] = -points.Normals[i];
    }
    features += ExpectTextbook(points, settings);
  }
  EXPECT_GT(features, 1000u) << "hardly anything to compare on edges";
}

TEST(VotingClouds, WithoutOrientationSignsDoNotMatter)
{
  for (const SurfaceCloud& cloud : Clouds())
  {
    for (const PointScheme scheme : { PointScheme::OwnHeight, PointScheme::BalancedHeight })
    {
      VotingTensorPointsSettings settings;
      settings.Unoriented = true;
      settings.FlatScheme = scheme;
      PointSet points = ToPointSet(cloud, 3.0);
      PointSet turned = points;
      for (std::size_t i = 0; i < points.Size(); ++i)
      {
        turned.Normals[i] = (i * 7919) % 5 < 2 ? Vec3(-points.Normals[i]) : points.Normals[i];
      }
      Iterate(points, settings, 5);
      Iterate(turned, settings, 5);
      for (std::size_t i = 0; i < points.Size(); ++i)
      {
        ASSERT_EQ(turned.Positions[i], points.Positions[i]);
        const double sign = (i * 7919) % 5 < 2 ? -1.0 : 1.0;
        ASSERT_EQ(sign * turned.Normals[i], points.Normals[i]);
      }
    }
  }
}

TEST(VotingClouds, DoNotDependOnThreads)
{
  PointSet points = ToPointSet(Noisy(CubeCloud(12), 0.2), 3.0);
  PointSet other = points;
  OddThreads threads(5);
  Iterate(points, {}, 3);
  Iterate(other, {}, 3, threads);
  EXPECT_EQ(points.Positions, other.Positions);
  EXPECT_EQ(points.Normals, other.Normals);
  EXPECT_EQ(points.Classes, other.Classes);
}

TEST(VotingClouds, DegenerateInput)
{
  SurfaceCloud cloud = Noisy(WedgeCloud(12, 6), 0.1);
  cloud.Positions[3] = cloud.Positions[4];
  cloud.Positions[5] = cloud.Positions[4];
  for (const std::size_t i : { 7, 8, 20 })
  {
    cloud.Normals[i].setZero();
  }
  cloud.Positions[10] = Vec3(1000.0, 0.0, 0.0); // sees nobody
  cloud.Normals[11] = Vec3(0.0, -1.0, 0.0);     // like nobody
  for (const double planeScale : { 0.0, 0.7 })
  {
    VotingTensorPointsSettings settings;
    settings.PlaneScale = planeScale;
    PointSet points = ToPointSet(cloud, 3.0);
    Iterate(points, settings, 3);
    for (std::size_t i = 0; i < points.Size(); ++i)
    {
      ASSERT_TRUE(points.Positions[i].allFinite()) << i;
      ASSERT_TRUE(points.Normals[i].allFinite()) << i;
    }
    for (const std::size_t i : { 10, 11 })
    {
      EXPECT_EQ(points.Status[i], PointStatus::Kept);
      EXPECT_EQ(points.Positions[i], cloud.Positions[i]);
      EXPECT_EQ(points.Normals[i], cloud.Normals[i]);
    }
  }

  SurfaceCloud same;
  same.Spacing = 1.0;
  same.Positions.assign(5, Vec3(1.0, 2.0, 3.0));
  same.Normals.assign(5, Vec3(0.0, 0.0, 1.0));
  PointSet points = ToPointSet(same, 3.0);
  Iterate(points, {}, 2);
  EXPECT_EQ(points.Positions, same.Positions);
  EXPECT_EQ(points.Status, Buffer<PointStatus>(5, PointStatus::Kept));
}
