// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NearestInRuns.h"

#include <cmath>
#include <limits>

namespace SurfaceDenoising
{

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Balls that hold as many points around neighbours seldom differ by more.
constexpr double LikelyGrowth = 1.12;

}

/// The range of points around point i in the order, some times as many as wanted, or all there are.
/// It is the same for all points of a run.
std::pair<std::size_t, std::size_t> NearestInRuns::Around(std::size_t i) const
{
  const std::size_t all = this->Runs.NumberOfPoints();
  const std::size_t length = (2 * this->Count / RunLength + 2) * RunLength;
  const std::size_t begin = i / length * length;
  return begin + length <= all ? std::make_pair(begin, begin + length)
                               : std::make_pair(all - std::min(all, length), all);
}

/// A distance from point i within which there are as many points as wanted.
double NearestInRuns::BoundAround(std::size_t i)
{
  const auto [begin, end] = this->Around(i);
  const Vec3 p = this->Runs.Point(i);
  this->Squares.resize(end - begin);
  for (std::size_t j = begin; j < end; ++j)
  {
    this->Squares[j - begin] = (this->Runs.Point(j) - p).squaredNorm();
  }
  const auto last = this->Squares.begin() + static_cast<std::ptrdiff_t>(this->Count);
  std::nth_element(this->Squares.begin(), last, this->Squares.end());
  return std::sqrt(*last);
}

/// Points at the place of point i, of which there are enough around it in the order.
void NearestInRuns::TakeHeap(std::size_t i, Index* row) const
{
  const auto [begin, end] = this->Around(i);
  const Vec3 p = this->Runs.Point(i);
  std::size_t taken = 0;
  for (std::size_t j = begin; j < end && taken < this->Count; ++j)
  {
    if (j != i && (this->Runs.Point(j) - p).squaredNorm() == 0.0)
    {
      row[taken++] = static_cast<Index>(j);
    }
  }
}

void NearestInRuns::FindOne(std::size_t i, const PointRuns::Box& box, double bound, Index* row)
{
  const Vec3 p = this->Runs.Point(i);
  double likely = bound;
  if (this->Done > 0)
  {
    std::size_t nearest = 0;
    double square = Infinity;
    for (std::size_t n = 0; n < this->Done; ++n)
    {
      const double apart = (this->Places[n] - p).squaredNorm();
      nearest = apart < square ? n : nearest;
      square = std::min(square, apart);
    }
    // The ball around a point before reaches as far, seen from here. Most often, one of nearly its
    // size around this point is enough.
    bound = std::min(bound, this->Distances[nearest] + std::sqrt(square));
    likely = LikelyGrowth * this->Distances[nearest];
  }
  this->Places[this->Done] = p;
  double& distance = this->Distances[this->Done++];
  if (bound == 0.0 && this->BoundAround(i) == 0.0)
  {
    distance = 0.0;
    this->TakeHeap(i, row);
    return;
  }
  // One more than wanted, because the point finds itself.
  const std::size_t count = this->Count + 1;
  if (!(likely < bound && this->Search.TakePoints(p, likely * likely) >= count) &&
    this->Search.TakePoints(p, Above(bound) * Above(bound)) < count)
  {
    // Lengths so small that their squares have no digits left.
    this->Search.TakeRuns(box, Infinity);
    this->Search.TakePoints(p, Infinity);
  }
  this->Search.SortPoints(count);
  distance = std::sqrt(this->Search.LastSquare());
  const Index* sorted = this->Search.Sorted();
  std::size_t written = 0;
  for (std::size_t n = 0; n < count && written < this->Count; ++n)
  {
    row[written] = sorted[n];
    written += sorted[n] != i ? 1 : 0;
  }
}

void NearestInRuns::Find(std::size_t run, Index* rows)
{
  const std::size_t first = run * RunLength;
  const std::size_t last = std::min(first + RunLength, this->Runs.NumberOfPoints());
  const PointRuns::Box box = this->Runs.BoxOf(run);

  // Begins in the middle, from where the others are not far.
  const Vec3 center = 0.5 * (box.Low + box.High);
  std::size_t pivot = first;
  for (std::size_t i = first; i < last; ++i)
  {
    if ((this->Runs.Point(i) - center).squaredNorm() <
      (this->Runs.Point(pivot) - center).squaredNorm())
    {
      pivot = i;
    }
  }
  double reach = 0.0;
  for (std::size_t i = first; i < last; ++i)
  {
    reach = std::max(reach, (this->Runs.Point(i) - this->Runs.Point(pivot)).norm());
  }
  this->Done = 0;
  const double bound = this->BoundAround(pivot);
  this->Search.TakeRuns(box, Above(bound + reach));
  this->FindOne(pivot, box, bound, rows + (pivot - first) * this->Count);
  this->Search.KeepRuns(box, Above(this->Distances[0] + reach));
  for (std::size_t i = first; i < last; ++i)
  {
    if (i != pivot)
    {
      this->FindOne(i, box, Infinity, rows + (i - first) * this->Count);
    }
  }
}

}
