// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
// The filter with bundles of normals on noisy clouds: against a textbook, signs, threads, odd
// input, quality.

#include "BundleExamples.h"
#include "NoisyClouds.h"
#include "OddThreads.h"
#include "Points/NormalBundles.h"
#include "Points/PointDenoising.h"
#include "TextbookBundlePoints.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace SurfaceDenoising;

namespace
{

/// A point set with fitted normals on the sides of those of the surface.
PointSet Noisy(const SurfaceCloud& cloud, double noise, int neighbors, unsigned seed)
{
  PointSet points;
  points.Positions = cloud.Positions;
  AddNoise(points.Positions, noise * cloud.Spacing, seed);
  Execution serial;
  points.Start = points.Positions;
  points.Neighbors = NearestPoints(points.Positions, static_cast<std::size_t>(neighbors), serial);
  points.Spacing = cloud.Spacing;
  points.Spacings.assign(points.Size(), cloud.Spacing);
  points.Status.assign(points.Size(), PointStatus::Filtered);
  points.Normals = PlaneFitNormals(points.Positions, points.Neighbors, 16, serial);
  SharpenNormals(points.Positions, points.Neighbors, cloud.Spacing, points.Normals, serial, 0, 1);
  for (std::size_t i = 0; i < points.Size(); ++i)
  {
    if (points.Normals[i].dot(cloud.Normals[i]) < 0.0)
    {
      points.Normals[i] = -points.Normals[i];
    }
  }
  return points;
}

std::vector<SurfaceCloud> Surfaces()
{
  return { SphereCloud(500), CubeCloud(9), WedgeCloud(20, 10) };
}

TextbookBundles::Parameters TextbookParameters(const NormalBundlesSettings& settings,
  const PointSet& points)
{
  TextbookBundles::Parameters parameters;
  parameters.CandidateScale = settings.CandidateScale;
  parameters.CandidateThreshold = settings.CandidateThreshold;
  parameters.SkeletonRadius = settings.UseSkeleton ? settings.SkeletonRadius * points.Spacing : 0.0;
  parameters.BundleAngle = settings.BundleAngle;
  parameters.BundleSeparation = settings.BundleSeparation;
  parameters.MaximumBundles = settings.MaximumBundles;
  parameters.BundleReach = settings.BundleReach * points.Spacing;
  parameters.RangeScale = settings.RangeScale;
  parameters.SpatialScale = settings.SpatialScale * points.Spacing;
  parameters.PatchNeighbors = settings.PatchNeighbors;
  parameters.PatchAgreement = settings.PatchAgreement;
  parameters.PatchMemberAgreement = settings.PatchMemberAgreement;
  parameters.NormalIterations = settings.NormalIterations;
  parameters.PointIterations = settings.PointIterations;
  parameters.FeaturePull = settings.FeaturePull;
  parameters.Unoriented = settings.Unoriented;
  parameters.MaximumDisplacement = points.MaximumDisplacement;
  return parameters;
}

TextbookBundles::Cloud TextbookCloud(const PointSet& points)
{
  TextbookBundles::Cloud cloud;
  for (std::size_t i = 0; i < points.Size(); ++i)
  {
    cloud.Positions.push_back(points.Positions[i]);
    cloud.Normals.push_back(points.Normals[i]);
    const Span<Index> row = points.Neighbors.Row(i);
    cloud.Neighbors.emplace_back(row.begin(), row.end());
  }
  cloud.Start = cloud.Positions;
  return cloud;
}

/// Iterations of the operator and of the textbook with the same neighbours must agree; returns how
/// many points have several normals.
std::size_t Compare(PointSet points, const NormalBundlesSettings& settings, int iterations = 1)
{
  TextbookBundles::Cloud cloud = TextbookCloud(points);
  const TextbookBundles::Parameters parameters = TextbookParameters(settings, points);
  const auto filter = MakeNormalBundles(settings);
  Execution serial;
  std::size_t several = 0;
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    EXPECT_TRUE(filter->Run(points, serial, 0.0, 1.0));
    TextbookBundles::Denoise(cloud, parameters);
    several = 0;
    double positions = 0.0;
    double normals = 0.0;
    for (std::size_t i = 0; i < points.Size(); ++i)
    {
      positions = std::max(positions, (points.Positions[i] - cloud.Positions[i]).norm());
      normals = std::max(normals, (points.Normals[i] - cloud.Means[i]).norm());
      EXPECT_EQ(static_cast<std::size_t>(points.Classes[i]) + 1, cloud.Bundles[i].size());
      several += cloud.Bundles[i].size() > 1;
    }
    EXPECT_LT(positions, 1e-9 * points.Spacing);
    EXPECT_LT(normals, 1e-9);
  }
  return several;
}

void ExpectSound(const PointSet& points)
{
  for (std::size_t i = 0; i < points.Size(); ++i)
  {
    ASSERT_TRUE(points.Positions[i].allFinite());
    const double length = points.Normals[i].norm();
    ASSERT_TRUE(length == 0.0 || std::abs(length - 1.0) < 1e-12);
  }
}

