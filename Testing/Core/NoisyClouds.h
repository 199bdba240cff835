// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file NoisyClouds.h
 * @brief Points on simple surfaces, with noise, and how far they are from them.
 */

#ifndef NoisyClouds_h
#define NoisyClouds_h

#include "Noise.h"
#include "Types.h"

#include <cmath>
#include <functional>
#include <random>

/// A cloud without noise, and what its points are measured by.
struct SurfaceCloud
{
  SurfaceDenoising::Buffer<SurfaceDenoising::Vec3> Positions;
  SurfaceDenoising::Buffer<SurfaceDenoising::Vec3> Normals;
  double Spacing = 0.0;
  std::function<double(const SurfaceDenoising::Vec3&)> DistanceOf; ///< from the surface
};

/// A Fibonacci lattice on the unit sphere.
static inline SurfaceCloud SphereCloud(int count)
{
  using SurfaceDenoising::Vec3;
  SurfaceCloud cloud;
  for (int i = 0; i < count; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double angle = i * 2.399963229728653;
    const double r = std::sqrt(1.0 - z * z);
    cloud.Positions.push_back(Vec3(r * std::cos(angle), r * std::sin(angle), z));
  }
  cloud.Normals = cloud.Positions;
  cloud.Spacing = std::sqrt(4.0 * 3.14159265358979323846 / count);
  cloud.DistanceOf = [](const Vec3& p) { return p.norm() - 1.0; };
  return cloud;
}

/// Points in rows along the big circle of a torus with radii 1 and 0.5, rows ratio times as far
/// apart as the points of a row. Noise of nearest points is not that of the surface: they lie in a
/// row.
static inline SurfaceCloud TorusInRows(int count, double ratio)
{
  using SurfaceDenoising::Vec3;
  constexpr double turn = 2.0 * 3.14159265358979323846;
  SurfaceCloud cloud;
  cloud.Spacing = std::sqrt(0.5 * turn * turn / count);
  const double apart = cloud.Spacing * std::sqrt(ratio);
  const int rows = static_cast<int>(std::lround(0.5 * turn / apart));
  for (int row = 0; row < rows; ++row)
  {
    const double tube = turn * (row + 0.3) / rows;
    const double radius = 1.0 + 0.5 * std::cos(tube);
    const int length = static_cast<int>(std::lround(turn * radius * ratio / apart));
    for (int k = 0; k < length; ++k)
    {
      // Rows start anywhere.
      const double angle = turn * (k + std::fmod(0.618 * row, 1.0)) / length;
      const Vec3 normal(std::cos(tube) * std::cos(angle), std::cos(tube) * std::sin(angle),
        std::sin(tube));
      cloud.Positions.push_back(Vec3(std::cos(angle), std::sin(angle), 0.0) + 0.5 * normal);
      cloud.Normals.push_back(normal);
    }
  }
  cloud.DistanceOf = [](const Vec3& p)
  { return std::hypot(std::hypot(p[0], p[1]) - 1.0, p[2]) - 0.5; };
  return cloud;
}

/// n x n points in the middle of cells on every face of [-1, 1]^3.
static inline SurfaceCloud CubeCloud(int n)
{
  using SurfaceDenoising::Vec3;
  SurfaceCloud cloud;
  cloud.Spacing = 2.0 / n;
  for (int face = 0; face < 6; ++face)
  {
    for (int k = 0; k < n * n; ++k)
    {
      Vec3 p;
      p[face / 2] = face % 2 == 0 ? 1.0 : -1.0;
      p[(face / 2 + 1) % 3] = (k % n + 0.5) * cloud.Spacing - 1.0;
      p[(face / 2 + 2) % 3] = (k / n + 0.5) * cloud.Spacing - 1.0;
      cloud.Positions.push_back(p);
      cloud.Normals.push_back(Vec3::Unit(face / 2) * p[face / 2]);
    }
  }
  cloud.DistanceOf = [](const Vec3& p)
  {
    const Vec3 q = p.cwiseAbs() - Vec3::Ones();
    return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0);
  };
  return cloud;
}

/// Two faces of along x across points with spacing 1 at a right angle, solid for x < 0 and z < 0;
/// the edge is the y axis.
static inline SurfaceCloud WedgeCloud(int along, int across)
{
  using SurfaceDenoising::Vec3;
  SurfaceCloud cloud;
  cloud.Spacing = 1.0;
  for (int face = 0; face < 2; ++face)
  {
    for (int k = 0; k < along * across; ++k)
    {
      const double away = -(k / along + 0.5);
      const double y = k % along + 0.5;
      cloud.Positions.push_back(face == 0 ? Vec3(away, y, 0.0) : Vec3(0.0, y, away));
      cloud.Normals.push_back(face == 0 ? Vec3(0.0, 0.0, 1.0) : Vec3(1.0, 0.0, 0.0));
    }
  }
  cloud.DistanceOf = [](const Vec3& p)
  {
    const double x = p[0];
    const double z = p[2];
    return x > 0.0 && z > 0.0 ? std::hypot(x, z) : std::max(x, z);
  };
  return cloud;
}

/// Normally distributed vectors of this size (per coordinate) on all of them.
static inline void AddNoise(SurfaceDenoising::Buffer<SurfaceDenoising::Vec3>& vectors, double size,
  unsigned seed)
{
  std::mt19937 generator(seed);
  // Not std::normal_distribution, which differs between libraries.
  auto uniform = [&] { return (generator() + 0.5) / 4294967296.0; };
  for (SurfaceDenoising::Vec3& v : vectors)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double length = std::sqrt(-2.0 * std::log(uniform()));
      v[k] += size * length * std::cos(6.283185307179586 * uniform());
    }
  }
}

/// The product of a normally distributed length and a random direction: of the parts along normals
/// the deviation is size, too, but the kurtosis is 5.4 instead of 3.
static inline void AddHeavyTailedNoise(SurfaceDenoising::Buffer<SurfaceDenoising::Vec3>& vectors,
  double size, std::uint64_t seed)
{
  SurfaceDenoising::NoiseParameters parameters;
  parameters.Deviation = std::sqrt(3.0) * size;
  parameters.Seed = seed;
  const SurfaceDenoising::NoiseSource source(parameters, vectors.size());
  for (std::size_t i = 0; i < vectors.size(); ++i)
  {
    vectors[i] += source.Amplitude(i) * source.Direction(i);
  }
}

#endif
