// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Automatic/AutomaticCloud.h"

#include "Automatic/CloudCandidates.h"
#include "Automatic/CloudRisk.h"
#include "Automatic/CloudTrials.h"
#include "Automatic/ProgressShare.h"
#include "Automatic/SurfaceStep.h"
#include "InterruptedExecution.h"
#include "KdTree.h"
#include "SpatialOrder.h"

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

/// Methods that may be alike by their risks, and the surfaces to try them on.
constexpr std::size_t TriedMethods = 6;
constexpr std::size_t TrialSurfaces = 3;

/// Of those that are not far from the least risk, the one that leaves the least distances in
/// trials. The best by risks is among the steps.
std::size_t LeastDistance(const std::vector<CloudCandidate>& candidates,
  const std::vector<StepStatistics>& steps, std::size_t best, double deviation, CloudTrials& trials,
  Execution& execution)
{
  // A third of what the trials count, for the root of the risk.
  constexpr double weight = 0.15;
  constexpr double hardlyAny = 0.05;
  auto riskOf = [&](std::size_t k) { return steps[k].Risk(deviation); };
  // Surfaces that methods made have no detail that these would not know: what takes away much of it
  // has a large risk, and is not tried.
  const double least = std::max(0.0, riskOf(best));
  const double most = least + 0.15 * (1.0 - least);
  std::vector<std::size_t> alike;
  for (std::size_t k = 0; k < steps.size(); ++k)
  {
    if (riskOf(k) <= most)
    {
      alike.push_back(k);
    }
  }
  if (alike.size() < 2)
  {
    return best;
  }
  std::stable_sort(alike.begin(), alike.end(),
    [&](std::size_t a, std::size_t b) { return riskOf(a) < riskOf(b); });
  alike.resize(std::min(alike.size(), TriedMethods));
  for (std::size_t n = 0; n < std::min(alike.size(), TrialSurfaces); ++n)
  {
    trials.AddSurface(candidates[alike[n]].Settings, execution);
  }
  double leastLoss = std::numeric_limits<double>::infinity();
  for (const std::size_t k : alike)
  {
    const double loss = trials.LogDistance(candidates[k].Settings, execution) +
      weight * std::log(hardlyAny + std::max(0.0, riskOf(k)));
    if (loss < leastLoss)
    {
      leastLoss = loss;
      best = k;
    }
  }
  return best;
}

/// Places of outliers on the surface of the denoised points; those farther away than reach stay.
void PullOutliers(PointCloud& cloud, const Buffer<Index>& outliers, const PointCloud& clean,
  double reach, AutomaticCloudReport& report)
{
  const KdTree tree(clean.Positions);
  std::vector<Index> found;
  SurfaceStep way;
  for (const Index i : outliers)
  {
    const Vec3 place = cloud.Positions[i];
    cloud.Status[i] = PointStatus::Kept;
    tree.Nearest(place, SurfaceStep::QuadricNeighbors, found);
    way.Start();
    Vec3 side(0.0, 0.0, 0.0);
    for (const Index j : found)
    {
      way.Add(clean.Positions[j] - place);
      side += clean.Normals[j];
    }
    Vec3 normal;
    const Vec3 step = way.Step(normal);
    if (normal.isZero(0.0) || step.norm() > reach)
    {
      ++report.LeftOutliers;
      continue;
    }
    cloud.Positions[i] = place + step;
    cloud.Normals[i] = side.dot(normal) < 0.0 ? Vec3(-normal) : normal;
    cloud.Status[i] = PointStatus::Filtered;
    ++report.Pulled;
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
  std::vector<double> risks;
  for (const CloudCandidate& candidate : candidates)
  {
    steps.push_back(rough.StepsOf(candidate.Settings, execution));
    risks.push_back(steps.back().Risk(deviation));
  }
  std::optional<CloudRisk> fine;
  if (rough.GetSample().Positions.size() < points.size())
  {
    // What is far behind on a small sample need not be tried on a larger one.
    const double limit = 0.1 + 1.3 * std::max(0.0, *std::min_element(risks.begin(), risks.end()));
    fine.emplace(points, noise, deviation, FineParts, execution);
    for (std::size_t k = 0; k < steps.size() && execution.Proceed(0.0); ++k)
    {
      if (risks[k] < limit)
      {
        steps[k] = fine->StepsOf(candidates[k].Settings, execution);
      }
      else
      {
        steps[k].Squares = std::numeric_limits<double>::infinity();
      }
    }
  }
  double least = 1.0;
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
      best = LeastDistance(candidates, steps, best, revised, trials, execution);
    }
    least = best < steps.size() ? steps[best].Risk(revised) : 1.0;
  }
  const char* kind = "";
  if (best < steps.size())
  {
    kind = candidates[best].Kind;
    choice.Nothing = false;
    choice.Method = candidates[best].Method;
    choice.Settings = candidates[best].Settings;
  }
  choice.Remaining = std::sqrt(std::max(0.0, least));
  char reason[200];
  if (choice.Nothing)
  {
    std::snprintf(reason, sizeof(reason),
      "Noise of %.2f spacings: every method would take away more of the surface than of the noise.",
      level);
  }
  else
  {
    std::snprintf(reason, sizeof(reason),
      "Noise of %.2f spacings on a surface that is taken for %s: the least error of all methods, "
      "about %.0f%% of the "
      "noise.",
      level, kind, 100.0 * choice.Remaining);
  }
  choice.Reason = reason;
  return choice;
}

