// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlausibleSurfaces.h"

#include "ProgressShare.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

constexpr double Infinite = std::numeric_limits<double>::infinity();
/// If the first surfaces fit no better than that, none will.
constexpr double LargestMisfit = 0.12;
constexpr std::size_t FirstSurfaces = 12;
/// The other kind of noise is not tried any more once the first are worse with it by that.
constexpr double ClearGap = 0.06;
/// What makes a surface less plausible, see the header.
constexpr double RoughnessCost = 0.05;
constexpr double CorrelationCost = 0.05;
/// What is more correlated is not nearly white.
constexpr double LargestCorrelation = 0.05;
/// A surface is taken as the sample has it if that brings M2 nearer by this.
constexpr double ClearlyNearer = 0.03;
/// No surface has a larger share of folded edges than the sample by more.
constexpr double MoreFolds = 0.001;
/// Shares of folded edges: chains for folds need no trial; clean meshes have hardly more; only
/// noise makes as many.
constexpr double HardlyAFold = 0.01;
constexpr double FewFolds = 0.03;
constexpr double ManyFolds = 0.05;
/// From there on, of 1 if only noise makes as many folds, chains must unfold to make surfaces.
constexpr double MustUnfold = 0.5;
/// Of fewer faces, noise is not told from shape.
constexpr std::size_t Judgeable = 50;
/// Of fewer faces, many may meet at sharp edges.
constexpr std::size_t LeastFaces = 500;
/// The search for the deviation of the noise: from 0 to these mean edge lengths, halved as often.
constexpr double MostNoise = 2.0;
constexpr int Bisections = 12;

const std::vector<double> BendFractions = { 0.1, 0.25, 0.5, 0.75, 0.9 };
constexpr std::size_t LowerQuartile = 1;
constexpr std::size_t Middle = 2;
constexpr std::size_t UpperQuartile = 3;
/// If the lower quartile without noise is above that share of what it should be, more noise may
/// lower it, so that it does not tell how much there is.
constexpr double BentByShape = 0.8;

double Ramp(double x, double from, double to)
{
  return std::clamp((x - from) / (to - from), 0.0, 1.0);
}

double Difference(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k)
  {
    sum += std::abs(LogarithmOfAngles(a[k], b[k]));
  }
  return sum / double(a.size());
}

}

PlausibleSurfaces::PlausibleSurfaces(const TrialSample& sample)
  : Sample(sample)
  , LeastMisfit(Infinite)
  , LeastSum{ Infinite, Infinite }
{
}

/// Mean angles between the mesh and what quick chains make of it, each with each.
bool PlausibleSurfaces::MeasureProbes(const TriangleMesh& mesh, Measures& angles,
  Execution& execution) const
{
  std::vector<Buffer<Vec3>> normals(1, FaceNormals(mesh, execution));
  for (const MethodChain& chain : ProbeChains())
  {
    TriangleMesh result = mesh;
    if (!RunChain(result, chain, execution))
    {
      return false;
    }
    normals.push_back(FaceNormals(result, execution));
    for (std::size_t k = 0; k + 1 < normals.size(); ++k)
    {
      angles.push_back(this->Sample.MeanAngle(normals.back(), normals[k], execution));
    }
  }
  return true;
}

/// How much noise makes that quartile of the angles between adjacent faces what it was.
double PlausibleSurfaces::DeviationFor(std::size_t quartile, const TriangleMesh& surface,
  const Buffer<Vec3>& noise, Execution& execution) const
{
  double low = 0.0;
  double high = MostNoise * this->Sample.EdgeLength();
  double deviation = 0.0;
  for (int step = 0; step < Bisections; ++step)
  {
    deviation = 0.5 * (low + high);
    const Buffer<Vec3> normals = FaceNormals(Displaced(surface, noise, deviation), execution);
    const double bend = this->Sample.Bends(normals, { BendFractions[quartile] })[0];
    (bend < this->BendsBefore[quartile] ? low : high) = deviation;
  }
  return deviation;
}

/// How much noise makes the bends of a surface those of the sample.
PlausibleSurfaces::Fit PlausibleSurfaces::FitNoise(const TriangleMesh& surface, TrialNoise kind,
  Execution& execution) const
{
  Fit fit;
  fit.Truth.Kind = kind;
  fit.Truth.Surface = surface;
  fit.Truth.Normals = FaceNormals(surface, execution);
  const Measures bends = this->Sample.Bends(fit.Truth.Normals, BendFractions);
  fit.Roughness = bends[Middle] / (this->BendsBefore[Middle] + SofteningAngle);
  std::vector<std::size_t> quartiles(1, LowerQuartile);
  if (bends[LowerQuartile] > BentByShape * this->BendsBefore[LowerQuartile])
  {
    quartiles.push_back(UpperQuartile);
  }
  const Buffer<Vec3> noise = this->Sample.Noise(surface, kind, execution);
  fit.Difference = Infinite;
  for (const std::size_t quartile : quartiles)
  {
    const double deviation = this->DeviationFor(quartile, surface, noise, execution);
    const Buffer<Vec3> normals = FaceNormals(Displaced(surface, noise, deviation), execution);
    const double difference =
      Difference(this->Sample.Bends(normals, BendFractions), this->BendsBefore);
    if (difference < fit.Difference)
    {
      fit.Difference = difference;
      fit.Truth.Deviation = deviation;
    }
  }
  return fit;
}

