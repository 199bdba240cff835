// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Automatic/CloudChoice.h"

#include "Automatic/CloudCandidates.h"
#include "Automatic/CloudRisk.h"
#include "Automatic/CloudTrials.h"
#include "Automatic/TrialVerdict.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

namespace SurfaceDenoising
{

namespace
{

/// Parts of the cloud that all candidates are tried on, and those that the best are.
constexpr std::size_t RoughParts = 3;
constexpr std::size_t FineParts = 10;

/// The first of those nearly alike with the least risk, or their number if all are worse than
/// leaving the points alone.
std::size_t LeastRisk(const std::vector<StepStatistics>& steps, double deviation)
{
  double least = 1.0;
  std::size_t best = steps.size();
  for (std::size_t k = 0; k < steps.size(); ++k)
  {
    // Risks are not that exact: of those nearly alike the first, gentlest one.
    const double risk = steps[k].Risk(deviation);
    if (risk < 0.97 * least - 0.0005)
    {
      least = risk;
      best = k;
    }
  }
  return best;
}

/// What a method that suits removes tells the noise better than fits to a few points, which take
/// edges for noise and miss what is in tails. Where only gentle methods suit, what is removed may
/// be detail: that is no reason to believe in more noise.
double Revised(double deviation, double strength, const StepStatistics& steps)
{
  constexpr double gentle = 0.45;
  const double most = steps.Derivative < gentle ? 1.2 : 1.0;
  return deviation * std::clamp(strength * steps.RemovedNoise() / deviation, 0.8, most);
}

/// Methods that are tried beside the best by risks, and those of them that make surfaces, as it
/// does.
constexpr std::size_t OthersTried = 5;
constexpr std::size_t OtherSurfaces = 2;

/// Those whose risk is not far from that of the best, the lesser first.
std::vector<std::size_t> FindAlike(const std::vector<StepStatistics>& steps, std::size_t best,
  double deviation)
{
  auto riskOf = [&](std::size_t k) { return steps[k].Risk(deviation); };
  // Surfaces that methods made have no detail that these would not know: what takes away much of it
  // has a large risk, and is not tried.
  const double least = std::max(0.0, riskOf(best));
  const double most = least + 0.15 * (1.0 - least);
  std::vector<std::size_t> alike;
  for (std::size_t k = 0; k < steps.size(); ++k)
  {
    if (k != best && riskOf(k) <= most)
    {
      alike.push_back(k);
    }
  }
  std::stable_sort(alike.begin(), alike.end(),
    [&](std::size_t a, std::size_t b) { return riskOf(a) < riskOf(b); });
  alike.resize(std::min(alike.size(), OthersTried));
  return alike;
}

/// Of the best by risks and those that are alike, the one that leaves the least distances in
/// trials: the best by risks unless another one leaves clearly less.
std::size_t LeastDistance(const std::vector<CloudCandidate>& candidates, std::size_t best,
  const std::vector<std::size_t>& alike, CloudTrials& trials, Execution& execution)
{
  std::vector<std::size_t> kinds;
  for (const CloudCandidate& candidate : candidates)
  {
    kinds.push_back(candidate.Settings.Operator.index());
  }
  std::vector<std::size_t> makers(1, best);
  makers.insert(makers.end(), alike.begin(),
    alike.begin() + static_cast<std::ptrdiff_t>(std::min(alike.size(), OtherSurfaces)));
  TrialVerdict verdict(std::move(kinds), best, trials.NumberOfJudged());
  for (const std::size_t maker : makers)
  {
    if (!trials.AddSurface(candidates[maker].Settings, execution))
    {
      continue;
    }
    const std::size_t surface = trials.NumberOfSurfaces() - 1;
    const double ofBest = trials.LogDistance(surface, candidates[best].Settings, execution);
    for (const std::size_t k : alike)
    {
      if (verdict.IsHeard(maker, k))
      {
        verdict.AddGain(k, ofBest - trials.LogDistance(surface, candidates[k].Settings, execution));
      }
    }
  }
  return verdict.Chosen();
}

/// Steps on a larger sample, of those that are not far behind on a small one; others lose.
void TryAgain(const CloudRisk& fine, const std::vector<CloudCandidate>& candidates,
  double deviation, std::vector<StepStatistics>& steps, Execution& execution)
{
  double least = std::numeric_limits<double>::infinity();
  for (const StepStatistics& step : steps)
  {
    least = std::min(least, step.Risk(deviation));
  }
  const double limit = 0.15 + 1.3 * std::max(0.0, least);
  for (std::size_t k = 0; k < steps.size() && execution.Proceed(0.0); ++k)
  {
    if (steps[k].Risk(deviation) < limit)
    {
      steps[k] = fine.StepsOf(candidates[k].Settings, execution);
    }
    else
    {
      steps[k].Squares = std::numeric_limits<double>::infinity();
    }
  }
}

}

CloudChoice ChooseForCloud(const Buffer<Vec3>& points, const CloudNoise& noise, double strength,
  SurfaceType type, Execution& execution)
{
  const AutomaticSettings asked(1.0, type);
  CloudChoice choice;
  const double deviation = strength * noise.Deviation;
  const double level = strength * noise.Level();
  if (!(level > CloudNoise::LeastLevel))
  {
    choice.Reason = "There is no noise.";
    return choice;
  }
  const CloudRisk rough(points, noise, deviation, RoughParts, execution);
  if (!rough.GetSample().IsMeaningful())
  {
    choice.Reason = "There are too few points to tell noise from shape.";
    return choice;
  }
  const std::vector<CloudCandidate> candidates = CloudCandidatesFor(level, noise.Widening, asked);
  std::vector<StepStatistics> steps;
  for (const CloudCandidate& candidate : candidates)
  {
    steps.push_back(rough.StepsOf(candidate.Settings, execution));
  }
  std::optional<CloudRisk> fine;
  if (rough.GetSample().Positions.size() < points.size())
  {
    fine.emplace(points, noise, deviation, FineParts, execution);
    TryAgain(*fine, candidates, deviation, steps, execution);
  }
  std::size_t best = LeastRisk(steps, deviation);
  if (best < steps.size())
  {
    const double revised = Revised(deviation, strength, steps[best]);
    best = LeastRisk(steps, revised);
    // What reaches beyond a row may draw two sides together. On surfaces that have become one so,
    // it would do no harm any more.
    if (best < steps.size() && noise.Widening == 1 && execution.Proceed(0.0))
    {
      CloudTrials trials((fine ? *fine : rough).GetSample(), revised);
      const std::vector<std::size_t> alike = FindAlike(steps, best, revised);
      best = alike.empty() ? best : LeastDistance(candidates, best, alike, trials, execution);
    }
    choice.Remaining =
      best < steps.size() ? std::sqrt(std::max(0.0, steps[best].Risk(revised))) : 1.0;
  }
  char reason[200];
  if (best < steps.size())
  {
    choice.Nothing = false;
    choice.Method = candidates[best].Method;
    choice.Settings = candidates[best].Settings;
    std::snprintf(reason, sizeof(reason),
      "Noise of %.2f spacings on a surface that is taken for %s: the least error of all methods, "
      "about %.0f%% of the noise.",
      level, candidates[best].Kind, 100.0 * choice.Remaining);
  }
  else
  {
    std::snprintf(reason, sizeof(reason),
      "Noise of %.2f spacings: every method would take away more of the surface than of the noise.",
      level);
  }
  choice.Reason = reason;
  return choice;
}

}
