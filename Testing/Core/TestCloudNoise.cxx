// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// The estimated noise of clouds against the known one, and their outliers.

#include "Automatic/CloudNoise.h"

#include "Noise.h"
#include "NoisyClouds.h"
#include "OddThreads.h"

#include <gtest/gtest.h>

#include <limits>

using namespace SurfaceDenoising;

namespace
{

/// Noise along the normals, in spacings.
Buffer<Vec3> Noisy(const SurfaceCloud& cloud, double level, std::uint64_t seed)
{
  NoiseParameters parameters;
  parameters.Deviation = level * cloud.Spacing;
  parameters.Seed = seed;
  const NoiseSource source(parameters, cloud.Positions.size());
  Buffer<Vec3> positions = cloud.Positions;
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    positions[i] += source.Amplitude(i) * cloud.Normals[i];
  }
  return positions;
}

Buffer<Vec3> NoisyWithHeavyTails(const SurfaceCloud& cloud, double level, std::uint64_t seed)
{
  Buffer<Vec3> positions = cloud.Positions;
  AddHeavyTailedNoise(positions, level * cloud.Spacing, seed);
  return positions;
}

/// A sphere with waves of a tenth of its radius, some six spacings from crest to trough: organic.
SurfaceCloud WavyCloud(int count)
{
  SurfaceCloud cloud = SphereCloud(count);
  for (Vec3& p : cloud.Positions)
  {
    p *= 1.0 + 0.1 * std::sin(9.0 * p[0]) * std::sin(9.0 * p[1]) * std::sin(9.0 * p[2]);
  }
  return cloud;
}

/// Both sides of a plate 0.3 thick, in rows at this distance; points are 0.1 apart along them.
Buffer<Vec3> PlateInRows(double distance)
{
  Buffer<Vec3> plate;
  for (int row = 0; row < 20; ++row)
  {
    for (int k = 0; k < 300; ++k)
    {
      plate.push_back(Vec3(0.1 * (k / 2), distance * row, k % 2 == 0 ? 0.0 : 0.3));
    }
  }
  return plate;
}

CloudNoise Estimate(const Buffer<Vec3>& points)
{
  Execution serial;
  return EstimateNoise(points, serial);
}

/// Estimates over the truth are within these bounds for all levels.
void ExpectRatios(const SurfaceCloud& cloud, double least, double most,
  const std::vector<double>& levels = { 0.05, 0.1, 0.2, 0.35, 0.5, 0.7, 1.0 },
  decltype(Noisy)* noisy = Noisy)
{
  for (const double level : levels)
  {
    for (const std::uint64_t seed : { 1, 2 })
    {
      const CloudNoise noise = Estimate(noisy(cloud, level, seed));
      const double ratio = noise.Deviation / (level * cloud.Spacing);
      EXPECT_GT(ratio, least) << level;
      EXPECT_LT(ratio, most) << level;
      EXPECT_LT(noise.OutlierShare(), 0.003) << level;
    }
  }
}

}

TEST(CloudNoise, KnownNoiseOnASphere) { ExpectRatios(SphereCloud(3000), 0.95, 1.05); }

TEST(CloudNoise, KnownNoiseOnACube) { ExpectRatios(CubeCloud(22), 0.95, 1.16); }

TEST(CloudNoise, KnownNoiseOnAWedge) { ExpectRatios(WedgeCloud(45, 30), 0.9, 1.12); }

TEST(CloudNoise, KnownNoiseOnWaves) { ExpectRatios(WavyCloud(3000), 0.8, 1.16); }

/// Places with little noise are more frequent under heavy tails.
TEST(CloudNoise, KnownNoiseWithHeavyTails)
{
  const std::vector<double> levels = { 0.1, 0.2, 0.4 };
  ExpectRatios(SphereCloud(3000), 0.85, 1.1, levels, NoisyWithHeavyTails);
  ExpectRatios(CubeCloud(22), 0.85, 1.3, levels, NoisyWithHeavyTails);
  ExpectRatios(WedgeCloud(45, 30), 0.85, 1.2, levels, NoisyWithHeavyTails);
}

