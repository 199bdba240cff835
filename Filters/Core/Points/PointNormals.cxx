// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PointNormals.h"

#include "InterruptedExecution.h"
#include "RowPlanes.h"

#include <cmath>

namespace SurfaceDenoising
{

Buffer<Vec3> PlaneFitNormals(const Buffer<Vec3>& points, const NeighborGraph& nearest,
  std::size_t count, Execution& execution)
{
  Buffer<Vec3> normals(points.size());
  execution.For(points.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        PlaneSum sum;
        sum.Add(Vec3(0.0, 0.0, 0.0));
        const Span<Index> row = nearest.Row(i);
        for (std::size_t k = 0; k < std::min(count, row.size()); ++k)
        {
          sum.Add(points[row[k]] - points[i]);
        }
        normals[i] = sum.Fit().Normal;
      }
    });
  return normals;
}

bool SharpenNormals(const Buffer<Vec3>& points, const NeighborGraph& nearest, double spacing,
  Buffer<Vec3>& normals, Execution& execution, double first, double last)
{
  constexpr int rounds = 3;
  constexpr double eighth = 3.14159265358979323846 / 8.0;
  NormalFilter filter(nearest, WeightsBySimilarNormals(eighth));
  const Buffer<double> noAreas;
  filter.SetGeometry({ points, noAreas, 0.0 }, execution);

  const RobustPlaneSettings fit{ 0.01 * spacing, 10 };
  Buffer<Vec3> sharpened(points.size());
  for (int round = 0; round < rounds; ++round)
  {
    const double share = (last - first) / rounds;
    InterruptedExecution interrupted(execution, first + share * round, first + share * (round + 1));
    filter.VisitWeights({ normals, normals, normals, normals }, interrupted,
      [&](std::size_t i, const double* weights)
      {
        static thread_local WeightedPatch patch;
        patch.Take(points, i, nearest.Row(i), weights);
        const Vec3 normal = FitRobustPlane(patch.Points, patch.Weights, fit).Normal;
        sharpened[i] = normal.isZero(0.0) ? normals[i] : normal;
      });
    if (!interrupted.Proceed(last))
    {
      return false;
    }
    normals.swap(sharpened);
  }
  return true;
}

double ShareOfOpposedNormals(const NeighborGraph& nearest, const Buffer<Vec3>& normals,
  Execution& execution)
{
  using Pairs = Eigen::Array2d; // all and opposed ones
  const Pairs pairs = OrderedSum(execution, normals.size(), Pairs(0.0, 0.0),
    [&](std::size_t i)
    {
      const Span<Index> row = nearest.Row(i);
      if (row.size() == 0 || normals[i].isZero(0.0) || normals[row[0]].isZero(0.0))
      {
        return Pairs(0.0, 0.0);
      }
      return Pairs(1.0, normals[i].dot(normals[row[0]]) < 0.0 ? 1.0 : 0.0);
    });
  return pairs[0] > 0.0 ? pairs[1] / pairs[0] : 0.0;
}

}
