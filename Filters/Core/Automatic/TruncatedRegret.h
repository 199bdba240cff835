// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file TruncatedRegret.h
 * @brief The best of several choices after rounds that do not agree.
 *
 * The regret of a choice in a round is how much more it loses than the best one there, but 0.3 at
 * most: so no round decides alone. Weighted sums of regrets are compared. A choice is given up as
 * soon as no outcome of the rounds to come could make it the best: that saves its trials and
 * changes nothing.
 */

#ifndef SurfaceDenoising_TruncatedRegret_h
#define SurfaceDenoising_TruncatedRegret_h

#include <cstddef>
#include <vector>

namespace SurfaceDenoising
{

class TruncatedRegret
{
public:
  /// Of logarithms of errors: what is worse by a third is bad enough for one round to say so.
  static constexpr double Largest = 0.3;

  /// Choices that are all open, and the weight of all rounds together.
  TruncatedRegret(std::size_t choices, double weight);

  std::size_t NumberOfChoices() const { return this->Regrets.size(); }

  /// Leaves a choice out of all rounds.
  void Exclude(std::size_t choice);

  bool IsOpen(std::size_t choice) const;

  /// Counts a round with the losses of all choices, of which those of open ones matter.
  void AddRound(double weight, const std::vector<double>& losses);

  /// The open choice with the least regret, the first of several.
  std::size_t Best() const;

private:
  std::vector<double> Regrets; ///< infinite for choices that are not open
  double Left;                 ///< weight of the rounds to come
};

}

#endif
