// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FlipGuard.h"
#include "RandomMeshes.h"
#include "VertexUpdate.h"

#include <gtest/gtest.h>

using namespace SurfaceDenoising;

namespace
{

/// Moves the vertices of the mesh; returns the number of guarded vertices.
std::size_t Move(TriangleMesh& mesh, const Buffer<Vec3>& targets,
  const VertexUpdateSettings& settings, int count = 1)
{
  Execution serial;
  const CompressedRows stars = VertexStars(mesh);
  const EdgeCensus edges = TakeEdgeCensus(mesh, stars, serial);
  Buffer<Vec3> positions = mesh.Positions;
  VertexUpdate update(mesh, stars, edges.BoundaryVertex, edges.MeanEdgeLength, settings);
  EXPECT_TRUE(update.Run(positions, targets, count, serial, 0.0, 1.0));
  mesh.Positions = positions;
  return update.NumberOfGuardedVertices();
}

/// A vertex above the middle of a square ring.
TriangleMesh Fan()
{
  TriangleMesh mesh;
  mesh.Positions = { Vec3(0, 0, 0.5), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0),
    Vec3(0, -1, 0) };
  for (Index i = 0; i < 4; ++i)
  {
    mesh.Triangles.push_back({ 0, 1 + i, 1 + (i + 1) % 4 });
  }
  return mesh;
}

const Buffer<Vec3> Up(4, Vec3(0, 0, 1));

/// sum_f A_f |n_f - m_f|^2 = sum_f 2 A_f - 2 s_f . m_f
double FitEnergy(const TriangleMesh& mesh, const Buffer<Vec3>& targets)
{
  double energy = 0.0;
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    const Vec3 s = 0.5 * mesh.DoubleAreaVector(f);
    energy += 2.0 * s.norm() - 2.0 * s.dot(targets[f]);
  }
  return energy;
}

}

TEST(VertexUpdate, OneStepOfTheFan)
{
  const std::pair<VertexScheme, double> heights[] = { { VertexScheme::FaceMean, 0.166667 },
    { VertexScheme::ConstantStep, 0.277778 }, { VertexScheme::AreaWeighted, 0.166667 },
    { VertexScheme::IntegralFit, 0.336701 } };
  for (const auto& row : heights)
  {
    TriangleMesh mesh = Fan();
    VertexUpdateSettings settings;
    settings.Scheme = row.first;
    Move(mesh, Up, settings);
    EXPECT_LT((mesh.Positions[0] - Vec3(0, 0, row.second)).norm(), 1e-6) << int(row.first);
    for (std::size_t v = 1; v < 5; ++v)
    {
      EXPECT_EQ(mesh.Positions[v], Fan().Positions[v]); // the ring is the boundary
    }
  }
}

TEST(VertexUpdate, EdgeWeightedStepOfATiltedFan)
{
  TriangleMesh mesh = Fan();
  mesh.Positions[0] = Vec3(0.2, 0.1, 0.5);
  VertexUpdateSettings settings;
  settings.Scheme = VertexScheme::EdgeWeighted;
  settings.Relaxation = 0.2;
  Move(mesh, Up, settings);
  EXPECT_LT((mesh.Positions[0] - Vec3(0.088612, 0.044451, 0.066667)).norm(), 1e-6);

  // Without relaxation it is the mean over the faces.
  settings.Relaxation = 0.0;
  mesh = Fan();
  Move(mesh, Up, settings);
  EXPECT_NEAR(mesh.Positions[0].z(), 1.0 / 6.0, 1e-15);
}

TEST(VertexUpdate, InputPullGoesBackAlongTheNormal)
{
  VertexUpdateSettings settings;
  settings.InputPull = 0.25;
  TriangleMesh mesh = Fan();
  Move(mesh, Up, settings);
  EXPECT_NEAR(mesh.Positions[0].z(), 1.0 / 6.0 + 0.25 * (0.5 - 1.0 / 6.0), 1e-15);
}

