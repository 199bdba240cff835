// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Noise.h"

#include <algorithm>
#include <cmath>

namespace SurfaceDenoising
{

namespace
{

constexpr double Pi = 3.14159265358979323846;

/// What a random number of a point is used for. Each has numbers of its own.
enum Draw : std::uint64_t
{
  DrawRank,
  DrawRadius,
  DrawPhase,
  DrawHeight,
  DrawLongitude,
  DrawsPerPoint = 8, // room for more without a change of the numbers above
};

/// The output function of SplitMix64 (Steele, Lea, Flood 2014): a bijection that mixes all bits.
std::uint64_t Mix(std::uint64_t z)
{
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// SplitMix64 counts in steps of gamma and mixes, so that any of its numbers can be asked for.
std::uint64_t Hash(std::uint64_t seed, std::uint64_t i, Draw draw)
{
  constexpr std::uint64_t gamma = 0x9e3779b97f4a7c15u;
  // A mixed seed: neighbouring seeds would otherwise share most of their numbers, shifted.
  return Mix(Mix(seed + gamma) + gamma * (i * DrawsPerPoint + draw + 1));
}

/// In the open interval (0, 1). 52 bits, because the half added to 53 would round up to 1.
double Unit(std::uint64_t seed, std::uint64_t i, Draw draw)
{
  return (static_cast<double>(Hash(seed, i, draw) >> 12) + 0.5) * 0x1p-52;
}

/// Box and Muller 1958.
double Gaussian(std::uint64_t seed, std::uint64_t i)
{
  return std::sqrt(-2.0 * std::log(Unit(seed, i, DrawRadius))) *
    std::cos(2.0 * Pi * Unit(seed, i, DrawPhase));
}

}

Buffer<unsigned char> ChooseFraction(double fraction, std::size_t count, std::uint64_t seed)
{
  const double share = fraction > 0.0 ? std::min(fraction, 1.0) : 0.0; // not a number counts as 0
  const double wanted = std::floor(share * static_cast<double>(count) + 1e-6);
  const std::size_t chosen = std::min(count, static_cast<std::size_t>(wanted));

  // The points with the lowest hash values, equal values by number.
  std::vector<std::pair<std::uint64_t, std::size_t>> ranks(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    ranks[i] = { Hash(seed, i, DrawRank), i };
  }
  std::nth_element(ranks.begin(), ranks.begin() + chosen, ranks.end());

  Buffer<unsigned char> marks;
  marks.assign(count, 0);
  for (std::size_t k = 0; k < chosen; ++k)
  {
    marks[ranks[k].second] = 1;
  }
  return marks;
}

NoiseSource::NoiseSource(const NoiseParameters& parameters, std::size_t numberOfPoints)
  : Parameters(parameters)
{
  if (parameters.Kind == NoiseKind::Impulsive)
  {
    this->Hit = ChooseFraction(parameters.Fraction, numberOfPoints, parameters.Seed);
  }
}

double NoiseSource::Amplitude(std::size_t i) const
{
  const NoiseParameters& p = this->Parameters;
  switch (p.Kind)
  {
    case NoiseKind::Uniform:
      return p.Deviation * std::sqrt(3.0) * (2.0 * Unit(p.Seed, i, DrawRadius) - 1.0);
    case NoiseKind::Impulsive:
      return this->Hit[i] ? p.Deviation * Gaussian(p.Seed, i) : 0.0;
    case NoiseKind::Gaussian:
      break;
  }
  return p.Deviation * Gaussian(p.Seed, i);
}

Vec3 NoiseSource::Direction(std::size_t i) const
{
  // Slices of equal height have equal area on the sphere (Archimedes).
  const double z = 2.0 * Unit(this->Parameters.Seed, i, DrawHeight) - 1.0;
  const double phi = 2.0 * Pi * Unit(this->Parameters.Seed, i, DrawLongitude);
  const double r = std::sqrt((1.0 - z) * (1.0 + z));
  return Vec3(r * std::cos(phi), r * std::sin(phi), z);
}

}
