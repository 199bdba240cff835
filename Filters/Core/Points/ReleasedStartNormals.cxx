// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlaneFit.h"
#include "ReleasedVotingTensor.h"

#include <numeric>

namespace SurfaceDenoising
{

namespace
{

Buffer<Vec3> NormalsOfPlanes(const Buffer<Vec3>& points, const NeighborGraph& nearest,
  Execution& execution)
{
  Buffer<Vec3> normals(points.size());
  execution.For(points.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        PlaneSum sum;
        for (const Index j : nearest.Row(i))
        {
          sum.Add(points[j] - points[i]);
        }
        normals[i] = sum.Fit().Normal;
      }
    });
  return normals;
}

/// Signs along the spanning tree with the least sum of 1 - |n_i . n_j|, from the highest point on.
void OrientFromTop(const Buffer<Vec3>& points, const NeighborGraph& nearest, Buffer<Vec3>& normals)
{
  struct Edge
  {
    double Length;
    Index From;
    Index To;
  };
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (const Index j : nearest.Row(i))
    {
      edges.push_back({ 1.0 - std::abs(normals[i].dot(normals[j])), static_cast<Index>(i), j });
    }
  }
  std::stable_sort(edges.begin(), edges.end(),
    [](const Edge& a, const Edge& b) { return a.Length < b.Length; });

  std::vector<Index> setOf(points.size());
  std::iota(setOf.begin(), setOf.end(), Index(0));
  auto find = [&setOf](Index i)
  {
    while (setOf[i] != i)
    {
      i = setOf[i] = setOf[setOf[i]];
    }
    return i;
  };
  std::vector<std::vector<Index>> tree(points.size());
  for (const Edge& edge : edges)
  {
    const Index a = find(edge.From);
    const Index b = find(edge.To);
    if (a != b)
    {
      setOf[b] = a;
      tree[edge.From].push_back(edge.To);
      tree[edge.To].push_back(edge.From);
    }
  }

  std::vector<Index> fromTop(points.size());
  std::iota(fromTop.begin(), fromTop.end(), Index(0));
  std::stable_sort(fromTop.begin(), fromTop.end(),
    [&](Index i, Index j) { return points[i][2] > points[j][2]; });
  std::vector<bool> reached(points.size(), false);
  std::vector<Index> ahead;
  for (const Index root : fromTop)
  {
    if (reached[root])
    {
      continue;
    }
    if (normals[root][2] < 0.0)
    {
      normals[root] = -normals[root];
    }
    reached[root] = true;
    ahead.assign(1, root);
    while (!ahead.empty())
    {
      const Index i = ahead.back();
      ahead.pop_back();
      for (const Index j : tree[i])
      {
        if (!reached[j])
        {
          if (normals[i].dot(normals[j]) < 0.0)
          {
            normals[j] = -normals[j];
          }
          reached[j] = true;
          ahead.push_back(j);
        }
      }
    }
  }
}

}

Buffer<Vec3> ReleasedStartNormals(const Buffer<Vec3>& points, const NeighborGraph& nearest,
  Execution& execution)
{
  Buffer<Vec3> normals = NormalsOfPlanes(points, nearest, execution);
  OrientFromTop(points, nearest, normals);
  return normals;
}

}