TEST(VertexUpdate, IntegralFitDescendsItsEnergy)
{
  EXPECT_NEAR(FitEnergy(Fan(), Up), 0.898979, 1e-6);
  const TriangleMesh mesh = MeshRecipes()[2].Make(1);
  PortableRandom random(4);
  Buffer<Vec3> targets;
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    targets.push_back(random.Direction());
  }
  TriangleMesh moved = mesh;
  VertexUpdateSettings settings;
  settings.Scheme = VertexScheme::IntegralFit;
  Move(moved, targets, settings);
  constexpr double h = 1e-6;
  for (std::size_t v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      TriangleMesh there = mesh;
      TriangleMesh back = mesh;
      there.Positions[v][axis] += h;
      back.Positions[v][axis] -= h;
      const double slope = (FitEnergy(there, targets) - FitEnergy(back, targets)) / (2.0 * h);
      EXPECT_NEAR(moved.Positions[v][axis] - mesh.Positions[v][axis], -0.05 * slope, 1e-9);
    }
  }
}

TEST(VertexUpdate, FacesWithoutTargetAreIgnored)
{
  for (const VertexScheme scheme : { VertexScheme::FaceMean, VertexScheme::AreaWeighted })
  {
    VertexUpdateSettings settings;
    settings.Scheme = scheme;
    TriangleMesh mesh = Fan();
    Buffer<Vec3> targets = Up;
    targets[1] = Vec3(0, 0, 0);
    Move(mesh, targets, settings);
    EXPECT_NEAR(mesh.Positions[0].z(), 1.0 / 6.0, 1e-15); // the mean of the three others
    mesh = Fan();
    Move(mesh, Buffer<Vec3>(4, Vec3(0, 0, 0)), settings);
    EXPECT_EQ(mesh.Positions, Fan().Positions);
  }
}

TEST(VertexUpdate, FreeBoundaryMoves)
{
  TriangleMesh mesh = Fan();
  VertexUpdateSettings settings;
  settings.Boundary = BoundaryHandling::Free;
  Move(mesh, Up, settings);
  EXPECT_NEAR(mesh.Positions[1].z(), 0.5 / 3.0, 1e-15);
}

TEST(VertexUpdate, SlidingBoundaryStaysOnItsBorder)
{
  TriangleMesh mesh = PlaneSheet(6, 2);
  PortableRandom random(3);
  for (Vec3& p : mesh.Positions)
  {
    p.z() = 0.02 * random.Gaussian();
  }
  const TriangleMesh before = mesh;
  Buffer<Vec3> targets;
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    targets.push_back(Vec3(0.3 * random.Gaussian(), 0.3 * random.Gaussian(), 1.0).normalized());
  }
  VertexUpdateSettings settings;
  settings.Boundary = BoundaryHandling::Slide;
  Move(mesh, targets, settings);

  Execution serial;
  const CompressedRows stars = VertexStars(before);
  const EdgeCensus edges = TakeEdgeCensus(before, stars, serial);
  for (Index v = 0; v < before.NumberOfVertices(); ++v)
  {
    if (!edges.BoundaryVertex[v])
    {
      continue;
    }
    Vec3 normal(0, 0, 0);
    for (const Index f : stars.Row(v))
    {
      normal += before.DoubleAreaVector(f);
    }
    std::vector<Spoke> spokes;
    CollectSpokes(before, stars.Row(v), v, spokes);
    std::vector<Vec3> ends;
    for (const Spoke& spoke : spokes)
    {
      if (spoke.Out + spoke.In == 1)
      {
        ends.push_back(before.Positions[spoke.Vertex]);
      }
    }
    ASSERT_EQ(ends.size(), 2u);
    const Vec3 inward = normal.cross(ends[1] - ends[0]).normalized();
    const Vec3 step = mesh.Positions[v] - before.Positions[v];
    EXPECT_GT(step.norm(), 1e-6);
    EXPECT_NEAR(step.dot(inward), 0.0, 1e-15);
  }
}

