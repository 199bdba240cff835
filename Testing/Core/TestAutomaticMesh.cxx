// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Denoising that finds its parameters itself.

#include "Automatic/AutomaticMesh.h"
#include "Automatic/CandidateChains.h"
#include "Automatic/MeshSample.h"
#include "AutomaticRuns.h"
#include "AutomaticShapes.h"
#include "CompareMeshes.h"
#include "Impatient.h"
#include "ImpulsiveShapes.h"
#include "NoisyCube.h"
#include "OddThreads.h"

#include <limits>

// Steps of voxels look like strong noise, but they are not white.
TEST(AutomaticMesh, DoesNoHarmToVoxels)
{
  const TriangleMesh clean = Voxels(10);
  for (const double level : { 0.0, 0.1 })
  {
    TriangleMesh mesh = Noisy(clean, level);
    const double before = Measure(mesh, clean).MeanAngle;
    Automatic(mesh);
    EXPECT_LE(Measure(mesh, clean).MeanAngle, 0.5 * before) << level;
  }
}

// Regular bumps and weak noise: what a chain would remove is more like shape than what it removes
// from a smooth surface with noise.
TEST(AutomaticMesh, LeavesDetailAlone)
{
  for (const TriangleMesh& clean : { BumpyTorus(0.4, 6.0), BumpyTorus(0.5, 5.0) })
  {
    TriangleMesh mesh = Noisy(clean, 0.05);
    const double before = Measure(mesh, clean).MeanAngle;
    Automatic(mesh);
    EXPECT_LE(Measure(mesh, clean).MeanAngle, before);
  }
}

TEST(AutomaticMesh, LeavesCleanShapesAlone)
{
  for (const AutomaticShape& shape : AutomaticShapes())
  {
    const TriangleMesh clean = shape.Make();
    TriangleMesh mesh = clean;
    const AutomaticReport report = Automatic(mesh);
    EXPECT_TRUE(report.Plan.Steps.empty()) << shape.Name;
    EXPECT_EQ(Distance(mesh.Positions, clean.Positions), 0.0) << shape.Name;
    EXPECT_EQ(report.Plan.ExpectedError, 1.0);
    EXPECT_GT(report.Last.MeanEdgeLength, 0.0);
  }
}

TEST(AutomaticMesh, WithoutStrengthNothingMoves)
{
  const TriangleMesh noisy = Noisy(Cube(8), 0.2);
  for (const double strength : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    TriangleMesh mesh = noisy;
    EXPECT_TRUE(Automatic(mesh, strength).Plan.Steps.empty());
    EXPECT_EQ(Distance(mesh.Positions, noisy.Positions), 0.0);
  }
}

TEST(AutomaticMesh, StrengthRemovesMore)
{
  const TriangleMesh noisy = Noisy(Torus(20), 0.1);
  double last = 0.0;
  for (const double strength : { 0.3, 1.0, 3.0 })
  {
    TriangleMesh mesh = noisy;
    const double removed = Automatic(mesh, strength).Removed;
    EXPECT_GE(removed, last) << strength;
    last = removed;
  }
}

// Impulses are taken out, and what they left alone stays to the bit.
TEST(AutomaticMesh, RepairsImpulsesAlone)
{
  for (const AutomaticShape& shape : AutomaticShapes())
  {
    const TriangleMesh clean = shape.Make();
    TriangleMesh mesh = WithJumps(clean);
    const double before = Measure(mesh, clean).MeanAngle;
    const AutomaticReport report = Automatic(mesh);
    EXPECT_LT(Measure(mesh, clean).MeanAngle, 0.5 * before) << shape.Name;
    EXPECT_GT(report.RepairedVertices, 0.05 * double(mesh.NumberOfVertices())) << shape.Name;
    std::size_t same = 0;
    for (std::size_t v = 0; v < mesh.NumberOfVertices(); ++v)
    {
      same += mesh.Positions[v] == clean.Positions[v] ? 1 : 0;
    }
    EXPECT_GT(same, 0.7 * double(mesh.NumberOfVertices())) << shape.Name;
  }
}