/// Root mean squares of the distances from the surface of points that come from within two spacings
/// of the edge of a wedge and of all others, after the filter.
std::pair<double, double> DenoisedErrors(const SurfaceCloud& surface, double noise,
  NormalSource normals)
{
  PointDenoisingSettings settings;
  settings.Neighborhood.Count = 30;
  settings.Normals.Source = normals;
  settings.MaximumDisplacement = 2.0;
  settings.Operator = NormalBundlesSettings();
  double sums[2] = { 0.0, 0.0 };
  int counts[2] = { 0, 0 };
  for (unsigned seed = 1; seed <= 2; ++seed)
  {
    PointCloud cloud;
    cloud.Positions = surface.Positions;
    AddNoise(cloud.Positions, noise * surface.Spacing, seed);
    PointDenoisingReport report;
    Execution serial;
    EXPECT_TRUE(DenoisePoints(cloud, settings, report, serial));
    for (std::size_t i = 0; i < surface.Positions.size(); ++i)
    {
      const Vec3& p = surface.Positions[i];
      const bool near = surface.Spacing == 1.0 && std::hypot(p[0], p[2]) < 2.0;
      const double distance = surface.DistanceOf(cloud.Positions[i]);
      sums[near ? 0 : 1] += distance * distance;
      ++counts[near ? 0 : 1];
    }
  }
  return { std::sqrt(sums[0] / std::max(1, counts[0])), std::sqrt(sums[1] / counts[1]) };
}

}

TEST(BundleClouds, FollowsTheTextbook)
{
  std::size_t several = 0;
  for (const SurfaceCloud& surface : Surfaces())
  {
    for (const double noise : { 0.1, 0.3 })
    {
      several += Compare(Noisy(surface, noise, 30, 3), {});
    }
  }
  EXPECT_GT(several, 100u);
}

TEST(BundleClouds, FollowsTheTextbookWithOtherSettings)
{
  std::vector<NormalBundlesSettings> variants(7);
  variants[0].UseSkeleton = true;
  variants[1].Unoriented = true;
  variants[2].BundleReach = 0.0;
  variants[2].FeaturePull = 1.0;
  variants[2].BundleSeparation = 0.0;
  variants[3].MaximumBundles = 2;
  variants[3].BundleAngle = 0.5;
  variants[4].PatchNeighbors = 12;
  variants[4].PatchAgreement = 0.7;
  variants[4].PatchMemberAgreement = 0.8;
  variants[4].RangeScale = 0.5;
  variants[5].NormalIterations = 0;
  variants[5].CandidateThreshold = 1.1;
  variants[6].CandidateScale = 0.1;
  variants[6].SpatialScale = 2.5;
  for (const SurfaceCloud& surface : Surfaces())
  {
    for (const NormalBundlesSettings& settings : variants)
    {
      Compare(Noisy(surface, 0.2, 16, 5), settings);
    }
  }
}

TEST(BundleClouds, FollowsTheTextbookInLaterIterationsAndWithALimit)
{
  NormalBundlesSettings settings;
  settings.NormalIterations = 2;
  settings.PointIterations = 4;
  PointSet points = Noisy(CubeCloud(9), 0.2, 20, 6);
  points.MaximumDisplacement = 0.5 * points.Spacing;
  EXPECT_GT(Compare(points, settings, 3), 50u);
  settings.Unoriented = true;
  Compare(points, settings, 3);
}

TEST(BundleClouds, FollowsTheTextbookWithoutSomeNormals)
{
  PointSet points = Noisy(WedgeCloud(20, 10), 0.2, 16, 9);
  for (std::size_t i = 0; i < points.Size(); i += 7)
  {
    points.Normals[i].setZero();
  }
  Compare(points, {});
}

TEST(BundleClouds, SignsOfNormalsDoNotMatterWithoutOrientation)
{
  NormalBundlesSettings settings;
  settings.Unoriented = true;
  for (const SurfaceCloud& surface : Surfaces())
  {
    PointSet plain = Noisy(surface, 0.3, 20, 4);
    PointSet flipped = plain;
    std::mt19937 generator(11);
    for (Vec3& n : flipped.Normals)
    {
      n *= generator() % 2 == 0 ? 1.0 : -1.0;
    }
    const Buffer<Vec3> before = flipped.Normals;
    Execution serial;
    ASSERT_TRUE(MakeNormalBundles(settings)->Run(plain, serial, 0.0, 1.0));
    ASSERT_TRUE(MakeNormalBundles(settings)->Run(flipped, serial, 0.0, 1.0));
    EXPECT_EQ(plain.Positions, flipped.Positions);
    EXPECT_EQ(plain.Classes, flipped.Classes);
    for (std::size_t i = 0; i < plain.Size(); ++i)
    {
      EXPECT_EQ(plain.Normals[i].cwiseAbs(), flipped.Normals[i].cwiseAbs());
    }
  }
}

