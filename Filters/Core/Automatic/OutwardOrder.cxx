// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Automatic/OutwardOrder.h"

#include <numeric>

namespace SurfaceDenoising
{

Vec3 MeanOf(const Buffer<Vec3>& points, Execution& execution)
{
  const Vec3 sum = OrderedSum(execution, points.size(), Vec3(0.0, 0.0, 0.0),
    [&](std::size_t i) -> const Vec3& { return points[i]; });
  return sum / static_cast<double>(std::max<std::size_t>(1, points.size()));
}

Buffer<Index> OrderBy(const Buffer<double>& keys)
{
  Buffer<Index> order(keys.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::sort(order.begin(), order.end(),
    [&](Index a, Index b) { return keys[a] < keys[b] || (keys[a] == keys[b] && a < b); });
  return order;
}

Buffer<Index> OutwardOrder(const Buffer<Vec3>& points, Execution& execution)
{
  const Vec3 mean = MeanOf(points, execution);
  Buffer<double> distances(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    distances[i] = (points[i] - mean).squaredNorm();
  }
  return OrderBy(distances);
}

}
