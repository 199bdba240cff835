// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PointNeighbors.h"

#include "NearestInRuns.h"
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
  Buffer<double> apart(spacings.size());
  const auto end = std::copy_if(spacings.begin(), spacings.end(), apart.begin(),
    [](double spacing) { return spacing > 0.0; });
  apart.resize(static_cast<std::size_t>(end - apart.begin()));
  return Median(apart);
}

NeighborGraph NearestOrderedPoints(const Buffer<Vec3>& points, std::size_t count,
  Execution& execution)
{
  const std::size_t size = points.size();
  count = std::min(count, size > 0 ? size - 1 : 0);
  NeighborGraph graph;
  graph.Offsets.resize(size + 1);
  execution.For(size + 1,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        graph.Offsets[i] = i * count;
      }
    });
  graph.Ids.resize(size * count);
  if (count == 0)
  {
    return graph;
  }
  const PointRuns runs(points, execution);
  execution.For(
    runs.NumberOfRuns(),
    [&](std::size_t begin, std::size_t end)
    {
      NearestInRuns search(runs, count);
      for (std::size_t run = begin; run < end; ++run)
      {
        search.Find(run, graph.Ids.data() + run * RunLength * count);
      }
    },
    64);
  return graph;
}

NeighborGraph PointsWithinRadius(const Buffer<Vec3>& points, double radius, std::size_t limit,
  Execution& execution)
{
  const PointRuns runs(points, execution);
  radius = std::max(radius, 0.0);
  return BuildRowsWith(execution, points.size(),
    [&]
    {
      return [&, search = RunSearch(runs)](std::size_t i, Buffer<Index>& row) mutable
      {
        // Chunks of rows begin with a run.
        if (i % RunLength == 0)
        {
          search.TakeRuns(i / RunLength, Above(radius));
        }
        const std::size_t found = search.TakePoints(points[i], radius * radius);
        const std::size_t sorted = limit < found ? limit + 1 : found;
        search.SortPoints(sorted);
        std::size_t appended = 0;
        for (std::size_t n = 0; n < sorted && appended < limit; ++n)
        {
          const Index j = search.Sorted()[n];
          if (j != i)
          {
            row.push_back(j);
            ++appended;
          }
        }
      };
    });
}

}
