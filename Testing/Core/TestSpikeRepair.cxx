// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Impulses are put back, and nothing else is taken for them.

#include "Automatic/SpikeRepair.h"
#include "Automatic/Spikes.h"
#include "AutomaticShapes.h"
#include "CompareMeshes.h"
#include "Impatient.h"
#include "ImpulsiveShapes.h"
#include "NoisyCube.h"
#include "OddThreads.h"
#include "OneStage/VertexRings.h"

namespace
{

std::size_t Repair(TriangleMesh& mesh, Execution& execution)
{
  const CompressedRows stars = VertexStars(mesh);
  const EdgeCensus edges = TakeEdgeCensus(mesh, stars, execution);
  std::size_t repaired = 0;
  EXPECT_TRUE(RepairSpikes(mesh, stars, edges, repaired, execution));
  return repaired;
}

std::size_t Repair(TriangleMesh& mesh)
{
  Execution serial;
  return Repair(mesh, serial);
}

/// All vertices become the means of their neighbours, that many times.
TriangleMesh Smoothed(TriangleMesh mesh, int times)
{
  Execution serial;
  const CompressedRows rings = VertexRings(mesh, VertexStars(mesh), serial);
  for (int step = 0; step < times; ++step)
  {
    const Buffer<Vec3> before = mesh.Positions;
    for (std::size_t v = 0; v < before.size(); ++v)
    {
      mesh.Positions[v].setZero();
      for (const Index w : rings.Row(v))
      {
        mesh.Positions[v] += before[w] / double(rings.Row(v).size());
      }
    }
  }
  return mesh;
}

}

// The steps are still there after one round, and look like spikes on flat ground.
TEST(SpikeRepair, LeavesSmoothedVoxelsAlone)
{
  for (const int radius : { 8, 10, 13 })
  {
    for (const int times : { 0, 1, 2, 3 })
    {
      const TriangleMesh clean = Smoothed(Voxels(radius), times);
      TriangleMesh mesh = clean;
      EXPECT_EQ(Repair(mesh), 0u) << radius << " " << times;
      EXPECT_EQ(Distance(mesh.Positions, clean.Positions), 0.0) << radius << " " << times;
    }
  }
}

TEST(SpikeRepair, LeavesCleanShapesAlone)
{
  // The inner corners of a torus with few stick out of their fits.
  std::vector<TriangleMesh> shapes = { RoughTorus(), Torus(6) };
  for (const AutomaticShape& shape : AutomaticShapes())
  {
    shapes.push_back(shape.Make());
  }
  for (const TriangleMesh& clean : shapes)
  {
    TriangleMesh mesh = clean;
    EXPECT_EQ(Repair(mesh), 0u);
    EXPECT_EQ(Distance(mesh.Positions, clean.Positions), 0.0);
  }
}

TEST(SpikeRepair, LeavesGaussianNoiseAlone)
{
  for (const TriangleMesh& clean :
    { Cube(12), Torus(26), RoughTorus(), Voxels(10), Smoothed(Voxels(10), 1) })
  {
    for (const double level : { 0.05, 0.1, 0.3, 0.7 })
    {
      TriangleMesh mesh = clean;
      AddNormalNoise(mesh, level, 12345);
      EXPECT_EQ(Repair(mesh), 0u) << level;
      mesh = clean;
      AddDirectionNoise(mesh, level, 12345);
      EXPECT_EQ(Repair(mesh), 0u) << level;
    }
  }
}

// Amplitudes along the normals have heavy tails if directions are random, but not as heavy. By
// chance some look so at first.
TEST(SpikeRepair, LeavesNoiseInRandomDirectionsAlone)
{
  Execution serial;
  int found = 0;
  for (std::uint32_t seed = 1; seed <= 16; ++seed)
  {
    for (const double level : { 0.2, 0.3, 0.5 })
    {
      TriangleMesh mesh = Prism(7, 14, 30);
      AddDirectionNoise(mesh, level, seed);
      Buffer<unsigned char> marks;
      found += FindImpulses(mesh, VertexStars(mesh), marks, serial) ? 1 : 0;
    }
  }
  EXPECT_LE(found, 5) << "of 48";
}

// What is usual differs from place to place.
TEST(SpikeRepair, FindsImpulsesOnRoughShapes)
{
  const TriangleMesh clean = RoughTorus();
  for (const bool alongNormals : { true, false })
  {
    for (const double share : { 0.1, 0.2 })
    {
      const TriangleMesh noisy = WithImpulses(clean, share, alongNormals);
      TriangleMesh mesh = noisy;
      EXPECT_GT(Repair(mesh), 0.25 * share * double(mesh.NumberOfVertices()));
      EXPECT_LT(Measure(mesh, clean).MeanAngle, 0.65 * Measure(noisy, clean).MeanAngle)
        << alongNormals << " " << share;
    }
  }
}