/// Puts a surface with noise to the test.
bool PlausibleSurfaces::Judge(Fit fit, double colour, Execution& execution)
{
  PlausibleSurface& truth = fit.Truth;
  const double folds = this->Sample.FoldedShare(truth.Normals);
  if (folds > this->FoldsBefore + MoreFolds)
  {
    return true;
  }
  Measures probes;
  if (!this->MeasureProbes(this->WithNoise(truth, 1.0, execution), probes, execution))
  {
    return false;
  }
  const double misfit = 0.5 * (Difference(probes, this->ProbesBefore) + fit.Difference);
  truth.Misfit = misfit + this->Folding * folds;
  truth.Sum = misfit + folds + RoughnessCost * fit.Roughness + colour;
  this->LeastMisfit = std::min(this->LeastMisfit, misfit);
  double& least = this->LeastSum[static_cast<int>(truth.Kind)];
  least = std::min(least, truth.Sum);
  this->Surfaces.push_back(std::move(truth));
  return true;
}

/// Adds a surface with noise of each kind.
bool PlausibleSurfaces::Add(const TriangleMesh& surface, SurfaceType type, double correlation,
  Execution& execution)
{
  const bool first = this->Surfaces.size() < FirstSurfaces;
  const double colour = CorrelationCost * std::max(0.0, correlation);
  const TriangleMesh resampled = this->Sample.Resampled(surface, execution);
  // Of the surfaces before: on this one, either kind has the same chance.
  const double limit = std::min(this->LeastSum[0], this->LeastSum[1]) + ClearGap;
  for (const TrialNoise kind : { TrialNoise::AlongNormals, TrialNoise::RandomDirections })
  {
    if (!first && this->LeastSum[static_cast<int>(kind)] > limit)
    {
      continue;
    }
    Fit fit = this->FitNoise(surface, kind, execution);
    Fit other = this->FitNoise(resampled, kind, execution);
    const bool nearer = other.Difference < fit.Difference - ClearlyNearer;
    Fit& nearest = nearer ? other : fit;
    nearest.Truth.Type = type;
    if (!this->Judge(std::move(nearest), colour, execution))
    {
      return false;
    }
  }
  return true;
}

bool PlausibleSurfaces::MakesTruth(const CandidateChain& chain) const
{
  if (!this->IsWorthATrial(chain))
  {
    return false;
  }
  return chain.Truth == TruthUse::WithoutFolds ? this->Folding < MustUnfold
                                               : chain.Truth != TruthUse::Never;
}

bool PlausibleSurfaces::Find(const std::vector<const CandidateChain*>& candidates,
  Execution& execution)
{
  this->OutcomesOfCandidates.assign(candidates.size(), ChainOutcome());
  const TriangleMesh& mesh = this->Sample.Mesh();
  const Buffer<Vec3> normals = FaceNormals(mesh, execution);
  this->BendsBefore = this->Sample.Bends(normals, BendFractions);
  this->FoldsBefore = this->Sample.FoldedShare(normals);
  this->Folding = normals.size() < LeastFaces ? 0.0 : Ramp(this->FoldsBefore, FewFolds, ManyFolds);
  // If so many faces are in line with their neighbours, there is no noise; of a few faces, it
  // cannot be told.
  if (this->BendsBefore[LowerQuartile] < SofteningAngle || this->Sample.Count() < Judgeable)
  {
    return true;
  }
  if (!this->MeasureProbes(mesh, this->ProbesBefore, execution))
  {
    return false;
  }
  for (std::size_t k = 0; k < candidates.size(); ++k)
  {
    if (!this->MakesTruth(*candidates[k]))
    {
      continue;
    }
    if (this->Surfaces.size() >= FirstSurfaces && !this->AnyFits())
    {
      break;
    }
    const double part = 1.0 / double(candidates.size());
    ProgressShare share(execution, double(k) * part, double(k + 1) * part);
    TriangleMesh surface = mesh;
    if (!RunChain(surface, candidates[k]->Steps, share))
    {
      return false;
    }
    this->OutcomesOfCandidates[k] = this->OutcomeOf(surface, share);
    const double correlation = this->OutcomesOfCandidates[k].Removed.Correlation;
    if (candidates[k]->Truth == TruthUse::IfWhite && correlation > LargestCorrelation)
    {
      continue;
    }
    if (!this->Add(surface, candidates[k]->Type, correlation, share))
    {
      return false;
    }
  }
  std::stable_sort(this->Surfaces.begin(), this->Surfaces.end(),
    [](const PlausibleSurface& a, const PlausibleSurface& b) { return a.Sum < b.Sum; });
  return true;
}

ChainOutcome PlausibleSurfaces::OutcomeOf(const TriangleMesh& surface, Execution& execution) const
{
  ChainOutcome outcome;
  outcome.Known = true;
  outcome.Folds = this->Sample.FoldedShare(FaceNormals(surface, execution));
  outcome.Removed = this->Sample.Residual(this->Sample.Mesh(), surface, execution);
  return outcome;
}

TriangleMesh PlausibleSurfaces::WithNoise(const PlausibleSurface& truth, double strength,
  Execution& execution) const
{
  return Displaced(truth.Surface, this->Sample.Noise(truth.Surface, truth.Kind, execution),
    strength * truth.Deviation);
}

bool PlausibleSurfaces::IsWorthATrial(const CandidateChain& chain) const
{
  return !chain.ForFolds || this->FoldsBefore >= HardlyAFold;
}

bool PlausibleSurfaces::AnyFits() const
{
  return this->LeastMisfit <= LargestMisfit + this->Folding;
}

const PlausibleSurface& PlausibleSurfaces::BestFitting() const
{
  return *std::min_element(this->Surfaces.begin(), this->Surfaces.end(),
    [](const PlausibleSurface& a, const PlausibleSurface& b) { return a.Misfit < b.Misfit; });
}

}
