// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Neighbourhoods against brute force over all pairs.

#include "NeighborGraph.h"
#include "OddThreads.h"
#include "RandomMeshes.h"

#include <gtest/gtest.h>

#include <set>

using namespace SurfaceDenoising;

namespace
{

using Sets = std::vector<std::set<Index>>;

/// The rows as sets; fails if a row has an entry twice or its own number.
Sets ToSets(const NeighborGraph& graph)
{
  Sets sets(graph.NumberOfRows());
  for (std::size_t i = 0; i < sets.size(); ++i)
  {
    for (const Index j : graph.Row(i))
    {
      EXPECT_TRUE(sets[i].insert(j).second) << i << " has " << j << " twice";
      EXPECT_NE(i, j);
    }
  }
  return sets;
}

std::set<Index> Corners(const Triangle& t) { return { t.begin(), t.end() }; }

/// Faces that share count or more different vertices.
Sets FacesThatShare(const TriangleMesh& mesh, std::size_t count)
{
  Sets sets(mesh.NumberOfFaces());
  for (Index f = 0; f < sets.size(); ++f)
  {
    for (Index g = 0; g < sets.size(); ++g)
    {
      std::size_t shared = 0;
      for (const Index v : Corners(mesh.Triangles[f]))
      {
        shared += Corners(mesh.Triangles[g]).count(v);
      }
      if (f != g && shared >= count)
      {
        sets[f].insert(g);
      }
    }
  }
  return sets;
}

Buffer<Vec3> Centroids(const TriangleMesh& mesh)
{
  Buffer<Vec3> centroids;
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    centroids.push_back(mesh.Centroid(f));
  }
  return centroids;
}

class NeighborGraphs : public testing::TestWithParam<MeshRecipe>
{
protected:
  TriangleMesh Mesh = GetParam().Make(5);
  CompressedRows Stars = VertexStars(this->Mesh);
  OddThreads Threads{ 3 };
};

}

TEST_P(NeighborGraphs, VertexStars)
{
  for (Index v = 0; v < this->Mesh.NumberOfVertices(); ++v)
  {
    std::vector<Index> expected;
    for (Index f = 0; f < this->Mesh.NumberOfFaces(); ++f)
    {
      if (HasCorner(this->Mesh.Triangles[f], v))
      {
        expected.push_back(f);
      }
    }
    const Span<Index> row = this->Stars.Row(v);
    EXPECT_EQ(std::vector<Index>(row.begin(), row.end()), expected);
  }
}

TEST_P(NeighborGraphs, EdgeAdjacent)
{
  EXPECT_EQ(ToSets(EdgeAdjacentFaces(this->Mesh, this->Stars, this->Threads)),
    FacesThatShare(this->Mesh, 2));
}

TEST_P(NeighborGraphs, VertexSharing)
{
  EXPECT_EQ(ToSets(VertexSharingFaces(this->Mesh, this->Stars, this->Threads)),
    FacesThatShare(this->Mesh, 1));
}

TEST_P(NeighborGraphs, WithinRadius)
{
  const Buffer<Vec3> centroids = Centroids(this->Mesh);
  const NeighborGraph connections = VertexSharingFaces(this->Mesh, this->Stars, this->Threads);
  const double d = MeanAdjacentDistance(EdgeAdjacentFaces(this->Mesh, this->Stars, this->Threads),
    centroids, this->Threads);
  for (const double radius : { 0.0, 0.9 * d, 1.7 * d, 3.1 * d, 100.0 * d })
  {
    for (const std::size_t most : { std::size_t(13), LargestBall })
    {
      // Growth by whole generations until nothing changes, or there are enough.
      Sets expected(centroids.size());
      for (Index f = 0; f < expected.size(); ++f)
      {
        std::set<Index> reached = { f };
        for (std::size_t before = 0; before != reached.size() && reached.size() - 1 <= most;)
        {
          before = reached.size();
          for (const Index from : std::set<Index>(reached))
          {
            for (const Index g : connections.Row(from))
            {
              if ((centroids[g] - centroids[f]).norm() <= radius)
              {
                reached.insert(g);
              }
            }
          }
        }
        reached.erase(f);
        expected[f] = reached;
      }
      EXPECT_EQ(ToSets(FacesWithinRadius(connections, centroids, radius, most, this->Threads)),
        expected);
    }
  }
}

