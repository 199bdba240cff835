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

// A surface that methods have moved along itself comes back to where the vertices were, and no face
// is turned over for it.
TEST(TrialSample, ResampledAsItWas)
{
  const TriangleMesh clean = PlaneSheet(20, 7);
  Execution serial;
  const MeshSample sample = TakeSample(clean, clean.NumberOfFaces(), serial);
  const TrialSample trial(sample, serial);
  for (const double step : { 0.1, 0.7 })
  {
    TriangleMesh moved = sample.Mesh;
    const double length = step * trial.EdgeLength();
    for (std::size_t v = 0; v < moved.NumberOfVertices(); ++v)
    {
      moved.Positions[v] +=
        length * Vec3(std::cos(2.4 * double(v)), std::sin(2.4 * double(v)), 0.0);
    }
    const TriangleMesh resampled = trial.Resampled(moved, serial);
    std::size_t back = 0;
    for (std::size_t v = 0; v < moved.NumberOfVertices(); ++v)
    {
      back += (resampled.Positions[v] - sample.Mesh.Positions[v]).norm() < 1e-9 ? 1 : 0;
    }
    for (std::size_t f = 0; f < moved.NumberOfFaces(); ++f)
    {
      EXPECT_GT(resampled.DoubleAreaVector(f).dot(moved.DoubleAreaVector(f)), 0.0) << step;
    }
    if (step < 0.5)
    {
      EXPECT_EQ(back, moved.NumberOfVertices());
    }
  }
}
