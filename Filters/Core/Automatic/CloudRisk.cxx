// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Automatic/CloudRisk.h"

#include <algorithm>
#include <limits>

namespace SurfaceDenoising
{

CloudRisk::CloudRisk(const Buffer<Vec3>& points, const Buffer<Vec3>& normals,
  const CloudNoise& noise, double deviation, std::size_t parts, Execution& execution)
  : Sample(points, normals, noise, deviation, parts, execution)
  , Deviation(deviation)
  , Step(std::max(0.5 * deviation, 1e-4 * noise.Spacing))
{
}

StepStatistics CloudRisk::StepsOf(const PointDenoisingSettings& settings,
  Execution& execution) const
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  const Buffer<Vec3>& before = this->Sample.Positions;
  const Buffer<Vec3>& directions = this->Sample.Directions;
  const Buffer<Index>& judged = this->Sample.Judged;
  auto movedBy = [&](double step)
  {
    Buffer<Vec3> moved = before;
    for (const Index i : judged)
    {
      moved[i] += step * directions[i];
    }
    return this->Sample.Denoise(settings, std::move(moved), execution);
  };
  const Buffer<Vec3> plus = movedBy(this->Step);
  const Buffer<Vec3> minus = plus.empty() ? Buffer<Vec3>() : movedBy(-this->Step);
  if (minus.empty() || judged.empty())
  {
    return { none, none };
  }
  StepStatistics sums = { 0.0, 0.0 };
  for (const Index i : judged)
  {
    const double up = directions[i].dot(plus[i] - before[i]);
    const double down = directions[i].dot(minus[i] - before[i]);
    sums.Squares += (up * up + down * down) / 2.0;
    sums.Derivative += (up - down) / (2.0 * this->Step);
  }
  const double number = static_cast<double>(judged.size());
  return { sums.Squares / number, sums.Derivative / number };
}

}
