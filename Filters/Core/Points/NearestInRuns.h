// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file NearestInRuns.h
 * @brief The nearest points of the points of a run.
 */

#ifndef SurfaceDenoising_NearestInRuns_h
#define SurfaceDenoising_NearestInRuns_h

#include "RunSearch.h"

#include <limits>

namespace SurfaceDenoising
{

/// The work of one thread on one run after the other.
class NearestInRuns
{
public:
  /// There must be more than count points, and count must not be zero.
  NearestInRuns(const PointRuns& runs, std::size_t count)
    : Runs(runs)
    , Count(count)
    , Search(runs)
    , Before(std::numeric_limits<double>::infinity())
  {
  }

  /**
   * For every point of the run, the count nearest of the other points, nearest first, equally
   * distant ones by number, to rows[0 .. count) and so on. Of more than count points at the place
   * of one, the first of those around it in the order are taken: looking at all of a heap of points
   * would take too long.
   */
  void Find(std::size_t run, Index* rows);

private:
  std::pair<std::size_t, std::size_t> Around(std::size_t i) const;
  double BoundAround(std::size_t i);
  bool IsInHeap(std::size_t i) const;
  double TakeHeap(std::size_t i, Index* row) const;
  bool Take(std::size_t i, double distance);
  void TakeEnough(std::size_t i, double likely, double bound);
  double FindOne(std::size_t i, double likely, double bound, Index* row);

  const PointRuns& Runs;
  const std::size_t Count;
  RunSearch Search;
  Buffer<double> Squares;

  double Before; ///< the distance of the last neighbour in the middle of the run before

  /// The present run, how far around it others were taken, and for its points the distance of the
  /// last neighbour.
  std::size_t Run = 0;
  double Covered = 0.0;
  double Distances[RunLength];
};

}

#endif
