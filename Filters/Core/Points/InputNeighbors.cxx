// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "InputNeighbors.h"

#include "InterruptedExecution.h"
#include "PointNeighbors.h"
#include "RunSearch.h"
#include "SpatialOrder.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// With the bits of the searches, which add in this order.
double SquaredDistance(const Vec3& p, const Vec3& q)
{
  const Vec3 d = q - p;
  return d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
}

}

OrderedPoints::OrderedPoints(const Buffer<Vec3>& input, Execution& execution)
  : Numbers(FindPointOrder(input, {}, execution))
  , Places(input.size())
{
  InterruptedExecution interrupted(execution, 0.0);
  FormRuns(input, this->Numbers, interrupted);
  this->Positions = Gather(input, this->Numbers, interrupted);
  for (std::size_t k = 0; k < this->Numbers.size(); ++k)
  {
    this->Places[this->Numbers[k]] = static_cast<Index>(k);
  }
}

NeighborGraph NearestOfInput(const OrderedPoints& points, std::size_t count, Execution& execution)
{
  const Buffer<Vec3>& p = points.Positions;
  count = std::min(count, p.empty() ? 0 : p.size() - 1);
  // One more tells whether the last is as far as others, of which another number may be smaller.
  const NeighborGraph more = NearestOrderedPoints(p, count + 1, execution);
  const PointRuns runs(p, execution);
  NeighborGraph graph;
  graph.Offsets.resize(p.size() + 1);
  for (std::size_t i = 0; i <= p.size(); ++i)
  {
    graph.Offsets[i] = i * count;
  }
  graph.Ids.resize(p.size() * count);
  execution.For(p.size(),
    [&](std::size_t begin, std::size_t end)
    {
      RunSearch search(runs);
      std::vector<std::pair<double, Index>> found;
      for (std::size_t i = begin; i < end; ++i)
      {
        auto take = [&](const Index* first, const Index* last)
        {
          found.clear();
          for (const Index* j = first; j != last; ++j)
          {
            if (*j != i)
            {
              found.emplace_back(SquaredDistance(p[i], p[*j]), points.Numbers[*j]);
            }
          }
        };
        const Span<Index> row = more.Row(i);
        take(row.begin(), row.end());
        const bool tie = count > 0 && found.size() > count && found[count].first > 0.0 &&
          found[count - 1].first == found[count].first;
        if (tie)
        {
          const double square = found[count].first;
          search.TakeRuns(i / RunLength, Above(std::sqrt(square)));
          const std::size_t taken = search.TakePoints(p[i], square);
          search.SortPoints(taken);
          take(search.Sorted(), search.Sorted() + taken);
        }
        std::sort(found.begin(), found.end());
        Index* ids = graph.Ids.data() + points.Numbers[i] * count;
        for (std::size_t k = 0; k < count; ++k)
        {
          ids[k] = found[k].second;
        }
      }
    });
  return graph;
}

NeighborGraph BallsOfInput(const OrderedPoints& points, double radius, Execution& execution)
{
  const Buffer<Vec3>& p = points.Positions;
  NeighborGraph graph = PointsWithinRadius(p, radius, NoIndex, execution);
  execution.For(p.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        Index* const last = graph.Ids.data() + graph.Offsets[i + 1];
        for (Index* first = graph.Ids.data() + graph.Offsets[i]; first != last;)
        {
          const double square = SquaredDistance(p[i], p[*first]);
          Index* const farther = std::find_if(first + 1, last,
            [&](Index j) { return SquaredDistance(p[i], p[j]) > square; });
          std::sort(first, farther,
            [&](Index j, Index k) { return points.Numbers[j] < points.Numbers[k]; });
          first = farther;
        }
      }
    });
  return graph;
}

}
