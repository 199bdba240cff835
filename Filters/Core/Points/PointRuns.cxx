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

struct NumberedPoint
{
  double Place[3];
  Index Number;
};

/// Halves the points across the longest side of their box until runs are left.
void Halve(NumberedPoint* first, NumberedPoint* last)
{
  const std::size_t count = static_cast<std::size_t>(last - first);
  if (count <= RunLength)
  {
    return;
  }
  int axis = 0;
  double longest = -1.0;
  for (int side = 0; side < 3; ++side)
  {
    double low = first->Place[side];
    double high = low;
    for (const NumberedPoint* p = first; p != last; ++p)
    {
      low = std::min(low, p->Place[side]);
      high = std::max(high, p->Place[side]);
    }
    if (high - low > longest)
    {
      longest = high - low;
      axis = side;
    }
  }
  NumberedPoint* middle = first + (count / RunLength + 1) / 2 * RunLength;
  std::nth_element(first, middle, last,
    [axis](const NumberedPoint& p, const NumberedPoint& q)
    { return p.Place[axis] < q.Place[axis]; });
  Halve(first, middle);
  Halve(middle, last);
}

/// Axes of a box: 0 to 2.
constexpr auto AllAxes = { 0, 1, 2 };

}

void FormRuns(const Buffer<Vec3>& points, Buffer<Index>& order, Execution& execution)
{
  const std::size_t count = order.size();
  execution.For((count + StretchLength - 1) / StretchLength,
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<NumberedPoint> stretch(std::min(count, StretchLength));
      for (std::size_t number = begin; number < end; ++number)
      {
        Index* numbers = order.data() + number * StretchLength;
        const std::size_t length = std::min(count - number * StretchLength, StretchLength);
        for (std::size_t k = 0; k < length; ++k)
        {
          const Vec3& p = points[numbers[k]];
          stretch[k] = { { p[0], p[1], p[2] }, numbers[k] };
        }
        Halve(stretch.data(), stretch.data() + length);
        for (std::size_t k = 0; k < length; ++k)
        {
          numbers[k] = stretch[k].Number;
        }
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

/// The box of child number % Fan of family number / Fan.
PointRuns::Box PointRuns::BoxAt(std::size_t level, std::size_t number) const
{
  const Family& family = this->Boxes[level][number / Fan];
  Box box;
  for (const int axis : AllAxes)
  {
    box.Low[axis] = family.Low[axis][number % Fan];
    box.High[axis] = family.High[axis][number % Fan];
  }
  return box;
}

PointRuns::Box PointRuns::BoxOf(std::size_t run) const { return this->BoxAt(0, run); }

PointRuns::Box PointRuns::BoxOfFamily(std::size_t family) const
{
  if (this->Boxes.size() > 1)
  {
    return this->BoxAt(1, family);
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return { Vec3::Constant(-infinity), Vec3::Constant(infinity) };
}

}
