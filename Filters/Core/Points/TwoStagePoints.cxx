// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TwoStagePoints.h"

#include "NormalMedian.h"
#include "RowPlanes.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// Neighbours whose normals tell the scale of a norm.
constexpr std::size_t ScaleNeighbors = 6;

/// x_ij of two points that are e apart and have the normals n and m.
double DifferenceOf(NormalArgument argument, const Vec3& e, const Vec3& n, const Vec3& m)
{
  const double chord = (m - n).norm();
  const double angle = std::atan2(m.cross(n).norm(), m.dot(n));
  switch (argument)
  {
    case NormalArgument::Angle:
      return angle;
    case NormalArgument::DirectionalCurvature:
      return angle / e.norm();
    case NormalArgument::NormalGradient:
      return chord / e.norm();
    case NormalArgument::Height:
      return std::abs(n.dot(e));
    case NormalArgument::NeighborHeight:
      return std::abs(m.dot(e));
    case NormalArgument::BentArc: // without a bend, as in the sweeps
      return (chord > 1e-10 ? angle / chord : 1.0) * e.norm();
    case NormalArgument::SiteCurvature: // not for points
    case NormalArgument::Chord:
      break;
  }
  return chord;
}

/// x_ij between every point and its first neighbours.
Buffer<double> NeighborDifferences(const PointSet& points, NormalArgument argument, bool unoriented)
{
  Buffer<double> differences;
  differences.reserve(points.Size() * ScaleNeighbors);
  for (std::size_t i = 0; i < points.Size(); ++i)
  {
    const Span<Index> row = points.Neighbors.Row(i);
    for (std::size_t k = 0; k < std::min(ScaleNeighbors, row.size()); ++k)
    {
      const Vec3 e = points.Positions[row[k]] - points.Positions[i];
      const Vec3& n = points.Normals[i];
      Vec3 m = points.Normals[row[k]];
      if (m.isZero(0.0) || n.isZero(0.0) || e.isZero(0.0))
      {
        continue;
      }
      if (unoriented && m.dot(n) < 0.0)
      {
        m = -m;
      }
      differences.push_back(DifferenceOf(argument, e, n, m));
    }
  }
  return differences;
}

/// What the scale of the norm is multiplied by.
double ScaleUnit(const PointSet& points, NormalArgument argument)
{
  return IsCurvature(argument) ? 1.0 / points.Spacing : IsLength(argument) ? points.Spacing : 1.0;
}

class TwoStagePoints : public PointOperator
{
public:
  explicit TwoStagePoints(const TwoStageSettings& settings)
    : Settings(settings)
  {
  }

  bool Run(PointSet& points, Execution& execution, double first, double last) override
  {
    if (!this->ChoseScale)
    {
      this->ChooseScale(points);
    }
    if (this->Done.NoNoiseFound)
    {
      return true;
    }
    const TwoStageSettings& settings = this->Settings;
    this->Areas.resize(settings.DensityWeights ? points.Size() : 0);
    for (std::size_t i = 0; i < this->Areas.size(); ++i)
    {
      const double spacing = points.Spacings[i] / points.Spacing;
      this->Areas[i] = spacing * spacing;
    }
    const int steps = std::max(1, settings.NormalIterations + settings.PointIterations);
    const double middle = first + (last - first) * settings.NormalIterations / steps;
    std::unique_ptr<NormalFilter> filter;
    const bool finished = this->FilterNormals(points, filter, execution, first, middle) &&
      this->MovePoints(points, filter, execution, middle, last);
    Release(this->Spare);
    return finished;
  }

private:
  void ChooseScale(const PointSet& points)
  {
    const TwoStageSettings& settings = this->Settings;
    this->ChoseScale = true;
    this->Done.NormScale = settings.Normals.NormScale;
    if (!(settings.Normals.NormScale > 0.0))
    {
      const NormalArgument argument = settings.Normals.Argument;
      Buffer<double> values = NeighborDifferences(points, argument, settings.Unoriented);
      const double sigma = RobustScale(values, settings.Estimator) / ScaleUnit(points, argument);
      this->Done.NoNoiseFound = sigma < 1e-6;
      this->Done.NormScale = ScaleForOutlierBoundary(settings.Normals.Norm, sigma);
    }
  }