TEST(BundleClouds, AllNormalsTurnedIsTheSame)
{
  PointSet plain = Noisy(CubeCloud(9), 0.3, 20, 4);
  PointSet flipped = plain;
  for (Vec3& n : flipped.Normals)
  {
    n = -n;
  }
  Execution serial;
  ASSERT_TRUE(MakeNormalBundles({})->Run(plain, serial, 0.0, 1.0));
  ASSERT_TRUE(MakeNormalBundles({})->Run(flipped, serial, 0.0, 1.0));
  EXPECT_EQ(plain.Positions, flipped.Positions);
}

TEST(BundleClouds, DoesNotDependOnThreads)
{
  std::vector<NormalBundlesSettings> variants(3);
  variants[1].UseSkeleton = true;
  variants[2].Unoriented = true;
  for (const NormalBundlesSettings& settings : variants)
  {
    PointSet one = Noisy(CubeCloud(12), 0.3, 16, 2);
    one.LocalScale = settings.Unoriented;
    PointSet five = one;
    Execution serial;
    OddThreads threads(5);
    ASSERT_TRUE(MakeNormalBundles(settings)->Run(one, serial, 0.0, 1.0));
    ASSERT_TRUE(MakeNormalBundles(settings)->Run(five, threads, 0.0, 1.0));
    EXPECT_EQ(one.Positions, five.Positions);
    EXPECT_EQ(one.Normals, five.Normals);
    EXPECT_EQ(one.Classes, five.Classes);
    EXPECT_EQ(one.Status, five.Status);
  }
}

TEST(BundleClouds, LocalScaleOfEqualSpacingsIsTheGlobalOne)
{
  PointSet global = Noisy(CubeCloud(9), 0.3, 16, 2);
  PointSet local = global;
  local.LocalScale = true;
  Execution serial;
  ASSERT_TRUE(MakeNormalBundles({})->Run(global, serial, 0.0, 1.0));
  ASSERT_TRUE(MakeNormalBundles({})->Run(local, serial, 0.0, 1.0));
  EXPECT_EQ(global.Positions, local.Positions);
  // Half the spacings, half the reach: other bundles.
  local = Noisy(CubeCloud(9), 0.3, 16, 2);
  local.LocalScale = true;
  local.Spacings.assign(local.Size(), 0.5 * local.Spacing);
  ASSERT_TRUE(MakeNormalBundles({})->Run(local, serial, 0.0, 1.0));
  EXPECT_NE(global.Classes, local.Classes);
}

TEST(BundleClouds, OddInput)
{
  Execution serial;
  std::vector<NormalBundlesSettings> variants(4);
  variants[1].UseSkeleton = true;
  variants[2].Unoriented = true;
  variants[3].CandidateThreshold = 2.0; // all are candidates
  variants[3].SpatialScale = 0.0;
  for (const NormalBundlesSettings& settings : variants)
  {
    auto run = [&](PointSet points)
    {
      EXPECT_TRUE(MakeNormalBundles(settings)->Run(points, serial, 0.0, 1.0));
      ExpectSound(points);
      return points;
    };
    PointSet none;
    none.Neighbors = Rows({});
    run(none);

    PointSet points = Noisy(CubeCloud(9), 0.3, 16, 2);
    PointSet bare = points;
    bare.Normals.assign(bare.Size(), Vec3(0.0, 0.0, 0.0));
    const PointSet kept = run(bare);
    EXPECT_EQ(kept.Positions, bare.Positions);
    EXPECT_EQ(kept.Status, Buffer<PointStatus>(bare.Size(), PointStatus::Kept));

    PointSet lonely = points;
    lonely.Neighbors.Ids.clear();
    lonely.Neighbors.Offsets.assign(lonely.Size() + 1, 0);
    EXPECT_EQ(run(lonely).Positions, lonely.Positions);

    PointSet doubled = points;
    for (std::size_t i = 0; i < 200; ++i)
    {
      doubled.Positions[i + 200] = doubled.Positions[i];
    }
    doubled.Neighbors = NearestPoints(doubled.Positions, 16, serial);
    doubled.Start = doubled.Positions;
    run(doubled);

    PointSet coincident = points;
    coincident.Positions.assign(points.Size(), Vec3(1.0, 2.0, 3.0));
    coincident.Start = coincident.Positions;
    EXPECT_EQ(run(coincident).Positions, coincident.Positions);
  }
}

TEST(BundleClouds, LessNoiseThanBeforeNearEdgesAndElsewhere)
{
  const auto low = DenoisedErrors(WedgeCloud(40, 20), 0.1, NormalSource::RobustFit);
  EXPECT_LT(low.first, 0.032);
  EXPECT_LT(low.second, 0.021);
  const auto high = DenoisedErrors(WedgeCloud(40, 20), 0.3, NormalSource::RobustFit);
  EXPECT_LT(high.first, 0.12);
  EXPECT_LT(high.second, 0.062);
  EXPECT_LT(DenoisedErrors(WedgeCloud(40, 20), 0.1, NormalSource::PlaneFit).first, 0.06);
  EXPECT_LT(DenoisedErrors(CubeCloud(20), 0.3, NormalSource::RobustFit).second, 0.010);
  EXPECT_LT(DenoisedErrors(SphereCloud(2400), 0.3, NormalSource::RobustFit).second, 0.0055);
}
