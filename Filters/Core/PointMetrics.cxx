// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PointMetrics.h"

#include "KdTree.h"
#include "Metrics.h"
#include "NeighborGraph.h"

#include <cmath>
#include <limits>

namespace SurfaceDenoising
{

namespace
{

constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();

/// The points with NaN for those that are nowhere: a search passes over them and keeps the numbers.
Buffer<Vec3> Places(const Buffer<Vec3>& points)
{
  Buffer<Vec3> places(points);
  for (Vec3& p : places)
  {
    if (!IsPlace(p))
    {
      p = Vec3::Constant(Undefined);
    }
  }
  return places;
}

}

NearestElements FindNearestPoints(const Buffer<Vec3>& points, const Buffer<Vec3>& positions,
  Execution& execution)
{
  const KdTree tree(Places(points));
  NearestElements nearest;
  nearest.Distances.resize(positions.size());
  nearest.Numbers.resize(positions.size());
  execution.For(
    positions.size(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Index> found;
      for (std::size_t i = begin; i < end; ++i)
      {
        found.clear();
        if (IsPlace(positions[i]))
        {
          tree.Nearest(positions[i], 1, found);
        }
        nearest.Numbers[i] = found.empty() ? NoIndex : found[0];
        nearest.Distances[i] = found.empty() ? Undefined : (points[found[0]] - positions[i]).norm();
      }
    },
    1024);
  return nearest;
}

PointSetDistances ComparePointSets(const Buffer<double>& toReference,
  const Buffer<double>& fromReference, Execution& execution)
{
  const Statistics to = Summarize(toReference, {}, execution);
  const Statistics from = Summarize(fromReference, {}, execution);
  PointSetDistances distances;
  distances.Chamfer = 0.5 * (to.Mean + from.Mean);
  distances.SquaredChamfer =
    to.RootMeanSquare * to.RootMeanSquare + from.RootMeanSquare * from.RootMeanSquare;
  distances.ToReference = to.Maximum;
  distances.FromReference = from.Maximum;
  distances.Hausdorff = std::fmax(to.Maximum, from.Maximum); // both are numbers, or none
  return distances;
}

Buffer<double> NearestSpacings(const Buffer<Vec3>& points, Execution& execution)
{
  const Buffer<Vec3> places = Places(points);
  const NeighborGraph nearest = NearestPoints(places, 1, execution);
  Buffer<double> spacings(points.size());
  execution.For(spacings.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Span<Index> other = nearest.Row(i);
        spacings[i] = other.size() == 0 ? Undefined : (places[other[0]] - places[i]).norm();
      }
    });
  return spacings;
}

double Variation(const Buffer<double>& values, Execution& execution)
{
  const double mean = Summarize(values, {}, execution).Mean;
  Buffer<double> deviations(values);
  for (double& value : deviations)
  {
    value -= mean;
  }
  const double deviation = Summarize(deviations, {}, execution).RootMeanSquare;
  return mean == 0.0 ? Undefined : deviation / mean;
}

}
