// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ChainTrials.h"

#include "ProgressShare.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

constexpr double Infinite = std::numeric_limits<double>::infinity();
/// Truths whose sums differ by this differ by a factor of e in what they count.
constexpr double Tolerance = 0.01;
/// Truths that are worse than the best by more are left out.
constexpr double LargestGap = 0.04;
constexpr std::size_t MostTruths = 3;
/// If the first truths fit no better than that, none will.
constexpr double LargestMisfit = 0.12;
constexpr std::size_t FirstTruths = 8;
/// The other kind of noise is not tried any more once the first truths are worse with it by that.
constexpr double ClearGap = 0.04;
constexpr double RoughnessCost = 0.05;
/// Candidates with errors this much larger than the least are not tried on further truths.
constexpr double Hopeless = 1.4;
/// Angles below are as good as none, in degrees.
constexpr double Softening = 0.1;
/// The search for the deviation of the noise: from 0 to these mean edge lengths, halved as often.
constexpr double MostNoise = 2.0;
constexpr int Bisections = 12;
/// A gain below this is not certain: the error must fall to this share of that of the input.
constexpr double LargestError = 0.9;
/// The same if noise and detail can be confused, for the truths that count and for any other.
constexpr double LargestDoubtfulError = 0.62;
constexpr double LargestWitnessError = 0.7;
constexpr double MisfitCost = 10.0;
constexpr double WeakAngle = 20.0;
constexpr double StrongAngle = 35.0;

const std::vector<double> BendFractions = { 0.1, 0.25, 0.5, 0.75, 0.9 };
constexpr std::size_t LowerQuartile = 1;
constexpr std::size_t Middle = 2;

double Logarithm(double angle, double over)
{
  return std::log((angle + Softening) / (over + Softening));
}

double Difference(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k)
  {
    sum += std::abs(Logarithm(a[k], b[k]));
  }
  return sum / double(a.size());
}

bool Apply(const MethodChain& chain, TriangleMesh& mesh, Execution& execution)
{
  Buffer<Vec3> normals;
  MeshDenoisingReport report;
  return RunChain(mesh, chain, normals, report, execution);
}

}

struct ChainTrials::Truth
{
  TrialNoise Kind = TrialNoise::AlongNormals;
  double Misfit = 0.0;
  double Sum = 0.0; ///< misfit and the rest
  Buffer<Vec3> Normals;
  TriangleMesh Surface;
  double Deviation = 0.0;
};

ChainTrials::ChainTrials(const TrialSample& sample,
  const std::vector<const CandidateChain*>& candidates)
  : Sample(sample)
  , Candidates(candidates)
  , LeastSum{ Infinite, Infinite }
{
}

ChainTrials::~ChainTrials() = default;

