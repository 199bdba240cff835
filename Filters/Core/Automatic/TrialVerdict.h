// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file TrialVerdict.h
 * @brief What trials on surfaces that methods made say of these methods.
 *
 * A surface favours the method that made it, and those of its kind: it has what they leave. So
 * it is not heard on its maker, nor on methods of its maker's kind beside a favourite of another
 * kind. But what others leave of the noise looks like detail that the favourite takes away: its own
 * surface is heard on all others. The favourite stays unless the mean gain of another one, a
 * logarithm of distances, is above 2.2 / sqrt(N) with N points judged: the rest is chance.
 */

#ifndef SurfaceDenoising_TrialVerdict_h
#define SurfaceDenoising_TrialVerdict_h

#include <cstddef>
#include <vector>

namespace SurfaceDenoising
{

class TrialVerdict
{
public:
  /// On methods of these kinds, one of which is the favourite, from so many points.
  TrialVerdict(std::vector<std::size_t> kinds, std::size_t favourite, std::size_t judged);

  /// Whether a surface that the maker made tells this method, another one than the favourite,
  /// apart from the favourite.
  bool IsHeard(std::size_t maker, std::size_t method) const;

  /// How much less the method leaves there than the favourite: a difference of logarithms.
  void AddGain(std::size_t method, double gain);

  /// The one with the most gain on average, or the favourite if that may be chance.
  std::size_t Chosen() const;

private:
  struct Gains
  {
    double Sum = 0.0;
    std::size_t Count = 0;
  };

  std::vector<std::size_t> Kinds;
  std::size_t Favourite;
  double Chance;
  std::vector<Gains> Found;
};

}

#endif
