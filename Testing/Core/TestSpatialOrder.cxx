// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshDenoising.h"
#include "SpatialOrder.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

using namespace SurfaceDenoising;

namespace
{

/// A bumpy grid with 2 n^2 faces.
TriangleMesh Grid(Index n)
{
  TriangleMesh mesh;
  for (Index j = 0; j <= n; ++j)
  {
    for (Index i = 0; i <= n; ++i)
    {
      mesh.Positions.push_back(Vec3(i, j, std::sin(12.9 * i + 78.2 * j)));
      const Index a = j * (n + 1) + i;
      if (i < n && j < n)
      {
        mesh.Triangles.push_back({ a, a + 1, a + n + 2 });
        mesh.Triangles.push_back({ a, a + n + 2, a + n + 1 });
      }
    }
  }
  return mesh;
}

SpatialOrder Shuffle(const TriangleMesh& mesh, bool faces, bool vertices)
{
  SpatialOrder order;
  order.Faces.resize(mesh.NumberOfFaces());
  order.Vertices.resize(mesh.NumberOfVertices());
  std::iota(order.Faces.begin(), order.Faces.end(), Index(0));
  std::iota(order.Vertices.begin(), order.Vertices.end(), Index(0));
  std::mt19937 random(7);
  if (faces)
  {
    std::shuffle(order.Faces.begin(), order.Faces.end(), random);
  }
  if (vertices)
  {
    std::shuffle(order.Vertices.begin(), order.Vertices.end(), random);
  }
  return order;
}

}

TEST(SpatialOrder, TellsScatteredMeshesFromOrderedOnes)
{
  Execution execution;
  TriangleMesh mesh = Grid(180);
  EXPECT_FALSE(IsScattered(mesh, execution));
  EXPECT_TRUE(IsScattered(Reorder(mesh, Shuffle(mesh, true, false)), execution));
  EXPECT_TRUE(IsScattered(Reorder(mesh, Shuffle(mesh, false, true)), execution));

  // A point without faces may be anywhere, or nowhere.
  mesh.Positions.push_back(Vec3::Constant(std::nan("")));
  EXPECT_FALSE(IsScattered(mesh, execution));

  const TriangleMesh small = Grid(20);
  EXPECT_FALSE(IsScattered(Reorder(small, Shuffle(small, true, true)), execution));
}

TEST(SpatialOrder, RestoresLocality)
{
  Execution execution;
  TriangleMesh mesh = Grid(180);
  mesh.Positions.push_back(Vec3(1.0, 2.0, 3.0)); // without faces
  const TriangleMesh scattered = Reorder(mesh, Shuffle(mesh, true, true));
  const SpatialOrder order = FindSpatialOrder(scattered, execution);
  const TriangleMesh ordered = Reorder(scattered, order);
  EXPECT_FALSE(IsScattered(ordered, execution));
  ASSERT_EQ(ordered.NumberOfVertices(), mesh.NumberOfVertices());
  EXPECT_EQ(ordered.Positions.back(), Vec3(1.0, 2.0, 3.0));

  // The same faces, corner by corner.
  ASSERT_EQ(ordered.NumberOfFaces(), mesh.NumberOfFaces());
  for (std::size_t f = 0; f < ordered.NumberOfFaces(); ++f)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      ASSERT_EQ(ordered.Positions[ordered.Triangles[f][corner]],
        scattered.Positions[scattered.Triangles[order.Faces[f]][corner]]);
    }
  }
}

TEST(SpatialOrder, DoesNotShowInTheResult)
{
  Execution execution;
  TriangleMesh mesh = Grid(180);
  const SpatialOrder shuffle = Shuffle(mesh, true, true);
  TriangleMesh scattered = Reorder(mesh, shuffle);
  MeshDenoisingSettings settings;
  settings.NormalIterations = 3;
  settings.VertexIterations = 3;

  for (const bool given : { false, true })
  {
    TriangleMesh a = mesh;
    TriangleMesh b = scattered;
    Buffer<Vec3> normals(given ? mesh.NumberOfFaces() : 0, Vec3(0.0, 0.6, 0.8));
    Buffer<Vec3> scatteredNormals = normals;
    MeshDenoisingReport report;
    ASSERT_TRUE(DenoiseMesh(a, normals, settings, report, execution));
    ASSERT_TRUE(DenoiseMesh(b, scatteredNormals, settings, report, execution));
    double difference = 0.0;
    for (std::size_t v = 0; v < shuffle.Vertices.size(); ++v)
    {
      difference = std::max(difference, (b.Positions[v] - a.Positions[shuffle.Vertices[v]]).norm());
    }
    for (std::size_t f = 0; f < shuffle.Faces.size(); ++f)
    {
      difference = std::max(difference, (scatteredNormals[f] - normals[shuffle.Faces[f]]).norm());
    }
    EXPECT_LT(difference, 1e-10);
  }
}
