// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MedialSkeleton.h"

#include "KdTree.h"
#include "SymmetricEigen.h"

#include <algorithm>
#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// Every so many points of the cloud. Its numbers follow a curve through space, so that these are
/// spread evenly.
Buffer<Vec3> PickEvenly(const Buffer<Vec3>& cloud, const MedialSkeletonSettings& settings)
{
  const std::size_t count = cloud.size();
  const std::size_t wanted = static_cast<std::size_t>(settings.Share * static_cast<double>(count));
  const std::size_t picked = std::min(count, std::max(settings.Fewest, wanted));
  Buffer<Vec3> points(picked);
  for (std::size_t i = 0; i < picked; ++i)
  {
    points[i] = cloud[i * count / picked];
  }
  return points;
}

/// The next place of x, itself the point i of the skeleton.
Vec3 Contract(const Vec3& x, std::size_t i, const Buffer<Vec3>& cloud,
  const std::vector<Index>& near, const Buffer<Vec3>& skeleton, const std::vector<Index>& others,
  const MedialSkeletonSettings& settings)
{
  const double h = settings.Radius;
  const double shortest = 0.1 * h;
  Vec3 pull(0.0, 0.0, 0.0);
  double pullWeight = 0.0;
  for (const Index j : near)
  {
    const Vec3 e = cloud[j] - x;
    const double square = e.squaredNorm();
    const double weight = std::exp(-4.0 * square / (h * h)) / std::max(std::sqrt(square), shortest);
    pull += weight * e;
    pullWeight += weight;
  }
  Vec3 push(0.0, 0.0, 0.0);
  double pushWeight = 0.0;
  Mat3 spread = Mat3::Zero();
  for (const Index k : others)
  {
    if (k != i)
    {
      const Vec3 e = x - skeleton[k];
      const double square = e.squaredNorm();
      const double theta = std::exp(-4.0 * square / (h * h));
      const double weight = theta / std::max(square, shortest * shortest);
      push += weight * e;
      pushWeight += weight;
      spread += theta * e * e.transpose();
    }
  }
  Vec3 place = x;
  if (pullWeight > 0.0)
  {
    place += pull / pullWeight;
  }
  const double trace = spread.trace();
  if (pushWeight > 0.0 && trace > 0.0)
  {
    const double directed = Decompose(spread).Values[2] / trace;
    place += settings.Repulsion * directed / pushWeight * push;
  }
  return place;
}

}

bool FindMedialSkeleton(const Buffer<Vec3>& cloud, const MedialSkeletonSettings& settings,
  Buffer<Vec3>& skeleton, Execution& execution, double first, double last)
{
  skeleton = PickEvenly(cloud, settings);
  const KdTree cloudTree(cloud);
  Buffer<Vec3> places(skeleton.size());
  for (int iteration = 0; iteration < settings.Iterations; ++iteration)
  {
    if (!execution.Proceed(first + (last - first) * iteration / settings.Iterations))
    {
      return false;
    }
    const KdTree skeletonTree(skeleton);
    execution.For(
      skeleton.size(),
      [&](std::size_t begin, std::size_t end)
      {
        std::vector<Index> near;
        std::vector<Index> others;
        for (std::size_t i = begin; i < end; ++i)
        {
          const Vec3& x = skeleton[i];
          cloudTree.Within(x, settings.Radius, near);
          skeletonTree.Within(x, settings.Radius, others);
          places[i] = Contract(x, i, cloud, near, skeleton, others, settings);
        }
      },
      256);
    skeleton.swap(places);
  }
  return true;
}

}
