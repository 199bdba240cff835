// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file RandomClouds.h
 * @brief Noisy point sets with a known truth, the same in every run.
 */

#ifndef RandomClouds_h
#define RandomClouds_h

#include "Points/PointDenoising.h"

#include <cmath>
#include <random>

/// Adds isotropic Gaussian noise with the given deviation per coordinate.
inline void AddNoise(SurfaceDenoising::Buffer<SurfaceDenoising::Vec3>& points, double deviation,
  unsigned seed)
{
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0.0, deviation);
  for (SurfaceDenoising::Vec3& p : points)
  {
    for (int c = 0; c < 3; ++c)
    {
      p[c] += normal(random);
    }
  }
}

/// Points on the unit sphere, evenly on a Fibonacci spiral.
inline SurfaceDenoising::Buffer<SurfaceDenoising::Vec3> SpherePoints(std::size_t count)
{
  SurfaceDenoising::Buffer<SurfaceDenoising::Vec3> points;
  const double golden = 3.14159265358979323846 * (3.0 - std::sqrt(5.0));
  for (std::size_t i = 0; i < count; ++i)
  {
    const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(count);
    const double r = std::sqrt(1.0 - z * z);
    const double a = golden * static_cast<double>(i);
    points.push_back(SurfaceDenoising::Vec3(r * std::cos(a), r * std::sin(a), z));
  }
  return points;
}

/// side x side points on each face of the cube [-1, 1]^3, none on its edges; spacing 2 / side.
inline SurfaceDenoising::Buffer<SurfaceDenoising::Vec3> CubePoints(int side)
{
  SurfaceDenoising::Buffer<SurfaceDenoising::Vec3> points;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double sign : { -1.0, 1.0 })
    {
      for (int a = 0; a < side; ++a)
      {
        for (int b = 0; b < side; ++b)
        {
          SurfaceDenoising::Vec3 p;
          p[axis] = sign;
          p[(axis + 1) % 3] = (2.0 * a + 1.0) / side - 1.0;
          p[(axis + 2) % 3] = (2.0 * b + 1.0) / side - 1.0;
          points.push_back(p);
        }
      }
    }
  }
  return points;
}

/// Two square-grid faces of length x width points at a right angle, with spacing 1; the edge is the
/// y axis, the faces are z = 0 with x < 0 and x = 0 with z < 0.
inline SurfaceDenoising::Buffer<SurfaceDenoising::Vec3> WedgePoints(int length, int width)
{
  SurfaceDenoising::Buffer<SurfaceDenoising::Vec3> points;
  for (int a = 0; a < width; ++a)
  {
    for (int b = 0; b < length; ++b)
    {
      points.push_back(SurfaceDenoising::Vec3(-0.5 - a, b, 0.0));
      points.push_back(SurfaceDenoising::Vec3(0.0, b, -0.5 - a));
    }
  }
  return points;
}

/// Distance from the faces of the wedge, which go on beyond their points.
inline double DistanceToWedge(const SurfaceDenoising::Vec3& p)
{
  const double top = std::hypot(p[2], std::max(p[0], 0.0));
  const double side = std::hypot(p[0], std::max(p[2], 0.0));
  return std::min(top, side);
}

/// Distance from the surface of the cube [-1, 1]^3.
inline double DistanceToCube(const SurfaceDenoising::Vec3& p)
{
  const SurfaceDenoising::Vec3 q = p.cwiseAbs() - SurfaceDenoising::Vec3::Ones();
  const double inside = q.maxCoeff();
  return inside <= 0.0 ? -inside : q.cwiseMax(0.0).norm();
}

#endif
