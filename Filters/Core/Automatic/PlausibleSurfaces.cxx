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
constexpr std::size_t FirstSurfaces = 8;
/// The other kind of noise is not tried any more once the first are worse with it by that.
constexpr double ClearGap = 0.06;
/// What makes a surface less plausible, see the header.
constexpr double RoughnessCost = 0.05;
constexpr double CorrelationCost = 0.05;
/// What is more correlated is not nearly white.
constexpr double LargestCorrelation = 0.05;
/// Folds of a surface cost so much more if that share of the edges of the input is folded.
constexpr double MoreFoldCost = 2.0;
constexpr double FoldsOfStrongNoise = 0.2;
/// Shares of folded edges: chains for folds need no trial; clean meshes have hardly more; only
/// noise makes as many.
constexpr double HardlyAFold = 0.01;
constexpr double FewFolds = 0.03;
constexpr double ManyFolds = 0.05;
/// From there on, of 1 if only noise makes as many folds, chains must unfold to make surfaces.
constexpr double MustUnfold = 0.5;
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

/// Adds noise of each kind to a surface and puts it to the test.
bool PlausibleSurfaces::Add(const TriangleMesh& surface, Execution& execution)
{
  const bool first = this->Surfaces.size() < FirstSurfaces;
  const Buffer<Vec3> right = FaceNormals(surface, execution);
  const double folds = this->Sample.FoldedShare(right) *
    (1.0 + MoreFoldCost * Ramp(this->FoldsBefore, 0.5 * FoldsOfStrongNoise, FoldsOfStrongNoise));
  const Measures bends = this->Sample.Bends(right, BendFractions);
  const double colour = CorrelationCost *
    std::max(0.0, this->Sample.Residual(this->Sample.Mesh(), surface, execution).Correlation);
  const double roughness =
    RoughnessCost * bends[Middle] / (this->BendsBefore[Middle] + SofteningAngle);
  std::vector<std::size_t> quartiles(1, LowerQuartile);
  if (bends[LowerQuartile] > BentByShape * this->BendsBefore[LowerQuartile])
  {
    quartiles.push_back(UpperQuartile);
  }
  // Of the surfaces before: on this one, either kind has the same chance.
  const double limit = std::min(this->LeastSum[0], this->LeastSum[1]) + ClearGap;
  for (const TrialNoise kind : { TrialNoise::AlongNormals, TrialNoise::RandomDirections })
  {
    double& least = this->LeastSum[static_cast<int>(kind)];
    if (!first && least > limit)
    {
      continue;
    }
    PlausibleSurface truth;
    truth.Kind = kind;
    const Buffer<Vec3> noise = this->Sample.Noise(surface, kind, execution);
    double leastDifference = Infinite;
    for (const std::size_t quartile : quartiles)
    {
      const double deviation = this->DeviationFor(quartile, surface, noise, execution);
      const Buffer<Vec3> normals = FaceNormals(Displaced(surface, noise, deviation), execution);
      const double difference =
        Difference(this->Sample.Bends(normals, BendFractions), this->BendsBefore);
      if (difference < leastDifference)
      {
        leastDifference = difference;
        truth.Deviation = deviation;
      }
    }
    const TriangleMesh noisy = Displaced(surface, noise, truth.Deviation);
    Measures probes;
    if (!this->MeasureProbes(noisy, probes, execution))
    {
      return false;
    }
    const double misfit = 0.5 * (Difference(probes, this->ProbesBefore) + leastDifference);
    truth.Misfit = misfit + this->Folding * folds;
    truth.Sum = misfit + folds + roughness + colour;
    this->LeastMisfit = std::min(this->LeastMisfit, misfit);
    least = std::min(least, truth.Sum);
    truth.Surface = surface;
    truth.Normals = right;
    this->Surfaces.push_back(std::move(truth));
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
  this->FoldsOfCandidates.assign(candidates.size(), std::nan(""));
  const TriangleMesh& mesh = this->Sample.Mesh();
  const Buffer<Vec3> normals = FaceNormals(mesh, execution);
  this->BendsBefore = this->Sample.Bends(normals, BendFractions);
  this->FoldsBefore = this->Sample.FoldedShare(normals);
  this->Folding = normals.size() < LeastFaces ? 0.0 : Ramp(this->FoldsBefore, FewFolds, ManyFolds);
  // If so many faces are in line with their neighbours, there is no noise.
  if (this->BendsBefore[LowerQuartile] < SofteningAngle)
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
    this->FoldsOfCandidates[k] = this->Sample.FoldedShare(FaceNormals(surface, share));
    if (candidates[k]->Truth == TruthUse::IfWhite &&
      this->Sample.Residual(mesh, surface, share).Correlation > LargestCorrelation)
    {
      continue;
    }
    if (!this->Add(surface, share))
    {
      return false;
    }
  }
  std::stable_sort(this->Surfaces.begin(), this->Surfaces.end(),
    [](const PlausibleSurface& a, const PlausibleSurface& b) { return a.Sum < b.Sum; });
  return true;
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
