// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PointRuns.h"

#include <limits>

namespace SurfaceDenoising
{

namespace
{

/// Axes of a box: 0 to 2.
constexpr auto AllAxes = { 0, 1, 2 };

/// Points that are rearranged among themselves.
constexpr std::size_t StretchLength = 64 * RunLength;

/**
 * A point of a stretch in one number: its coordinates in 16 bits each, then where in the stretch it
 * was. All of a stretch differ, and are quickly moved.
 */
using Packed = std::uint64_t;

constexpr int AxisBits = 16;
constexpr Packed LastStep = (1 << AxisBits) - 1;

/// The same bits with the coordinate along an axis in front.
Packed InFront(Packed point, int axis)
{
  const int shift = AxisBits * axis;
  return shift == 0 ? point : (point << shift) | (point >> (64 - shift));
}

/// The points of a stretch, in steps of a 65535th of the longest side of their box.
void Pack(const Buffer<Vec3>& points, const Index* numbers, std::size_t count, Packed* packed)
{
  Vec3 low = points[numbers[0]];
  Vec3 high = low;
  for (std::size_t k = 1; k < count; ++k)
  {
    low = low.cwiseMin(points[numbers[k]]);
    high = high.cwiseMax(points[numbers[k]]);
  }
  // Halves, because the whole side might be no number.
  const double side = (0.5 * high - 0.5 * low).maxCoeff();
  const double steps = side > 1e-290 ? static_cast<double>(LastStep) / side : 0.0;
  for (std::size_t k = 0; k < count; ++k)
  {
    const Vec3 place = steps * (0.5 * points[numbers[k]] - 0.5 * low);
    packed[k] = k;
    for (const int axis : AllAxes)
    {
      packed[k] |= static_cast<Packed>(place[axis]) << (48 - AxisBits * axis);
    }
  }
}

/// Brings the points that come first along an axis before middle, where there is one.
void Split(Packed* first, Packed* middle, Packed* last, int axis)
{
  while (last - first > 2)
  {
    // Of three different points the middle one: there is a point on either side.
    const Packed a = InFront(*first, axis);
    const Packed b = InFront(first[(last - first) / 2], axis);
    const Packed c = InFront(last[-1], axis);
    const Packed pivot = std::max(std::min(a, b), std::min(std::max(a, b), c));
    Packed* end = first; // of those before the pivot
    for (Packed* p = first; p != last; ++p)
    {
      // Exchanged in any case: branches would be guessed wrong every other time.
      const Packed point = *p;
      *p = *end;
      *end = point;
      end += InFront(point, axis) < pivot ? 1 : 0;
    }
    if (end == middle)
    {
      return;
    }
    (end < middle ? first : last) = end;
  }
  if (last - first == 2 && InFront(first[1], axis) < InFront(first[0], axis))
  {
    std::swap(first[0], first[1]);
  }
}

/// The axis along which the box of the points is longest.
int LongestSide(const Packed* first, const Packed* last)
{
  Packed low[3];
  Packed high[3];
  for (const int axis : AllAxes)
  {
    low[axis] = high[axis] = InFront(*first, axis);
  }
  for (const Packed* p = first + 1; p != last; ++p)
  {
    for (const int axis : AllAxes)
    {
      const Packed key = InFront(*p, axis);
      low[axis] = std::min(low[axis], key);
      high[axis] = std::max(high[axis], key);
    }
  }
  int longest = 0;
  for (const int axis : AllAxes)
  {
    longest = high[axis] - low[axis] > high[longest] - low[longest] ? axis : longest;
  }
  return longest;
}

/// Halves the points across the longest side of their box until runs are left.
void Halve(Packed* first, Packed* last)
{
  const std::size_t count = static_cast<std::size_t>(last - first);
  if (count <= RunLength)
  {
    return;
  }
  const int axis = LongestSide(first, last);
  Packed* middle = first + (count / RunLength + 1) / 2 * RunLength;
  Split(first, middle, last, axis);
  Halve(first, middle);
  Halve(middle, last);
}

}

void FormRuns(const Buffer<Vec3>& points, Buffer<Index>& order, Execution& execution)
{
  const std::size_t count = order.size();
  execution.For((count + StretchLength - 1) / StretchLength,
    [&](std::size_t begin, std::size_t end)
    {
      Packed packed[StretchLength];
      Index before[StretchLength];
      for (std::size_t number = begin; number < end; ++number)
      {
        Index* numbers = order.data() + number * StretchLength;
        const std::size_t length = std::min(count - number * StretchLength, StretchLength);
        Pack(points, numbers, length, packed);
        std::copy(numbers, numbers + length, before);
        Halve(packed, packed + length);
        for (std::size_t k = 0; k < length; ++k)
        {
          numbers[k] = before[packed[k] & LastStep];
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