  /// The norm of a stage.
  static ErrorNorm NormOf(const PointSet& points, const PointWeights& weights, double normScale)
  {
    return MakeErrorNorm(weights.Norm, normScale * ScaleUnit(points, weights.Argument));
  }

  /// True if both stages have the same fixed weights: normals change, but points do not move
  /// between the two.
  bool HasOneGeometry(const PointSet& points) const
  {
    const PointWeights& one = this->Settings.Normals;
    const PointWeights& other = this->Settings.Points;
    return one.SpatialScale == other.SpatialScale && one.IncludeOwn == other.IncludeOwn &&
      !NeedsDistances(one.Argument) && !NeedsDistances(other.Argument) && !points.LocalScale;
  }

  static bool NeedsDistances(NormalArgument argument)
  {
    return IsCurvature(argument) || argument == NormalArgument::BentArc;
  }

  /// True if so few sweeps follow that it does not pay to keep what is fixed.
  bool SweepsAreFew(const PointSet& points) const
  {
    return this->Settings.NormalIterations < 2 && this->Settings.PointIterations < 2 &&
      !points.LocalScale;
  }

  /// The engine with the weights of a stage, for the present positions.
  std::unique_ptr<NormalFilter> MakeFilter(const PointSet& points, const PointWeights& weights,
    double normScale, Execution& execution)
  {
    NormalFilterSettings settings;
    settings.Norm = NormOf(points, weights, normScale);
    settings.Argument = weights.Argument;
    settings.SpatialSigma = weights.SpatialScale * points.Spacing;
    settings.Weighting = SiteWeight::Area;
    settings.IncludeOwn = weights.IncludeOwn;
    settings.Step = this->Settings.Operator == PointNormalOperator::Diffusion
      ? NormalStep::Diffusion
      : NormalStep::Average;
    settings.StepLength = this->Settings.StepLength;
    settings.Unoriented = this->Settings.Unoriented;
    settings.BendFactor = std::pow(points.Spacing, 4);
    settings.KeepFixedWeights = !this->SweepsAreFew(points);
    auto filter = std::make_unique<NormalFilter>(points.Neighbors, settings);

    SiteGeometry geometry{ points.Positions, this->Areas, 1e-12 * points.Spacing };
    Buffer<double> widths;
    if (points.LocalScale)
    {
      widths = points.Spacings;
      this->ScaleFactors.resize(points.Size());
      for (std::size_t i = 0; i < points.Size(); ++i)
      {
        const double relative = points.Spacings[i] / points.Spacing;
        widths[i] *= weights.SpatialScale;
        this->ScaleFactors[i] = IsLength(weights.Argument) ? relative
          : IsCurvature(weights.Argument)                  ? 1.0 / relative
                                                           : 1.0;
      }
      geometry.SpatialSigmas = weights.SpatialScale > 0.0 ? &widths : nullptr;
      geometry.NormScaleFactors = &this->ScaleFactors;
    }
    filter->SetGeometry(geometry, execution);
    return filter;
  }

