// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// How near meshes come to the right ones with nothing set.

#include "AutomaticRuns.h"
#include "AutomaticShapes.h"
#include "NoisyCube.h"

TEST(AutomaticMeshQuality, IsBetterThanItsInput)
{
  for (const AutomaticShape& shape : AutomaticShapes())
  {
    const TriangleMesh clean = shape.Make();
    for (const double level : { 0.1, 0.3 })
    {
      TriangleMesh mesh = Noisy(clean, level);
      const double before = Measure(mesh, clean).MeanAngle;
      const AutomaticReport report = Automatic(mesh);
      EXPECT_LT(Measure(mesh, clean).MeanAngle, 0.35 * before) << shape.Name << level;
      EXPECT_FALSE(report.Plan.Reason.empty());
      EXPECT_EQ(report.Plan.Methods.size(), report.Plan.Steps.size());
      EXPECT_LT(report.Plan.ExpectedError, 0.5);
      EXPECT_NEAR(report.Removed / level, 0.9, 0.3) << shape.Name << level;
    }
  }
}

// Noise in random directions has heavy tails along the normals. Weak noise of that kind is taken
// away as well, and strong noise of any kind.
TEST(AutomaticMeshQuality, WeakAndStrongNoise)
{
  struct Case
  {
    double Level;
    bool AlongNormals;
    double Left; ///< of the error
  };
  const TriangleMesh clean = Torus(32);
  for (const Case& test :
    { Case{ 0.1, false, 0.13 }, Case{ 0.7, false, 0.09 }, Case{ 0.7, true, 0.09 } })
  {
    TriangleMesh mesh = clean;
    if (test.AlongNormals)
    {
      AddNormalNoise(mesh, test.Level, 12345);
    }
    else
    {
      AddDirectionNoise(mesh, test.Level, 12345);
    }
    const double before = Measure(mesh, clean).MeanAngle;
    Automatic(mesh);
    EXPECT_LT(Measure(mesh, clean).MeanAngle, test.Left * before) << test.Level;
  }
}

// Faces of a coarse surface meet at angles as large as those that weak noise makes: it flattens as
// many edges as it bends. And of few faces, chance makes much.
TEST(AutomaticMeshQuality, CoarseCurvedSurfaces)
{
  for (const int cuts : { 5, 6, 7, 8 })
  {
    const TriangleMesh clean = Ball(cuts);
    TriangleMesh mesh = Noisy(clean, 0.05);
    const double before = Measure(mesh, clean).MeanAngle;
    Automatic(mesh);
    EXPECT_LT(Measure(mesh, clean).MeanAngle, 0.4 * before) << cuts;
  }
  for (const int squares : { 11, 12, 13 })
  {
    const TriangleMesh clean = Torus(squares);
    TriangleMesh mesh = Noisy(clean, 0.07);
    const double before = Measure(mesh, clean).MeanAngle;
    Automatic(mesh);
    EXPECT_LT(Measure(mesh, clean).MeanAngle, 0.6 * before) << squares;
  }
}

// A surface that has edges and weak noise is among those that a noisy mesh may have been.
TEST(AutomaticMeshQuality, SharpEdgesOfLongTriangles)
{
  const TriangleMesh clean = Gear(40, 2, 0.2);
  TriangleMesh mesh = Noisy(clean, 0.05);
  const double before = Measure(mesh, clean).MeanAngle;
  Automatic(mesh);
  EXPECT_LT(Measure(mesh, clean).MeanAngle, 0.4 * before);
}

// Sides that meet at 51 degrees.
TEST(AutomaticMeshQuality, BluntEdges)
{
  const TriangleMesh clean = Prism(7, 14, 30);
  TriangleMesh mesh = clean;
  AddDirectionNoise(mesh, 0.3, 12345);
  const double before = Measure(mesh, clean).MeanAngle;
  Automatic(mesh);
  EXPECT_LT(Measure(mesh, clean).MeanAngle, 0.12 * before);
}

// Weak noise is strong for thin faces, and folds some. What methods make of such a surface has
// fatter ones; it is judged with thin ones all the same.
TEST(AutomaticMeshQuality, ThinFaces)
{
  for (const double nearer : { 0.9, 0.95 })
  {
    const TriangleMesh clean = Torus(32, nearer);
    for (const bool alongNormals : { true, false })
    {
      TriangleMesh mesh = clean;
      (alongNormals ? AddNormalNoise : AddDirectionNoise)(mesh, 0.1, 12345);
      const double before = Measure(mesh, clean).MeanAngle;
      Automatic(mesh);
      EXPECT_LT(Measure(mesh, clean).MeanAngle, 0.14 * before) << nearer << alongNormals;
    }
  }
}

// Quick chains leave rough surfaces here, which say that nothing is better than these chains. The
// others have a say as well.
TEST(AutomaticMeshQuality, RidgesOfIrregularTriangles)
{
  for (const double jitter : { 0.4, 0.5 })
  {
    const TriangleMesh clean = Ridges(48, jitter);
    TriangleMesh mesh = clean;
    AddDirectionNoise(mesh, 0.1, 12345);
    const double before = Measure(mesh, clean).MeanAngle;
    Automatic(mesh);
    EXPECT_LT(Measure(mesh, clean).MeanAngle, 0.32 * before) << jitter;
  }
}

// Of low bumps, noise can be told, but not by chains that remove the bumps as well.
TEST(AutomaticMeshQuality, KeepsLowBumps)
{
  const TriangleMesh clean = BumpyTorus(0.35, 6.0);
  for (const int seed : { 1, 2, 3 })
  {
    TriangleMesh mesh = clean;
    AddNormalNoise(mesh, 0.05, seed);
    const double before = Measure(mesh, clean).MeanAngle;
    Automatic(mesh);
    EXPECT_LT(Measure(mesh, clean).MeanAngle, 0.75 * before) << seed;
  }
}

// Noise that is larger than triangles are high folds them over. Surfaces without noise have no
// folds: what is there to judge by is how many of them a chain leaves.
TEST(AutomaticMeshQuality, UnfoldsSlivers)
{
  TriangleMesh clean = Torus(20);
  for (Vec3& p : clean.Positions)
  {
    p[0] *= 12.0;
  }
  TriangleMesh mesh = Noisy(clean, 0.5);
  const double before = Measure(mesh, clean).MeanAngle;
  EXPECT_GT(before, 70.0);
  Automatic(mesh);
  EXPECT_LT(Measure(mesh, clean).MeanAngle, 0.3 * before);
}
