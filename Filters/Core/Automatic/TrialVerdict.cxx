// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Automatic/TrialVerdict.h"

#include <cmath>
#include <utility>

namespace SurfaceDenoising
{

TrialVerdict::TrialVerdict(std::vector<std::size_t> kinds, std::size_t favourite,
  std::size_t judged)
  : Kinds(std::move(kinds))
  , Favourite(favourite)
  , Chance(2.2 / std::sqrt(static_cast<double>(judged)))
  , Found(this->Kinds.size())
{
}

bool TrialVerdict::IsHeard(std::size_t maker, std::size_t method) const
{
  const std::size_t kind = this->Kinds[method];
  return maker != method && (this->Kinds[maker] != kind || this->Kinds[this->Favourite] == kind);
}

void TrialVerdict::AddGain(std::size_t method, double gain)
{
  this->Found[method].Sum += gain;
  ++this->Found[method].Count;
}

std::size_t TrialVerdict::Chosen() const
{
  std::size_t chosen = this->Favourite;
  double most = this->Chance;
  for (std::size_t k = 0; k < this->Found.size(); ++k)
  {
    const Gains& gains = this->Found[k];
    if (gains.Count > 0 && gains.Sum / static_cast<double>(gains.Count) > most)
    {
      most = gains.Sum / static_cast<double>(gains.Count);
      chosen = k;
    }
  }
  return chosen;
}

}
