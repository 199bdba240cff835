// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PointRuns.h"

#include <limits>

namespace SurfaceDenoising
{

namespace
{

/// Points that are rearranged among themselves.
constexpr std::size_t StretchLength = 64 * RunLength;

/// Halves the numbers across the longest side of their box until a run is left.
void Halve(const Buffer<Vec3>& points, Index* first, Index* last)
{
  const std::size_t count = static_cast<std::size_t>(last - first);
  if (count <= RunLength)
  {
    return;
  }
  Vec3 low = points[*first];
  Vec3 high = low;
  for (const Index* i = first; i != last; ++i)
  {
    low = low.cwiseMin(points[*i]);
    high = high.cwiseMax(points[*i]);
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  Index* middle = first + (count / RunLength + 1) / 2 * RunLength;
  std::nth_element(first, middle, last,
    [&points, axis](Index i, Index j) { return points[i][axis] < points[j][axis]; });
  Halve(points, first, middle);
  Halve(points, middle, last);
}

/// Axes of a box: 0 to 2.
constexpr auto AllAxes = { 0, 1, 2 };

}

void FormRuns(const Buffer<Vec3>& points, Buffer<Index>& order, Execution& execution)
{
  const std::size_t count = order.size();
  execution.For(
    (count + StretchLength - 1) / StretchLength,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t stretch = begin; stretch < end; ++stretch)
      {
        Halve(points, order.data() + stretch * StretchLength,
          order.data() + std::min(count, (stretch + 1) * StretchLength));
      }
    },
    4);
}

PointRuns::PointRuns(const Buffer<Vec3>& points, Execution& execution)
  : Count(points.size())
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::size_t runs = this->NumberOfRuns();
  for (Buffer<double>& coordinates : this->Axes)
  {
    coordinates.resize(runs * RunLength);
    std::fill(coordinates.begin() + static_cast<std::ptrdiff_t>(this->Count), coordinates.end(),
      std::numeric_limits<double>::quiet_NaN());
  }
  this->Boxes.emplace_back((runs + Fan - 1) / Fan);
  execution.For(
    this->Boxes[0].size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t f = begin; f < end; ++f)
      {
        for (std::size_t child = 0; child < Fan; ++child)
        {
          const std::size_t first = std::min((f * Fan + child) * RunLength, this->Count);
          const std::size_t last = std::min(first + RunLength, this->Count);
          for (const int axis : AllAxes)
          {
            double low = infinity;
            double high = -infinity;
            for (std::size_t i = first; i < last; ++i)
            {
              const double x = points[i][axis];
              this->Axes[axis][i] = x;
              low = std::min(low, x);
              high = std::max(high, x);
            }
            this->Boxes[0][f].Low[axis][child] = low;
            this->Boxes[0][f].High[axis][child] = high;
          }
        }
      }
    },
    64);
  while (this->Boxes.back().size() > 1)
  {
    const Buffer<Family>& below = this->Boxes.back();
    Buffer<Family> above((below.size() + Fan - 1) / Fan);
    for (std::size_t n = 0; n < above.size() * Fan; ++n)
    {
      for (const int axis : AllAxes)
      {
        const bool exists = n < below.size();
        double& low = above[n / Fan].Low[axis][n % Fan];
        double& high = above[n / Fan].High[axis][n % Fan];
        low = exists ? *std::min_element(below[n].Low[axis], below[n].Low[axis] + Fan) : infinity;
        high =
          exists ? *std::max_element(below[n].High[axis], below[n].High[axis] + Fan) : -infinity;
      }
    }
    this->Boxes.push_back(std::move(above));
  }
}

PointRuns::Box PointRuns::BoxOf(std::size_t run) const
{
  const Family& family = this->Boxes[0][run / Fan];
  Box box;
  for (const int axis : AllAxes)
  {
    box.Low[axis] = family.Low[axis][run % Fan];
    box.High[axis] = family.High[axis][run % Fan];
  }
  return box;
}

}
