// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RowPlanes.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

constexpr double NegligibleWeight = 1e-3;
constexpr std::ptrdiff_t FewestMembers = 4;

}

void FitPlanes(const NormalFilter& filter, const NormalFilter::Fields& fields,
  const Buffer<Vec3>& positions, Buffer<Vec3>& fitted, Execution& execution)
{
  const NeighborGraph& graph = filter.Neighbors();
  fitted.resize(graph.NumberOfRows());
  filter.VisitWeights(fields, execution,
    [&](std::size_t i, const double* weights)
    {
      PlaneSum sum;
      if (filter.IncludesOwn())
      {
        sum.Add(Vec3(0.0, 0.0, 0.0), *weights++);
      }
      for (const Index j : graph.Row(i))
      {
        sum.Add(positions[j] - positions[i], *weights++);
      }
      const Vec3 normal = sum.Fit().Normal;
      const Vec3& before = fields.Current[i];
      fitted[i] = normal.isZero(0.0) ? before : normal.dot(before) < 0.0 ? Vec3(-normal) : normal;
    });
}

void WeightedPatch::Take(const Buffer<Vec3>& positions, std::size_t i, Span<Index> row,
  const double* weights)
{
  this->Points.assign(1, Vec3(0.0, 0.0, 0.0));
  for (const Index j : row)
  {
    this->Points.push_back(positions[j] - positions[i]);
  }
  const double* end = weights + this->Points.size();
  this->Uniform =
    std::count_if(weights, end, [](double w) { return w > NegligibleWeight; }) < FewestMembers;
  if (this->Uniform)
  {
    this->Weights.assign(this->Points.size(), 1.0);
  }
  else
  {
    this->Weights.assign(weights, end);
  }
}

NormalFilterSettings WeightsBySimilarNormals(double sigma)
{
  NormalFilterSettings settings;
  settings.Norm = GaussianNorm{ sigma / std::sqrt(2.0) };
  settings.Argument = NormalArgument::Angle;
  settings.Weighting = SiteWeight::Uniform;
  settings.IncludeOwn = true;
  settings.Unoriented = true;
  return settings;
}

}
