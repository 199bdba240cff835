// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PointWork.h
 * @brief The work on one cloud: neighbours, normals, signs, outer iterations.
 */

#ifndef SurfaceDenoising_PointWork_h
#define SurfaceDenoising_PointWork_h

#include "InterruptedExecution.h"
#include "PointDenoising.h"
#include "Stopwatch.h"

#include <cmath>

namespace SurfaceDenoising
{

/// The work on one cloud, in its own order.
class PointWork
{
public:
  PointWork(const PointDenoisingSettings& settings, PointDenoisingReport& report)
    : Settings(settings)
    , Report(report)
  {
  }

  PointSet Points;

  bool SetUp(Execution& execution)
  {
    const Stopwatch stopwatch(this->Report.SetupSeconds);
    PointSet& points = this->Points;
    if (this->NeedsStart())
    {
      points.Start = points.Positions;
    }
    this->CountMissingNormals(execution);
    points.LocalScale = this->Settings.LocalScale;
    points.Status.assign(points.Size(), PointStatus::Filtered);
    NeighborGraph nearest;
    if (!this->FindNearest(nearest, execution, 0.02))
    {
      return false;
    }
    this->MeasureSpacing(nearest, execution);
    if (!(points.Spacing > 0.0))
    {
      return true; // all points at one place
    }
    points.MaximumDisplacement = this->Settings.MaximumDisplacement * points.Spacing;
    return this->FindNormals(nearest, execution) &&
      this->FindNeighbors(std::move(nearest), execution, 0.25);
  }

  /// All outer iterations. Returns false if the execution asked to stop.
  bool Run(Execution& execution);

private:
  /// Fewer neighbours define no plane.
  static constexpr std::size_t FewestNeighbors = 3;

  std::size_t CountOfNeighborhood() const
  {
    const PointNeighborSettings& wanted = this->Settings.Neighborhood;
    return wanted.Kind == PointNeighborhood::Nearest
      ? static_cast<std::size_t>(std::max(1, wanted.Count))
      : 0;
  }

  /// True if points may have to go back to where they came from.
  bool NeedsStart() const
  {
    const bool lonely =
      std::min(this->CountOfNeighborhood() + 1, this->Points.Size()) <= FewestNeighbors;
    return this->Settings.MaximumDisplacement > 0.0 || this->Settings.Residual > 0.0 || lonely;
  }

  void CountMissingNormals(Execution& execution)
  {
    const Buffer<Vec3>& given = this->Points.Normals;
    this->MissingNormals = this->Points.Size() - given.size() +
      OrderedSum(execution, given.size(), std::size_t(0),
        [&](std::size_t i) { return given[i].isZero(0.0) ? 1 : 0; });
  }

  /// True if the normals that came with the points count.
  bool TakesGivenNormals() const
  {
    const NormalSource source = this->Settings.Normals.Source;
    return (source == NormalSource::Automatic || source == NormalSource::Given) &&
      this->MissingNormals < this->Points.Size();
  }

  /// True if normals, or some, have to come from fits.
  bool NeedsFits() const { return !this->TakesGivenNormals() || this->MissingNormals > 0; }

  /// As many nearest points as anything needs; after the first time, the neighbourhood alone.
  bool FindNearest(NeighborGraph& nearest, Execution& execution, double fraction)
  {
    std::size_t count = this->CountOfNeighborhood();
    if (this->Points.Spacings.empty())
    {
      const int forNormals = this->NeedsFits() ? this->Settings.Normals.NumberOfNeighbors : 1;
      count =
        std::max({ count, SpacingNeighbors, static_cast<std::size_t>(std::max(1, forNormals)) });
    }
    if (count == 0)
    {
      return true;
    }
    InterruptedExecution interrupted(execution, fraction);
    nearest = NearestOrderedPoints(this->Points.Positions, count, interrupted);
    return execution.Proceed(fraction);
  }

  void MeasureSpacing(const NeighborGraph& nearest, Execution& execution)
  {
    PointSet& points = this->Points;
    points.Spacings = PointSpacings(points.Positions, nearest, execution);
    points.Spacing = MedianSpacing(points.Spacings);
    this->Report.Spacing = points.Spacing;
    for (double& spacing : points.Spacings)
    {
      spacing = spacing > 0.0 ? spacing : points.Spacing;
    }
  }

  bool FindNormals(const NeighborGraph& nearest, Execution& execution);
  void FillGaps(const NeighborGraph& nearest, const Buffer<Vec3>& fitted, Buffer<Vec3>& normals);
  bool Agree(const NeighborGraph& nearest, const Buffer<Vec3>& given, Execution& execution) const;
  void Orient(const NeighborGraph& nearest, bool agree, Execution& execution);

  /// The neighbourhood of the settings from the nearest points.
  bool FindNeighbors(NeighborGraph nearest, Execution& execution, double fraction)
  {
    PointSet& points = this->Points;
    const PointNeighborSettings& wanted = this->Settings.Neighborhood;
    InterruptedExecution interrupted(execution, fraction);
    Release(points.Neighbors.Ids);
    if (wanted.Kind == PointNeighborhood::Radius)
    {
      nearest = NeighborGraph();
      points.Neighbors = PointsWithinRadius(points.Positions, wanted.Radius * points.Spacing,
        static_cast<std::size_t>(std::max(1, wanted.MaximumCount)), interrupted);
    }
    else if (nearest.NumberOfRows() > 0 && nearest.Row(0).size() > this->CountOfNeighborhood())
    {
      points.Neighbors = FirstNeighbors(nearest, this->CountOfNeighborhood(), interrupted);
    }
    else
    {
      points.Neighbors = std::move(nearest);
    }
    return execution.Proceed(fraction);
  }

  double Residual() const
  {
    const PointSet& points = this->Points;
    Buffer<double> heights(points.Size());
    for (std::size_t i = 0; i < points.Size(); ++i)
    {
      heights[i] = std::abs(points.Normals[i].dot(points.Positions[i] - points.Start[i]));
    }
    return RobustScale(heights, ScaleEstimator::HalfNormal);
  }

  /// Normals before an iteration, if there are points that no iteration may touch.
  Buffer<Vec3> LonelyNormals() const
  {
    const NeighborGraph& graph = this->Points.Neighbors;
    for (std::size_t i = 0; i < this->Points.Size(); ++i)
    {
      if (graph.Row(i).size() < FewestNeighbors)
      {
        return this->Points.Normals;
      }
    }
    return {};
  }

  /// Points with hardly a neighbour stay as they were.
  void KeepLonely(const Buffer<Vec3>& normals)
  {
    PointSet& points = this->Points;
    for (std::size_t i = 0; i < normals.size(); ++i)
    {
      if (points.Neighbors.Row(i).size() < FewestNeighbors)
      {
        points.Positions[i] = points.Start[i];
        points.Normals[i] = normals[i];
        points.Status[i] = PointStatus::Kept;
      }
    }
  }

  const PointDenoisingSettings& Settings;
  PointDenoisingReport& Report;
  std::size_t MissingNormals = 0; ///< of those that came with the points
};

}

#endif
