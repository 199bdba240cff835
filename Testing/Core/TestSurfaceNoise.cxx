// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Noise that is estimated from a surface, against noise that was put there.

#include "Automatic/Spikes.h"
#include "Automatic/SurfaceNoise.h"
#include "AutomaticShapes.h"
#include "CompareMeshes.h"

#include <gtest/gtest.h>

using namespace SurfaceDenoising;

namespace
{

SurfaceNoise NoiseOf(const TriangleMesh& mesh)
{
  Execution serial;
  return EstimateNoise(mesh, VertexStars(mesh), serial);
}

}

TEST(SurfaceNoise, IsWhatWasAdded)
{
  for (const AutomaticShape& shape : AutomaticShapes())
  {
    const TriangleMesh clean = shape.Make();
    const double edge = EdgeLengthOf(clean);
    for (const double level : { 0.1, 0.3, 0.5, 1.0 })
    {
      TriangleMesh mesh = clean;
      AddNormalNoise(mesh, level, 5);
      const SurfaceNoise noise = NoiseOf(mesh);
      EXPECT_NEAR(noise.Deviation / (level * edge), 1.05, 0.4) << shape.Name << level;
      EXPECT_NEAR(noise.Level / level, 1.0, 0.45) << shape.Name << level;
      EXPECT_GT(noise.NormalAngle, 45.0 * std::min(level, 1.0)) << shape.Name << level;
      EXPECT_LT(noise.NormalAngle, 90.0) << shape.Name << level;
    }
  }
}

TEST(SurfaceNoise, IsNoneOnCleanShapes)
{
  for (const AutomaticShape& shape : AutomaticShapes())
  {
    EXPECT_LT(NoiseOf(shape.Make()).Level, 0.01) << shape.Name;
  }
}

TEST(SurfaceNoise, FollowsScaleAndNothingElse)
{
  TriangleMesh mesh = Cube(12);
  AddNormalNoise(mesh, 0.2, 5);
  const SurfaceNoise noise = NoiseOf(mesh);
  TriangleMesh moved = mesh;
  const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  for (Vec3& p : moved.Positions)
  {
    p = 7.0 * (turn * p) + Vec3(3.0, -2.0, 5.0);
  }
  const SurfaceNoise other = NoiseOf(ShuffledMesh(moved).Mesh);
  EXPECT_NEAR(other.Deviation, 7.0 * noise.Deviation, 1e-6);
  EXPECT_NEAR(other.Level, noise.Level, 1e-6);
  EXPECT_NEAR(other.NormalAngle, noise.NormalAngle, 1e-4);
  EXPECT_EQ(other.SpikeShare, noise.SpikeShare);
  EXPECT_EQ(other.Samples, noise.Samples);
}

TEST(SurfaceNoise, OddMeshes)
{
  for (const TriangleMesh& mesh : OddMeshes())
  {
    const SurfaceNoise noise = NoiseOf(mesh);
    EXPECT_EQ(noise.Deviation, 0.0);
    EXPECT_EQ(noise.Level, 0.0);
    EXPECT_EQ(noise.Samples, 0u);
  }
}

// Single vertices that stick out are found, corners are not.
TEST(SurfaceNoise, Spikes)
{
  TriangleMesh mesh = Cube(10);
  Execution serial;
  const Buffer<unsigned char> none = FindSpikes(mesh, VertexStars(mesh), serial);
  EXPECT_EQ(std::count(none.begin(), none.end(), 1), 0);
  for (std::size_t v = 0; v < mesh.NumberOfVertices(); v += 97)
  {
    mesh.Positions[v] += 0.05 * Vec3(1.0, 1.0, 1.0);
  }
  const Buffer<unsigned char> spikes = FindSpikes(mesh, VertexStars(mesh), serial);
  for (std::size_t v = 0; v < mesh.NumberOfVertices(); v += 97)
  {
    EXPECT_EQ(spikes[v], 1) << v;
  }
}
