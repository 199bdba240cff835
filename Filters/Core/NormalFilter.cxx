// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NormalFilter.h"

#include "NormalFilterStages.h"

#include <atomic>

namespace SurfaceDenoising
{

NormalFilter::NormalFilter(const NeighborGraph& graph, const NormalFilterSettings& settings)
  : Graph(graph)
  , Settings(settings)
{
  std::size_t longest = 0;
  for (std::size_t i = 0; i < graph.NumberOfRows(); ++i)
  {
    longest = std::max(longest, graph.Row(i).size());
  }
  this->BlockEntries = std::max(EntriesPerBlock, longest + 1);
  this->Capacity = RoundUp(this->BlockEntries);
}

void NormalFilter::SetGeometry(const SiteGeometry& geometry, Execution& execution)
{
  const NormalFilterSettings& settings = this->Settings;
  const std::size_t rows = this->Graph.NumberOfRows();
  const std::size_t entries = this->EntryOf(rows);
  this->Frozen = false;
  this->InverseSquaredDistances.resize(this->NeedsDistances() ? entries : 0);
  this->Areas = &geometry.Areas;
  this->Shortest = geometry.Shortest;
  this->SpatialSigmas = geometry.SpatialSigmas;
  this->Couplings = geometry.Couplings;
  this->Positions = &geometry.Positions;
  this->Centres = geometry.Centres ? geometry.Centres : &geometry.Positions;
  this->NormScaleFactors = geometry.NormScaleFactors;
  if (settings.Argument == NormalArgument::SiteCurvature)
  {
    const Buffer<double>& curvatures = *geometry.Curvatures;
    this->SiteFactors.resize(rows);
    for (std::size_t i = 0; i < rows; ++i)
    {
      this->SiteFactors[i] = Weight(settings.Norm, curvatures[i]);
    }
  }
  this->Kept = settings.KeepFixedWeights && !this->AllWeighOne();
  if (this->Kept)
  {
    this->ResizeFixedWeights();
  }
  else
  {
    Release(this->FixedWeights);
  }
  if (!this->Kept && !this->NeedsDistances())
  {
    return;
  }
  execution.For(rows,
    [&](std::size_t begin, std::size_t end)
    {
      Buffer<double> squares(this->Capacity);
      this->ForBlocks(begin, end,
        [&](const Block& block)
        {
          const bool squared = this->Kept &&
            this->ComputeFixedWeights(block, squares.data(),
              this->FixedWeights.data() + block.Entry);
          if (this->NeedsDistances())
          {
            if (!squared)
            {
              this->SquareDistances(block, squares.data());
            }
            this->ComputeInverseDistances(block, squares.data());
          }
        });
    });
}

/// True if fixed weights are faster made than read.
bool NormalFilter::AllWeighOne() const
{
  const NormalFilterSettings& settings = this->Settings;
  return this->Areas->empty() && settings.Weighting != SiteWeight::Coupling &&
    !(settings.SpatialSigma > 0.0) && !this->SpatialSigmas;
}

void NormalFilter::ResizeFixedWeights()
{
  const std::size_t entries = this->EntryOf(this->Graph.NumberOfRows());
  this->FixedWeights.resize(entries + Lanes);
  std::fill(this->FixedWeights.begin() + entries, this->FixedWeights.end(), 0.0);
}

void NormalFilter::SquareDistances(const Block& block, double* squares) const
{
  SquaredDistances<VectorKind::Positions>(
    { this->Graph, this->Settings.IncludeOwn, block.First, block.Last }, this->Centres->data(),
    this->Positions->data(), squares);
}

/// Returns true if it needed the squared distances, and leaves them.
bool NormalFilter::ComputeFixedWeights(const Block& block, double* squares, double* fixed) const
{
  const NormalFilterSettings& settings = this->Settings;
  const bool own = settings.IncludeOwn;
  const bool coupled = settings.Weighting == SiteWeight::Coupling;
  const Buffer<double>& areas = *this->Areas;
  if (areas.empty() && !coupled)
  {
    std::fill(fixed, fixed + block.Count, 1.0);
  }
  else
  {
    auto weightOf = [&](std::size_t j)
    { return settings.Weighting == SiteWeight::Area ? areas[j] : (areas[j] > 0.0 ? 1.0 : 0.0); };
    std::size_t k = 0;
    for (std::size_t i = block.First; i < block.Last; ++i)
    {
      if (own)
      {
        fixed[k++] = coupled ? 0.0 : weightOf(i);
      }
      for (std::uint64_t p = this->Graph.Offsets[i]; p < this->Graph.Offsets[i + 1]; ++p)
      {
        const double weight = weightOf(this->Graph.Ids[p]);
        fixed[k++] = coupled ? weight * (*this->Couplings)[p] : weight;
      }
    }
  }
  if (this->SpatialSigmas)
  {
    this->SquareDistances(block, squares);
    for (std::size_t i = block.First; i < block.Last; ++i)
    {
      const std::size_t first = this->EntryOf(i) - block.Entry;
      Attenuate(GaussianNorm{ (*this->SpatialSigmas)[i] }, squares + first,
        this->EntryOf(i + 1) - this->EntryOf(i), fixed + first);
    }
    return true;
  }
  if (settings.SpatialSigma > 0.0)
  {
    this->SquareDistances(block, squares);
    Attenuate(GaussianNorm{ settings.SpatialSigma }, squares, block.Count, fixed);
    return true;
  }
  return false;
}

/// From the squared distances, which it changes.
void NormalFilter::ComputeInverseDistances(const Block& block, double* squares)
{
  const bool own = this->Settings.IncludeOwn;
  const bool bent = this->Settings.Argument == NormalArgument::BentArc;
  if (bent && this->NormScaleFactors)
  {
    // With distances over the factor of the site, x comes out over the factor.
    DivideBySquares({ this->Graph, own, block.First, block.Last }, this->NormScaleFactors->data(),
      squares);
  }
  InvertSquares(squares, block.Count, this->Shortest * this->Shortest,
    this->InverseSquaredDistances.data() + block.Entry);
  if (bent && own && this->Centres == this->Positions)
  {
    // No way to oneself: the least that keeps products finite.
    for (std::size_t i = block.First; i < block.Last; ++i)
    {
      this->InverseSquaredDistances[this->EntryOf(i)] = 1e300;
    }
  }
}

const double* NormalFilter::FixedWeightsOf(const Block& block, Workspace& work) const
{
  if (this->Kept)
  {
    return this->FixedWeights.data() + block.Entry;
  }
  this->ComputeFixedWeights(block, work.Squares.data(), work.Fixed.data());
  // Weights are computed to the end of a vector.
  std::fill(work.Fixed.data() + block.Count, work.Fixed.data() + RoundUp(block.Count), 0.0);
  return work.Fixed.data();
}

void NormalFilter::SetNorm(const ErrorNorm& norm, NormalArgument argument)
{
  this->Settings.Norm = norm;
  this->Settings.Argument = argument;
}

void NormalFilter::FreezeWeights(const Fields& fields, Execution& execution)
{
  this->ResizeFixedWeights();
  execution.For(this->Graph.NumberOfRows(),
    [&](std::size_t begin, std::size_t end)
    {
      Workspace work(this->Capacity);
      this->ForBlocks(begin, end,
        [&](const Block& block)
        {
          const double* fixed = this->FixedWeightsOf(block, work);
          const double* weights = this->WeightsOf(block, fields, fixed, work);
          std::copy(weights, weights + block.Count, this->FixedWeights.data() + block.Entry);
        });
    });
  this->Kept = true;
  this->Frozen = true;
}

const double* NormalFilter::WeightsOf(const Block& block, const Fields& fields, const double* fixed,
  Workspace& work) const
{
  // The weight of a mean is one whatever the argument.
  if (this->Frozen || std::holds_alternative<L2Norm>(this->Settings.Norm))
  {
    return fixed;
  }
  this->ComputeWeights(block, fields, fixed, work.Weights.data());
  return work.Weights.data();
}

void NormalFilter::ComputeWeights(const Block& block, const Fields& fields, const double* fixed,
  double* weights) const
{
  const Rows rows{ this->Graph, this->Settings.IncludeOwn, block.First, block.Last };
  const NormalArgument argument = this->Settings.Argument;
  if (argument == NormalArgument::SiteCurvature)
  {
    WeighBySites(rows, this->SiteFactors.data(), fixed, weights);
    return;
  }
  if (argument == NormalArgument::Height)
  {
    SquaredHeights<false>(rows, fields.Centre.data(), this->Centres->data(),
      this->Positions->data(), weights);
  }
  else if (argument == NormalArgument::NeighborHeight)
  {
    SquaredHeights<true>(rows, fields.Compared.data(), this->Centres->data(),
      this->Positions->data(), weights);
  }
  else if (this->Settings.Unoriented)
  {
    SquaredDistances<VectorKind::Axes>(rows, fields.Centre.data(), fields.Compared.data(), weights);
  }
  else
  {
    SquaredDistances<VectorKind::Normals>(rows, fields.Centre.data(), fields.Compared.data(),
      weights);
  }
  if (argument == NormalArgument::Angle || argument == NormalArgument::DirectionalCurvature)
  {
    ChordsToAngles(weights, block.Count);
  }
  if (IsCurvature(argument))
  {
    Multiply(this->InverseSquaredDistances.data() + block.Entry, block.Count, weights);
  }
  else if (argument == NormalArgument::BentArc)
  {
    ChordsToBentArcs(this->InverseSquaredDistances.data() + block.Entry, block.Count,
      this->Settings.BendFactor, weights);
  }
  if (this->NormScaleFactors && argument != NormalArgument::BentArc)
  {
    DivideBySquares(rows, this->NormScaleFactors->data(), weights);
  }
  std::visit([&](const auto& norm) { Weigh(norm, fixed, weights, block.Count); },
    this->Settings.Norm);
}

std::size_t NormalFilter::Sweep(const Fields& fields, Buffer<Vec3>& filtered,
  Execution& execution) const
{
  filtered.resize(this->Graph.NumberOfRows());
  std::atomic<std::size_t> kept{ 0 };
  execution.For(this->Graph.NumberOfRows(),
    [&](std::size_t begin, std::size_t end)
    {
      Workspace work(this->Capacity);
      std::size_t keptHere = 0;
      this->ForBlocks(begin, end,
        [&](const Block& block)
        {
          const double* fixed = this->FixedWeightsOf(block, work);
          const double* weights = this->WeightsOf(block, fields, fixed, work);
          const Rows rows{ this->Graph, this->Settings.IncludeOwn, block.First, block.Last };
          const Vec3* data = fields.Data.data();
          const Vec3* current = fields.Current.data();
          if (this->Settings.Step == NormalStep::Diffusion)
          {
            keptHere +=
              Diffuse(rows, this->Settings, weights, fixed, data, current, filtered.data());
            return;
          }
          keptHere += (this->Settings.Unoriented ? Average<true> : Average<false>)(rows, weights,
            data, current, filtered.data());
        });
      kept += keptHere;
    });
  return kept;
}

}
