// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file FourFaces.h
 * @brief Four faces whose filtered normals are worked out by hand: a flat one, two that lean by 10
 * and 20 degrees, and one across a sharp edge.
 */

#ifndef FourFaces_h
#define FourFaces_h

#include "NormalFilter.h"

#include <gtest/gtest.h>

#include <cmath>

constexpr double Degree = 3.14159265358979323846 / 180.0;
constexpr double Digits = 1.01e-6; // the numbers have six decimals

using namespace SurfaceDenoising;

class FourFaces : public testing::Test
{
protected:
  FourFaces()
  {
    this->Graph.Offsets = { 0, 3, 3, 3, 3 };
    this->Graph.Ids = { 1, 2, 3 };
    this->Settings.Norm = GaussianNorm{ 0.35 };
  }

  /// The filtered normal of face 0 after a number of sweeps with the original data.
  Vec3 Filter(const NormalFilterSettings& settings, int sweeps = 1) const
  {
    Execution serial;
    NormalFilter filter(this->Graph, settings);
    filter.SetGeometry({ this->Centroids, this->Areas, 1e-12 }, serial);
    Buffer<Vec3> current = this->Normals;
    Buffer<Vec3> filtered;
    for (int sweep = 0; sweep < sweeps; ++sweep)
    {
      filter.Sweep({ current, current, this->Normals, this->Normals }, filtered, serial);
      current.swap(filtered);
    }
    return current[0];
  }

  void ExpectNormal(const NormalFilterSettings& settings, const Vec3& expected, int sweeps = 1)
  {
    EXPECT_LT((this->Filter(settings, sweeps) - expected).cwiseAbs().maxCoeff(), Digits)
      << NameOf(settings.Norm) << (settings.IncludeOwn ? " with own face" : "");
  }

  NeighborGraph Graph;
  NormalFilterSettings Settings;
  Buffer<Vec3> Normals = { Vec3(0, 0, 1), Vec3(std::sin(10 * Degree), 0, std::cos(10 * Degree)),
    Vec3(0, std::sin(20 * Degree), std::cos(20 * Degree)), Vec3(1, 0, 0) };
  Buffer<double> Areas = { 1.0, 1.0, 2.0, 1.0 };
  Buffer<Vec3> Centroids = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(-0.5, -0.5, 0) };
};

#endif
