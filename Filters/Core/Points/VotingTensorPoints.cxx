// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VotingTensorPoints.h"

#include "InterruptedExecution.h"
#include "PlaneFit.h"
#include "VotingTensor.h"

#include <cmath>

namespace SurfaceDenoising
{

FeatureClass ClassifyVariances(const Vec3& variances, double threshold)
{
  const double limit = threshold * variances.norm();
  if (variances[0] < limit && variances[2] > limit)
  {
    return variances[1] < limit ? FeatureClass::Edge
      : variances[1] > limit    ? FeatureClass::Flat
                                : FeatureClass::Corner;
  }
  return FeatureClass::Corner;
}

namespace
{

/// The engine's Gaussian is exp(-x^2 / (2 sigma^2)), that of the method exp(-x^2 / sigma^2).
const double PerSigma = std::sqrt(0.5);

class VotingTensorPoints : public PointOperator
{
public:
  explicit VotingTensorPoints(const VotingTensorPointsSettings& settings)
    : Settings(settings)
  {
  }

  bool Run(PointSet& points, Execution& execution, double first, double last) override
  {
    this->Done.NormScale = this->Settings.AngleThreshold;
    this->Ones.assign(points.Size(), 1.0);
    // Neighbourhoods are large: every stage can be stopped half way.
    auto stage = [&](double begin, double end)
    {
      return InterruptedExecution(execution, first + begin * (last - first),
        first + end * (last - first));
    };

    InterruptedExecution normals = stage(0.0, 0.5);
    if (!this->FilterNormals(points, normals))
    {
      return false;
    }
    Buffer<Vec3> steps;
    InterruptedExecution heights = stage(0.5, 0.8);
    this->MeasureHeights(points, steps, heights);
    if (!heights.Proceed(0.0))
    {
      return false;
    }
    const NeighborGraph graph = this->RowsOfFeatures(points, execution);
    InterruptedExecution planes = stage(0.8, 1.0);
    this->IntersectPlanes(points, graph, steps, planes);
    if (!planes.Proceed(0.0))
    {
      return false;
    }
    MoveBy(steps, points, execution);
    return true;
  }

private:
  static NormalFilter::Fields FieldsOf(const PointSet& points)
  {
    return { points.Normals, points.Normals, points.Normals, points.Normals };
  }

  /// The engine with this norm and a spatial scale in spacings.
  std::unique_ptr<NormalFilter> MakeFilter(const PointSet& points, const NeighborGraph& graph,
    NormalFilterSettings settings, double spatialScale, Execution& execution)
  {
    settings.SpatialSigma = PerSigma * spatialScale * points.Spacing;
    settings.Weighting = SiteWeight::Uniform;
    settings.Unoriented = this->Settings.Unoriented;
    SiteGeometry geometry{ points.Positions, this->Ones, 0.0 };
    Buffer<double> widths;
    if (points.LocalScale)
    {
      this->ScaleFactors.resize(points.Size());
      widths.resize(points.Size());
      for (std::size_t i = 0; i < points.Size(); ++i)
      {
        widths[i] = PerSigma * spatialScale * points.Spacings[i];
        this->ScaleFactors[i] = points.Spacings[i] / points.Spacing;
      }
      geometry.SpatialSigmas = spatialScale > 0.0 ? &widths : nullptr;
      geometry.NormScaleFactors = IsLength(settings.Argument) ? &this->ScaleFactors : nullptr;
    }
    auto filter = std::make_unique<NormalFilter>(graph, settings);
    filter->SetGeometry(geometry, execution);
    return filter;
  }

  /// The tensor step and the classes that follow. Returns false if asked to stop.
  bool FilterNormals(PointSet& points, Execution& execution)
  {
    NormalFilterSettings similar;
    similar.Norm = TruncatedL2Norm{ this->Settings.AngleThreshold };
    similar.Argument = NormalArgument::Angle;
    const auto votes = this->MakeFilter(points, points.Neighbors, similar, 0.0, execution);
    VotingTensorSettings tensor;
    tensor.Threshold = this->Settings.EigenvalueThreshold;
    tensor.Damping = this->Settings.Damping;
    tensor.Unit = EigenvalueUnit::Trace;
    Buffer<Vec3> filtered;
    VoteOnNormals(*votes, FieldsOf(points), points.Positions, tensor, filtered, execution);
    if (!execution.Proceed(0.0))
    {
      return false;
    }
    points.Normals.swap(filtered);
    this->Classify(*votes, points, execution);
    return execution.Proceed(0.0);
  }

