// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ChainTrials.h"

#include "ProgressShare.h"

#include <cmath>
#include <map>

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
/// Chains for surfaces of one type make surfaces that are alike, and would outvote the others.
constexpr std::size_t MostOfType = 2;
/// What a folded edge adds to the mean angle of faces, in degrees: an edge for one and a half
/// faces.
constexpr double FoldAngle = 250.0;
/// Candidates with errors this much larger than the least are not tried on further truths.
constexpr double Hopeless = 1.4;
/// A gain below this is not certain: the error must fall to this share of that of the input.
constexpr double LargestError = 0.9;
/// If noise and detail can be confused, the same for any other truth than those that count.
constexpr double LargestWitnessError = 0.7;
/// What makes a gain doubtful, see TrialResult::Certain.
constexpr double MisfitCost = 10.0;
constexpr double SizeCost = 1.0;
constexpr double CorrelationCost = 4.0;
/// Misfit that chance makes with N faces, times the square root of N.
constexpr double ChanceMisfit = 0.5;
constexpr double WeakAngle = 20.0;
constexpr double StrongAngle = 35.0;

double ErrorOf(double angle, double before) { return std::exp(LogarithmOfAngles(angle, before)); }

}

ChainTrials::ChainTrials(const TrialSample& sample,
  const std::vector<const CandidateChain*>& candidates)
  : Sample(sample)
  , Candidates(candidates)
  , Surfaces(sample)
{
}

double ChainTrials::AngleTo(const PlausibleSurface& truth, const TriangleMesh& mesh, double folds,
  Execution& execution) const
{
  const Buffer<Vec3> normals = FaceNormals(mesh, execution);
  const double angle = this->Sample.MeanAngle(normals, truth.Normals, execution);
  return angle +
    this->Surfaces.FoldsAreNoise() * FoldAngle *
    std::max(0.0, folds - this->Sample.FoldedShare(normals));
}

bool ChainTrials::AngleAfter(std::size_t candidate, const PlausibleSurface& truth,
  const TriangleMesh& noisy, double& angle, Execution& execution)
{
  TriangleMesh result = noisy;
  if (!RunChain(result, this->Candidates[candidate]->Steps, execution))
  {
    return false;
  }
  if (!(this->Surfaces.FoldsAreNoise() > 0.0))
  {
    angle = this->AngleTo(truth, result, 0.0, execution);
    return true;
  }
  double& folds = this->FoldsAfter[candidate];
  if (std::isnan(folds))
  {
    TriangleMesh real = this->Sample.Mesh();
    if (!RunChain(real, this->Candidates[candidate]->Steps, execution))
    {
      return false;
    }
    folds = this->Sample.FoldedShare(FaceNormals(real, execution));
  }
  angle = this->AngleTo(truth, result, folds, execution);
  return true;
}

/// Adds the errors that the candidates below a limit leave for a truth.
bool ChainTrials::Try(const PlausibleSurface& truth, double strength, double limit, double weight,
  Measures& errors, Execution& execution)
{
  const TriangleMesh noisy = this->Surfaces.WithNoise(truth, strength, execution);
  const double before = this->AngleTo(truth, noisy, this->Surfaces.ShareOfFolds(), execution);
  for (std::size_t k = 0; k < errors.size(); ++k)
  {
    const double part = 1.0 / double(errors.size());
    ProgressShare share(execution, double(k) * part, double(k + 1) * part);
    double angle = 0.0;
    if (errors[k] > limit)
    {
      errors[k] = Infinite;
    }
    else if (this->AngleAfter(k, truth, noisy, angle, share))
    {
      errors[k] += weight * ErrorOf(angle, before);
    }
    else
    {
      return false;
    }
  }
  return true;
}

/// What a candidate removes from the input that it does not remove from a truth with noise.
bool ChainTrials::Surplus(std::size_t candidate, const PlausibleSurface& truth, double& surplus,
  Execution& execution)
{
  const TriangleMesh noisy = this->Surfaces.WithNoise(truth, 1.0, execution);
  TriangleMesh foreseen = noisy;
  TriangleMesh real = this->Sample.Mesh();
  if (!RunChain(foreseen, this->Candidates[candidate]->Steps, execution) ||
    !RunChain(real, this->Candidates[candidate]->Steps, execution))
  {
    return false;
  }
  const TrialResidual expected = this->Sample.Residual(noisy, foreseen, execution);
  const TrialResidual found = this->Sample.Residual(this->Sample.Mesh(), real, execution);
  surplus = CorrelationCost * std::max(0.0, found.Correlation - expected.Correlation);
  if (found.Size > expected.Size)
  {
    surplus += SizeCost * (found.Size / expected.Size - 1.0);
  }
  return true;
}

