// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file EveryPointMethod.h
 * @brief Runs tests for every row in the table of methods for point sets.
 */

#ifndef EveryPointMethod_h
#define EveryPointMethod_h

#include "NoisyClouds.h"
#include "Points/PointMethods.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace SurfaceDenoising;

class PointMethodTest : public testing::TestWithParam<PointMethod>
{
protected:
  /// The settings of the method, with fewer iterations if it makes many.
  PointDenoisingSettings Settings() const
  {
    PointDenoisingSettings settings = SettingsOf(this->GetParam());
    settings.OuterIterations = std::min(settings.OuterIterations, 5);
    return settings;
  }

  PointCloud Denoise(PointCloud cloud, Execution& execution) const
  {
    PointDenoisingReport report;
    EXPECT_TRUE(DenoisePoints(cloud, this->Settings(), report, execution));
    return cloud;
  }

  PointCloud Denoise(const PointCloud& cloud) const
  {
    Execution serial;
    return this->Denoise(cloud, serial);
  }
};

inline PointCloud NoisyCube(double noise = 0.04)
{
  PointCloud cloud;
  cloud.Positions = CubeCloud(16).Positions;
  AddNoise(cloud.Positions, noise, 7);
  return cloud;
}

inline PointCloud NoisySphere()
{
  PointCloud cloud;
  cloud.Positions = SphereCloud(900).Positions;
  AddNoise(cloud.Positions, 0.03, 8);
  return cloud;
}

inline double DistanceToCube(const Vec3& p)
{
  static const SurfaceCloud cube = CubeCloud(1);
  return std::abs(cube.DistanceOf(p));
}

inline void ExpectFinite(const PointCloud& cloud)
{
  for (std::size_t i = 0; i < cloud.Positions.size(); ++i)
  {
    if (cloud.Status[i] != PointStatus::NotFinite)
    {
      ASSERT_TRUE(cloud.Positions[i].allFinite()) << "point " << i;
      const double length = cloud.Normals[i].norm();
      ASSERT_TRUE(length == 0.0 || std::abs(length - 1.0) < 1e-12) << "point " << i;
    }
  }
}

inline double MeanDistance(const Buffer<Vec3>& points, double (*distance)(const Vec3&))
{
  double sum = 0.0;
  for (const Vec3& p : points)
  {
    sum += distance(p);
  }
  return sum / static_cast<double>(points.size());
}

inline double DistanceToSphere(const Vec3& p) { return std::abs(p.norm() - 1.0); }

inline std::vector<PointMethod> EveryPointMethod()
{
  std::vector<PointMethod> methods;
  for (const PointMethodRow& row : PointMethods())
  {
    methods.push_back(row.Id);
  }
  return methods;
}

inline std::string NameOfPointMethod(const testing::TestParamInfo<PointMethod>& info)
{
  std::string name = PointMethods()[static_cast<std::size_t>(info.param)].Name;
  name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
  return name;
}

#endif
