// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// How near points come to the surface with nothing set.

#include "AutomaticClouds.h"
#include "Points/PointMethods.h"

using namespace SurfaceDenoising;

namespace
{

/// What the best method leaves with the settings that it comes with.
double Best(const SurfaceCloud& clean, const PointCloud& noisy)
{
  double best = 1e300;
  for (const PointMethodRow& row : PointMethods())
  {
    PointCloud cloud = noisy;
    PointDenoisingReport report;
    Execution serial;
    EXPECT_TRUE(DenoisePoints(cloud, row.Settings, report, serial));
    best = std::min(best, MeanDistance(clean, cloud.Positions));
  }
  return best;
}

}

/// As good as the best of all methods as they come, or nearly so: small clouds tell risks roughly.
TEST(AutomaticCloudQuality, NearTheBestMethodWhateverTheSurface)
{
  for (const double noise : { 0.1, 0.4 })
  {
    const SurfaceCloud clouds[] = { SphereCloud(700), CubeCloud(11), WedgeCloud(20, 18) };
    for (const SurfaceCloud& clean : clouds)
    {
      PointCloud cloud = Noisy(clean, noise);
      const AutomaticCloudReport report = Denoise(cloud);
      EXPECT_LT(MeanDistance(clean, cloud.Positions),
        1.1 * Best(clean, Noisy(clean, noise)) + 0.005)
        << report.Choice.Reason;
      EXPECT_FALSE(report.Choice.Nothing);
      EXPECT_FALSE(report.Choice.Reason.empty());
    }
  }
}

/// Of noise with heavy tails most points show little.
TEST(AutomaticCloudQuality, SeesHeavyTails)
{
  const SurfaceCloud clouds[] = { SphereCloud(1500), CubeCloud(16), WedgeCloud(30, 25) };
  for (const SurfaceCloud& clean : clouds)
  {
    PointCloud cloud;
    cloud.Positions = clean.Positions;
    AddHeavyTailedNoise(cloud.Positions, 0.4 * clean.Spacing, 3);
    const double best = Best(clean, cloud);
    const AutomaticCloudReport report = Denoise(cloud);
    EXPECT_LT(MeanDistance(clean, cloud.Positions), 0.75 * best) << report.Choice.Reason;
  }
}

/// Risks are of squares and prefer what leaves no point far off the surface; trials see that more
/// points come nearer to it otherwise.
TEST(AutomaticCloudQuality, BringsMostPointsNear)
{
  const struct
  {
    SurfaceCloud Clean;
    double Noise;
    double Left; ///< of the mean distance; by risks alone 1.1 to 1.5 times as much
  } clouds[] = { { WedgeCloud(60, 30), 0.1, 0.145 }, { CubeCloud(22), 0.2, 0.175 } };
  for (const auto& [clean, noise, left] : clouds)
  {
    for (const std::uint64_t seed : { 1, 2 })
    {
      PointCloud cloud;
      cloud.Positions = clean.Positions;
      AddHeavyTailedNoise(cloud.Positions, noise * clean.Spacing, seed);
      const double before = MeanDistance(clean, cloud.Positions);
      const AutomaticCloudReport report = Denoise(cloud);
      EXPECT_LT(MeanDistance(clean, cloud.Positions), left * before) << report.Choice.Reason;
    }
  }
}

/// What is removed tells more of the noise than fits to a few points: smoother methods follow.
TEST(AutomaticCloudQuality, MeasuresNoiseByWhatItRemoves)
{
  const SurfaceCloud clean = SphereCloud(1500);
  for (const double noise : { 0.3, 0.4 })
  {
    PointCloud cloud;
    cloud.Positions = clean.Positions;
    AddNoise(cloud.Positions, noise * clean.Spacing, 3);
    const double before = MeanDistance(clean, cloud.Positions);
    const AutomaticCloudReport report = Denoise(cloud);
    EXPECT_LT(MeanDistance(clean, cloud.Positions), 0.22 * before) << report.Choice.Reason;
  }
}

/// Rows ten times as far apart as their points: what is nearest is a row, unless noise is strong
/// enough to hide it.
TEST(AutomaticCloudQuality, DenoisesPointsInRows)
{
  const SurfaceCloud clean = TorusInRows(1500, 10.0);
  PointCloud cloud = Noisy(clean, 0.1);
  const double before = MeanDistance(clean, cloud.Positions);
  const AutomaticCloudReport report = Denoise(cloud);
  EXPECT_LT(MeanDistance(clean, cloud.Positions), 0.4 * before) << report.Choice.Reason;

  cloud.Positions = clean.Positions;
  Denoise(cloud);
  EXPECT_LT(MeanDistance(clean, cloud.Positions), 0.005);
}

/// Plain moving least squares round edges off, the more so the stronger the noise.
TEST(AutomaticCloudQuality, TwiceAsNearToEdgesAsMovingLeastSquares)
{
  const SurfaceCloud clean = CubeCloud(20);
  // Mean distance of points within three spacings of an edge.
  auto nearEdges = [&](const Buffer<Vec3>& positions)
  {
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      const Vec3 p = clean.Positions[i].cwiseAbs();
      if ((p.array() > 1.0 - 3.0 * clean.Spacing).count() > 1)
      {
        sum += std::abs(clean.DistanceOf(positions[i]));
        ++count;
      }
    }
    return sum / count;
  };
  PointCloud cloud = Noisy(clean, 1.0);
  PointCloud rounded = cloud;
  Denoise(cloud);
  PointDenoisingReport report;
  Execution serial;
  ASSERT_TRUE(DenoisePoints(rounded, SettingsOf(PointMethod::MovingLeastSquares), report, serial));
  EXPECT_LT(nearEdges(cloud.Positions), 0.5 * nearEdges(rounded.Positions));
}
