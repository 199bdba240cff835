// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// What the guard of the quadric updates is for.

#include "VotingClouds.h"

namespace
{

/// A closed polygon in the plane y = 0, extruded along y, with spacing 1.
SurfaceCloud ExtrudedCloud(const std::vector<Vec3>& profile, int length)
{
  SurfaceCloud cloud;
  cloud.Spacing = 1.0;
  for (std::size_t k = 0; k < profile.size(); ++k)
  {
    const Vec3 side = profile[(k + 1) % profile.size()] - profile[k];
    const int count = static_cast<int>(std::lround(side.norm()));
    for (int i = 0; i < count * length; ++i)
    {
      const double share = (i / length + 0.5) / count;
      cloud.Positions.push_back(profile[k] + share * side + Vec3(0.0, i % length, 0.0));
      cloud.Normals.push_back(Vec3(-side[2], 0.0, side[0]).normalized());
    }
  }
  cloud.DistanceOf = [profile](const Vec3& p)
  {
    double least = 1e300;
    for (std::size_t k = 0; k < profile.size(); ++k)
    {
      const Vec3 side = profile[(k + 1) % profile.size()] - profile[k];
      const Vec3 arm = Vec3(p[0], 0.0, p[2]) - profile[k];
      const double share = std::min(std::max(arm.dot(side) / side.squaredNorm(), 0.0), 1.0);
      least = std::min(least, (arm - share * side).norm());
    }
    return least;
  };
  return cloud;
}

/// Mean distance from the surface after some iterations with the neighbourhoods of the paper.
double MeanDistanceAfter(const SurfaceCloud& cloud, double planeScale)
{
  VotingTensorPointsSettings settings;
  settings.PlaneScale = planeScale;
  PointSet points = ToPointSet(cloud, 7.5);
  points.MaximumDisplacement = 3.0;
  Iterate(points, settings, 5);
  double sum = 0.0;
  for (const Vec3& p : points.Positions)
  {
    sum += cloud.DistanceOf(p);
  }
  return sum / static_cast<double>(points.Size());
}

}

TEST(VotingClouds, GuardHoldsPointsNearEdges)
{
  // Of a square bar, and of a gutter with a flat top, a neighbourhood sees all faces.
  std::vector<Vec3> square = { Vec3(0.0, 0.0, 0.0), Vec3(5.0, 0.0, 0.0), Vec3(5.0, 0.0, -5.0),
    Vec3(0.0, 0.0, -5.0) };
  std::vector<Vec3> gutter;
  for (int k = 0; k <= 9; ++k)
  {
    const double a = 3.14159265358979323846 * k / 9.0;
    gutter.push_back(Vec3(6.0 * std::cos(a), 0.0, -6.0 * std::sin(a)));
  }
  for (const std::vector<Vec3>& profile : { square, gutter })
  {
    const SurfaceCloud cloud = Noisy(ExtrudedCloud(profile, 24), 0.2);
    double before = 0.0;
    for (const Vec3& p : cloud.Positions)
    {
      before += cloud.DistanceOf(p) / static_cast<double>(cloud.Positions.size());
    }
    EXPECT_LT(MeanDistanceAfter(cloud, 0.7), 0.8 * before);
    EXPECT_GT(MeanDistanceAfter(cloud, 0.0), 2.0 * before) << "is a guard needed?";
  }
}
