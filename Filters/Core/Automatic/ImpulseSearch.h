// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file ImpulseSearch.h
 * @brief Vertices or points far off the surface around them, and whether they are noise.
 *
 * Noise that reaches some of them and leaves the others alone has heavy tails, and what it does to
 * one says nothing about those beside it. Gaussian noise has no such tails. Features, the steps of
 * voxels among them, stick out in rows and patterns: near one there are more of them than by
 * chance.
 */

#ifndef SurfaceDenoising_ImpulseSearch_h
#define SurfaceDenoising_ImpulseSearch_h

#include "../CompressedRows.h"

#include <functional>

namespace SurfaceDenoising
{

/// How far all are off the surface around them, and off what is usual there.
struct SpikeScores
{
  Buffer<double> Heights; ///< lengths; NaN where not enough is around
  Buffer<double> Ratios;  ///< over the upper third of the heights nearby; NaN as well with few
};

/// Ratios: heights over the 2/3 quantile of those nearby that are not marked, which is a length of
/// the order of unit.
void CompareWithUsual(SpikeScores& scores, const CompressedRows& nearby,
  const Buffer<unsigned char>& marks, double unit, Execution& execution);

/// What spikes are looked for among.
struct SpikeSites
{
  CompressedRows Beside;         ///< next to each
  CompressedRows Nearby;         ///< these and the next but one
  Buffer<unsigned char> Counted; ///< 0 for those that are never spikes
  double Unit = 0.0;             ///< a length: the mean edge length or the spacing
  /// Spikes very far off among all, of which Gaussian noise has hardly any.
  double LeastVeryFar = 0.15;
  /// Spikes beside spikes, and next but one, over those to expect if places are chosen at random.
  /// Rows of features are clustered by more, impulses hardly: those that are missed are in rough
  /// places, and an impulse may let its neighbour look like one.
  double MostClustered = 1.4;
  /// Scores of all, in which those that are marked have no part as neighbours.
  std::function<SpikeScores(const Buffer<unsigned char>& marks, Execution& execution)> Score;
};

/// Marks spikes with 1: heights above 4 times what is usual around them and above 0.05 units.
Buffer<unsigned char> FindSpikes(const SpikeSites& sites, Execution& execution);

/**
 * True if there is impulsive noise, and then marks what it has moved. Spikes as of FindSpikes are
 * looked for again without those found before, which hide smaller ones and let what is beside them
 * look like spikes: twice above 3 times what is usual, twice above 2.5 times.
 *
 * Noise is impulsive if at least 100 count and
 * - spikes are at least 1% of those that count, and a share of LeastVeryFar of them is above 8
 *   times what is usual, in the first and in the second round: of Gaussian noise in random
 *   directions, a few in the first are so by chance;
 * - in the second round, no more beside spikes are spikes than if they were chosen at random, but
 *   for a factor of MostClustered and a standard deviation of chance. The same for the next but
 *   one.
 *
 * If the execution asks to stop, what comes back is of no use.
 */
bool FindImpulses(const SpikeSites& sites, Buffer<unsigned char>& marks, Execution& execution);

}

#endif