TEST_P(NeighborGraphs, MeanAdjacentDistance)
{
  const Sets sets = FacesThatShare(this->Mesh, 2);
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t f = 0; f < sets.size(); ++f)
  {
    for (const Index g : sets[f])
    {
      sum += (this->Mesh.Centroid(f) - this->Mesh.Centroid(g)).norm();
      ++count;
    }
  }
  const double mean =
    MeanAdjacentDistance(EdgeAdjacentFaces(this->Mesh, this->Stars, this->Threads),
      Centroids(this->Mesh), this->Threads);
  EXPECT_NEAR(mean, count > 0 ? sum / count : 0.0, 1e-14);
}

TEST_P(NeighborGraphs, NearestPoints)
{
  const Buffer<Vec3>& points = this->Mesh.Positions;
  const NeighborGraph graph = NearestPoints(points, 7, this->Threads);
  ToSets(graph);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    std::vector<double> expected;
    for (std::size_t j = 0; j < points.size(); ++j)
    {
      if (i != j)
      {
        expected.push_back((points[i] - points[j]).norm());
      }
    }
    std::sort(expected.begin(), expected.end());
    expected.resize(std::min<std::size_t>(expected.size(), 7));
    std::vector<double> found;
    for (const Index j : graph.Row(i))
    {
      found.push_back((points[i] - points[j]).norm());
    }
    EXPECT_EQ(found, expected); // at equal distances any point will do
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, NeighborGraphs, testing::ValuesIn(MeshRecipes()),
  [](const auto& info) { return std::string(info.param.Name); });

// A thin wall: the other side is near but not connected within the radius.
TEST(NeighborGraph, RadiusDoesNotReachThroughAWall)
{
  TriangleMesh wall = Cube(8);
  for (Vec3& p : wall.Positions)
  {
    p.z() *= 0.01;
  }
  Execution serial;
  const Buffer<Vec3> centroids = Centroids(wall);
  const NeighborGraph graph = FacesWithinRadius(VertexSharingFaces(wall, VertexStars(wall), serial),
    centroids, 0.15, LargestBall, serial);
  for (std::size_t f = 0; f < wall.NumberOfFaces(); ++f)
  {
    const Vec3 fromMiddle = (centroids[f] - Vec3(0.5, 0.5, 0.005)).cwiseAbs();
    if (fromMiddle.z() > 0.0049 && fromMiddle.x() < 0.2 && fromMiddle.y() < 0.2)
    {
      EXPECT_GT(graph.Row(f).size(), 3u);
      for (const Index g : graph.Row(f))
      {
        EXPECT_LT(std::abs(centroids[g].z() - centroids[f].z()), 0.005);
      }
    }
  }
}

// Two cones on one circle.
TEST(NeighborGraph, FacesOfLargeFansAreNeighboursAcrossEdges)
{
  for (const Index sides : { Index(LargestFan), Index(LargestFan + 1) })
  {
    TriangleMesh mesh;
    for (Index i = 0; i < sides; ++i)
    {
      const double angle = 2.0 * 3.14159265358979323846 * i / sides;
      mesh.Positions.push_back(Vec3(std::cos(angle), std::sin(angle), 0.0));
      const Index next = (i + 1) % sides;
      mesh.Triangles.push_back({ i, next, sides });
      mesh.Triangles.push_back({ next, i, sides + 1 });
    }
    mesh.Positions.push_back(Vec3(0.0, 0.0, 1.0));
    mesh.Positions.push_back(Vec3(0.0, 0.0, -1.0));
    Execution serial;
    const Sets rows = ToSets(VertexSharingFaces(mesh, VertexStars(mesh), serial));
    if (sides <= LargestFan)
    {
      EXPECT_EQ(rows, FacesThatShare(mesh, 1));
      continue;
    }
    for (Index f = 0; f < rows.size(); ++f)
    {
      std::set<Index> expected;
      for (const Index side : { f / 2 + sides - 1, f / 2, f / 2 + 1 })
      {
        expected.insert(side % sides * 2);
        expected.insert(side % sides * 2 + 1);
      }
      expected.erase(f);
      EXPECT_EQ(rows[f], expected) << f;
    }
  }
}