/// Mean angles between the mesh and what quick chains make of it, each with each.
bool ChainTrials::MeasureProbes(const TriangleMesh& mesh, Measures& angles,
  Execution& execution) const
{
  std::vector<Buffer<Vec3>> normals(1, FaceNormals(mesh, execution));
  for (const MethodChain& chain : ProbeChains())
  {
    TriangleMesh result = mesh;
    if (!Apply(chain, result, execution))
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

/// Adds noise of each kind to a surface and puts it to the test.
bool ChainTrials::Add(const TriangleMesh& surface, Execution& execution)
{
  const bool first = this->Truths.size() < FirstTruths;
  const Buffer<Vec3> right = FaceNormals(surface, execution);
  const double cost = this->Sample.FoldedShare(right) +
    RoughnessCost * this->Sample.Bends(right, { BendFractions[Middle] })[0] /
      (this->BendsBefore[Middle] + Softening);
  for (const TrialNoise kind : { TrialNoise::AlongNormals, TrialNoise::RandomDirections })
  {
    double& least = this->LeastSum[static_cast<int>(kind)];
    if (!first && least > std::min(this->LeastSum[0], this->LeastSum[1]) + ClearGap)
    {
      continue;
    }
    Truth truth;
    truth.Kind = kind;
    const Buffer<Vec3> noise = this->Sample.Noise(surface, kind);
    double low = 0.0;
    double high = MostNoise * this->Sample.EdgeLength();
    TriangleMesh noisy;
    Buffer<Vec3> normals;
    for (int step = 0; step < Bisections; ++step)
    {
      truth.Deviation = 0.5 * (low + high);
      noisy = Displaced(surface, noise, truth.Deviation);
      normals = FaceNormals(noisy, execution);
      const double bend = this->Sample.Bends(normals, { BendFractions[LowerQuartile] })[0];
      (bend < this->BendsBefore[LowerQuartile] ? low : high) = truth.Deviation;
    }
    Measures probes;
    if (!this->MeasureProbes(noisy, probes, execution))
    {
      return false;
    }
    const double misfit = 0.5 *
      (Difference(probes, this->ProbesBefore) +
        Difference(this->Sample.Bends(normals, BendFractions), this->BendsBefore));
    truth.Misfit = misfit;
    truth.Sum = misfit + cost;
    this->LeastMisfit = std::min(this->LeastMisfit, misfit);
    least = std::min(least, truth.Sum);
    truth.Surface = surface;
    truth.Normals = right;
    this->Truths.push_back(std::move(truth));
  }
  return true;
}

bool ChainTrials::FindTruths(Execution& execution)
{
  const TriangleMesh& mesh = this->Sample.Mesh();
  this->BendsBefore = this->Sample.Bends(FaceNormals(mesh, execution), BendFractions);
  // If so many faces are in line with their neighbours, there is no noise.
  if (this->BendsBefore[LowerQuartile] < Softening)
  {
    return true;
  }
  if (!this->MeasureProbes(mesh, this->ProbesBefore, execution))
  {
    return false;
  }
  for (std::size_t k = 0; k < this->Candidates.size(); ++k)
  {
    if (!this->Candidates[k]->MakesTruth)
    {
      continue;
    }
    if (this->Truths.size() >= FirstTruths && this->LeastMisfit > LargestMisfit)
    {
      break;
    }
    const double part = 1.0 / double(this->Candidates.size());
    ProgressShare share(execution, double(k) * part, double(k + 1) * part);
    TriangleMesh surface = mesh;
    if (!Apply(this->Candidates[k]->Steps, surface, share) || !this->Add(surface, share))
    {
      return false;
    }
  }
  std::stable_sort(this->Truths.begin(), this->Truths.end(),
    [](const Truth& a, const Truth& b) { return a.Sum < b.Sum; });
  return true;
}

TriangleMesh ChainTrials::WithNoise(const Truth& truth, double strength) const
{
  return Displaced(truth.Surface, this->Sample.Noise(truth.Surface, truth.Kind),
    strength * truth.Deviation);
}

double ChainTrials::AngleTo(const Truth& truth, const TriangleMesh& mesh,
  Execution& execution) const
{
  return this->Sample.MeanAngle(FaceNormals(mesh, execution), truth.Normals, execution);
}

bool ChainTrials::AngleAfter(const MethodChain& chain, const Truth& truth,
  const TriangleMesh& noisy, double& angle, Execution& execution) const
{
  TriangleMesh result = noisy;
  if (!Apply(chain, result, execution))
  {
    return false;
  }
  angle = this->AngleTo(truth, result, execution);
  return true;
}

bool ChainTrials::Run(double strength, TrialResult& result, Execution& execution)
{
  result = TrialResult();
  ProgressShare finding(execution, 0.0, 0.6);
  if (!this->FindTruths(finding))
  {
    return false;
  }
  const std::size_t count = this->Candidates.size();
  if (this->Truths.empty() || count == 0 || this->LeastMisfit > LargestMisfit)
  {
    return execution.Proceed(1.0);
  }
  std::vector<double> logarithms(count, 0.0);
  double weights = 0.0;
  double angleBefore = 0.0;
  for (std::size_t t = 0; t < std::min(MostTruths, this->Truths.size()); ++t)
  {
    const Truth& truth = this->Truths[t];
    const double gap = truth.Sum - this->Truths[0].Sum;
    if (gap > LargestGap)
    {
      break;
    }
    const TriangleMesh noisy = this->WithNoise(truth, strength);
    const double before = this->AngleTo(truth, noisy, execution);
    angleBefore = t == 0 ? before : angleBefore;
    const double weight = std::exp(-gap / Tolerance);
    weights += weight;
    const double least = *std::min_element(logarithms.begin(), logarithms.end());
    for (std::size_t k = 0; k < count; ++k)
    {
      if (logarithms[k] > least + (weights - weight) * std::log(Hopeless))
      {
        logarithms[k] = Infinite;
        continue;
      }
      const double done = (double(t) + double(k) / double(count)) / double(MostTruths);
      ProgressShare share(execution, 0.6 + 0.4 * done, 0.6 + 0.4 * done);
      double angle = 0.0;
      if (!this->AngleAfter(this->Candidates[k]->Steps, truth, noisy, angle, share))
      {
        return false;
      }
      logarithms[k] += weight * Logarithm(angle, before);
    }
  }
  result.Best =
    std::size_t(std::min_element(logarithms.begin(), logarithms.end()) - logarithms.begin());
  result.Error = std::exp(logarithms[result.Best] / weights);
  // The truth that fits best may be one that is not smooth. Then what is best for it is safer.
  const Truth& witness = *std::min_element(this->Truths.begin(), this->Truths.end(),
    [](const Truth& a, const Truth& b) { return a.Misfit < b.Misfit; });
  const double doubt =
    std::clamp((StrongAngle - angleBefore) / (StrongAngle - WeakAngle), 0.0, 1.0);
  result.Certain = result.Error < LargestError;
  if (doubt > 0.0)
  {
    const double limit = LargestDoubtfulError * std::exp(-MisfitCost * doubt * witness.Misfit);
    const TriangleMesh noisy = this->WithNoise(witness, strength);
    const double before = this->AngleTo(witness, noisy, execution);
    std::vector<double> errors(count, Infinite);
    for (std::size_t k = 0; k < count; ++k)
    {
      const std::size_t next = (result.Best + k) % count;
      double angle = 0.0;
      if (!this->AngleAfter(this->Candidates[next]->Steps, witness, noisy, angle, execution))
      {
        return false;
      }
      errors[next] = std::exp(Logarithm(angle, before));
      if (k == 0 && errors[next] < LargestWitnessError)
      {
        result.Certain = result.Error < limit;
        return execution.Proceed(1.0);
      }
    }
    result.Best = std::size_t(std::min_element(errors.begin(), errors.end()) - errors.begin());
    result.Error = errors[result.Best];
    result.Certain = result.Error < limit;
  }
  return execution.Proceed(1.0);
}

}
