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

/// Entries handled together: their weights stay in the first-level cache between the stages.
constexpr std::size_t BlockEntries = 512;

/// Sums of weights below this are none: their squares would lose digits, and normals their length.
constexpr double NoWeight = 1e-140;

/// Rows [First, Last) of the graph; their entries begin at Entry in the arrays of fixed values.
struct Block
{
  std::size_t First;
  std::size_t Last;
  std::size_t Entry;
  std::size_t Count;
};

/// Calls use(block) for rows [begin, end), cut into blocks of at most capacity entries.
template <typename Use>
void ForBlocks(const CompressedRows& graph, bool own, std::size_t capacity, std::size_t begin,
  std::size_t end, Use use)
{
  auto entryOf = [&graph, own](std::size_t i) { return graph.Offsets[i] + (own ? i : 0); };
  for (std::size_t first = begin; first < end;)
  {
    std::size_t last = first + 1;
    while (last < end && entryOf(last + 1) - entryOf(first) <= capacity)
    {
      ++last;
    }
    use(Block{ first, last, entryOf(first), entryOf(last) - entryOf(first) });
    first = last;
  }
}

/**
 * Stage 1: |centre_i - compared_j|^2 for the entries of a block. If the vectors are normals, a zero
 * centre is no normal and differs from nothing.
 */
template <bool AreNormals>
SURFACEDENOISING_VECTORIZED void SquaredDistances(const CompressedRows& graph, bool own,
  const Block& block, const Vec3* centre, const Vec3* compared, double* squares)
{
  const std::uint64_t* offsets = graph.Offsets.data();
  const Index* ids = graph.Ids.data();
  std::size_t k = 0;
  for (std::size_t i = block.First; i < block.Last; ++i)
  {
    const double cx = centre[i][0];
    const double cy = centre[i][1];
    const double cz = centre[i][2];
    const bool differs = !AreNormals || cx * cx + cy * cy + cz * cz > 0.0;
    const double factor = differs ? 1.0 : 0.0;
    auto square = [=](const Vec3& n)
    {
      const double dx = n[0] - cx;
      const double dy = n[1] - cy;
      const double dz = n[2] - cz;
      return factor * (dx * dx + dy * dy + dz * dz);
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

/// values *= factors.
void Multiply(const double* factors, std::size_t count, double* values)
{
  for (std::size_t k = 0; k < count; ++k)
  {
    values[k] *= factors[k];
  }
}

/// 1 / squares, held at 1 / smallest.
void InvertSquares(const double* squares, std::size_t count, double smallest, double* inverse)
{
  for (std::size_t k = 0; k < count; ++k)
  {
    inverse[k] = 1.0 / std::max(squares[k], smallest);
  }
}

/// values *= f(d), the spatial kernel.
SURFACEDENOISING_VECTORIZED
void Attenuate(const GaussianNorm kernel, const double* squares, std::size_t count, double* values)
{
  for (std::size_t k = 0; k < count; ++k)
  {
    values[k] *= kernel.WeightOfSquare(squares[k]);
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
    if (length > std::max(1e-12 * total, NoWeight))
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
  std::size_t longest = 0;
  for (std::size_t i = 0; i < graph.NumberOfRows(); ++i)
  {
    longest = std::max(longest, graph.Row(i).size());
  }
  this->Capacity = std::max(BlockEntries, RoundUp(longest + 1));
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

  auto weightOf = [&](std::size_t j)
  { return settings.AreaWeighted ? areas[j] : (areas[j] > 0.0 ? 1.0 : 0.0); };
  execution.For(rows,
    [&](std::size_t begin, std::size_t end)
    {
      Buffer<double> squares(this->Capacity);
      auto fix = [&](const Block& block)
      {
        double* fixed = this->FixedWeights.data() + block.Entry;
        std::size_t k = 0;
        for (std::size_t i = block.First; i < block.Last; ++i)
        {
          if (own)
          {
            fixed[k++] = weightOf(i);
          }
          for (const Index j : this->Graph.Row(i))
          {
            fixed[k++] = weightOf(j);
          }
        }
        if (settings.SpatialSigma > 0.0 || curvature)
        {
          SquaredDistances<false>(this->Graph, own, block, positions.data(), positions.data(),
            squares.data());
        }
        if (curvature)
        {
          InvertSquares(squares.data(), block.Count, shortest * shortest,
            this->InverseSquaredDistances.data() + block.Entry);
        }
        if (settings.SpatialSigma > 0.0)
        {
          Attenuate(GaussianNorm{ settings.SpatialSigma }, squares.data(), block.Count, fixed);
        }
      };
      ForBlocks(this->Graph, own, this->Capacity, begin, end, fix);
    });
}

std::size_t NormalFilter::Sweep(const Fields& fields, Buffer<Vec3>& filtered,
  Execution& execution) const
{
  const std::size_t rows = this->Graph.NumberOfRows();
  const bool own = this->Settings.IncludeOwn;
  const NormalArgument argument = this->Settings.Argument;
  filtered.resize(rows);
  std::atomic<std::size_t> kept{ 0 };
  execution.For(rows,
    [&](std::size_t begin, std::size_t end)
    {
      Buffer<double> weights(this->Capacity);
      std::size_t keptHere = 0;
      auto filter = [&](const Block& block)
      {
        SquaredDistances<true>(this->Graph, own, block, fields.Centre.data(),
          fields.Compared.data(), weights.data());
        if (argument != NormalArgument::Chord)
        {
          ChordsToAngles(weights.data(), block.Count);
        }
        if (argument == NormalArgument::DirectionalCurvature)
        {
          Multiply(this->InverseSquaredDistances.data() + block.Entry, block.Count, weights.data());
        }
        std::visit([&](const auto& norm)
          { Weigh(norm, this->FixedWeights.data() + block.Entry, weights.data(), block.Count); },
          this->Settings.Norm);
        keptHere += WeightedMeans(this->Graph, own, block, weights.data(), fields.Data.data(),
          fields.Current.data(), filtered.data());
      };
      ForBlocks(this->Graph, own, this->Capacity, begin, end, filter);
      kept += keptHere;
    });
  return kept;
}

}