// Details hide many impulses, and some of them look like one. Most of what moves was out of place.
TEST(SpikeRepair, FindsImpulsesAmongDetails)
{
  const TriangleMesh clean = RoughTorus(0.04);
  for (const double share : { 0.1, 0.2 })
  {
    const TriangleMesh noisy = WithImpulses(clean, share, false);
    TriangleMesh mesh = noisy;
    const std::size_t repaired = Repair(mesh);
    std::size_t inPlace = 0;
    for (std::size_t v = 0; v < mesh.NumberOfVertices(); ++v)
    {
      inPlace +=
        mesh.Positions[v] != noisy.Positions[v] && noisy.Positions[v] == clean.Positions[v];
    }
    EXPECT_GT(repaired, 0.15 * share * double(mesh.NumberOfVertices()));
    EXPECT_LT(inPlace, 0.4 * double(repaired)) << share;
    EXPECT_LT(Measure(mesh, clean).MeanAngle, 0.8 * Measure(noisy, clean).MeanAngle) << share;
  }
}

// Steps of voxels are made up worse than the impulses have left them.
TEST(SpikeRepair, IsUndoneWhereItWouldMissMore)
{
  for (const bool alongNormals : { true, false })
  {
    const TriangleMesh noisy = WithImpulses(Voxels(10), 0.2, alongNormals);
    TriangleMesh mesh = noisy;
    EXPECT_EQ(Repair(mesh), 0u);
    EXPECT_EQ(Distance(mesh.Positions, noisy.Positions), 0.0);
  }
}

TEST(SpikeRepair, MovesNothingElse)
{
  const TriangleMesh noisy = WithImpulses(Torus(26), 0.2, true);
  TriangleMesh mesh = noisy;
  const std::size_t repaired = Repair(mesh);
  std::size_t moved = 0;
  for (std::size_t v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    moved += mesh.Positions[v] != noisy.Positions[v] ? 1 : 0;
  }
  EXPECT_GT(repaired, 0u);
  EXPECT_EQ(moved, repaired);
}

TEST(SpikeRepair, OrderAndThreadsDoNotMatter)
{
  const TriangleMesh noisy = WithImpulses(RoughTorus(), 0.2, true);
  TriangleMesh mesh = noisy;
  const std::size_t repaired = Repair(mesh);
  EXPECT_GT(repaired, 0u);
  TriangleMesh threaded = noisy;
  OddThreads threads(3);
  EXPECT_EQ(Repair(threaded, threads), repaired);
  EXPECT_EQ(Distance(threaded.Positions, mesh.Positions), 0.0);
  ShuffledMesh shuffled(noisy);
  EXPECT_EQ(Repair(shuffled.Mesh), repaired);
  for (std::size_t v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    EXPECT_LT((shuffled.Mesh.Positions[shuffled.Vertices[v]] - mesh.Positions[v]).norm(), 1e-9);
  }
}

TEST(SpikeRepair, PlaceAndSizeDoNotMatter)
{
  TriangleMesh mesh = WithImpulses(RoughTorus(), 0.2, true);
  TriangleMesh other = mesh;
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(2.0, 1.0, -1.0).normalized()).toRotationMatrix();
  const auto place = [&](const Vec3& p) { return Vec3(4.0 * (turn * p) + Vec3(5.0, -3.0, 2.0)); };
  std::transform(mesh.Positions.begin(), mesh.Positions.end(), other.Positions.begin(), place);
  const std::size_t repaired = Repair(mesh);
  EXPECT_GT(repaired, 0u);
  EXPECT_EQ(Repair(other), repaired);
  for (std::size_t v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    EXPECT_LT((other.Positions[v] - place(mesh.Positions[v])).norm(), 1e-7) << v;
  }
}

// The first questions are all tried, of later ones some.
TEST(SpikeRepair, StopsAtAnyQuestion)
{
  const TriangleMesh noisy = WithImpulses(Torus(14), 0.2, true);
  int questions = 0;
  for (bool finished = false; !finished; questions += 1 + questions / 10)
  {
    TriangleMesh mesh = noisy;
    Impatient execution(questions);
    const CompressedRows stars = VertexStars(mesh);
    Execution serial;
    const EdgeCensus edges = TakeEdgeCensus(mesh, stars, serial);
    std::size_t repaired = 0;
    finished = RepairSpikes(mesh, stars, edges, repaired, execution);
  }
  EXPECT_GT(questions, 20);
}

TEST(SpikeRepair, GetsThroughFaultyMeshes)
{
  for (const TriangleMesh& odd : OddMeshes())
  {
    TriangleMesh mesh = odd;
    EXPECT_EQ(Repair(mesh), 0u);
  }
  for (const MeshRecipe& recipe : MeshRecipes())
  {
    TriangleMesh mesh = recipe.Make(2);
    Repair(mesh);
    for (const Vec3& p : mesh.Positions)
    {
      EXPECT_TRUE(p.allFinite()) << recipe.Name;
    }
  }
}
