// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file VotingClouds.h
 * @brief Noisy point sets, and voting tensors on them without a driver.
 */

#ifndef VotingClouds_h
#define VotingClouds_h

#include "NoisyClouds.h"
#include "Points/PointDenoising.h"

#include <gtest/gtest.h>

using namespace SurfaceDenoising;

/// Noise of this many spacings, and normals that are off by as many radians.
inline SurfaceCloud Noisy(SurfaceCloud cloud, double noise)
{
  AddNoise(cloud.Positions, noise * cloud.Spacing, 5);
  AddNoise(cloud.Normals, noise, 6);
  for (Vec3& normal : cloud.Normals)
  {
    normal.normalize();
  }
  return cloud;
}

/// Near edges, normals are means of those of the faces.
inline SurfaceCloud Blended(SurfaceCloud cloud)
{
  Execution serial;
  const NeighborGraph near =
    PointsWithinRadius(cloud.Positions, 1.4 * cloud.Spacing, NoIndex, serial);
  const Buffer<Vec3> normals = cloud.Normals;
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    for (const Index j : near.Row(i))
    {
      cloud.Normals[i] += normals[j];
    }
    cloud.Normals[i].normalize();
  }
  return cloud;
}

/// Neighbours are those within radius spacings.
inline PointSet ToPointSet(const SurfaceCloud& cloud, double radius)
{
  Execution serial;
  PointSet points;
  points.Positions = points.Start = cloud.Positions;
  points.Normals = cloud.Normals;
  points.Neighbors = PointsWithinRadius(points.Positions, radius * cloud.Spacing, NoIndex, serial);
  points.Spacing = cloud.Spacing;
  for (std::size_t i = 0; i < points.Size(); ++i)
  {
    points.Spacings.push_back(cloud.Spacing * (1.0 + 0.3 * std::sin(3.0 * i)));
  }
  points.Status.assign(points.Size(), PointStatus::Filtered);
  return points;
}

inline void Iterate(PointSet& points, const VotingTensorPointsSettings& settings, int iterations,
  Execution& execution)
{
  const auto filter = MakeVotingTensorPoints(settings);
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    points.Status.assign(points.Size(), PointStatus::Filtered);
    EXPECT_TRUE(filter->Run(points, execution, 0.0, 1.0));
  }
}

inline void Iterate(PointSet& points, const VotingTensorPointsSettings& settings, int iterations)
{
  Execution serial;
  Iterate(points, settings, iterations, serial);
}

#endif
