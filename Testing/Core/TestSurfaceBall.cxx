// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Balls along a surface against a search without any cleverness.

#include "OneStage/SurfaceBall.h"
#include "OneStage/VertexRings.h"
#include "RandomMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

using namespace SurfaceDenoising;

namespace
{

std::set<Index> Members(const SurfaceBall& ball)
{
  std::set<Index> members;
  for (std::size_t k = 0; k < ball.Size(); ++k)
  {
    EXPECT_TRUE(members.insert(ball[k]).second);
  }
  return members;
}

/// Grows a set by the neighbours of its members that are inside, until it stops growing.
template <typename Inside, typename AreNeighbors>
std::set<Index> Grown(std::set<Index> members, std::size_t count, Inside inside,
  AreNeighbors areNeighbors)
{
  for (std::size_t before = 0; before != members.size();)
  {
    before = members.size();
    for (Index i = 0; i < count; ++i)
    {
      if (inside(i) &&
        std::any_of(members.begin(), members.end(), [&](Index j) { return areNeighbors(i, j); }))
      {
        members.insert(i);
      }
    }
  }
  return members;
}

class Balls : public testing::TestWithParam<MeshRecipe>
{
protected:
  TriangleMesh Mesh = GetParam().Make(4);
  CompressedRows Stars = VertexStars(this->Mesh);
  Execution Serial;
};

}

TEST_P(Balls, Vertices)
{
  const CompressedRows rings = VertexRings(this->Mesh, this->Stars, this->Serial);
  SurfaceBall ball;
  for (Index v = 0; v < this->Mesh.NumberOfVertices(); v += 5)
  {
    const double radius = 0.1 + 0.03 * (v % 17);
    auto distance = [&](Index w)
    { return (this->Mesh.Positions[w] - this->Mesh.Positions[v]).norm(); };
    ball.GrowVertices(rings, this->Mesh.Positions, v, radius);
    EXPECT_EQ(ball[0], v);
    EXPECT_EQ(Members(ball),
      Grown(
        { v }, this->Mesh.NumberOfVertices(), [&](Index w) { return distance(w) <= radius; },
        [&](Index a, Index b)
        {
          const Span<Index> ring = rings.Row(a);
          return std::find(ring.begin(), ring.end(), b) != ring.end();
        }));

    for (std::size_t k = 0; k < ball.Size(); ++k)
    {
      ball.Heights[k] = 0.1 * double(k);
    }
    const Buffer<double> weights = ball.Weigh(0.4, 0.3);
    for (std::size_t k = 0; k < ball.Size(); ++k)
    {
      const double d = distance(ball[k]);
      const double h = 0.1 * double(k);
      EXPECT_NEAR(weights[k], std::exp(-d * d / 0.32 - h * h / 0.18), 1e-14);
    }
  }
}

TEST_P(Balls, Faces)
{
  FaceGeometry faces;
  ComputeFaceGeometry(this->Mesh, 1.0, faces, this->Serial);
  SurfaceBall ball;
  for (Index v = 0; v < this->Mesh.NumberOfVertices(); v += 5)
  {
    const double radius = 0.1 + 0.03 * (v % 17);
    auto inside = [&](Index f)
    { return (faces.Centroids[f] - this->Mesh.Positions[v]).norm() <= radius; };
    std::set<Index> start;
    for (const Index f : this->Stars.Row(v))
    {
      if (inside(f))
      {
        start.insert(f);
      }
    }
    ball.GrowFaces(this->Mesh, this->Stars, faces.Centroids, v, radius);
    EXPECT_EQ(Members(ball),
      Grown(start, this->Mesh.NumberOfFaces(), inside,
        [&](Index f, Index g)
        {
          const Triangle& t = this->Mesh.Triangles[f];
          const Triangle& s = this->Mesh.Triangles[g];
          return HasCorner(t, s[0]) || HasCorner(t, s[1]) || HasCorner(t, s[2]);
        }));
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, Balls, testing::ValuesIn(MeshRecipes()),
  [](const auto& info) { return std::string(info.param.Name); });

TEST(SurfaceBall, ScalesWithoutEndAndScalesThatUnderflow)
{
  const TriangleMesh sheet = PlaneSheet(4, 3);
  Execution serial;
  const CompressedRows rings = VertexRings(sheet, VertexStars(sheet), serial);
  SurfaceBall ball;
  ball.GrowVertices(rings, sheet.Positions, 12, 10.0);
  EXPECT_EQ(ball.Size(), sheet.NumberOfVertices());
  ball.Heights.back() = 1.0;
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double w : ball.Weigh(infinite, infinite))
  {
    EXPECT_EQ(w, 1.0);
  }
  const Buffer<double>& weights = ball.Weigh(infinite, 1e-200);
  EXPECT_EQ(weights.front(), 1.0);
  EXPECT_LT(weights.back(), 1e-300);
}

TEST(IndexSet, IsASet)
{
  PortableRandom random(9);
  IndexSet set;
  for (int round = 0; round < 20; ++round)
  {
    set.Clear();
    std::set<Index> expected;
    for (int k = 0; k < 1000; ++k)
    {
      const Index value = random.Below(round % 2 == 0 ? 300 : 4000000000u);
      ASSERT_EQ(set.Insert(value), expected.insert(value).second);
    }
  }
}
