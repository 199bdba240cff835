// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Automatic/TruncatedRegret.h"

#include <algorithm>
#include <limits>

namespace SurfaceDenoising
{

namespace
{
constexpr double Infinite = std::numeric_limits<double>::infinity();
}

TruncatedRegret::TruncatedRegret(std::size_t choices, double weight)
  : Regrets(choices, 0.0)
  , Left(weight)
{
}

void TruncatedRegret::Exclude(std::size_t choice) { this->Regrets[choice] = Infinite; }

bool TruncatedRegret::IsOpen(std::size_t choice) const { return this->Regrets[choice] < Infinite; }

void TruncatedRegret::AddRound(double weight, const std::vector<double>& losses)
{
  double best = Infinite;
  for (std::size_t k = 0; k < losses.size(); ++k)
  {
    best = this->IsOpen(k) ? std::min(best, losses[k]) : best;
  }
  for (std::size_t k = 0; k < losses.size(); ++k)
  {
    this->Regrets[k] += weight * std::min(Largest, losses[k] - best);
  }
  // Rounding must not close the best of all.
  this->Left = std::max(0.0, this->Left - weight);
  const double limit =
    *std::min_element(this->Regrets.begin(), this->Regrets.end()) + this->Left * Largest;
  for (double& regret : this->Regrets)
  {
    regret = regret > limit ? Infinite : regret;
  }
}

std::size_t TruncatedRegret::Best() const
{
  const auto best = std::min_element(this->Regrets.begin(), this->Regrets.end());
  return static_cast<std::size_t>(best - this->Regrets.begin());
}

}
