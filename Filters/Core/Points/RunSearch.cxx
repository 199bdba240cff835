// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RunSearch.h"

#include "Vectorize.h"

#include <limits>

namespace SurfaceDenoising
{

namespace
{

using Box = PointRuns::Box;

/// Up to as many points are ranked by comparing all pairs, which takes no branches; more are
/// sorted.
constexpr std::size_t MostRanked = 96;

/// Numbers that are handled together, whatever the width of vectors.
constexpr std::size_t Lanes = 8;

std::size_t Padded(std::size_t count) { return (count + Lanes - 1) / Lanes * Lanes; }

/// Squared distances between a box and the boxes of a list, axis by axis.
SURFACEDENOISING_VECTORIZED
void SquaredGaps(const Box& box, const double* const low[3], const double* const high[3],
  std::size_t count, double* squares)
{
  for (std::size_t e = 0; e < count; ++e)
  {
    const double x = std::max(std::max(low[0][e] - box.High[0], box.Low[0] - high[0][e]), 0.0);
    const double y = std::max(std::max(low[1][e] - box.High[1], box.Low[1] - high[1][e]), 0.0);
    const double z = std::max(std::max(low[2][e] - box.High[2], box.Low[2] - high[2][e]), 0.0);
    squares[e] = x * x + y * y + z * z;
  }
}

/**
 * Of some runs, the points whose squared distance from p is at most limit. There must be room for
 * all points of the runs. Returns how many there are.
 */
SURFACEDENOISING_VECTORIZED
std::size_t NearPoints(const double* const axes[3], const Index* runs, std::size_t count,
  const Vec3& p, double limit, Index* numbers, double* taken)
{
  const double px = p[0];
  const double py = p[1];
  const double pz = p[2];
  std::size_t near = 0;
  for (std::size_t n = 0; n < count; ++n)
  {
    const std::size_t first = runs[n] * RunLength;
    const double* x = axes[0] + first;
    const double* y = axes[1] + first;
    const double* z = axes[2] + first;
    double squares[RunLength];
    for (std::size_t k = 0; k < RunLength; ++k)
    {
      const double dx = x[k] - px;
      const double dy = y[k] - py;
      const double dz = z[k] - pz;
      squares[k] = dx * dx + dy * dy + dz * dz;
    }
    for (std::size_t k = 0; k < RunLength; ++k)
    {
      // Written in any case and kept if it is near: branches would be guessed wrong.
      numbers[near] = static_cast<Index>(first + k);
      taken[near] = squares[k];
      near += squares[k] <= limit ? 1 : 0;
    }
  }
  return near;
}

/// ranks[i] = how many of the squares are smaller than squares[i]. Both lists are padded.
SURFACEDENOISING_VECTORIZED
void CountSmaller(const double* squares, std::size_t count, std::int64_t* ranks)
{
  for (std::size_t i = 0; i < count; i += Lanes)
  {
    std::int64_t smaller[Lanes] = {};
    for (std::size_t j = 0; j < count; ++j)
    {
      for (std::size_t lane = 0; lane < Lanes; ++lane)
      {
        smaller[lane] += squares[j] < squares[i + lane] ? 1 : 0;
      }
    }
    std::copy(smaller, smaller + Lanes, ranks + i);
  }
}

}

void RunSearch::AddRun(Index run, const PointRuns::Family& family, std::size_t child)
{
  const std::size_t n = this->NumberOfRuns++;
  if (n == this->TakenRuns.size())
  {
    const std::size_t size = 2 * n + 64;
    this->TakenRuns.resize(size);
    this->NearRuns.resize(size);
    this->Gaps.resize(size);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Low[axis].resize(size);
      this->High[axis].resize(size);
    }
  }
  this->TakenRuns[n] = run;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Low[axis][n] = family.Low[axis][child];
    this->High[axis][n] = family.High[axis][child];
  }
}

