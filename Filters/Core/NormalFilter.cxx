// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NormalFilter.h"

#include <atomic>

namespace SurfaceDenoising
{

namespace
{

/// Loops over weights run to a multiple of the widest vector, so that no remainder loop rounds
/// differently.
constexpr std::size_t Lanes = 8;

constexpr std::size_t RoundUp(std::size_t count) { return (count + Lanes - 1) / Lanes * Lanes; }

/// Pairs that are handled together: their weights stay in the first-level cache between the stages.
constexpr std::size_t BlockPairs = 512;

/// Rows [First, Last) of the graph; their entries begin at Entry in the arrays of fixed values.
struct Block
{
  std::size_t First;
  std::size_t Last;
  std::size_t Entry;
  std::size_t Count;
};

/// Stage 1: squared chords |centre_i - compared_j|^2 of a block; 0 where the centre has no normal.
SURFACEDENOISING_VECTORIZED
void SquaredChords(const CompressedRows& graph, bool own, const Block& block, const Vec3* centre,
  const Vec3* compared, double* squares)
{
  const std::uint64_t* offsets = graph.Offsets.data();
  const Index* ids = graph.Ids.data();
  std::size_t k = 0;
  for (std::size_t i = block.First; i < block.Last; ++i)
  {
    const double cx = centre[i][0];
    const double cy = centre[i][1];
    const double cz = centre[i][2];
    const double known = cx * cx + cy * cy + cz * cz > 0.0 ? 1.0 : 0.0;
    auto square = [=](const Vec3& n)
    {
      const double dx = n[0] - cx;
      const double dy = n[1] - cy;
      const double dz = n[2] - cz;
      return known * (dx * dx + dy * dy + dz * dz);
    };
    if (own)
    {
      squares[k++] = square(compared[i]);
    }
    for (std::uint64_t p = offsets[i]; p < offsets[i + 1]; ++p)
    {
      squares[k++] = square(compared[ids[p]]);
    }
  }
  for (const std::size_t end = RoundUp(k); k < end; ++k)
  {
    squares[k] = 0.0;
  }
}

/// Stage 2, if angles are compared: the angle between unit vectors from the square of their chord.
void ChordsToAngles(double* squares, std::size_t count)
{
  for (std::size_t k = 0; k < count; ++k)
  {
    const double angle =
      2.0 * std::atan2(std::sqrt(squares[k]), std::sqrt(std::max(0.0, 4.0 - squares[k])));
    squares[k] = angle * angle;
  }
}

/// Stage 3: the weights of the norm times what is fixed.
template <typename Norm>
SURFACEDENOISING_VECTORIZED void Weigh(const Norm norm, const double* fixed, double* squares,
  std::size_t count)
{
  for (std::size_t k = 0, end = RoundUp(count); k < end; ++k)
  {
    squares[k] = norm.WeightOfSquare(squares[k]) * fixed[k];
  }
}

/// Stage 4: weighted sums of the data, normalised. Returns the number of sites that kept their
/// normal.
SURFACEDENOISING_VECTORIZED
std::size_t WeightedMeans(const CompressedRows& graph, bool own, const Block& block,
  const double* weights, const Vec3* data, const Vec3* current, Vec3* filtered)
{
  const std::uint64_t* offsets = graph.Offsets.data();
  const Index* ids = graph.Ids.data();
  std::size_t kept = 0;
  std::size_t k = 0;
  for (std::size_t i = block.First; i < block.Last; ++i)
  {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    double total = 0.0;
    auto add = [&](const Vec3& n)
    {
      const double w = weights[k++];
      x += w * n[0];
      y += w * n[1];
      z += w * n[2];
      total += w;
    };
    if (own)
    {
      add(data[i]);
    }
    for (std::uint64_t p = offsets[i]; p < offsets[i + 1]; ++p)
    {
      add(data[ids[p]]);
    }
    const double length = std::sqrt(x * x + y * y + z * z);
    if (length > 1e-12 * total)
    {
      const double scale = 1.0 / length;
      filtered[i] = Vec3(x * scale, y * scale, z * scale);
    }
    else
    {
      filtered[i] = current[i];
      ++kept;
    }
  }
  return kept;
}

}

NormalFilter::NormalFilter(const NeighborGraph& graph, const NormalFilterSettings& settings)
  : Graph(graph)
  , Settings(settings)
{
  for (std::size_t i = 0; i < graph.NumberOfRows(); ++i)
  {
    this->LongestRow = std::max(this->LongestRow, graph.Row(i).size());
  }
}

void NormalFilter::SetGeometry(const Buffer<Vec3>& positions, const Buffer<double>& areas,
  double shortest, Execution& execution)
{
  const NormalFilterSettings& settings = this->Settings;
  const std::size_t rows = this->Graph.NumberOfRows();
  const std::size_t own = settings.IncludeOwn ? 1 : 0;
  const bool curvature = settings.Argument == NormalArgument::DirectionalCurvature;
  const std::size_t entries = this->Graph.NumberOfIds() + own * rows;
  this->FixedWeights.resize(entries + Lanes);
  this->InverseSquaredDistances.resize(curvature ? entries : 0);
  std::fill(this->FixedWeights.begin() + entries, this->FixedWeights.end(), 0.0);

  const double exponent =
    settings.SpatialSigma > 0.0 ? -0.5 / (settings.SpatialSigma * settings.SpatialSigma) : 0.0;
  auto fix = [&](std::size_t entry, std::size_t i, std::size_t j)
  {
    const double a = settings.AreaWeighted ? areas[j] : (areas[j] > 0.0 ? 1.0 : 0.0);
    const double dd = (positions[i] - positions[j]).squaredNorm();
    this->FixedWeights[entry] = exponent < 0.0 ? a * ExpOfNegative(exponent * dd) : a;
    if (curvature)
    {
      this->InverseSquaredDistances[entry] = 1.0 / std::max(dd, shortest * shortest);
    }
  };
  execution.For(rows,
    [&](std::size_t begin, std::size_t end)
    {
      std::size_t entry = this->Graph.Offsets[begin] + own * begin;
      for (std::size_t i = begin; i < end; ++i)
      {
        if (own)
        {
          fix(entry++, i, i);
        }
        for (const Index j : this->Graph.Row(i))
        {
          fix(entry++, i, j);
        }
      }
    });
}

std::size_t NormalFilter::Sweep(const Fields& fields, Buffer<Vec3>& filtered,
  Execution& execution) const
{
  const std::size_t rows = this->Graph.NumberOfRows();
  const bool own = this->Settings.IncludeOwn;
  const NormalArgument argument = this->Settings.Argument;
  const std::uint64_t* offsets = this->Graph.Offsets.data();
  const std::size_t capacity = std::max(BlockPairs, RoundUp(this->LongestRow + 1));
  filtered.resize(rows);
  std::atomic<std::size_t> kept{ 0 };

  execution.For(rows,
    [&](std::size_t begin, std::size_t end)
    {
      Buffer<double> weights(capacity);
      std::size_t keptHere = 0;
      auto entryOf = [&](std::size_t i) { return offsets[i] + (own ? i : 0); };
      for (std::size_t first = begin; first < end;)
      {
        std::size_t last = first + 1;
        while (last < end && entryOf(last + 1) - entryOf(first) <= capacity)
        {
          ++last;
        }
        const Block block{ first, last, entryOf(first), entryOf(last) - entryOf(first) };
        SquaredChords(this->Graph, own, block, fields.Centre.data(), fields.Compared.data(),
          weights.data());
        if (argument != NormalArgument::Chord)
        {
          ChordsToAngles(weights.data(), block.Count);
        }
        if (argument == NormalArgument::DirectionalCurvature)
        {
          const double* inverse = this->InverseSquaredDistances.data() + block.Entry;
          for (std::size_t k = 0; k < block.Count; ++k)
          {
            weights[k] *= inverse[k];
          }
        }
        std::visit([&](const auto& norm)
          { Weigh(norm, this->FixedWeights.data() + block.Entry, weights.data(), block.Count); },
          this->Settings.Norm);
        keptHere += WeightedMeans(this->Graph, own, block, weights.data(), fields.Data.data(),
          fields.Current.data(), filtered.data());
        first = last;
      }
      kept += keptHere;
    });
  return kept;
}

}
