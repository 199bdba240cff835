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
  const bool own = settings.IncludeOwn;
  const bool bent = settings.Argument == NormalArgument::BentArc;
  const bool curvature = settings.Argument == NormalArgument::DirectionalCurvature ||
    settings.Argument == NormalArgument::NormalGradient || bent;
  const bool spatial = settings.SpatialSigma > 0.0 || geometry.SpatialSigmas;
  const bool coupled = settings.Weighting == SiteWeight::Coupling;
  const Buffer<double>& areas = geometry.Areas;
  const std::size_t entries = this->EntryOf(rows);
  this->Frozen = false;
  this->FixedWeights.resize(entries + Lanes);
  this->InverseSquaredDistances.resize(curvature ? entries : 0);
  std::fill(this->FixedWeights.begin() + entries, this->FixedWeights.end(), 0.0);
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

  auto weightOf = [&](std::size_t j)
  { return settings.Weighting == SiteWeight::Area ? areas[j] : (areas[j] > 0.0 ? 1.0 : 0.0); };
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
            fixed[k++] = coupled ? 0.0 : weightOf(i);
          }
          for (std::uint64_t p = this->Graph.Offsets[i]; p < this->Graph.Offsets[i + 1]; ++p)
          {
            const double weight = weightOf(this->Graph.Ids[p]);
            fixed[k++] = coupled ? weight * (*geometry.Couplings)[p] : weight;
          }
        }
        if (spatial || curvature)
        {
          SquaredDistances<VectorKind::Positions>({ this->Graph, own, block.First, block.Last },
            this->Centres->data(), geometry.Positions.data(), squares.data());
        }
        if (geometry.SpatialSigmas)
        {
          for (std::size_t i = block.First; i < block.Last; ++i)
          {
            const std::size_t first = this->EntryOf(i) - block.Entry;
            Attenuate(GaussianNorm{ (*geometry.SpatialSigmas)[i] }, squares.data() + first,
              this->EntryOf(i + 1) - this->EntryOf(i), fixed + first);
          }
        }
        else if (spatial)
        {
          Attenuate(GaussianNorm{ settings.SpatialSigma }, squares.data(), block.Count, fixed);
        }
        if (curvature)
        {
          if (bent && geometry.NormScaleFactors)
          {
            // With distances over the factor of the site, x comes out over the factor.
            DivideBySquares({ this->Graph, own, block.First, block.Last },
              geometry.NormScaleFactors->data(), squares.data());
          }
          InvertSquares(squares.data(), block.Count, geometry.Shortest * geometry.Shortest,
            this->InverseSquaredDistances.data() + block.Entry);
        }
        if (bent && own && !geometry.Centres)
        {
          // No way to oneself: the least that keeps products finite.
          for (std::size_t i = block.First; i < block.Last; ++i)
          {
            this->InverseSquaredDistances[this->EntryOf(i)] = 1e300;
          }
        }
      };
      this->ForBlocks(begin, end, fix);
    });
}

void NormalFilter::SetNorm(const ErrorNorm& norm, NormalArgument argument)
{
  this->Settings.Norm = norm;
  this->Settings.Argument = argument;
}

void NormalFilter::FreezeWeights(const Fields& fields, Execution& execution)
{
  execution.For(this->Graph.NumberOfRows(),
    [&](std::size_t begin, std::size_t end)
    {
      Buffer<double> weights(this->Capacity);
      this->ForBlocks(begin, end,
        [&](const Block& block)
        {
          this->ComputeWeights(block, fields, weights.data());
          std::copy(weights.data(), weights.data() + block.Count,
            this->FixedWeights.data() + block.Entry);
        });
    });
  this->Frozen = true;
}

void NormalFilter::ComputeWeights(const Block& block, const Fields& fields, double* weights) const
{
  const Rows rows{ this->Graph, this->Settings.IncludeOwn, block.First, block.Last };
  const double* fixed = this->FixedWeights.data() + block.Entry;
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
      Buffer<double> weights(this->Capacity);
      std::size_t keptHere = 0;
      this->ForBlocks(begin, end,
        [&](const Block& block)
        {
          this->ComputeWeights(block, fields, weights.data());
          const Rows rows{ this->Graph, this->Settings.IncludeOwn, block.First, block.Last };
          const Vec3* data = fields.Data.data();
          const Vec3* current = fields.Current.data();
          if (this->Settings.Step == NormalStep::Diffusion)
          {
            keptHere += Diffuse(rows, this->Settings, weights.data(),
              this->FixedWeights.data() + block.Entry, data, current, filtered.data());
            return;
          }
          keptHere += (this->Settings.Unoriented ? Average<true> : Average<false>)(rows,
            weights.data(), data, current, filtered.data());
        });
      kept += keptHere;
    });
  return kept;
}

}
