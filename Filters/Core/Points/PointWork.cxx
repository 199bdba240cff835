// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PointWork.h"

namespace SurfaceDenoising
{

namespace
{

/// Edges of the spanning tree lead to so many neighbours.
constexpr std::size_t TreeNeighbors = 10;

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

}

bool PointWork::Run(Execution& execution)
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
    InterruptedExecution interrupted(execution, 0.2);
    const NeighborGraph edges = FirstNeighbors(nearest, TreeNeighbors, interrupted);
    if (!interrupted.Proceed(0.2))
    {
      return;
    }
    this->Report.Parts = OrientNormals(points.Positions, edges, points.Normals, execution, 0.2);
    this->Report.Oriented = true;
  }
}

}
