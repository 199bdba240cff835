// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Denoising of clouds without a setting.

#include "Automatic/AutomaticCloud.h"

#include "AutomaticClouds.h"
#include "Impatient.h"
#include "Noise.h"
#include "NoisyClouds.h"
#include "OddThreads.h"
#include "Points/PointMethods.h"

#include <gtest/gtest.h>

#include <limits>

using namespace SurfaceDenoising;

TEST(AutomaticCloud, CleanCloudsStayAsTheyAre)
{
  const SurfaceCloud clouds[] = { SphereCloud(1500), CubeCloud(16), WedgeCloud(30, 20) };
  for (const SurfaceCloud& clean : clouds)
  {
    PointCloud cloud;
    cloud.Positions = clean.Positions;
    const AutomaticCloudReport report = Denoise(cloud);
    double moved = 0.0;
    for (std::size_t i = 0; i < cloud.Positions.size(); ++i)
    {
      moved += (cloud.Positions[i] - clean.Positions[i]).norm() / clean.Spacing;
    }
    EXPECT_LT(moved / static_cast<double>(cloud.Positions.size()), 0.002) << report.Choice.Reason;
  }
}

TEST(AutomaticCloud, StrengthNothingChangesNothing)
{
  const PointCloud noisy = Noisy(CubeCloud(12), 0.3);
  for (const double strength : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    PointCloud cloud = noisy;
    const AutomaticCloudReport report = Denoise(cloud, strength);
    EXPECT_TRUE(report.Choice.Nothing);
    EXPECT_EQ(cloud.Positions, noisy.Positions);
  }
}

TEST(AutomaticCloud, StrengthMakesForSmoother)
{
  const SurfaceCloud sphere = SphereCloud(600);
  double moved[2];
  for (const int strong : { 0, 1 })
  {
    PointCloud cloud = Noisy(sphere, 0.2);
    const PointCloud noisy = cloud;
    Denoise(cloud, strong ? 2.0 : 0.02);
    moved[strong] = 0.0;
    for (std::size_t i = 0; i < cloud.Positions.size(); ++i)
    {
      moved[strong] += (cloud.Positions[i] - noisy.Positions[i]).norm();
    }
  }
  EXPECT_LT(moved[0], 0.5 * moved[1]);
}

TEST(AutomaticCloud, NeitherOrderNorThreadsNorPlacementMatter)
{
  const PointCloud noisy = Noisy(CubeCloud(9), 0.3);
  PointCloud expected = noisy;
  Denoise(expected);

  PointCloud threaded = noisy;
  OddThreads threads(3);
  AutomaticCloudReport report;
  ASSERT_TRUE(DenoiseAutomatically(threaded, 1.0, report, threads));
  EXPECT_EQ(threaded.Positions, expected.Positions);

  PointCloud backwards;
  backwards.Positions.assign(noisy.Positions.rbegin(), noisy.Positions.rend());
  Denoise(backwards);
  EXPECT_EQ(Buffer<Vec3>(backwards.Positions.rbegin(), backwards.Positions.rend()),
    expected.Positions);

  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  const Vec3 shift(3.0, -2.0, 1.0);
  PointCloud moved = noisy;
  for (Vec3& p : moved.Positions)
  {
    p = 7.0 * (turn * p) + shift;
  }
  Denoise(moved);
  for (std::size_t i = 0; i < moved.Positions.size(); ++i)
  {
    const Vec3 back = turn.transpose() * (moved.Positions[i] - shift) / 7.0;
    ASSERT_LT((back - expected.Positions[i]).norm(), 1e-8);
  }
}

