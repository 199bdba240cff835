// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Automatic/CloudSample.h"

#include "Automatic/OutwardOrder.h"
#include "KdTree.h"
#include "SpatialOrder.h"

#include <algorithm>

namespace SurfaceDenoising
{

namespace
{

/// Points that normals come from: the stronger the noise, in spacings, the more.
std::size_t NormalNeighbors(double level)
{
  return static_cast<std::size_t>(std::clamp(80.0 * level, 20.0, 80.0));
}

constexpr std::size_t MostNormalNeighbors = 200;

/// The points of a part, and those of them that have all their neighbours.
constexpr std::size_t PartPoints = 800;
constexpr std::size_t InnerPoints = 450;

/// Of clouds whose methods take more neighbours, parts are so many times as large at most.
constexpr std::size_t LargestParts = 2;

/// That look random.
std::uint64_t RandomBits(std::size_t rank)
{
  const std::uint64_t hash = (rank + 1) * 0x9E3779B97F4A7C15ull;
  return (hash ^ (hash >> 31)) * 0xBF58476D1CE4E5B9ull;
}

/// 1 for points of the sample, 2 for those to be judged.
Buffer<unsigned char> ChooseSample(const Buffer<Vec3>& points, const Buffer<Index>& ranked,
  std::size_t asked, std::size_t widening)
{
  const std::size_t larger = std::min(widening, LargestParts);
  const std::size_t parts =
    std::max(std::min<std::size_t>(2, asked), (asked + larger - 1) / larger);
  Buffer<unsigned char> chosen(points.size(), 2);
  if (points.size() <= parts * larger * PartPoints)
  {
    return chosen;
  }
  std::fill(chosen.begin(), chosen.end(), static_cast<unsigned char>(0));
  const KdTree tree(points);
  std::vector<Index> found;
  for (std::size_t part = 0; part < parts; ++part)
  {
    const Index centre = ranked[(2 * part + 1) * points.size() / (2 * parts)];
    tree.Nearest(points[centre], larger * PartPoints, found);
    for (std::size_t k = 0; k < found.size(); ++k)
    {
      unsigned char& mark = chosen[found[k]];
      mark = std::max(mark, static_cast<unsigned char>(k < larger * InnerPoints ? 2 : 1));
    }
  }
  return chosen;
}

}

CloudSample::CloudSample(const Buffer<Vec3>& points, const Buffer<Vec3>& normals,
  const CloudNoise& noise, double deviation, std::size_t parts, Execution& execution)
{
  const Buffer<Index> order = FindPointOrder(points, {}, execution);
  const Buffer<Vec3> ordered = Gather(points, order);
  const Vec3 mean = MeanOf(ordered, execution);
  const Buffer<Index> ranked = OutwardOrder(ordered, execution);
  const Buffer<unsigned char> chosen = ChooseSample(ordered, ranked, parts, noise.Widening);
  Buffer<Index> numbers(ordered.size(), NoIndex);
  for (std::size_t i = 0; i < ordered.size(); ++i)
  {
    if (chosen[i] > 0)
    {
      numbers[i] = static_cast<Index>(this->Positions.size());
      this->Positions.push_back(ordered[i]);
      if (!normals.empty())
      {
        this->Normals.push_back(normals[order[i]]);
      }
    }
  }
  const std::size_t neighbors = std::min(MostNormalNeighbors,
    noise.Widening * NormalNeighbors(noise.Spacing > 0.0 ? deviation / noise.Spacing : 0.0));
  const NeighborGraph nearest = NearestPoints(this->Positions, neighbors, execution);
  this->Directions = PlaneFitNormals(this->Positions, nearest, neighbors, execution);
  Buffer<double> keys;
  for (std::size_t rank = 0; rank < ranked.size(); ++rank)
  {
    const Index i = ranked[rank];
    if (chosen[i] == 0)
    {
      continue;
    }
    const std::uint64_t bits = RandomBits(rank);
    // The sign of a normal is arbitrary: take the one that points away from the mean.
    Vec3& direction = this->Directions[numbers[i]];
    const bool inward = direction.dot(this->Positions[numbers[i]] - mean) < 0.0;
    direction *= inward != (((bits >> 40) & 1) != 0) ? -1.0 : 1.0;
    if (chosen[i] == 2 && !direction.isZero(0.0))
    {
      this->Judged.push_back(numbers[i]);
      keys.push_back(static_cast<double>(bits & 0xFFFFFFFFull));
    }
  }
  Buffer<Index> judged;
  for (const Index k : OrderBy(keys))
  {
    judged.push_back(this->Judged[k]);
  }
  this->Judged = std::move(judged);
}

Buffer<Vec3> CloudSample::Denoise(const PointDenoisingSettings& settings, Buffer<Vec3> positions,
  Execution& execution) const
{
  PointCloud cloud;
  cloud.Positions = std::move(positions);
  cloud.Normals = this->Normals;
  PointDenoisingReport report;
  return DenoisePoints(cloud, settings, report, execution) ? std::move(cloud.Positions)
                                                           : Buffer<Vec3>();
}

}
