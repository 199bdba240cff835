// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Automatic/CloudCandidates.h"

#include "Points/PointMethods.h"

#include <algorithm>
#include <cmath>

namespace SurfaceDenoising
{

namespace
{

PointDenoisingSettings LeastSquares(int neighbors)
{
  PointDenoisingSettings settings = SettingsOf(PointMethod::MovingLeastSquares);
  settings.Neighborhood.Count = neighbors;
  return settings;
}

PointDenoisingSettings RobustPlanes(int neighbors, int forNormals, int iterations)
{
  PointDenoisingSettings settings = SettingsOf(PointMethod::MovingRobustPCA);
  settings.Neighborhood.Count = neighbors;
  settings.Normals.NumberOfNeighbors = forNormals;
  settings.OuterIterations = iterations;
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

const std::vector<CloudCandidate>& Candidates()
{
  static const std::vector<CloudCandidate> candidates = []
  {
    const char* composer = "Robust Point Normal";
    const char* squares = "Moving Least Squares";
    const char* planes = "Moving Robust PCA";
    const double any = 1e300;
    std::vector<CloudCandidate> all = {
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
      { planes, "sharp-edged", SurfaceType::Sharp, 0.0, 0.6, RobustPlanes(30, 30, 5) },
      { planes, "sharp-edged", SurfaceType::Sharp, 0.3, any, RobustPlanes(60, 60, 5) },
      { composer, "smooth", SurfaceType::Curved, 0.3, any, Composed(80, 80, 3.0, 0.5, 1, 2) },
      { composer, "smooth", SurfaceType::Curved, 0.4, any, Composed(80, 48, 3.0, 1.0, 3, 5) },
      { composer, "sharp-edged", SurfaceType::Sharp, 0.3, any, Composed(16, 48, 1.5, 0.2, 10, 10) },
      { composer, "sharp-edged", SurfaceType::Sharp, 0.3, any, Composed(40, 48, 3.0, 0.2, 10, 10) },
      { composer, "sharp-edged", SurfaceType::Sharp, 0.3, any, Composed(80, 96, 3.0, 0.2, 3, 5) },
      { composer, "sharp-edged", SurfaceType::Sharp, 0.4, any, Composed(40, 96, 3.0, 0.2, 10, 10) },
      { planes, "sharp-edged", SurfaceType::Sharp, 0.5, any, RobustPlanes(100, 100, 5) },
      { composer, "smooth", SurfaceType::Curved, 0.2, any, Composed(16, 96, 1.5, 1.0, 3, 5) },
      { composer, "smooth", SurfaceType::Curved, 0.2, any, Composed(40, 48, 3.0, 1.0, 10, 10) },
      { squares, "smooth", SurfaceType::Curved, 0.2, any, LeastSquares(100) },
      { squares, "smooth", SurfaceType::Curved, 0.4, any, LeastSquares(200) },
      { planes, "sharp-edged", SurfaceType::Sharp, 0.0, 0.6, RobustPlanes(30, 16, 1) },
      { planes, "sharp-edged", SurfaceType::Sharp, 0.0, 0.6, RobustPlanes(30, 16, 3) },
      { planes, "sharp-edged", SurfaceType::Sharp, 0.0, 0.6, RobustPlanes(16, 16, 5) },
      { planes, "sharp-edged", SurfaceType::Sharp, 0.0, any, RobustPlanes(16, 24, 5) },
      { planes, "sharp-edged", SurfaceType::Sharp, 0.1, any, RobustPlanes(30, 48, 5) },
    };
    for (CloudCandidate& candidate : all)
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

}

std::vector<CloudCandidate> CloudCandidatesFor(double level, std::size_t widening,
  const AutomaticSettings& asked)
{
  std::vector<CloudCandidate> found;
  for (const CloudCandidate& candidate : Candidates())
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

}