bool DenoiseAutomatically(PointCloud& cloud, const AutomaticSettings& asked,
  AutomaticCloudReport& report, Execution& execution)
{
  report = AutomaticCloudReport();
  const double strength = asked.CheckedStrength();
  if (!(strength > 0.0))
  {
    report.Choice.Reason = "The strength is 0.";
    return true;
  }
  InterruptedExecution measuring(execution, 0.0);
  report.Noise = EstimateNoise(cloud.Positions, measuring);
  if (!measuring.Proceed(0.0) || !execution.Proceed(0.1))
  {
    return false;
  }
  // Points along a curve through space, so that nothing depends on their order.
  const Buffer<Index> order = FindPointOrder(cloud.Positions, cloud.Normals, execution);
  Buffer<Index> kept;
  Buffer<Index> outliers;
  for (const Index i : order)
  {
    (report.Noise.Outliers[i] != 0 ? outliers : kept).push_back(i);
  }
  PointCloud clean;
  clean.Positions = Gather(cloud.Positions, kept);
  clean.Normals = cloud.Normals.empty() ? Buffer<Vec3>() : Gather(cloud.Normals, kept);
  ProgressShare choosing(execution, 0.1, 0.1);
  report.Choice = ChooseForCloud(clean.Positions, report.Noise, strength, asked.Type, choosing);
  if (!choosing.Proceed(0.0))
  {
    return false;
  }
  if (report.Choice.Nothing && outliers.empty())
  {
    return true;
  }
  PointDenoisingSettings settings = report.Choice.Settings;
  if (report.Choice.Nothing)
  {
    settings.OuterIterations = 0; // normals tell outliers the side
  }
  ProgressShare denoising(execution, 0.3, 1.0);
  if (!DenoisePoints(clean, settings, report.Denoising, denoising) || !execution.Proceed(1.0))
  {
    return false;
  }
  const std::size_t all = cloud.Positions.size();
  cloud.Normals.resize(all, Vec3(0.0, 0.0, 0.0));
  cloud.Status.assign(all, PointStatus::NotFinite);
  cloud.Classes.clear();
  for (std::size_t k = 0; k < kept.size(); ++k)
  {
    cloud.Positions[kept[k]] = clean.Positions[k];
    cloud.Normals[kept[k]] = clean.Normals[k];
    cloud.Status[kept[k]] = clean.Status[k];
  }
  PullOutliers(cloud, outliers, clean, 10.0 * report.Noise.Spacing, report);
  report.Denoising.NotFinite = all - order.size();
  return true;
}

}
