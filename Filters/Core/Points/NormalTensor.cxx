// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NormalTensor.h"

#include "SymmetricEigen.h"

namespace SurfaceDenoising
{

namespace
{

FeatureClass ClassOf(const Vec3& values, double threshold)
{
  if (!(FeatureIntensity(values) > threshold))
  {
    return FeatureClass::Flat;
  }
  return values[2] > values[1] - values[2] ? FeatureClass::Corner : FeatureClass::Edge;
}

/// The value that a quarter of those at a site and its neighbours are below.
double LowerQuartile(const Buffer<double>& values, std::size_t i, Span<Index> row)
{
  static thread_local std::vector<double> around;
  around.assign(1, values[i]);
  for (const Index j : row)
  {
    around.push_back(values[j]);
  }
  const auto quartile = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 4);
  std::nth_element(around.begin(), quartile, around.end());
  return *quartile;
}

}

Vec3 NormalTensorValues(const NormalFilter& filter, const Buffer<Vec3>& normals, std::size_t i,
  const double* weights)
{
  Mat3 tensor = Mat3::Zero();
  auto vote = [&](const Vec3& n) { tensor += *weights++ * n * n.transpose(); };
  if (filter.IncludesOwn())
  {
    vote(normals[i]);
  }
  for (const Index j : filter.Neighbors().Row(i))
  {
    vote(normals[j]);
  }
  // The trace is the sum of the weights, of those with a normal.
  const double trace = tensor.trace();
  if (!(trace > NormalFilter::NoWeight))
  {
    return Vec3(0.0, 0.0, 0.0);
  }
  return Decompose(tensor / trace).Values.reverse().cwiseMax(0.0);
}

void FindFeatures(const NormalFilter& filter, const Buffer<Vec3>& normals, double threshold,
  double contrast, Buffer<FeatureClass>& classes, Execution& execution)
{
  const NeighborGraph& graph = filter.Neighbors();
  classes.resize(graph.NumberOfRows());
  Buffer<double> intensities(graph.NumberOfRows());
  filter.VisitWeights({ normals, normals, normals, normals }, execution,
    [&](std::size_t i, const double* weights)
    {
      const Vec3 values = NormalTensorValues(filter, normals, i, weights);
      intensities[i] = FeatureIntensity(values);
      classes[i] = ClassOf(values, threshold);
    });
  execution.For(graph.NumberOfRows(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        if (classes[i] != FeatureClass::Flat &&
          intensities[i] < contrast * LowerQuartile(intensities, i, graph.Row(i)))
        {
          classes[i] = FeatureClass::Flat;
        }
      }
    });
}

}
