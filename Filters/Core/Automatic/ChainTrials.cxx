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
constexpr double Tolerance = 0.025;
/// Truths that are worse than the best by more are left out.
constexpr double LargestGap = 0.075;
/// Chains for surfaces of one type make surfaces that are alike, and would outvote the others.
constexpr std::size_t MostOfType = 2;
/// Lost shape as large as the noise is an error of that.
constexpr double ShapeError = 0.4;
/// What is added to the logarithm of the error if what is removed is correlated as noise is not.
constexpr double ColourCost = 0.75;
/// What a folded edge adds to the mean angle of faces, in degrees: an edge for one and a half
/// faces.
constexpr double FoldAngle = 250.0;
/// A gain below this is not certain: the error must fall to this share of that of the input.
constexpr double LargestError = 0.9;
/// If noise and detail can be confused, the same for any other truth than those that count.
constexpr double LargestWitnessError = 0.7;
/// What makes a gain doubtful, see TrialResult::Certain.
constexpr double MisfitCost = 6.0;
constexpr double SizeCost = 1.0;
constexpr double CorrelationCost = 4.0;
/// Misfit that chance makes with N faces, times the square root of N.
constexpr double ChanceMisfit = 0.5;
constexpr double WeakAngle = 20.0;
constexpr double StrongAngle = 35.0;

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

/// Runs a candidate on the input, if that was not done before.
bool ChainTrials::Know(std::size_t candidate, Execution& execution)
{
  ChainOutcome& outcome = this->OnInput[candidate];
  if (!outcome.Known)
  {
    TriangleMesh surface = this->Sample.Mesh();
    if (!RunChain(surface, this->Candidates[candidate]->Steps, execution))
    {
      return false;
    }
    outcome = this->Surfaces.OutcomeOf(surface, execution);
  }
  return true;
}

/// Runs a candidate on a truth with noise.
bool ChainTrials::Try(std::size_t candidate, const PlausibleSurface& truth,
  const TriangleMesh& noisy, Trial& trial, Execution& execution)
{
  TriangleMesh surface = noisy;
  if (!RunChain(surface, this->Candidates[candidate]->Steps, execution))
  {
    return false;
  }
  trial.Removed = this->Sample.Residual(noisy, surface, execution);
  // Folds of the input count only if they are noise.
  if (this->Surfaces.FoldsAreNoise() > 0.0 && !this->Know(candidate, execution))
  {
    return false;
  }
  trial.Angle = this->AngleTo(truth, surface, this->OnInput[candidate].Folds, execution);
  return true;
}

/// What a candidate removes from the input beyond what it removed in a trial.
bool ChainTrials::Compare(std::size_t candidate, const Trial& trial, Surplus& surplus,
  Execution& execution)
{
  if (!this->Know(candidate, execution))
  {
    return false;
  }
  const TrialResidual& found = this->OnInput[candidate].Removed;
  const TrialResidual& expected = trial.Removed;
  surplus.Correlation = std::max(0.0, found.Correlation - expected.Correlation);
  if (found.Size > expected.Size)
  {
    surplus.Size = found.Size / expected.Size - 1.0;
    surplus.Deviation = std::sqrt(found.Size * found.Size - expected.Size * expected.Size);
  }
  return true;
}

/// What is added to the logarithm of the error in a trial for shape that it did not foretell.
bool ChainTrials::CostOfShape(std::size_t candidate, const Trial& trial, double error,
  double deviation, double& cost, Execution& execution)
{
  Surplus surplus;
  if (!this->Compare(candidate, trial, surplus, execution))
  {
    return false;
  }
  const double lost = ShapeError * std::sqrt(this->Doubt) * surplus.Deviation / deviation;
  cost = std::log(std::hypot(error, lost) / error) + ColourCost * this->Doubt * surplus.Correlation;
  return true;
}

/// Tries the candidates that can still be the best on a truth.
bool ChainTrials::TryAll(const PlausibleSurface& truth, double strength, double weight,
  Scores& scores, Execution& execution)
{
  const TriangleMesh noisy = this->Surfaces.WithNoise(truth, strength, execution);
  const double before = this->AngleTo(truth, noisy, this->Surfaces.ShareOfFolds(), execution);
  const std::size_t count = scores.Errors.size();
  const double part = 0.5 / double(count);
  std::vector<Trial> trials(count);
  std::vector<double> costs(count, Infinite); // logarithms of errors, and what is added to them
  std::vector<std::size_t> order;             // the least error first
  for (std::size_t k = 0; k < count; ++k)
  {
    ProgressShare share(execution, double(k) * part, double(k + 1) * part);
    if (!scores.Regrets.IsOpen(k))
    {
      continue;
    }
    if (!this->Try(k, truth, noisy, trials[k], share))
    {
      return false;
    }
    costs[k] = LogarithmOfAngles(trials[k].Angle, before);
    scores.Errors[k] += weight * costs[k];
    order.push_back(k);
  }
  std::stable_sort(order.begin(), order.end(),
    [&costs](std::size_t a, std::size_t b) { return costs[a] < costs[b]; });
  double best = Infinite;
  for (std::size_t n = 0; n < order.size(); ++n)
  {
    const std::size_t k = order[n];
    ProgressShare share(execution, 0.5 + double(n) * part, 0.5 + double(n + 1) * part);
    // What is added makes no difference to those that are far behind.
    if (this->Doubt > 0.0 && costs[k] < best + TruncatedRegret::Largest)
    {
      // Removed from as much noise as the input has, as far as what is removed is proportional.
      trials[k].Removed.Size /= strength;
      double lost = 0.0;
      if (!this->CostOfShape(k, trials[k], std::exp(costs[k]), truth.Deviation, lost, share))
      {
        return false;
      }
      costs[k] += lost;
    }
    best = std::min(best, costs[k]);
  }
  scores.Regrets.AddRound(weight, costs);
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
    Trial trial;
    if (!this->Try(next, witness, noisy, trial, execution))
    {
      return false;
    }
    errors[next] = std::exp(LogarithmOfAngles(trial.Angle, before));
    if (k == 0 && errors[next] < LargestWitnessError)
    {
      return true;
    }
  }
  result.Best = std::size_t(std::min_element(errors.begin(), errors.end()) - errors.begin());
  result.Error = errors[result.Best];
  return true;
}