  /// Leaves its filter, if it made one.
  bool FilterNormals(PointSet& points, std::unique_ptr<NormalFilter>& filter, Execution& execution,
    double first, double last)
  {
    const TwoStageSettings& settings = this->Settings;
    if (settings.NormalIterations < 1)
    {
      return true;
    }
    filter = this->MakeFilter(points, settings.Normals, this->Done.NormScale, execution);
    const bool rolling = settings.Guidance == PointGuidance::Rolling;
    Buffer<Vec3>& normals = points.Normals;
    Buffer<Vec3> original;
    if (rolling || settings.Data == PointNormalData::Original)
    {
      original = normals;
    }
    Buffer<Vec3> guide;
    if (rolling)
    {
      guide.assign(points.Size(), Vec3(0.0, 0.0, 0.0)); // looks at nothing: the mean
    }
    PointPatchSettings patch = settings.Patch;
    patch.Unoriented = settings.Unoriented;
    Buffer<Vec3>& filtered = this->Spare;
    filtered.resize(points.Size());
    for (int iteration = 0; iteration < settings.NormalIterations; ++iteration)
    {
      if (!execution.Proceed(first + (last - first) * iteration / settings.NormalIterations))
      {
        return false;
      }
      const Buffer<Vec3>& data = original.empty() ? normals : original;
      const Buffer<Vec3>* centre = &normals;
      const Buffer<Vec3>* compared = &data;
      switch (settings.Guidance)
      {
        case PointGuidance::None:
          break;
        case PointGuidance::Patch:
          ComputePointPatches(points.Neighbors, normals, patch, guide, execution);
          centre = compared = &guide;
          break;
        case PointGuidance::Median:
          DirectionalMedians(points.Neighbors, normals, guide, execution, settings.Unoriented);
          centre = &guide;
          break;
        case PointGuidance::Rolling:
          centre = compared = &guide;
          break;
      }
      const NormalFilter::Fields fields{ normals, *centre, *compared, data };
      switch (settings.Operator)
      {
        case PointNormalOperator::Average:
        case PointNormalOperator::Diffusion:
          filter->Sweep(fields, filtered, execution);
          break;
        case PointNormalOperator::VotingTensor:
          VoteOnNormals(*filter, fields, points.Positions, settings.Tensor, filtered, execution);
          break;
        case PointNormalOperator::PlaneFit:
          FitPlanes(*filter, fields, points.Positions, filtered, execution);
          break;
      }
      normals.swap(filtered);
      if (rolling)
      {
        guide = normals;
      }
    }
    return true;
  }

  bool MovePoints(PointSet& points, std::unique_ptr<NormalFilter>& filter, Execution& execution,
    double first, double last)
  {
    const TwoStageSettings& settings = this->Settings;
    if (settings.PointIterations < 1)
    {
      return true;
    }
    const PointWeights& weights = settings.Points;
    if (filter && this->HasOneGeometry(points))
    {
      filter->SetNorm(NormOf(points, weights, weights.NormScale), weights.Argument);
    }
    else
    {
      filter.reset(); // first, for its memory
      filter = this->MakeFilter(points, weights, weights.NormScale, execution);
    }
    PointUpdateSettings update = settings.Update;
    update.Unoriented = settings.Unoriented;
    const NormalFilter::Fields fields{ points.Normals, points.Normals, points.Normals,
      points.Normals };
    // Normals stay as they are from now on, unlike heights.
    if (!IsLength(weights.Argument) && settings.PointIterations > 1)
    {
      filter->FreezeWeights(fields, execution);
    }
    Buffer<Vec3>& places = this->Spare;
    for (int iteration = 0; iteration < settings.PointIterations; ++iteration)
    {
      if (!execution.Proceed(first + (last - first) * iteration / settings.PointIterations))
      {
        return false;
      }
      ComputeDisplacements(*filter, fields, points.Positions, update, places, execution);
      MoveBy(places, points, execution);
    }
    return true;
  }

  TwoStageSettings Settings;
  bool ChoseScale = false;
  Buffer<Vec3> Spare; ///< for what comes out of a sweep: fresh memory costs as much as its work
  Buffer<double> Areas;
  Buffer<double> ScaleFactors; ///< of the norm, per point
};

}

std::unique_ptr<PointOperator> MakeTwoStagePoints(const TwoStageSettings& settings)
{
  return std::make_unique<TwoStagePoints>(settings);
}

}