/// If the best leaves too much for this truth, the best for it comes in its place.
bool ChainTrials::AskWitness(const PlausibleSurface& witness, double strength, TrialResult& result,
  Execution& execution)
{
  const TriangleMesh noisy = this->Surfaces.WithNoise(witness, strength, execution);
  const double before = this->AngleTo(witness, noisy, this->Surfaces.ShareOfFolds(), execution);
  const std::size_t count = this->Candidates.size();
  std::vector<double> errors(count, Infinite);
  for (std::size_t k = 0; k < count; ++k)
  {
    const std::size_t next = (result.Best + k) % count;
    if (!this->Surfaces.IsWorthATrial(*this->Candidates[next]))
    {
      continue;
    }
    double angle = 0.0;
    if (!this->AngleAfter(next, witness, noisy, angle, execution))
    {
      return false;
    }
    errors[next] = ErrorOf(angle, before);
    if (k == 0 && errors[next] < LargestWitnessError)
    {
      return true;
    }
  }
  result.Best = std::size_t(std::min_element(errors.begin(), errors.end()) - errors.begin());
  result.Error = errors[result.Best];
  return true;
}

bool ChainTrials::Run(double strength, TrialResult& result, Execution& execution)
{
  result = TrialResult();
  ProgressShare finding(execution, 0.0, 0.6);
  if (!this->Surfaces.Find(this->Candidates, finding))
  {
    return false;
  }
  this->FoldsAfter = this->Surfaces.FoldsAfter();
  const std::size_t count = this->Candidates.size();
  const std::vector<PlausibleSurface>& truths = this->Surfaces.BySum();
  if (truths.empty() || count == 0 || !this->Surfaces.AnyFits())
  {
    return execution.Proceed(1.0);
  }
  Measures errors(count, 0.0);
  for (std::size_t k = 0; k < count; ++k)
  {
    errors[k] = this->Surfaces.IsWorthATrial(*this->Candidates[k]) ? 0.0 : Infinite;
  }
  double weights = 0.0;
  std::size_t tried = 0;
  std::map<SurfaceType, std::size_t> ofType;
  for (const PlausibleSurface& truth : truths)
  {
    const double gap = truth.Sum - truths[0].Sum;
    if (gap > LargestGap || tried == MostTruths)
    {
      break;
    }
    if (ofType[truth.Type]++ >= MostOfType)
    {
      continue;
    }
    const double limit = Hopeless * *std::min_element(errors.begin(), errors.end());
    const double weight = std::exp(-gap / Tolerance);
    const double part = 0.4 / double(MostTruths);
    ProgressShare share(execution, 0.6 + double(tried) * part, 0.6 + double(tried + 1) * part);
    if (!this->Try(truth, strength, limit, weight, errors, share))
    {
      return false;
    }
    weights += weight;
    ++tried;
  }
  result.Best = std::size_t(std::min_element(errors.begin(), errors.end()) - errors.begin());
  result.Error = errors[result.Best] / weights;
  // The truth that fits best may be one that is not smooth. Then what is best for it is safer.
  const PlausibleSurface& witness = this->Surfaces.BestFitting();
  const double angleBefore = this->Sample.MeanAngle(
    FaceNormals(this->Surfaces.WithNoise(truths[0], strength, execution), execution),
    truths[0].Normals, execution);
  const double doubt = (1.0 - this->Surfaces.FoldsAreNoise()) *
    std::clamp((StrongAngle - angleBefore) / (StrongAngle - WeakAngle), 0.0, 1.0);
  double cost = 0.0;
  if (doubt > 0.0)
  {
    if (!this->AskWitness(witness, strength, result, execution) ||
      !this->Surplus(result.Best, truths[0], cost, execution))
    {
      return false;
    }
    const double chance = ChanceMisfit / std::sqrt(double(this->Sample.Count()));
    cost += MisfitCost * std::max(0.0, witness.Misfit - chance);
  }
  result.Certain = result.Error < LargestError * std::exp(-doubt * cost);
  return execution.Proceed(1.0);
}

}
