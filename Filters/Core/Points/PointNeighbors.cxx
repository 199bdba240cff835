// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PointNeighbors.h"

#include "KdTree.h"
#include "RobustScale.h"

#include <cmath>

namespace SurfaceDenoising
{

NeighborGraph FirstNeighbors(const NeighborGraph& graph, std::size_t count, Execution& execution)
{
  return BuildRows(execution, graph.NumberOfRows(),
    [&](std::size_t i, Buffer<Index>& row)
    {
      const Span<Index> all = graph.Row(i);
      row.insert(row.end(), all.begin(), all.begin() + std::min(count, all.size()));
    });
}

Buffer<double> PointSpacings(const Buffer<Vec3>& points, const NeighborGraph& nearest,
  Execution& execution)
{
  Buffer<double> spacings(points.size());
  execution.For(points.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Span<Index> row = nearest.Row(i);
        const std::size_t k = std::min(row.size(), SpacingNeighbors);
        spacings[i] = k == 0 ? 0.0
                             : (points[row[k - 1]] - points[i]).norm() *
            std::sqrt(3.14159265358979323846 / static_cast<double>(k));
      }
    });
  return spacings;
}

double MedianSpacing(const Buffer<double>& spacings)
{
  Buffer<double> apart;
  for (const double spacing : spacings)
  {
    if (spacing > 0.0)
    {
      apart.push_back(spacing);
    }
  }
  return Median(apart);
}

NeighborGraph PointsWithinRadius(const Buffer<Vec3>& points, double radius, std::size_t limit,
  Execution& execution)
{
  const KdTree tree(points);
  return BuildRows(execution, points.size(),
    [&](std::size_t i, Buffer<Index>& row)
    {
      static thread_local std::vector<Index> found;
      const std::size_t first = row.size();
      tree.Within(points[i], radius, found, limit < NoIndex ? limit + 1 : NoIndex);
      for (const Index j : found)
      {
        if (j != i && row.size() - first < limit)
        {
          row.push_back(j);
        }
      }
    });
}

}
