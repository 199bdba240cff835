// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PointNeighbors.h"

#include "NearestInRuns.h"
#include "RobustScale.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/**
 * Finds the points in balls, one after the other, of the nearest no more than limit. Scanners put
 * what they did not see in one place: where balls have more, what one point has found tells how
 * near to the next enough is found, and points at the place of the one before have the same ball.
 */
class BallSearch
{
public:
  BallSearch(const PointRuns& runs, const Buffer<Vec3>& points, double radius, std::size_t limit)
    : Points(points)
    , Radius(radius)
    , Limit(limit)
    , Search(runs)
  {
  }

  /// Appends the other points in the ball around point i. From the first of a run on, all of it
  /// must follow.
  void Append(std::size_t i, Buffer<Index>& row)
  {
    const std::size_t run = i / RunLength;
    if (i % RunLength == 0)
    {
      this->Reach = this->Radius;
      if (this->IsFull())
      {
        double farthest = 0.0;
        for (std::size_t j = i; j < std::min(i + RunLength, this->Points.size()); ++j)
        {
          farthest = std::max(farthest, this->EnoughFor(j));
        }
        this->Reach = std::min(this->Reach, farthest);
      }
      this->Search.TakeRuns(run, Above(this->Reach));
    }
    if (this->Last == NoIndex || this->Points[i] != this->Points[this->Last])
    {
      const double reach = this->IsFull() ? std::min(this->Reach, this->EnoughFor(i)) : this->Reach;
      const std::size_t found = this->Search.TakePoints(this->Points[i], reach * reach);
      this->Sorted = this->Limit < found ? this->Limit + 1 : found;
      this->Search.SortPoints(this->Sorted);
      this->Last = static_cast<Index>(i);
    }
    std::size_t appended = 0;
    for (std::size_t n = 0; n < this->Sorted && appended < this->Limit; ++n)
    {
      const Index j = this->Search.Sorted()[n];
      if (j != i)
      {
        row.push_back(j);
        ++appended;
      }
    }
  }

private:
  /// Whether the ball of the last point had more than were wanted.
  bool IsFull() const { return this->Last != NoIndex && this->Sorted > this->Limit; }

  /// So near to a point there are as many as the last one has found.
  double EnoughFor(std::size_t i) const
  {
    return Above((this->Points[i] - this->Points[this->Last]).norm() +
      Above(std::sqrt(this->Search.LastSquare())));
  }

  const Buffer<Vec3>& Points;
  double Radius;
  std::size_t Limit;
  RunSearch Search;
  double Reach = 0.0; ///< how far the runs taken reach from every point of the run
  Index Last = NoIndex;
  std::size_t Sorted = 0;
};

}

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
      return [search = BallSearch(runs, points, radius, limit)](std::size_t i,
               Buffer<Index>& row) mutable { search.Append(i, row); };
    });
}

}