// Neither for what is chosen nor for what is taken for an impulse.
TEST(AutomaticMesh, VerticesWithoutFacesDoNotMatter)
{
  const TriangleMesh clean = Torus(14);
  for (const TriangleMesh& noisy : { Noisy(clean, 0.1), WithJumps(clean) })
  {
    TriangleMesh alone = noisy;
    TriangleMesh more = noisy;
    more.Positions.push_back(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
    const AutomaticReport report = Automatic(alone);
    EXPECT_EQ(Automatic(more).Plan.Reason, report.Plan.Reason);
    EXPECT_GT(Distance(alone.Positions, noisy.Positions), 0.0);
    more.Positions.pop_back();
    EXPECT_EQ(more.Positions, alone.Positions);
  }
}

// Here impulses are told from details, but what is made up for them would miss as much. They are
// still there when methods are tried, and look like noise of all vertices.
TEST(AutomaticMesh, LeavesImpulsesThatItCannotRepair)
{
  const TriangleMesh noisy = WithImpulses(RoughTorus(0.035, 20), 0.2, true, 0.4);
  TriangleMesh mesh = noisy;
  const AutomaticReport report = Automatic(mesh);
  EXPECT_EQ(report.RepairedVertices, 0u);
  EXPECT_NE(report.Plan.Reason.find("impulses"), std::string::npos);
  EXPECT_EQ(mesh.Positions, noisy.Positions);
}

TEST(AutomaticMesh, ThreadsDoNotMatter)
{
  TriangleMesh one = Noisy(Cube(8), 0.2);
  TriangleMesh three = one;
  Automatic(one);
  OddThreads threads(3);
  AutomaticReport report;
  EXPECT_TRUE(DenoiseAutomatically(three, 1.0, report, threads));
  EXPECT_EQ(Distance(one.Positions, three.Positions), 0.0);
}

TEST(AutomaticMesh, OrderPlaceAndSizeDoNotMatter)
{
  TriangleMesh mesh = Noisy(Cube(8), 0.2);
  ShuffledMesh shuffled(mesh);
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(2.0, 1.0, -1.0).normalized()).toRotationMatrix();
  const Vec3 shift(5.0, -3.0, 2.0);
  for (Vec3& p : shuffled.Mesh.Positions)
  {
    p = 4.0 * (turn * p) + shift;
  }
  const AutomaticReport report = Automatic(mesh);
  const AutomaticReport other = Automatic(shuffled.Mesh);
  EXPECT_FALSE(report.Plan.Steps.empty());
  EXPECT_EQ(report.Plan.Methods, other.Plan.Methods);
  EXPECT_NEAR(report.Plan.Noise.Level, other.Plan.Noise.Level, 1e-6);
  for (std::size_t v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    const Vec3 expected = 4.0 * (turn * mesh.Positions[v]) + shift;
    EXPECT_LT((shuffled.Mesh.Positions[shuffled.Vertices[v]] - expected).norm(), 1e-7) << v;
  }
}

// Patches stand for a mesh of more faces.
TEST(AutomaticMesh, Samples)
{
  const TriangleMesh mesh = Cube(30);
  Execution serial;
  const MeshSample whole = TakeSample(mesh, mesh.NumberOfFaces(), serial);
  EXPECT_EQ(whole.Mesh.NumberOfFaces(), mesh.NumberOfFaces());
  EXPECT_EQ(whole.Mesh.NumberOfVertices(), mesh.NumberOfVertices());
  const MeshSample part = TakeSample(mesh, 3000, serial);
  EXPECT_LE(part.Mesh.NumberOfFaces(), 3000u);
  EXPECT_GT(part.Mesh.NumberOfFaces(), 1000u);
  EXPECT_EQ(part.Keys.size(), part.Mesh.NumberOfVertices());
  EXPECT_EQ(part.Inner.size(), part.Mesh.NumberOfFaces());
  EXPECT_GT(std::count(part.Inner.begin(), part.Inner.end(), 1), 500);
}

TEST(AutomaticMesh, OddMeshesStayAsTheyAre)
{
  for (const TriangleMesh& odd : OddMeshes())
  {
    TriangleMesh mesh = odd;
    EXPECT_TRUE(Automatic(mesh).Plan.Steps.empty());
    EXPECT_EQ(Distance(mesh.Positions, odd.Positions), 0.0);
    EXPECT_EQ(mesh.Triangles, odd.Triangles);
  }
}

TEST(AutomaticMesh, EveryFaultyMeshGetsThrough)
{
  for (const MeshRecipe& recipe : MeshRecipes())
  {
    TriangleMesh mesh = recipe.Make(2);
    const TriangleMesh before = mesh;
    Automatic(mesh);
    EXPECT_EQ(mesh.Triangles, before.Triangles) << recipe.Name;
    for (const Vec3& p : mesh.Positions)
    {
      EXPECT_TRUE(p.allFinite()) << recipe.Name;
    }
  }
}

TEST(AutomaticMesh, StopsWhenAsked)
{
  const TriangleMesh noisy = Noisy(Cube(6), 0.2);
  for (const int patience : { 0, 1, 5, 40, 200 })
  {
    TriangleMesh mesh = noisy;
    Impatient execution(patience);
    AutomaticReport report;
    EXPECT_FALSE(DenoiseAutomatically(mesh, 1.0, report, execution)) << patience;
  }
}

TEST(AutomaticMesh, CandidatesAreNamed)
{
  for (const CandidateChain& chain : CandidateChains())
  {
    EXPECT_FALSE(chain.Steps.empty());
    EXPECT_EQ(chain.Steps.size(), chain.Methods.size());
  }
}
