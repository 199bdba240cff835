// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// What tells noise from shape that was smoothed away: noise is white.

#include "Automatic/TrialSample.h"
#include "AutomaticRuns.h"
#include "AutomaticShapes.h"

using namespace SurfaceDenoising;

namespace
{

/// Of two meshes with the same faces. A sample numbers the vertices anew.
double Correlation(const TriangleMesh& mesh, const TriangleMesh& surface)
{
  Execution serial;
  const MeshSample sample = TakeSample(mesh, mesh.NumberOfFaces(), serial);
  const MeshSample place = TakeSample(surface, mesh.NumberOfFaces(), serial);
  return TrialSample(sample, serial).Residual(sample.Mesh, place.Mesh, serial).Correlation;
}

}

TEST(TrialSample, NoiseIsWhite)
{
  const TriangleMesh clean = Torus(32);
  for (const double level : { 0.1, 0.5 })
  {
    EXPECT_NEAR(Correlation(Noisy(clean, level), clean), 0.0, 0.05) << level;
  }
  EXPECT_EQ(Correlation(clean, clean), 0.0);
}

TEST(TrialSample, LostShapeIsNot)
{
  const TriangleMesh clean = Torus(32);
  TriangleMesh smaller = clean;
  for (Vec3& p : smaller.Positions)
  {
    p *= 0.9;
  }
  EXPECT_GT(Correlation(clean, smaller), 0.9);
  EXPECT_GT(Correlation(Noisy(clean, 0.1), smaller), 0.5);
}

// Rings are high and low by turns. Of the edges of a face, one is along its ring and two are
// between rings: 1 - 1 - 1 of 3.
TEST(TrialSample, HighAndLowRings)
{
  const int n = 12;
  const TriangleMesh clean = Torus(n);
  TriangleMesh mesh = clean;
  Execution serial;
  const Buffer<Vec3> normals = VertexAreaVectors(clean, VertexStars(clean), serial);
  for (std::size_t v = 0; v < normals.size(); ++v)
  {
    mesh.Positions[v] += (int(v) % n % 2 ? 0.01 : -0.01) * normals[v].normalized();
  }
  EXPECT_NEAR(Correlation(mesh, clean), -1.0 / 3.0, 1e-9);
}