TEST(VertexUpdate, MaximumDisplacementCountsFromTheStart)
{
  const TriangleMesh before = MeshRecipes()[2].Make(1);
  const Buffer<Vec3> targets(before.NumberOfFaces(), Vec3(0, 0, 1)); // flattens the sphere
  VertexUpdateSettings settings;
  settings.MaximumDisplacement = 0.1;
  TriangleMesh mesh = before;
  Move(mesh, targets, settings, 20);
  double farthest = 0.0;
  for (std::size_t v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    farthest = std::max(farthest, (mesh.Positions[v] - before.Positions[v]).norm());
  }
  EXPECT_NEAR(farthest, 0.1, 1e-15);
}

TEST(FlipGuard, GoodStepsPassUnchanged)
{
  TriangleMesh guarded = Fan();
  TriangleMesh free = Fan();
  VertexUpdateSettings settings;
  Move(free, Up, settings);
  settings.PreventFlips = true;
  EXPECT_EQ(Move(guarded, Up, settings), 0u);
  EXPECT_EQ(guarded.Positions, free.Positions);
}

// The middle vertex wants to leave the ring; half of the way would do.
TEST(FlipGuard, StepsAreHalvedUntilNoFaceTurns)
{
  const TriangleMesh mesh = Fan();
  Execution serial;
  Buffer<Vec3> moved = mesh.Positions;
  moved[0] = Vec3(1.5, 0.1, 0.0);
  const Vec3 step = moved[0] - mesh.Positions[0];
  const std::size_t guarded =
    PreventFlips(mesh, VertexStars(mesh), 1.0, Up, mesh.Positions, moved, serial);
  EXPECT_EQ(guarded, 4u); // the two faces beyond which it left have four vertices
  EXPECT_LT((moved[0] - (mesh.Positions[0] + 0.5 * step)).norm(), 1e-15);
  for (std::size_t v = 1; v < 5; ++v)
  {
    EXPECT_EQ(moved[v], mesh.Positions[v]);
  }
}

TEST(FlipGuard, FacesThatWereTurnedMayGetBetter)
{
  TriangleMesh mesh = Fan();
  mesh.Positions[0] = Vec3(3.0, 0.1, 0.0);
  Execution serial;
  Buffer<Vec3> moved = mesh.Positions;
  moved[0] = Vec3(2.0, 0.1, 0.0);
  EXPECT_EQ(PreventFlips(mesh, VertexStars(mesh), 1.0, Up, mesh.Positions, moved, serial), 0u);
  EXPECT_EQ(moved[0], Vec3(2.0, 0.1, 0.0));
}

TEST(FlipGuard, NoFaceGetsWorseThanTheLimitOnRandomMeshes)
{
  for (const MeshRecipe& recipe : MeshRecipes())
  {
    const TriangleMesh mesh = recipe.Make(9);
    Execution serial;
    FaceGeometry geometry;
    ComputeFaceGeometry(mesh, 1.0, geometry, serial);
    PortableRandom random(2);
    Buffer<Vec3> moved = mesh.Positions;
    for (Vec3& p : moved)
    {
      p += 0.2 * random.Gaussian() * random.Direction();
    }
    TriangleMesh after = mesh;
    const std::size_t guarded =
      PreventFlips(mesh, VertexStars(mesh), 0.2, geometry.Normals, mesh.Positions, moved, serial);
    EXPECT_TRUE(guarded > 0 || mesh.NumberOfFaces() == 1) << recipe.Name;
    after.Positions = moved;
    for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
    {
      const Vec3 s = after.DoubleAreaVector(f);
      EXPECT_TRUE(geometry.Areas[f] == 0.0 ||
        s.dot(geometry.Normals[f]) >= 0.1736481 * s.norm()) // cosine of 80 degrees
        << recipe.Name << " " << f;
    }
  }
}