/// The most plausible truths, with what they count.
std::vector<ChainTrials::WeightedTruth> ChainTrials::TruthsThatCount() const
{
  const std::vector<PlausibleSurface>& truths = this->Surfaces.BySum();
  std::vector<WeightedTruth> found;
  std::map<SurfaceType, std::size_t> ofType;
  for (const PlausibleSurface& truth : truths)
  {
    const double gap = truth.Sum - truths[0].Sum;
    if (gap > LargestGap)
    {
      break;
    }
    if (ofType[truth.Type]++ < MostOfType)
    {
      found.push_back({ &truth, std::exp(-gap / Tolerance) });
    }
  }
  return found;
}

/// Tries the candidates on the truths that count, and finds the best of them.
bool ChainTrials::Choose(double strength, TrialResult& result, Execution& execution)
{
  const std::vector<WeightedTruth> truths = this->TruthsThatCount();
  double weight = 0.0;
  for (const WeightedTruth& truth : truths)
  {
    weight += truth.Weight;
  }
  const std::size_t count = this->Candidates.size();
  Scores scores = { std::vector<double>(count, 0.0), TruncatedRegret(count, weight) };
  for (std::size_t k = 0; k < count; ++k)
  {
    if (!this->Surfaces.IsWorthATrial(*this->Candidates[k]))
    {
      scores.Regrets.Exclude(k);
    }
  }
  const double part = 1.0 / double(truths.size());
  for (std::size_t t = 0; t < truths.size(); ++t)
  {
    ProgressShare share(execution, double(t) * part, double(t + 1) * part);
    if (!this->TryAll(*truths[t].Truth, strength, truths[t].Weight, scores, share))
    {
      return false;
    }
  }
  result.Best = scores.Regrets.Best();
  result.Error = std::exp(scores.Errors[result.Best] / weight);
  return true;
}

/// d of TrialResult::Certain.
double ChainTrials::DoubtAbout(const PlausibleSurface& truth, double strength,
  Execution& execution) const
{
  const TriangleMesh noisy = this->Surfaces.WithNoise(truth, strength, execution);
  const double angle =
    this->Sample.MeanAngle(FaceNormals(noisy, execution), truth.Normals, execution);
  return (1.0 - this->Surfaces.FoldsAreNoise()) *
    std::clamp((StrongAngle - angle) / (StrongAngle - WeakAngle), 0.0, 1.0);
}

bool ChainTrials::Run(double strength, TrialResult& result, Execution& execution)
{
  result = TrialResult();
  ProgressShare finding(execution, 0.0, 0.6);
  ProgressShare choosing(execution, 0.6, 1.0);
  if (!this->Surfaces.Find(this->Candidates, finding))
  {
    return false;
  }
  this->OnInput = this->Surfaces.Outcomes();
  const std::vector<PlausibleSurface>& truths = this->Surfaces.BySum();
  if (truths.empty() || this->Candidates.empty() || !this->Surfaces.AnyFits())
  {
    return execution.Proceed(1.0);
  }
  this->Doubt = this->DoubtAbout(truths[0], strength, execution);
  if (!this->Choose(strength, result, choosing))
  {
    return false;
  }
  double cost = 0.0;
  if (this->Doubt > 0.0)
  {
    // The truth that fits best may be one that is not smooth. Then what is best for it is safer.
    const PlausibleSurface& witness = this->Surfaces.BestFitting();
    const TriangleMesh noisy = this->Surfaces.WithNoise(truths[0], 1.0, execution);
    Trial trial;
    Surplus surplus;
    if (!this->AskWitness(witness, strength, result, execution) ||
      !this->Try(result.Best, truths[0], noisy, trial, execution) ||
      !this->Compare(result.Best, trial, surplus, execution))
    {
      return false;
    }
    const double chance = ChanceMisfit / std::sqrt(double(this->Sample.Count()));
    cost = MisfitCost * std::max(0.0, witness.Misfit - chance) + SizeCost * surplus.Size +
      CorrelationCost * surplus.Correlation;
  }
  result.Certain = result.Error < LargestError * std::exp(-this->Doubt * cost);
  return execution.Proceed(1.0);
}

}
