// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleTree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace SurfaceDenoising;

namespace
{

/// Triangles anywhere in a cube, some of them without area, that share no vertices.
TriangleMesh RandomTriangles(std::size_t count, double size)
{
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  auto random = [&]()
  {
    const double x = uniform(generator);
    const double y = uniform(generator);
    return Vec3(x, y, uniform(generator));
  };
  TriangleMesh mesh;
  for (Index f = 0; f < count; ++f)
  {
    const Vec3 centre = random();
    for (int corner = 0; corner < 3; ++corner)
    {
      mesh.Positions.push_back(centre + size * random());
    }
    mesh.Triangles.push_back({ 3 * f, 3 * f + 1, 3 * f + (f % 10 == 9 ? 1 : 2) });
  }
  return mesh;
}

Buffer<double> Areas(const TriangleMesh& mesh)
{
  Execution serial;
  FaceGeometry geometry;
  ComputeFaceGeometry(mesh, 1.0, geometry, serial);
  return geometry.Areas;
}

}

TEST(TriangleTree, DistanceToATriangleInAllItsRegions)
{
  const Vec3 a(0.0, 0.0, 0.0);
  const Vec3 b(4.0, 0.0, 0.0);
  const Vec3 c(0.0, 4.0, 0.0);
  auto distance = [&](double x, double y, double z)
  { return std::sqrt(SquaredDistanceToTriangle(Vec3(x, y, z), a, b, c)); };
  EXPECT_DOUBLE_EQ(distance(1.0, 1.0, -2.0), 2.0); // face
  EXPECT_DOUBLE_EQ(distance(1.0, 1.0, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(distance(2.0, -3.0, 4.0), 5.0); // edges
  EXPECT_DOUBLE_EQ(distance(-3.0, 2.0, 4.0), 5.0);
  EXPECT_DOUBLE_EQ(distance(4.0, 4.0, 1.0), 3.0);   // sqrt(2^2 + 2^2 + 1)
  EXPECT_DOUBLE_EQ(distance(-2.0, -1.0, 2.0), 3.0); // vertices
  EXPECT_DOUBLE_EQ(distance(7.0, 0.0, 4.0), 5.0);
  EXPECT_DOUBLE_EQ(distance(-1.0, 8.0, 0.0), std::sqrt(17.0));
}

TEST(TriangleTree, FindsWhatTryingAllFinds)
{
  for (const double size : { 0.05, 0.8 }) // far apart, and a heap
  {
    const TriangleMesh mesh = RandomTriangles(500, size);
    const Buffer<double> areas = Areas(mesh);
    const TriangleTree tree(mesh, areas);
    for (const Vec3& query : RandomTriangles(200, 1.0).Positions)
    {
      TriangleTree::Hit expected;
      double best = std::numeric_limits<double>::infinity();
      for (Index f = 0; f < mesh.NumberOfFaces(); ++f)
      {
        const Triangle& t = mesh.Triangles[f];
        const double squared = areas[f] > 0.0
          ? SquaredDistanceToTriangle(query, mesh.Positions[t[0]], mesh.Positions[t[1]],
              mesh.Positions[t[2]])
          : std::numeric_limits<double>::infinity();
        if (squared < best)
        {
          best = squared;
          expected = { std::sqrt(squared), f };
        }
      }
      const TriangleTree::Hit hit = tree.Nearest(query);
      EXPECT_EQ(hit.Face, expected.Face);
      EXPECT_EQ(hit.Distance, expected.Distance);
    }
  }
}

TEST(TriangleTree, TiesGoToTheLowestNumber)
{
  TriangleMesh mesh = RandomTriangles(1, 1.0);
  mesh.Triangles.assign(1000, Triangle{ 0, 1, 2 });
  const TriangleTree tree(mesh, Areas(mesh));
  EXPECT_EQ(tree.Nearest(Vec3(3.0, 3.0, 3.0)).Face, 0u);
  EXPECT_EQ(tree.Nearest(mesh.Positions[1]).Face, 0u);
}

TEST(TriangleTree, NothingToFind)
{
  const TriangleMesh mesh = RandomTriangles(20, 1.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const TriangleTree empty((TriangleMesh()), {});
  const TriangleTree withoutArea(mesh, Buffer<double>(mesh.NumberOfFaces(), 0.0));
  const TriangleTree tree(mesh, Areas(mesh));
  for (const TriangleTree::Hit& hit :
    { empty.Nearest(Vec3(0.0, 0.0, 0.0)), withoutArea.Nearest(Vec3(0.0, 0.0, 0.0)),
      tree.Nearest(Vec3(0.0, nan, 0.0)), tree.Nearest(Vec3(1e300, 0.0, 0.0)) })
  {
    EXPECT_EQ(hit.Face, NoIndex);
    EXPECT_TRUE(std::isnan(hit.Distance));
  }
}
