// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "InterruptedLoops.h"
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

struct Edge
{
  double Length;
  Index From;
  Index To;
};

/// The spanning trees with the least sum of 1 - |n_i . n_j|. Returns false if asked to stop.
bool GrowTrees(const NeighborGraph& nearest, const Buffer<Vec3>& normals, CompressedRows& trees,
  Execution& execution, double fraction)
{
  Buffer<Edge> edges(nearest.NumberOfIds());
  InterruptedExecution interrupted(execution, fraction);
  interrupted.For(
    normals.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        for (std::uint64_t e = nearest.Offsets[i]; e < nearest.Offsets[i + 1]; ++e)
        {
          const Index j = nearest.Ids[e];
          edges[e] = { 1.0 - std::abs(normals[i].dot(normals[j])), static_cast<Index>(i), j };
        }
      }
    },
    4096);
  if (!interrupted.Proceed(fraction) ||
    !SortStably(
      edges, [](const Edge& a, const Edge& b) { return a.Length < b.Length; }, execution, fraction))
  {
    return false;
  }

  std::vector<Index> setOf(normals.size());
  std::iota(setOf.begin(), setOf.end(), Index(0));
  auto find = [&setOf](Index i)
  {
    while (setOf[i] != i)
    {
      i = setOf[i] = setOf[setOf[i]];
    }
    return i;
  };
  trees.Offsets.assign(normals.size() + 1, 0);
  std::size_t used = 0;
  auto use = [&](std::size_t e)
  {
    const Edge edge = edges[e];
    const Index a = find(edge.From);
    const Index b = find(edge.To);
    if (a != b)
    {
      setOf[b] = a;
      ++trees.Offsets[edge.From];
      ++trees.Offsets[edge.To];
      edges[used++] = edge;
    }
  };
  if (!ForInOrder(edges.size(), use, execution, fraction))
  {
    return false;
  }
  // Offsets are the ends of the rows, until filling moves them to the starts.
  std::partial_sum(trees.Offsets.begin(), trees.Offsets.end(), trees.Offsets.begin());
  trees.Ids.resize(2 * used);
  auto fill = [&](std::size_t e)
  {
    trees.Ids[--trees.Offsets[edges[e].From]] = edges[e].To;
    trees.Ids[--trees.Offsets[edges[e].To]] = edges[e].From;
  };
  return ForInOrder(used, fill, execution, fraction);
}

/// Signs along these trees, from the highest point on. Returns false if asked to stop.
bool OrientFromTop(const Buffer<Vec3>& points, const NeighborGraph& nearest, Buffer<Vec3>& normals,
  Execution& execution, double fraction)
{
  CompressedRows trees;
  if (!GrowTrees(nearest, normals, trees, execution, fraction))
  {
    return false;
  }
  Buffer<Index> fromTop(points.size());
  std::iota(fromTop.begin(), fromTop.end(), Index(0));
  if (!SortStably(
        fromTop, [&](Index i, Index j) { return points[i][2] > points[j][2]; }, execution,
        fraction))
  {
    return false;
  }
  std::vector<bool> reached(points.size(), false);
  std::vector<Index> ahead;
  auto highest = fromTop.begin();
  return ForInOrder(
    points.size(),
    [&](std::size_t)
    {
      if (ahead.empty())
      {
        highest = std::find_if(highest, fromTop.end(), [&](Index i) { return !reached[i]; });
        if (normals[*highest][2] < 0.0)
        {
          normals[*highest] = -normals[*highest];
        }
        reached[*highest] = true;
        ahead.push_back(*highest);
      }
      const Index i = ahead.back();
      ahead.pop_back();
      for (const Index j : trees.Row(i))
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
    },
    execution, fraction);
}

}

bool ReleasedStartNormals(const Buffer<Vec3>& points, const NeighborGraph& nearest,
  Buffer<Vec3>& normals, Execution& execution, double first, double last)
{
  InterruptedExecution interrupted(execution, first, last);
  normals = NormalsOfPlanes(points, nearest, interrupted);
  return interrupted.Proceed(last) && OrientFromTop(points, nearest, normals, execution, last);
}

}
