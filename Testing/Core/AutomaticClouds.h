// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file AutomaticClouds.h
 * @brief Noisy clouds, denoised without a setting.
 */

#ifndef AutomaticClouds_h
#define AutomaticClouds_h

#include "Automatic/AutomaticCloud.h"
#include "NoisyClouds.h"

#include <gtest/gtest.h>

inline SurfaceDenoising::PointCloud Noisy(const SurfaceCloud& clean, double noise)
{
  SurfaceDenoising::PointCloud cloud;
  cloud.Positions = clean.Positions;
  AddNoise(cloud.Positions, noise * clean.Spacing, 9);
  return cloud;
}

/// In spacings.
inline double MeanDistance(const SurfaceCloud& clean,
  const SurfaceDenoising::Buffer<SurfaceDenoising::Vec3>& positions)
{
  double sum = 0.0;
  for (const SurfaceDenoising::Vec3& p : positions)
  {
    sum += std::abs(clean.DistanceOf(p));
  }
  return sum / clean.Spacing / static_cast<double>(positions.size());
}

inline SurfaceDenoising::AutomaticCloudReport Denoise(SurfaceDenoising::PointCloud& cloud,
  double strength = 1.0)
{
  SurfaceDenoising::AutomaticCloudReport report;
  SurfaceDenoising::Execution serial;
  EXPECT_TRUE(SurfaceDenoising::DenoiseAutomatically(cloud, strength, report, serial));
  return report;
}

#endif