TEST(AutomaticCloud, OutliersHaveNoSayAndAreHandled)
{
  const SurfaceCloud sphere = SphereCloud(1500);
  PointCloud cloud = Noisy(sphere, 0.2);
  cloud.Positions[100] *= 1.0 + 5.0 * sphere.Spacing;
  cloud.Positions[700] *= 5.0;
  cloud.Positions[900][1] = std::numeric_limits<double>::quiet_NaN();
  const Vec3 far = cloud.Positions[700];
  const AutomaticCloudReport report = Denoise(cloud);
  EXPECT_EQ(report.Pulled, 1u);
  EXPECT_EQ(report.LeftOutliers, 1u);
  EXPECT_LT(std::abs(cloud.Positions[100].norm() - 1.0), 0.5 * sphere.Spacing);
  EXPECT_EQ(cloud.Positions[700], far);
  EXPECT_EQ(cloud.Status[700], PointStatus::Kept);
  EXPECT_EQ(cloud.Status[100], PointStatus::Filtered);
  EXPECT_EQ(cloud.Status[900], PointStatus::NotFinite);
  EXPECT_EQ(report.Denoising.NotFinite, 1u);
  for (std::size_t i = 0; i < cloud.Positions.size(); ++i)
  {
    if (i != 700 && i != 900)
    {
      EXPECT_LT(std::abs(cloud.Positions[i].norm() - 1.0), sphere.Spacing);
    }
  }
}

TEST(AutomaticCloud, ImpulsesGoBack)
{
  const SurfaceCloud clouds[] = { SphereCloud(1500), CubeCloud(16) };
  for (const SurfaceCloud& clean : clouds)
  {
    NoiseParameters parameters;
    parameters.Kind = NoiseKind::Impulsive;
    parameters.Deviation = 0.5 * clean.Spacing;
    parameters.Fraction = 0.2;
    const NoiseSource noise(parameters, clean.Positions.size());
    PointCloud cloud;
    cloud.Positions = clean.Positions;
    for (std::size_t i = 0; i < cloud.Positions.size(); ++i)
    {
      cloud.Positions[i] += noise.Amplitude(i) * clean.Normals[i];
    }
    const Buffer<Vec3> before = cloud.Positions;
    const AutomaticCloudReport report = Denoise(cloud);
    EXPECT_LT(MeanDistance(clean, cloud.Positions), 0.4 * MeanDistance(clean, before));
    EXPECT_GT(report.Pulled, cloud.Positions.size() / 10);
  }
}

TEST(AutomaticCloud, OddInput)
{
  Buffer<Vec3> line;
  Buffer<Vec3> few;
  for (int i = 0; i < 100; ++i)
  {
    line.push_back(Vec3(i, 2.0 * i, -i));
    if (i < 12)
    {
      few.push_back(Vec3(i % 4, i / 4, 0.1 * std::sin(5.0 * i)));
    }
  }
  const Buffer<Vec3> clouds[] = { {}, { Vec3(1.0, 2.0, 3.0) },
    Buffer<Vec3>(50, Vec3(1.0, 2.0, 3.0)), line, few,
    Buffer<Vec3>(3, Vec3(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0)) };
  for (const Buffer<Vec3>& points : clouds)
  {
    PointCloud cloud;
    cloud.Positions = points;
    const AutomaticCloudReport report = Denoise(cloud);
    EXPECT_TRUE(report.Choice.Nothing);
    ASSERT_EQ(cloud.Positions.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      EXPECT_TRUE(cloud.Positions[i] == points[i] || !points[i].allFinite());
    }
  }
}

TEST(AutomaticCloud, GivenNormalsTellTheSide)
{
  const SurfaceCloud sphere = SphereCloud(600);
  PointCloud cloud = Noisy(sphere, 0.2);
  for (const Vec3& p : sphere.Positions)
  {
    cloud.Normals.push_back(-p);
  }
  Denoise(cloud);
  for (std::size_t i = 0; i < cloud.Positions.size(); ++i)
  {
    EXPECT_LT(cloud.Normals[i].dot(sphere.Positions[i]), 0.0);
  }
}

TEST(AutomaticCloud, StopsWhenAskedTo)
{
  const PointCloud noisy = Noisy(CubeCloud(10), 0.3);
  for (const int patience : { 0, 1, 5, 20, 60, 200 })
  {
    PointCloud cloud = noisy;
    Impatient execution(patience);
    AutomaticCloudReport report;
    EXPECT_FALSE(DenoiseAutomatically(cloud, 1.0, report, execution)) << patience;
    EXPECT_EQ(cloud.Positions, noisy.Positions);
    EXPECT_TRUE(cloud.Status.empty());
  }
}