void RunSearch::TakeRuns(const Box& box, double distance)
{
  const std::vector<Buffer<PointRuns::Family>>& levels = this->Runs.Levels();
  const double most = distance * distance;
  this->NumberOfRuns = 0;
  this->Families.assign(1, { levels.size() - 1, 0 });
  while (!this->Families.empty())
  {
    const auto [level, number] = this->Families.back();
    this->Families.pop_back();
    const PointRuns::Family& family = levels[level][number];
    const double* low[3] = { family.Low[0], family.Low[1], family.Low[2] };
    const double* high[3] = { family.High[0], family.High[1], family.High[2] };
    double squares[PointRuns::Fan];
    SquaredGaps(box, low, high, PointRuns::Fan, squares);
    for (std::size_t child = 0; child < PointRuns::Fan; ++child)
    {
      const bool exists = family.Low[0][child] <= family.High[0][child];
      if (exists && squares[child] <= most)
      {
        const std::size_t below = number * PointRuns::Fan + child;
        if (level > 0)
        {
          this->Families.emplace_back(level - 1, below);
        }
        else
        {
          this->AddRun(static_cast<Index>(below), family, child);
        }
      }
    }
  }
}

void RunSearch::KeepRuns(const Box& box, double distance)
{
  const double* low[3] = { this->Low[0].data(), this->Low[1].data(), this->Low[2].data() };
  const double* high[3] = { this->High[0].data(), this->High[1].data(), this->High[2].data() };
  SquaredGaps(box, low, high, this->NumberOfRuns, this->Gaps.data());
  std::size_t kept = 0;
  for (std::size_t n = 0; n < this->NumberOfRuns; ++n)
  {
    this->TakenRuns[kept] = this->TakenRuns[n];
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Low[axis][kept] = this->Low[axis][n];
      this->High[axis][kept] = this->High[axis][n];
    }
    kept += this->Gaps[n] <= distance * distance ? 1 : 0;
  }
  this->NumberOfRuns = kept;
}

std::size_t RunSearch::TakePoints(const Vec3& p, double square)
{
  const double* low[3] = { this->Low[0].data(), this->Low[1].data(), this->Low[2].data() };
  const double* high[3] = { this->High[0].data(), this->High[1].data(), this->High[2].data() };
  SquaredGaps({ p, p }, low, high, this->NumberOfRuns, this->Gaps.data());
  std::size_t near = 0;
  for (std::size_t n = 0; n < this->NumberOfRuns; ++n)
  {
    this->NearRuns[near] = this->TakenRuns[n];
    near += this->Gaps[n] <= square ? 1 : 0;
  }
  if (this->Squares.size() < near * RunLength + Lanes)
  {
    this->Numbers.resize(2 * near * RunLength + Lanes);
    this->Squares.resize(this->Numbers.size());
    this->Order.resize(this->Numbers.size());
  }
  const double* axes[3] = { this->Runs.Coordinates(0), this->Runs.Coordinates(1),
    this->Runs.Coordinates(2) };
  this->NumberOfPoints = NearPoints(axes, this->NearRuns.data(), near, p, square,
    this->Numbers.data(), this->Squares.data());
  return this->NumberOfPoints;
}

/// Returns false if there are equal distances.
bool RunSearch::RankPoints(std::size_t count)
{
  const std::size_t taken = this->NumberOfPoints;
  const std::size_t padded = Padded(taken);
  std::fill(this->Squares.data() + taken, this->Squares.data() + padded,
    std::numeric_limits<double>::infinity());
  this->Ranks.resize(MostRanked);
  CountSmaller(this->Squares.data(), padded, this->Ranks.data());
  std::size_t sum = 0;
  for (std::size_t n = 0; n < taken; ++n)
  {
    const std::size_t rank = static_cast<std::size_t>(this->Ranks[n]);
    sum += rank;
    this->Order[rank] = this->Numbers[n];
    this->Last = rank + 1 == count ? this->Squares[n] : this->Last;
  }
  // Distinct numbers have the ranks 0, 1, 2 and so on, equal ones share the lowest.
  return sum == taken * (taken - 1) / 2;
}

void RunSearch::SortPoints(std::size_t count)
{
  const std::size_t taken = this->NumberOfPoints;
  if (count == 0 || (taken <= MostRanked && this->RankPoints(count)))
  {
    return;
  }
  this->Pairs.resize(taken);
  for (std::size_t n = 0; n < taken; ++n)
  {
    this->Pairs[n] = { this->Squares[n], this->Numbers[n] };
  }
  const auto middle = this->Pairs.begin() + static_cast<std::ptrdiff_t>(count);
  if (count < taken)
  {
    std::nth_element(this->Pairs.begin(), middle, this->Pairs.end());
  }
  std::sort(this->Pairs.begin(), middle);
  for (std::size_t n = 0; n < count; ++n)
  {
    this->Order[n] = this->Pairs[n].second;
  }
  this->Last = this->Pairs[count - 1].first;
}

}
