// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NearestInRuns.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Balls that hold as many points around neighbours seldom differ by more.
constexpr double LikelyGrowth = 1.12;

/// The same from run to run, where another try is dear.
constexpr double LikelyGrowthOfRuns = 1.3;

/// From one try to the next.
constexpr double Growth = 1.5;

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

/// True if the range around point i has more than count points at its place, itself included.
bool NearestInRuns::IsInHeap(std::size_t i) const
{
  const auto [begin, end] = this->Around(i);
  const Vec3 p = this->Runs.Point(i);
  std::size_t heap = 0;
  for (std::size_t j = begin; j < end; ++j)
  {
    heap += (this->Runs.Point(j) - p).squaredNorm() == 0.0 ? 1 : 0;
  }
  return heap > this->Count;
}

/// Takes points at the place of point i, of which there are enough around it in the order. Returns
/// their distance.
double NearestInRuns::TakeHeap(std::size_t i, Index* row) const
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
  return 0.0;
}

/// Takes the points at most distance away from point i. Returns false if they are not enough: one
/// more than wanted, because the point finds itself.
bool NearestInRuns::Take(std::size_t i, double distance)
{
  if (distance > this->Covered)
  {
    this->Covered = LikelyGrowthOfRuns * distance;
    this->Search.TakeRuns(this->Run, this->Covered);
  }
  return this->Search.TakePoints(this->Runs.Point(i), distance * distance) > this->Count;
}

/// Takes enough points around point i, and not many more: at least those in a ball of the likely
/// size if that is enough, else in larger ones, up to the bound, which is computed if it is
/// infinite.
void NearestInRuns::TakeEnough(std::size_t i, double likely, double bound)
{
  if (likely > 0.0 && this->Take(i, likely))
  {
    return;
  }
  bound = bound < Infinity ? bound : this->BoundAround(i);
  // Where the order leaps, the bound could hold half of the points.
  for (double distance = Growth * likely; distance > 0.0 && distance < bound; distance *= Growth)
  {
    if (this->Take(i, distance))
    {
      return;
    }
  }
  if (!this->Take(i, Above(bound)))
  {
    // Lengths so small that their squares have no digits left.
    this->Take(i, Infinity);
  }
}

/// Returns the distance of the last neighbour.
double NearestInRuns::FindOne(std::size_t i, double likely, double bound, Index* row)
{
  this->TakeEnough(i, likely, bound);
  this->Search.SortPoints(this->Count + 1);
  const Index* sorted = this->Search.Sorted();
  std::size_t written = 0;
  for (std::size_t n = 0; n <= this->Count && written < this->Count; ++n)
  {
    row[written] = sorted[n];
    written += sorted[n] != i ? 1 : 0;
  }
  return std::sqrt(this->Search.LastSquare());
}

void NearestInRuns::Find(std::size_t run, Index* rows)
{
  const std::size_t first = run * RunLength;
  const std::size_t last = std::min(first + RunLength, this->Runs.NumberOfPoints());
  const PointRuns::Box box = this->Runs.BoxOf(run);
  this->Run = run;
  this->Covered = -1.0; // not even the place itself

  // Begins in the middle, from where the others are not far.
  const Vec3 center = 0.5 * (box.Low + box.High);
  double nearest = Infinity;
  std::size_t pivot = first;
  for (std::size_t i = first; i < last; ++i)
  {
    const double square = (this->Runs.Point(i) - center).squaredNorm();
    pivot = square < nearest ? i : pivot;
    nearest = std::min(square, nearest);
  }
  double reach = 0.0;
  for (std::size_t i = first; i < last; ++i)
  {
    reach = std::max(reach, (this->Runs.Point(i) - this->Runs.Point(pivot)).squaredNorm());
  }
  // A run of uniform points reaches as far as its number of neighbours; where the run before lies
  // among fewer points, the ball could hold any number.
  const double share = static_cast<double>(this->Count + 1) / static_cast<double>(RunLength);
  const double likely = std::min(LikelyGrowthOfRuns * this->Before, std::sqrt(reach * share));
  Index* row = rows + (pivot - first) * this->Count;
  double& middle = this->Distances[pivot - first];
  middle = this->IsInHeap(pivot) ? this->TakeHeap(pivot, row)
                                 : this->FindOne(pivot, likely, Infinity, row);
  this->Before = middle;

  for (std::size_t i = first; i < last; ++i)
  {
    if (i == pivot)
    {
      continue;
    }
    // Of the points before, the nearest.
    const Vec3 p = this->Runs.Point(i);
    std::size_t other = pivot;
    double square = (this->Runs.Point(pivot) - p).squaredNorm();
    for (std::size_t j = first; j < i; ++j)
    {
      const double apart = (this->Runs.Point(j) - p).squaredNorm();
      other = apart < square ? j : other;
      square = std::min(square, apart);
    }
    // The ball around it reaches as far, seen from here. Most often, one of nearly its size around
    // this point is enough.
    const double distance = this->Distances[other - first];
    const double bound = distance + std::sqrt(square);
    row = rows + (i - first) * this->Count;
    this->Distances[i - first] = bound == 0.0 && this->IsInHeap(i)
      ? this->TakeHeap(i, row)
      : this->FindOne(i, std::min(LikelyGrowth * distance, bound), bound, row);
  }
}

}
