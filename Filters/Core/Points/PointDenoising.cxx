// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PointDenoising.h"

#include "InterruptedExecution.h"
#include "PointRuns.h"
#include "SpatialOrder.h"
#include "Stopwatch.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// Edges of the spanning tree lead to so many neighbours.
constexpr std::size_t TreeNeighbors = 10;

/// Fewer neighbours define no plane.
constexpr std::size_t FewestNeighbors = 3;

std::unique_ptr<PointOperator> MakeOperator(const PointOperatorSettings& settings)
{
  struct Maker
  {
    std::unique_ptr<PointOperator> operator()(const TwoStageSettings& s) const
    {
      return MakeTwoStagePoints(s);
    }
    std::unique_ptr<PointOperator> operator()(const MovingLeastSquaresSettings& s) const
    {
      return MakeMovingLeastSquares(s);
    }
    std::unique_ptr<PointOperator> operator()(const RobustImplicitMLSSettings& s) const
    {
      return MakeRobustImplicitMLS(s);
    }
    std::unique_ptr<PointOperator> operator()(const MovingRobustPCASettings& s) const
    {
      return MakeMovingRobustPCA(s);
    }
    std::unique_ptr<PointOperator> operator()(const LikelihoodPointsSettings& s) const
    {
      return MakeLikelihoodPoints(s);
    }
    std::unique_ptr<PointOperator> operator()(const NormalBundlesSettings& s) const
    {
      return MakeNormalBundles(s);
    }
    std::unique_ptr<PointOperator> operator()(const TensorRegionsSettings& s) const
    {
      return MakeTensorRegions(s);
    }
    std::unique_ptr<PointOperator> operator()(const VotingTensorPointsSettings& s) const
    {
      return MakeVotingTensorPoints(s);
    }
  };
  return std::visit(Maker(), settings);
}

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

  bool Run(Execution& execution)
  {
    PointSet& points = this->Points;
    if (!(points.Spacing > 0.0))
    {
      points.Status.assign(points.Size(), PointStatus::Kept);
      return true;
    }
    const Stopwatch stopwatch(this->Report.FilterSeconds);
    const auto filter = MakeOperator(this->Settings.Operator);
    const int iterations = this->Settings.OuterIterations;
    const double share = 0.7 / std::max(1, iterations);
    for (int outer = 0; outer < iterations; ++outer)
    {
      const double first = 0.3 + share * outer;
      const bool renew = this->Settings.RenewNeighborhood && outer > 0;
      NeighborGraph nearest;
      if (renew &&
        (!this->FindNearest(nearest, execution, first) ||
          !this->FindNeighbors(std::move(nearest), execution, first)))
      {
        return false;
      }
      if (renew || outer == 0)
      {
        filter->Renew(points, execution);
      }
      points.Status.assign(points.Size(), PointStatus::Filtered);
      const Buffer<Vec3> normals = this->LonelyNormals();
      if (!execution.Proceed(first) || !filter->Run(points, execution, first, first + share))
      {
        return false;
      }
      this->KeepLonely(normals);
      ++this->Report.OuterIterations;
      if (this->Settings.Residual > 0.0 && this->Residual() >= this->Settings.Residual)
      {
        break;
      }
    }
    static_cast<PointOperatorReport&>(this->Report) = filter->Report();
    return true;
  }

private:
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
    return this->Settings.MaximumDisplacement > 0.0 || lonely;
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

bool PointWork::FindNormals(const NeighborGraph& nearest, Execution& execution)
{
  PointSet& points = this->Points;
  const PointNormalSettings& settings = this->Settings.Normals;
  if (!this->NeedsFits())
  {
    this->Orient(nearest, this->Agree(nearest, points.Normals, execution), execution);
    return execution.Proceed(0.22);
  }
  const Buffer<Vec3> given = std::move(points.Normals);
  const std::size_t count = static_cast<std::size_t>(std::max(2, settings.NumberOfNeighbors));
  InterruptedExecution interrupted(execution, 0.1);
  points.Normals = PlaneFitNormals(points.Positions, nearest, count, interrupted);
  if (!execution.Proceed(0.1))
  {
    return false;
  }
  if (settings.Source != NormalSource::PlaneFit)
  {
    const bool all = nearest.NumberOfRows() == 0 || nearest.Row(0).size() <= count;
    const NeighborGraph fewer = all ? NeighborGraph() : FirstNeighbors(nearest, count, execution);
    if (!SharpenNormals(points.Positions, all ? nearest : fewer, points.Spacing, points.Normals,
          execution, 0.1, 0.2))
    {
      return false;
    }
  }
  this->Report.EstimatedNormals = points.Size();
  if (this->TakesGivenNormals())
  {
    Buffer<Vec3> normals = given;
    this->FillGaps(nearest, points.Normals, normals);
    points.Normals.swap(normals);
  }
  for (std::size_t i = 0; i < given.size(); ++i)
  {
    if (given[i].dot(points.Normals[i]) < 0.0)
    {
      points.Normals[i] = -points.Normals[i];
    }
  }
  this->Orient(nearest, this->Agree(nearest, given, execution), execution);
  return execution.Proceed(0.22);
}

