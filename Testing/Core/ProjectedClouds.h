// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file ProjectedClouds.h
 * @brief What the tests of moving least squares on whole clouds share.
 */

#ifndef ProjectedClouds_h
#define ProjectedClouds_h

#include "NoisyClouds.h"
#include "Points/PointDenoising.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace SurfaceDenoising;

/// Noise of this many spacings, and normals that are off by as many radians.
static inline SurfaceCloud Noisy(SurfaceCloud cloud, double noise)
{
  AddNoise(cloud.Positions, noise * cloud.Spacing, 5);
  AddNoise(cloud.Normals, noise, 6);
  for (Vec3& normal : cloud.Normals)
  {
    normal.normalize();
  }
  return cloud;
}

/// The clouds of all tests that compare.
static inline std::vector<SurfaceCloud> Clouds()
{
  return { Noisy(SphereCloud(700), 0.3), Noisy(CubeCloud(9), 0.2), Noisy(WedgeCloud(20, 10), 0.1) };
}

/// Normals as they are given.
static inline PointDenoisingSettings Settings(const PointOperatorSettings& method,
  int neighbors = 30)
{
  PointDenoisingSettings settings;
  settings.Neighborhood.Count = neighbors;
  settings.Normals.Orientation = NormalOrientation::Keep;
  settings.Operator = method;
  return settings;
}

static inline PointCloud Denoise(const Buffer<Vec3>& positions, const Buffer<Vec3>& normals,
  const PointDenoisingSettings& settings, Execution& execution)
{
  PointCloud cloud;
  cloud.Positions = positions;
  cloud.Normals = normals;
  PointDenoisingReport report;
  EXPECT_TRUE(DenoisePoints(cloud, settings, report, execution));
  return cloud;
}

static inline PointCloud Denoise(const Buffer<Vec3>& positions, const Buffer<Vec3>& normals,
  const PointDenoisingSettings& settings)
{
  Execution serial;
  return Denoise(positions, normals, settings, serial);
}

static inline void ExpectIdentical(const Buffer<Vec3>& a, const Buffer<Vec3>& b)
{
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)), 0);
}

static inline Buffer<Vec3> Flipped(Buffer<Vec3> normals)
{
  std::mt19937 generator(3);
  for (Vec3& normal : normals)
  {
    normal *= generator() % 2 == 0 ? -1.0 : 1.0;
  }
  return normals;
}

static inline RobustImplicitMLSSettings Unoriented()
{
  RobustImplicitMLSSettings settings;
  settings.Unoriented = true;
  return settings;
}

/// Both methods, all ways.
static inline std::vector<PointOperatorSettings> Methods()
{
  MovingLeastSquaresSettings plane;
  plane.Degree = 0;
  MovingLeastSquaresSettings wide;
  wide.Bandwidth = 1.5;
  return { plane, MovingLeastSquaresSettings(), wide, RobustImplicitMLSSettings(), Unoriented() };
}

#endif
