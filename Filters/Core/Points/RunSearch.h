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
 * The work of one thread: takes the runs near the box of a run, then of these the points near a
 * place, then sorts the points. Its memory grows to what the largest neighbourhood needs.
 */
class RunSearch
{
public:
  explicit RunSearch(const PointRuns& runs)
    : Runs(runs)
  {
  }

  /// Takes the runs whose boxes are at most distance away from the box.
  void TakeRuns(const PointRuns::Box& box, double distance);

  /// Of the runs taken, keeps those at most distance away from the box.
  void KeepRuns(const PointRuns::Box& box, double distance);

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
  bool RankPoints(std::size_t count);
  void AddRun(Index run, const PointRuns::Family& family, std::size_t child);

  const PointRuns& Runs;
  std::vector<std::pair<std::size_t, std::size_t>> Families; ///< to be visited: level and number

  /// Runs taken, with their boxes axis by axis.
  std::size_t NumberOfRuns = 0;
  Buffer<Index> TakenRuns;
  Buffer<double> Low[3];
  Buffer<double> High[3];
  Buffer<double> Gaps; ///< squared distances of the boxes
  Buffer<Index> NearRuns;

  /// Points taken, in no order.
  std::size_t NumberOfPoints = 0;
  Buffer<Index> Numbers;
  Buffer<double> Squares;

  Buffer<Index> Order;
  double Last = 0.0;
  Buffer<std::pair<double, Index>> Pairs;
  Buffer<std::int64_t> Ranks;
};

}

#endif