/// Missing normals become those of fits, on the side of the normals around them.
void PointWork::FillGaps(const NeighborGraph& nearest, const Buffer<Vec3>& fitted,
  Buffer<Vec3>& normals)
{
  const Buffer<Vec3> given = normals;
  this->Report.EstimatedNormals = 0;
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    if (given[i].isZero(0.0))
    {
      Vec3 sum(0.0, 0.0, 0.0);
      for (const Index j : nearest.Row(i))
      {
        sum += given[j];
      }
      normals[i] = sum.dot(fitted[i]) < 0.0 ? Vec3(-fitted[i]) : fitted[i];
      ++this->Report.EstimatedNormals;
    }
  }
}

/// True if normals came with the points and neighbours have theirs on the same side.
bool PointWork::Agree(const NeighborGraph& nearest, const Buffer<Vec3>& given,
  Execution& execution) const
{
  // Zero vectors agree with everything, but tell no side.
  return this->MissingNormals < this->Points.Size() &&
    ShareOfOpposedNormals(nearest, given, execution) <= 0.05;
}

void PointWork::Orient(const NeighborGraph& nearest, bool agree, Execution& execution)
{
  PointSet& points = this->Points;
  const NormalOrientation wanted = this->Settings.Normals.Orientation;
  if (wanted == NormalOrientation::SpanningTree ||
    (wanted == NormalOrientation::Automatic && !agree))
  {
    const NeighborGraph edges = FirstNeighbors(nearest, TreeNeighbors, execution);
    this->Report.Parts = OrientNormals(points.Positions, edges, points.Normals, execution);
    this->Report.Oriented = true;
  }
}

}

bool DenoisePoints(PointCloud& cloud, const PointDenoisingSettings& settings,
  PointDenoisingReport& report, Execution& execution)
{
  Buffer<Index> order = FindPointOrder(cloud.Positions, cloud.Normals, execution);
  FormRuns(cloud.Positions, order, execution);
  const std::size_t all = cloud.Positions.size();
  report.NotFinite = all - order.size();
  PointWork work(settings, report);
  PointSet& points = work.Points;
  points.Positions = Gather(cloud.Positions, order, execution);
  if (!cloud.Normals.empty())
  {
    points.Normals = Gather(cloud.Normals, order, execution);
  }
  if (!execution.Proceed(0.01) || !work.SetUp(execution) || !work.Run(execution) ||
    !execution.Proceed(1.0))
  {
    return false;
  }
  report.Kept = static_cast<std::size_t>(
    std::count(points.Status.begin(), points.Status.end(), PointStatus::Kept));

  // Points that are not finite keep what they came with.
  const bool hadNormals = !cloud.Normals.empty();
  if (!hadNormals)
  {
    cloud.Normals.assign(all, Vec3(0.0, 0.0, 0.0));
  }
  cloud.Status.assign(all, PointStatus::NotFinite);
  cloud.Classes.clear();
  if (!points.Classes.empty())
  {
    cloud.Classes.assign(all, FeatureClass::Flat);
  }
  execution.For(order.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t k = begin; k < end; ++k)
      {
        const Index i = order[k];
        cloud.Positions[i] = points.Positions[k];
        cloud.Status[i] = points.Status[k];
        if (!points.Normals.empty())
        {
          cloud.Normals[i] = points.Normals[k];
        }
        if (!points.Classes.empty())
        {
          cloud.Classes[i] = points.Classes[k];
        }
      }
    });
  return true;
}

}