  void Classify(const NormalFilter& votes, PointSet& points, Execution& execution)
  {
    points.Classes.assign(points.Size(), FeatureClass::Flat);
    this->Lines.assign(points.Size(), Vec3(0.0, 0.0, 0.0));
    votes.VisitWeights(FieldsOf(points), execution,
      [&](std::size_t i, const double* weights)
      {
        PlaneSum similar;
        similar.Add(Vec3(0.0, 0.0, 0.0));
        for (const Index j : points.Neighbors.Row(i))
        {
          similar.Add(points.Positions[j] - points.Positions[i], *weights++);
        }
        const Plane plane = similar.FitAxes();
        if (points.Normals[i].isZero(0.0) || plane.Along.isZero(0.0))
        {
          points.Status[i] = PointStatus::Kept; // nothing similar, or all of it at one place
          return;
        }
        points.Classes[i] = ClassifyVariances(plane.Variances, this->Settings.EigenvalueThreshold);
        if (points.Classes[i] == FeatureClass::Edge)
        {
          this->Lines[i] = plane.Along;
        }
      });
  }

  /// The steps that points take if they are flat.
  void MeasureHeights(const PointSet& points, Buffer<Vec3>& steps, Execution& execution)
  {
    NormalFilterSettings settings;
    settings.Norm = GaussianNorm{ PerSigma * this->Settings.FlatNormalScale };
    const auto filter = this->MakeFilter(points, points.Neighbors, settings,
      this->Settings.FlatSpatialScale, execution);
    PointUpdateSettings update;
    update.Scheme = this->Settings.FlatScheme;
    update.Step = this->Settings.Step;
    update.Unoriented = this->Settings.Unoriented;
    ComputeDisplacements(*filter, FieldsOf(points), points.Positions, update, steps, execution);
  }

  /// The rows of points on edges and corners; none of the others.
  NeighborGraph RowsOfFeatures(const PointSet& points, Execution& execution) const
  {
    return BuildRows(execution, points.Size(),
      [&](std::size_t i, Buffer<Index>& row)
      {
        if (points.Classes[i] != FeatureClass::Flat)
        {
          const Span<Index> all = points.Neighbors.Row(i);
          row.insert(row.end(), all.begin(), all.end());
        }
      });
  }

  /// Replaces the steps of points on edges and corners; takes those of kept points back.
  void IntersectPlanes(const PointSet& points, const NeighborGraph& graph, Buffer<Vec3>& steps,
    Execution& execution)
  {
    const bool guarded = this->Settings.PlaneScale > 0.0;
    NormalFilterSettings settings;
    settings.Norm = L2Norm{};
    if (guarded)
    {
      settings.Norm = GaussianNorm{ PerSigma * this->Settings.PlaneScale * points.Spacing };
      settings.Argument = NormalArgument::NeighborHeight;
    }
    const auto filter = this->MakeFilter(points, graph, settings,
      guarded ? this->Settings.FlatSpatialScale : 0.0, execution);
    PointUpdateSettings update;
    update.Scheme = PointScheme::QuadricFit;
    update.Step = guarded ? this->Settings.Step : 1.0;
    update.EigenvalueCut = this->Settings.EigenvalueCut;
    update.Lines = &this->Lines;
    Buffer<Vec3> towards;
    Buffer<unsigned char> ranks;
    ComputeDisplacements(*filter, FieldsOf(points), points.Positions, update, towards, execution,
      &ranks);
    const int fewest = guarded ? 2 : 0;
    execution.For(points.Size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          if (points.Status[i] == PointStatus::Kept)
          {
            steps[i].setZero();
          }
          else if (points.Classes[i] != FeatureClass::Flat && ranks[i] >= fewest)
          {
            steps[i] = towards[i];
          }
        }
      });
  }

  VotingTensorPointsSettings Settings;
  Buffer<double> Ones;
  Buffer<double> ScaleFactors; ///< of lengths, per point
  Buffer<Vec3> Lines;          ///< along edges; zero for other points
};

}

std::unique_ptr<PointOperator> MakeVotingTensorPoints(const VotingTensorPointsSettings& settings)
{
  return std::make_unique<VotingTensorPoints>(settings);
}

}