/// The nearest points of a point lie on a curve, in the plane of which noise does not show.
TEST(CloudNoise, KnownNoiseOfPointsInRows)
{
  for (const double ratio : { 5.0, 10.0 })
  {
    const SurfaceCloud torus = TorusInRows(2000, ratio);
    for (const double level : { 0.1, 0.35, 0.7 })
    {
      const CloudNoise noise = Estimate(Noisy(torus, level, 1));
      EXPECT_GT(noise.Widening, 1u) << level;
      EXPECT_NEAR(noise.Deviation / (level * torus.Spacing), 0.95, 0.15) << level;
    }
    EXPECT_LT(Estimate(torus.Positions).Level(), 0.01);
  }
  EXPECT_EQ(Estimate(Noisy(TorusInRows(2000, 1.0), 0.2, 1)).Widening, 1u);
}

/// Rows on both sides of a thin plate: fits that reach beyond a row take the sides for noise.
TEST(CloudNoise, SidesOfAThinPlateAreNoNoise)
{
  EXPECT_LT(Estimate(PlateInRows(1.4)).Level(), 1e-3);
}

/// The tails of noise in random directions are heavy enough to hide that the sides have none.
TEST(CloudNoise, SidesOfAThinPlateUnderHeavyTails)
{
  Buffer<Vec3> plate = PlateInRows(0.4);
  const NoiseSource source({ NoiseKind::Gaussian, 0.08, 0.0, 7 }, plate.size());
  double squares = 0.0;
  for (std::size_t i = 0; i < plate.size(); ++i)
  {
    const Vec3 step = source.Amplitude(i) * source.Direction(i);
    squares += step[2] * step[2];
    plate[i] += step;
  }
  const double deviation = std::sqrt(squares / double(plate.size()));
  EXPECT_NEAR(Estimate(plate).Deviation / deviation, 1.0, 0.3);
}

/// In rows, fits reach far enough to have some of the points that impulses have moved, whatever
/// point they are made for: that is not the noise of all of them.
TEST(CloudNoise, ImpulsesInRowsAreNoNoiseOfAllPoints)
{
  const SurfaceCloud torus = TorusInRows(2000, 10.0);
  const NoiseSource source({ NoiseKind::Impulsive, 0.5 * torus.Spacing, 0.2, 7 },
    torus.Positions.size());
  Buffer<Vec3> points = torus.Positions;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i] += source.Amplitude(i) * torus.Normals[i];
  }
  EXPECT_LT(Estimate(points).Level(), 0.02);
  const CloudNoise heavy = Estimate(NoisyWithHeavyTails(torus, 0.3, 1));
  EXPECT_NEAR(heavy.Deviation / (0.3 * torus.Spacing), 0.95, 0.2);
}

TEST(CloudNoise, NoNoiseOnCleanSurfaces)
{
  EXPECT_LT(Estimate(SphereCloud(3000).Positions).Level(), 1e-3);
  EXPECT_LT(Estimate(CubeCloud(22).Positions).Level(), 1e-9);
  EXPECT_LT(Estimate(WavyCloud(3000).Positions).Level(), 0.01);
}

TEST(CloudNoise, FindsOutliersAndIsNotFooledByThem)
{
  const SurfaceCloud sphere = SphereCloud(3000);
  Buffer<Vec3> points = Noisy(sphere, 0.2, 3);
  const NoiseSource source({ NoiseKind::Gaussian, 1.0, 0.0, 7 }, points.size());
  std::vector<std::size_t> off;
  std::vector<std::size_t> far;
  for (std::size_t i = 10; i < points.size(); i += 100)
  {
    (i % 200 == 10 ? off : far).push_back(i);
    points[i] *= i % 200 == 10 ? 1.0 + 5.0 * sphere.Spacing : 3.0;
  }
  const CloudNoise noise = Estimate(points);
  for (const std::size_t i : off)
  {
    EXPECT_EQ(noise.Outliers[i], 1) << i;
  }
  for (const std::size_t i : far)
  {
    EXPECT_EQ(noise.Outliers[i], 1) << i;
  }
  EXPECT_EQ(noise.Far + noise.Off, off.size() + far.size());
  EXPECT_NEAR(noise.OutlierShare(), 0.01, 1e-12);
  EXPECT_NEAR(noise.Deviation / sphere.Spacing, 0.2, 0.01);
}

