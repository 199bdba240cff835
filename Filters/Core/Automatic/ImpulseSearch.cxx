// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ImpulseSearch.h"

#include "../Metrics.h"

#include <cmath>
#include <limits>

namespace SurfaceDenoising
{

namespace
{

constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();
/// Heights that a ratio needs.
constexpr std::size_t LeastHeights = 5;

constexpr int Rounds = 5;
/// What is far, in what is usual around: large spikes are found first.
constexpr double Far[Rounds] = { 4.0, 3.0, 3.0, 2.5, 2.5 };
constexpr double VeryFar = 8.0;
/// Whatever is usual, in units.
constexpr double LeastHeight = 0.05;
/// Of fewer, shares say nothing.
constexpr std::size_t LeastNumber = 100;
/// Of impulsive noise: spikes among all.
constexpr double LeastShare = 0.01;

class SpikeSearch
{
public:
  SpikeSearch(const SpikeSites& sites, Execution& execution)
    : Sites(sites)
    , Host(execution)
    , Marks(sites.Counted.size(), 0)
  {
  }

  /// Marks anew what is far without the marks so far. What has no score keeps its mark.
  void Run(int round)
  {
    const SpikeScores scores = this->Sites.Score(this->Marks, this->Host);
    this->Inside = this->Spikes = this->VeryFarSpikes = 0;
    for (std::size_t v = 0; v < this->Marks.size(); ++v)
    {
      if (!this->Sites.Counted[v])
      {
        continue;
      }
      const double ratio = scores.Ratios[v];
      if (std::isfinite(ratio))
      {
        const bool high = scores.Heights[v] > LeastHeight * this->Sites.Unit;
        this->Marks[v] = high && ratio > Far[round] ? 1 : 0;
      }
      ++this->Inside;
      this->Spikes += this->Marks[v];
      this->VeryFarSpikes += this->Marks[v] && ratio > VeryFar ? 1 : 0;
    }
  }

  bool HasHeavyTails() const
  {
    return this->Inside >= LeastNumber && this->Spikes > 0 &&
      double(this->Spikes) >= LeastShare * double(this->Inside) &&
      double(this->VeryFarSpikes) >= this->Sites.LeastVeryFar * double(this->Spikes);
  }

  /// Whether spikes say nothing about what is beside them and next but one.
  bool IsScattered() const
  {
    const double share = double(this->Spikes) / double(std::max<std::size_t>(this->Inside, 1));
    std::size_t others[2] = { 0, 0 };
    std::size_t spikes[2] = { 0, 0 };
    for (std::size_t v = 0; v < this->Marks.size(); ++v)
    {
      for (const Index w : this->Marks[v] ? this->Sites.Nearby.Row(v) : Span<Index>())
      {
        if (this->Sites.Counted[w])
        {
          const Span<Index> ring = this->Sites.Beside.Row(v);
          const int apart = std::find(ring.begin(), ring.end(), w) == ring.end() ? 1 : 0;
          ++others[apart];
          spikes[apart] += this->Marks[w];
        }
      }
    }
    for (const int apart : { 0, 1 })
    {
      const double expected = share * double(others[apart]);
      // Pairs are counted from both ends: the variance of the count is twice its expectation.
      if (double(spikes[apart]) > this->Sites.MostClustered * expected + std::sqrt(2.0 * expected))
      {
        return false;
      }
    }
    return true;
  }

  Buffer<unsigned char>& Found() { return this->Marks; }

private:
  const SpikeSites& Sites;
  Execution& Host;
  Buffer<unsigned char> Marks;
  std::size_t Inside = 0;
  std::size_t Spikes = 0;
  std::size_t VeryFarSpikes = 0;
};

}

void CompareWithUsual(SpikeScores& scores, const CompressedRows& nearby,
  const Buffer<unsigned char>& marks, double unit, Execution& execution)
{
  const std::size_t count = scores.Heights.size();
  // Rounding errors of flat places are no scale.
  const double least = 1e-12 * unit;
  scores.Ratios.assign(count, Unknown);
  execution.For(
    count,
    [&](std::size_t begin, std::size_t end)
    {
      Buffer<double> heights;
      for (std::size_t v = begin; v < end; ++v)
      {
        heights.clear();
        for (const Index w : nearby.Row(v))
        {
          if (!marks[w] && std::isfinite(scores.Heights[w]))
          {
            heights.push_back(scores.Heights[w]);
          }
        }
        if (heights.size() >= LeastHeights && least > 0.0)
        {
          scores.Ratios[v] = scores.Heights[v] / std::max(least, Percentile(heights, 2.0 / 3.0));
        }
      }
    },
    256);
}

Buffer<unsigned char> FindSpikes(const SpikeSites& sites, Execution& execution)
{
  SpikeSearch search(sites, execution);
  search.Run(0);
  return std::move(search.Found());
}

bool FindImpulses(const SpikeSites& sites, Buffer<unsigned char>& marks, Execution& execution)
{
  SpikeSearch search(sites, execution);
  search.Run(0);
  if (!search.HasHeavyTails())
  {
    return false;
  }
  search.Run(1);
  if (!search.HasHeavyTails() || !search.IsScattered())
  {
    return false;
  }
  for (int round = 2; round < Rounds; ++round)
  {
    search.Run(round);
  }
  marks = std::move(search.Found());
  return true;
}

}
