// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RunSearch.h"

#include "Vectorize.h"

#ifdef SURFACEDENOISING_AVX512
#include <immintrin.h>
#endif

namespace SurfaceDenoising
{

namespace
{

using Box = PointRuns::Box;

/// Up to as many points are ranked by comparing all pairs, which takes no branches; more are
/// sorted.
constexpr std::size_t MostRanked = 96;

/// Numbers that are handled together, whatever the width of vectors. Fewer, and the compiler would
/// rather take the loop around them for one over vectors.
constexpr std::size_t Lanes = 32;

/// Doubles of the widest vector: boxes are looked at in whole ones.
constexpr std::size_t Wide = 8;

constexpr std::size_t RoundUp(std::size_t count, std::size_t to)
{
  return (count + to - 1) / to * to;
}

/// More runs around a family are too many to look through for each of its runs.
constexpr std::size_t MostAround = 512;

/// So many times as far as asked for, there is enough for most other runs of a family.
constexpr double RoomForOthers = 1.3;

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

/// Squared distances between p and the points of some runs, one run after the other.
SURFACEDENOISING_VECTORIZED
void SquaredDistances(const double* const axes[3], const Index* runs, std::size_t count,
  const Vec3& p, double* squares)
{
  const double px = p[0];
  const double py = p[1];
  const double pz = p[2];
  for (std::size_t n = 0; n < count; ++n)
  {
    const std::size_t first = runs[n] * RunLength;
    const double* x = axes[0] + first;
    const double* y = axes[1] + first;
    const double* z = axes[2] + first;
    for (std::size_t k = 0; k < RunLength; ++k)
    {
      const double dx = x[k] - px;
      const double dy = y[k] - py;
      const double dz = z[k] - pz;
      squares[n * RunLength + k] = dx * dx + dy * dy + dz * dz;
    }
  }
}

/// The numbers of the squares that are at most limit, ascending. There must be room for all of
/// them, and for Lanes more. Returns how many there are.
SURFACEDENOISING_DEFAULT
std::size_t FindSmall(const double* squares, std::size_t count, double limit, Index* numbers)
{
  std::size_t found = 0;
  for (std::size_t n = 0; n < count; ++n)
  {
    // Written in any case and kept if it is small: branches would be guessed wrong.
    numbers[found] = static_cast<Index>(n);
    found += squares[n] <= limit ? 1 : 0;
  }
  return found;
}

#ifdef SURFACEDENOISING_AVX512
/// The same with the instruction that was made for it, which compilers do not see in the loop.
SURFACEDENOISING_AVX512
std::size_t FindSmall(const double* squares, std::size_t count, double limit, Index* numbers)
{
  const __m512d limits = _mm512_set1_pd(limit);
  __m512i next = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  std::size_t found = 0;
  for (std::size_t n = 0; n < count; n += 16)
  {
    const std::uint32_t exist = n + 16 <= count ? 0xffff : (1u << (count - n)) - 1;
    const __m512d low = _mm512_maskz_loadu_pd(static_cast<__mmask8>(exist), squares + n);
    const __m512d high = _mm512_maskz_loadu_pd(static_cast<__mmask8>(exist >> 8), squares + n + 8);
    const std::uint32_t small = exist &
      (_mm512_cmp_pd_mask(low, limits, _CMP_LE_OQ) |
        std::uint32_t(_mm512_cmp_pd_mask(high, limits, _CMP_LE_OQ)) << 8);
    _mm512_storeu_si512(numbers + found,
      _mm512_maskz_compress_epi32(static_cast<__mmask16>(small), next));
    found += static_cast<std::size_t>(__builtin_popcount(small));
    next = _mm512_add_epi32(next, _mm512_set1_epi32(16));
  }
  return found;
}
#endif

/// ranks[i] = how many of the keys are smaller than keys[i]. Both lists must have room for a
/// multiple of Lanes.
SURFACEDENOISING_VECTORIZED
void CountSmaller(const float* keys, std::size_t count, std::int32_t* ranks)
{
  for (std::size_t i = 0; i < count; i += Lanes)
  {
    float own[Lanes];
    std::copy(keys + i, keys + i + Lanes, own);
    std::int32_t smaller[Lanes] = {};
    for (std::size_t j = 0; j < count; ++j)
    {
      for (std::size_t lane = 0; lane < Lanes; ++lane)
      {
        smaller[lane] += keys[j] < own[lane] ? 1 : 0;
      }
    }
    std::copy(smaller, smaller + Lanes, ranks + i);
  }
}

}

void RunSearch::RunList::Grow(std::size_t size)
{
  this->Numbers.resize(size);
  for (int axis = 0; axis < 3; ++axis)
  {
    // Read to the end of a vector, whatever is there.
    this->Low[axis].resize(size, 0.0);
    this->High[axis].resize(size, 0.0);
  }
}

void RunSearch::RunList::Add(Index run, const PointRuns::Family& family, std::size_t child)
{
  const std::size_t n = this->Count++;
  if (n == this->Numbers.size())
  {
    this->Grow(2 * n + 2 * Lanes);
  }
  this->Numbers[n] = run;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Low[axis][n] = family.Low[axis][child];
    this->High[axis][n] = family.High[axis][child];
  }
}

