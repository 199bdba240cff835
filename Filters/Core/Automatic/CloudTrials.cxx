// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Automatic/CloudTrials.h"

#include "Points/PointNeighbors.h"
#include "Points/PointNormals.h"

#include <algorithm>
#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// That tangent planes of a surface without noise come from.
constexpr std::size_t PlaneNeighbors = 12;

/// A distance in deviations that is as good as none.
constexpr double LeastDistance = 1e-3;

}

bool CloudTrials::AddSurface(const PointDenoisingSettings& method, Execution& execution)
{
  const Buffer<Index>& judged = this->Sample.Judged;
  Surface surface;
  surface.Positions = this->Sample.Denoise(method, this->Sample.Positions, execution);
  if (surface.Positions.empty())
  {
    return false;
  }
  auto removed = [&](Index i)
  { return this->Sample.Directions[i].dot(this->Sample.Positions[i] - surface.Positions[i]); };
  double squares = 0.0;
  for (const Index i : judged)
  {
    squares += removed(i) * removed(i);
  }
  if (!(squares > 0.0))
  {
    return false;
  }
  const double scale = this->Deviation / std::sqrt(squares / static_cast<double>(judged.size()));
  // The order of the points that are judged is random: the next one but some has nothing to do with
  // a point. The others, around them, take what the first ones have.
  surface.Noisy = surface.Positions;
  std::size_t next = this->Surfaces.size() + 1;
  Buffer<unsigned char> hasNoise(surface.Positions.size(), 0);
  auto addNoise = [&](std::size_t i)
  {
    const double amplitude = scale * removed(judged[next++ % judged.size()]);
    surface.Noisy[i] += amplitude * this->Sample.Directions[i];
    hasNoise[i] = 1;
  };
  std::for_each(judged.begin(), judged.end(), addNoise);
  for (std::size_t i = 0; i < hasNoise.size(); ++i)
  {
    if (!hasNoise[i])
    {
      addNoise(i);
    }
  }
  surface.Normals = PlaneFitNormals(surface.Positions,
    NearestPoints(surface.Positions, PlaneNeighbors, execution), PlaneNeighbors, execution);
  this->Surfaces.push_back(std::move(surface));
  return true;
}

double CloudTrials::LogDistance(std::size_t surface, const PointDenoisingSettings& method,
  Execution& execution) const
{
  const Surface& truth = this->Surfaces[surface];
  const Buffer<Vec3> result = this->Sample.Denoise(method, truth.Noisy, execution);
  if (result.empty())
  {
    return 0.0;
  }
  double distance = 0.0;
  for (const Index i : this->Sample.Judged)
  {
    distance += std::abs(truth.Normals[i].dot(result[i] - truth.Positions[i]));
  }
  distance /= this->Deviation * static_cast<double>(this->Sample.Judged.size());
  return std::log(std::max(distance, LeastDistance));
}

}