/// Dense vertices of a part of a cylinder, and a few far from them, but on it.
TEST(CloudNoise, LonelyPointsOnTheSurfaceAreNoOutliers)
{
  Buffer<Vec3> points;
  auto add = [&](double angle, double height)
  { points.push_back(Vec3(30.0 * std::cos(angle), 30.0 * std::sin(angle), height)); };
  for (int row = 0; row < 30; ++row)
  {
    for (int k = 0; k < 30; ++k)
    {
      add((k + 0.5 * (row % 2)) / 30.0, row);
    }
  }
  for (const double angle : { 0.33, 0.61 })
  {
    add(angle, 37.0);
  }
  const CloudNoise noise = Estimate(points);
  EXPECT_EQ(noise.Far + noise.Off, 0u);
  points.back() *= 1.3;
  EXPECT_EQ(Estimate(points).Outliers.back(), 1);
}

/// Rims with many vertices beside blocks with few, as of a bare CAD model.
TEST(CloudNoise, VerticesFarApartAreNoOutliers)
{
  Buffer<Vec3> points;
  for (const double height : { 0.0, 3.0, 12.0, 15.0 })
  {
    for (int k = 0; k < 240; ++k)
    {
      const double angle = 2.0 * 3.141592653589793 * k / 240;
      points.push_back(Vec3(10.0 * std::cos(angle), 10.0 * std::sin(angle), height));
    }
  }
  for (int k = 0; k < 108; ++k)
  {
    points.push_back(3.5 * Vec3(k % 3, (k / 3) % 3, 10 + (k / 9) + 2 * (k / 27)));
  }
  const CloudNoise noise = Estimate(points);
  EXPECT_EQ(noise.Far + noise.Off, 0u);
}

TEST(CloudNoise, NeitherOrderNorThreadsNorPlacementMatter)
{
  for (const SurfaceCloud& clean : { CubeCloud(15), TorusInRows(1500, 10.0) })
  {
    const Buffer<Vec3> points = Noisy(clean, 0.3, 5);
    const CloudNoise expected = Estimate(points);
    OddThreads threads(3);
    EXPECT_EQ(EstimateNoise(points, threads).Deviation, expected.Deviation);
    EXPECT_EQ(Estimate(Buffer<Vec3>(points.rbegin(), points.rend())).Deviation, expected.Deviation);

    const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
    Buffer<Vec3> moved = points;
    for (Vec3& p : moved)
    {
      p = 1e4 * (turn * p) + Vec3(5e4, -3e4, 1e4);
    }
    const CloudNoise found = Estimate(moved);
    EXPECT_EQ(found.Widening, expected.Widening);
    EXPECT_NEAR(found.Deviation / 1e4, expected.Deviation, 1e-8);
    EXPECT_NEAR(found.Level(), expected.Level(), 1e-8);
  }
}

TEST(CloudNoise, OddInput)
{
  EXPECT_EQ(Estimate({}).Finite, 0u);
  EXPECT_EQ(Estimate({ Vec3(1.0, 2.0, 3.0) }).Deviation, 0.0);
  EXPECT_EQ(Estimate(Buffer<Vec3>(100, Vec3(1.0, 2.0, 3.0))).Level(), 0.0);
  Buffer<Vec3> line;
  for (int i = 0; i < 100; ++i)
  {
    line.push_back(Vec3(i, 2.0 * i, -i));
  }
  EXPECT_EQ(Estimate(line).Deviation, 0.0);

  Buffer<Vec3> points = Noisy(SphereCloud(1500), 0.2, 4);
  const double expected = Estimate(points).Deviation;
  points.insert(points.begin(), Vec3(0.0, std::numeric_limits<double>::quiet_NaN(), 1.0));
  points.push_back(Vec3(std::numeric_limits<double>::infinity(), 0.0, 0.0));
  const CloudNoise noise = Estimate(points);
  EXPECT_EQ(noise.Finite, 1500u);
  EXPECT_EQ(noise.Deviation, expected);
  EXPECT_EQ(noise.Outliers.size(), 1502u);
  EXPECT_EQ(noise.Outliers[0], 0);
}
