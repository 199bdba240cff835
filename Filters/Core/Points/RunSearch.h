// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file RunSearch.h
 * @brief Looks for points near a place among those of the runs nearby.
 */

#ifndef SurfaceDenoising_RunSearch_h
#define SurfaceDenoising_RunSearch_h

#include "PointRuns.h"

namespace SurfaceDenoising
{

/// A length that is at least the exact sum or root that was rounded to it.
inline double Above(double length) { return length * (1.0 + 1e-14); }

/**
 * The work of one thread: takes the runs near a run, then of these the points near a place, then
 * sorts the points. Its memory grows to what the largest neighbourhood needs.
 */
class RunSearch
{
public:
  explicit RunSearch(const PointRuns& runs)
    : Runs(runs)
  {
  }

  /// Takes the runs whose boxes are at most distance away from that of a run.
  void TakeRuns(std::size_t run, double distance);

  /// Takes the points at a squared distance of at most square from p, from the runs taken. Returns
  /// how many there are.
  std::size_t TakePoints(const Vec3& p, double square);

  /// Sorts the count nearest of the points taken, equally distant ones by number. There must be as
  /// many.
  void SortPoints(std::size_t count);

  /// The numbers that were sorted.
  const Index* Sorted() const { return this->Order.data(); }

  /// The squared distance of the last one, if count was not zero.
  double LastSquare() const { return this->Last; }

private:
  using Box = PointRuns::Box;

  /// Some runs with their boxes, axis by axis.
  struct RunList
  {
    std::size_t Count = 0;
    Buffer<Index> Numbers;
    Buffer<double> Low[3];
    Buffer<double> High[3];

    void Add(Index run, const PointRuns::Family& family, std::size_t child);
    void Grow(std::size_t size);
  };

  bool FindRuns(const Box& box, double distance, std::size_t most, RunList& list);
  bool KnowsAround(std::size_t family, double distance);
  std::size_t NearRuns(const RunList& list, const Box& box, double square);
  bool RankPoints(std::size_t count);

  const PointRuns& Runs;
  std::vector<std::pair<std::size_t, std::size_t>> Families; ///< to be visited: level and number

  RunList Taken;
  Buffer<double> Gaps; ///< squared distances of boxes
  Buffer<Index> Near;  ///< numbers of runs, or where these are in a list

  /// The runs at most AroundDistance away from a family of runs: all of these look there first.
  RunList Around;
  std::size_t AroundFamily = NoIndex;
  double AroundDistance = 0.0;
  bool AroundKnown = false;

  /// Squared distances of the points of the runs in Near, one run after the other, and where among
  /// them the points taken are.
  Buffer<double> Squares;
  Buffer<Index> Places;
  std::size_t NumberOfPoints = 0;
  double Largest = 0.0; ///< what the squared distances of those taken are at most

  Index NumberOf(Index place) const
  {
    return this->Near[place / RunLength] * Index(RunLength) + place % Index(RunLength);
  }

  Buffer<float> Keys;
  Buffer<Index> Order;
  double Last = 0.0;
  Buffer<std::pair<double, Index>> Pairs;
};

}

#endif
