// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Automatic/AutomaticCloud.h"

#include "Automatic/CloudRisk.h"
#include "Automatic/ProgressShare.h"
#include "Automatic/SurfaceStep.h"
#include "InterruptedExecution.h"
#include "KdTree.h"
#include "Points/PointMethods.h"
#include "SpatialOrder.h"

#include <cmath>
#include <cstdio>
#include <limits>

namespace SurfaceDenoising
{

namespace
{

/// Something to try, and the noise for which it can be the best, in spacings.
struct Candidate
{
  const char* Method;
  const char* Kind; ///< of surface, for people
  SurfaceType Type;
  double From;
  double To;
  PointDenoisingSettings Settings;
};

PointDenoisingSettings LeastSquares(int neighbors)
{
  PointDenoisingSettings settings = SettingsOf(PointMethod::MovingLeastSquares);
  settings.Neighborhood.Count = neighbors;
  return settings;
}

PointDenoisingSettings RobustPlanes(int neighbors)
{
  PointDenoisingSettings settings = SettingsOf(PointMethod::MovingRobustPCA);
  settings.Neighborhood.Count = settings.Normals.NumberOfNeighbors = neighbors;
  return settings;
}

/// The composer with this range scale of normals.
PointDenoisingSettings Composed(int neighbors, int forNormals, double spatialScale,
  double rangeScale, int normalIterations, int pointIterations)
{
  PointDenoisingSettings settings = ComposedPoints();
  settings.Neighborhood.Count = neighbors;
  settings.Normals.NumberOfNeighbors = forNormals;
  auto& stages = std::get<TwoStageSettings>(settings.Operator);
  stages.Normals.NormScale = rangeScale;
  stages.Points.NormScale = rangeScale > 0.4 ? rangeScale : 0.2;
  stages.Normals.SpatialScale = stages.Points.SpatialScale = spatialScale;
  stages.NormalIterations = normalIterations;
  stages.PointIterations = pointIterations;
  return settings;
}

const std::vector<Candidate>& Candidates()
{
  static const std::vector<Candidate> candidates = []
  {
    const char* composer = "Robust Point Normal";
    const char* squares = "Moving Least Squares";
    const char* planes = "Moving Robust PCA";
    const double any = 1e300;
    std::vector<Candidate> all = {
      { squares, "full of fine details", SurfaceType::Curved, 0.0, 0.45, LeastSquares(16) },
      { squares, "smooth with some details", SurfaceType::Curved, 0.0, any, LeastSquares(30) },
      { squares, "smooth", SurfaceType::Curved, 0.0, any, LeastSquares(60) },
      { composer, "bent", SurfaceType::Curved, 0.0, 0.45, Composed(16, 16, 1.5, 0.5, 1, 2) },
      { composer, "bent with blunt edges", SurfaceType::Any, 0.0, 0.45,
        Composed(16, 16, 1.5, 0.35, 3, 5) },
      { composer, "smooth with some details", SurfaceType::Curved, 0.1, any,
        Composed(16, 24, 1.5, 1.0, 1, 4) },
      { composer, "sharp-edged", SurfaceType::Sharp, 0.1, any, Composed(16, 24, 1.5, 0.2, 10, 10) },
      { composer, "bent with blunt edges", SurfaceType::Any, 0.2, any,
        Composed(24, 36, 2.0, 0.5, 2, 5) },
      { composer, "sharp-edged", SurfaceType::Sharp, 0.3, any, Composed(24, 36, 2.0, 0.2, 10, 10) },
      { composer, "sharp-edged", SurfaceType::Sharp, 0.3, any, Composed(40, 40, 3.0, 0.35, 3, 5) },
      { planes, "sharp-edged", SurfaceType::Sharp, 0.0, 0.6, RobustPlanes(30) },
      { planes, "sharp-edged", SurfaceType::Sharp, 0.3, any, RobustPlanes(60) },
      { composer, "smooth", SurfaceType::Curved, 0.3, any, Composed(80, 80, 3.0, 0.5, 1, 2) },
      { composer, "smooth", SurfaceType::Curved, 0.4, any, Composed(80, 48, 3.0, 1.0, 3, 5) },
      { composer, "sharp-edged", SurfaceType::Sharp, 0.3, any, Composed(16, 48, 1.5, 0.2, 10, 10) },
      { composer, "sharp-edged", SurfaceType::Sharp, 0.3, any, Composed(40, 48, 3.0, 0.2, 10, 10) },
      { composer, "sharp-edged", SurfaceType::Sharp, 0.3, any, Composed(80, 96, 3.0, 0.2, 3, 5) },
      { composer, "sharp-edged", SurfaceType::Sharp, 0.4, any, Composed(40, 96, 3.0, 0.2, 10, 10) },
      { planes, "sharp-edged", SurfaceType::Sharp, 0.5, any, RobustPlanes(100) },
      { composer, "smooth", SurfaceType::Curved, 0.2, any, Composed(16, 96, 1.5, 1.0, 3, 5) },
      { composer, "smooth", SurfaceType::Curved, 0.2, any, Composed(40, 48, 3.0, 1.0, 10, 10) },
      { squares, "smooth", SurfaceType::Curved, 0.2, any, LeastSquares(100) },
      { squares, "smooth", SurfaceType::Curved, 0.4, any, LeastSquares(200) },
    };
    for (Candidate& candidate : all)
    {
      candidate.Settings.Normals.Source = NormalSource::RobustFit;
    }
    return all;
  }();
  return candidates;
}

/// More neighbours than any method needs: what is far away only rounds off.
constexpr int MostNeighbors = 200;

void Widen(int& count, std::size_t widening)
{
  count = std::max(count, std::min(MostNeighbors, count * static_cast<int>(widening)));
}

/// Neighbourhoods of so many times as many points.
PointDenoisingSettings Widened(PointDenoisingSettings settings, std::size_t widening)
{
  const double before = settings.Neighborhood.Count;
  Widen(settings.Neighborhood.Count, widening);
  Widen(settings.Normals.NumberOfNeighbors, widening);
  if (auto* stages = std::get_if<TwoStageSettings>(&settings.Operator))
  {
    const double scale = std::sqrt(settings.Neighborhood.Count / before);
    stages->Normals.SpatialScale *= scale;
    stages->Points.SpatialScale *= scale;
  }
  return settings;
}

/// What to try at this noise level, see AutomaticCloud.h.
std::vector<Candidate> CandidatesFor(double level, std::size_t widening,
  const AutomaticSettings& asked)
{
  std::vector<Candidate> found;
  for (const Candidate& candidate : Candidates())
  {
    if (level < candidate.From || level > candidate.To || !asked.Considers(candidate.Type))
    {
      continue;
    }
    // Normals come from a patch of surface in any case, what follows may do with fewer points.
    found.push_back(candidate);
    Widen(found.back().Settings.Normals.NumberOfNeighbors, widening);
    // Of those that are wide already, several would become the same.
    if (widening > 1 &&
      candidate.Settings.Neighborhood.Count * static_cast<int>(widening) < 2 * MostNeighbors)
    {
      found.push_back(candidate);
      found.back().Settings = Widened(candidate.Settings, widening);
    }
  }
  return found;
}

/// Parts of the cloud that all candidates are tried on, and those that the best are.
constexpr std::size_t RoughParts = 3;
constexpr std::size_t FineParts = 10;

/// The first of those nearly alike with the least risk, or their number if all are worse than
/// leaving the points alone.
std::size_t LeastRisk(const std::vector<StepStatistics>& steps, double deviation, double& least)
{
  least = 1.0;
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
  if (!rough.IsMeaningful())
  {
    choice.Reason = "There are too few points to tell noise from shape.";
    return choice;
  }
  const std::vector<Candidate> candidates = CandidatesFor(level, noise.Widening, asked);
  std::vector<StepStatistics> steps;
  std::vector<double> risks;
  for (const Candidate& candidate : candidates)
  {
    steps.push_back(rough.StepsOf(candidate.Settings, execution));
    risks.push_back(steps.back().Risk(deviation));
  }
  if (rough.NumberOfPoints() < points.size())
  {
    // What is far behind on a small sample need not be tried on a larger one.
    const double limit = 0.1 + 1.3 * std::max(0.0, *std::min_element(risks.begin(), risks.end()));
    const CloudRisk fine(points, noise, deviation, FineParts, execution);
    for (std::size_t k = 0; k < steps.size() && execution.Proceed(0.0); ++k)
    {
      if (risks[k] < limit)
      {
        steps[k] = fine.StepsOf(candidates[k].Settings, execution);
      }
      else
      {
        steps[k].Squares = std::numeric_limits<double>::infinity();
      }
    }
  }
  double least = 1.0;
  std::size_t best = LeastRisk(steps, deviation, least);
  if (best < steps.size())
  {
    best = LeastRisk(steps, Revised(deviation, strength, steps[best]), least);
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