/// The runs at most distance away from the box. Returns false if there are more than most.
bool RunSearch::FindRuns(const Box& box, double distance, std::size_t most, RunList& list)
{
  const std::vector<Buffer<PointRuns::Family>>& levels = this->Runs.Levels();
  const double limit = distance * distance;
  list.Count = 0;
  this->Families.assign(1, { levels.size() - 1, 0 });
  while (!this->Families.empty() && list.Count <= most)
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
      if (exists && squares[child] <= limit)
      {
        const std::size_t below = number * PointRuns::Fan + child;
        if (level > 0)
        {
          this->Families.emplace_back(level - 1, below);
        }
        else
        {
          list.Add(static_cast<Index>(below), family, child);
        }
      }
    }
  }
  return list.Count <= most;
}

/// Finds the runs around a family, unless they are known. Returns false if they are too many.
bool RunSearch::KnowsAround(std::size_t family, double distance)
{
  if (family != this->AroundFamily || distance > this->AroundDistance)
  {
    this->AroundFamily = family;
    this->AroundDistance = RoomForOthers * distance;
    this->AroundKnown = this->FindRuns(this->Runs.BoxOfFamily(family), this->AroundDistance,
      MostAround, this->Around);
  }
  return this->AroundKnown;
}

/// Where in the list the runs are that are so near; in Near. Returns how many there are.
std::size_t RunSearch::NearRuns(const RunList& list, const Box& box, double square)
{
  const std::size_t count = RoundUp(list.Count, Wide);
  if (this->Gaps.size() < count)
  {
    this->Gaps.resize(2 * count);
    this->Near.resize(2 * count + Lanes);
  }
  const double* low[3] = { list.Low[0].data(), list.Low[1].data(), list.Low[2].data() };
  const double* high[3] = { list.High[0].data(), list.High[1].data(), list.High[2].data() };
  SquaredGaps(box, low, high, count, this->Gaps.data());
  return FindSmall(this->Gaps.data(), list.Count, square, this->Near.data());
}

void RunSearch::TakeRuns(std::size_t run, double distance)
{
  const Box box = this->Runs.BoxOf(run);
  if (!this->KnowsAround(run / PointRuns::Fan, distance))
  {
    this->FindRuns(box, distance, this->Runs.NumberOfRuns(), this->Taken);
    return;
  }
  this->Taken.Count = this->NearRuns(this->Around, box, distance * distance);
  if (this->Taken.Numbers.size() < this->Taken.Count)
  {
    this->Taken.Grow(2 * RoundUp(this->Taken.Count, Wide));
  }
  for (std::size_t n = 0; n < this->Taken.Count; ++n)
  {
    const std::size_t place = this->Near[n];
    this->Taken.Numbers[n] = this->Around.Numbers[place];
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Taken.Low[axis][n] = this->Around.Low[axis][place];
      this->Taken.High[axis][n] = this->Around.High[axis][place];
    }
  }
}

std::size_t RunSearch::TakePoints(const Vec3& p, double square)
{
  const std::size_t near = this->NearRuns(this->Taken, { p, p }, square);
  for (std::size_t n = 0; n < near; ++n)
  {
    this->Near[n] = this->Taken.Numbers[this->Near[n]];
  }
  const std::size_t room = near * RunLength + Lanes;
  if (this->Places.size() < room)
  {
    this->Squares.resize(2 * room);
    this->Places.resize(2 * room);
    this->Order.resize(2 * room);
  }
  const double* axes[3] = { this->Runs.Coordinates(0), this->Runs.Coordinates(1),
    this->Runs.Coordinates(2) };
  SquaredDistances(axes, this->Near.data(), near, p, this->Squares.data());
  this->NumberOfPoints =
    FindSmall(this->Squares.data(), near * RunLength, square, this->Places.data());
  this->Largest = square;
  return this->NumberOfPoints;
}

/// Returns false if there are equal distances, or nearly equal ones.
bool RunSearch::RankPoints(std::size_t count)
{
  const std::size_t taken = this->NumberOfPoints;
  // Shares of the largest one, as short numbers: what differs among these differs the same way
  // before they are rounded.
  const double inverse = 1.0 / this->Largest;
  this->Keys.resize(MostRanked);
  float* keys = this->Keys.data();
  for (std::size_t n = 0; n < taken; ++n)
  {
    keys[n] = static_cast<float>(this->Squares[this->Places[n]] * inverse);
  }
  std::fill(keys + taken, keys + RoundUp(taken, Lanes), 0.0f);
  std::int32_t ranks[MostRanked];
  CountSmaller(keys, taken, ranks);
  Index ranked[MostRanked];
  std::size_t sum = 0;
  for (std::size_t n = 0; n < taken; ++n)
  {
    const std::size_t rank = static_cast<std::size_t>(ranks[n]);
    sum += rank;
    ranked[rank] = this->Places[n];
  }
  // Distinct numbers have the ranks 0, 1, 2 and so on, equal ones share the lowest.
  if (sum != taken * (taken - 1) / 2)
  {
    return false;
  }
  for (std::size_t n = 0; n < count; ++n)
  {
    this->Order[n] = this->NumberOf(ranked[n]);
  }
  this->Last = this->Squares[ranked[count - 1]];
  return true;
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
    const Index place = this->Places[n];
    this->Pairs[n] = { this->Squares[place], this->NumberOf(place) };
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
