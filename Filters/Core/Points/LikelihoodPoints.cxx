// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LikelihoodPoints.h"

#include "InterruptedExecution.h"
#include "NormalTensor.h"
#include "PlaneFit.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// Scales are at least so many spacings: exp(-(0 / 0)^2) is no weight.
constexpr double LeastScale = 1e-12;

/// Standard deviation of the angles between the normals of a point and its neighbours, about their
/// mean, whatever their signs; of those that have normals.
double DeviationOfAngles(const Buffer<Vec3>& normals, std::size_t i, Span<Index> row)
{
  const Vec3& n = normals[i];
  double count = 0.0;
  double mean = 0.0;
  double squares = 0.0; // of the differences from the mean
  for (const Index j : row)
  {
    const Vec3& m = normals[j];
    if (m.isZero(0.0) || n.isZero(0.0))
    {
      continue;
    }
    const double angle =
      AngleOfSquaredChord(std::min((m - n).squaredNorm(), (m + n).squaredNorm()));
    count += 1.0;
    const double difference = angle - mean;
    mean += difference / count;
    squares += difference * (angle - mean);
  }
  return count > 0.0 ? std::sqrt(squares / count) : 0.0;
}

class LikelihoodPoints : public PointOperator
{
public:
  explicit LikelihoodPoints(const LikelihoodPointsSettings& settings)
    : Settings(settings)
  {
  }

  bool Run(PointSet& points, Execution& execution, double first, double last) override
  {
    const double step = (last - first) / 3.0;
    InterruptedExecution judging(execution, first, first + step);
    this->Judge(points, judging);
    if (!judging.Proceed(first + step))
    {
      return false;
    }
    InterruptedExecution averaging(execution, first + step, first + 2.0 * step);
    Buffer<Vec3> normals;
    this->FilterNormals(points, normals, averaging);
    if (!averaging.Proceed(first + 2.0 * step))
    {
      return false;
    }
    points.Normals.swap(normals);
    InterruptedExecution moving(execution, first + 2.0 * step, last);
    Buffer<Vec3> moves;
    this->FindMoves(points, moves, moving);
    if (!moving.Proceed(last))
    {
      return false;
    }
    for (std::size_t i = 0; i < points.Size(); ++i)
    {
      if (!this->HasPlane[i] || points.Normals[i].isZero(0.0))
      {
        points.Status[i] = PointStatus::Kept;
        moves[i].setZero();
      }
    }
    MoveBy(moves, points, execution);
    return true;
  }

private:
  /// The engine with f_ij times the weights of a norm, the scale of which is a factor per point.
  NormalFilterSettings Weights(const ErrorNorm& norm, NormalArgument argument) const
  {
    NormalFilterSettings settings;
    settings.Norm = norm;
    settings.Argument = argument;
    settings.Weighting = SiteWeight::Area;
    settings.IncludeOwn = true;
    settings.Unoriented = true;
    return settings;
  }

  SiteGeometry Geometry(const PointSet& points, const Buffer<double>& shares) const
  {
    SiteGeometry geometry{ points.Positions, shares, 0.0 };
    geometry.SpatialSigmas = &this->Widths;
    geometry.NormScaleFactors = &this->Scales;
    return geometry;
  }

  /// Widths of the spatial kernel, likelihoods, intensities and the scales of angles.
  void Judge(const PointSet& points, Execution& execution)
  {
    const std::size_t count = points.Size();
    this->Widths.resize(count);
    execution.For(count,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          const Span<Index> row = points.Neighbors.Row(i);
          double radius = this->Settings.Radius * points.SpacingAt(i);
          if (!(radius > 0.0) && row.size() > 0)
          {
            radius = (points.Positions[row[row.size() - 1]] - points.Positions[i]).norm();
          }
          // exp(-4 d^2 / r^2) in the form of the engine
          this->Widths[i] = std::max(radius / std::sqrt(8.0), LeastScale * points.Spacing);
        }
      });

    this->Ones.assign(count, 1.0);
    this->Scales.assign(count, 1.0);
    this->Intensities.resize(count);
    this->Likelihoods.resize(count);
    this->HasPlane.resize(count);
    NormalFilter filter(points.Neighbors, this->Weights(L2Norm{ 1.0 }, NormalArgument::Chord));
    filter.SetGeometry(this->Geometry(points, this->Ones), execution);
    const Buffer<Vec3>& normals = points.Normals;
    Buffer<double>& offsets = this->Likelihoods;
    filter.VisitWeights({ normals, normals, normals, normals }, execution,
      [&](std::size_t i, const double* weights)
      {
        const Span<Index> row = points.Neighbors.Row(i);
        this->Intensities[i] = FeatureIntensity(NormalTensorValues(filter, normals, i, weights));
        this->Scales[i] = std::max(DeviationOfAngles(normals, i, row), this->Settings.LeastAngle);
        PlaneSum sum;
        sum.Add(Vec3(0.0, 0.0, 0.0), *weights++);
        for (const Index j : row)
        {
          sum.Add(points.Positions[j] - points.Positions[i], *weights++);
        }
        const Plane plane = sum.Fit();
        this->HasPlane[i] = !plane.Normal.isZero(0.0);
        offsets[i] = plane.HeightOf(Vec3(0.0, 0.0, 0.0));
      });
    const double squares =
      OrderedSum(execution, count, 0.0, [&](std::size_t i) { return offsets[i] * offsets[i]; });
    const double scale = 2.0 * squares / static_cast<double>(std::max<std::size_t>(1, count));
    const double least = LeastScale * points.Spacing;
    for (double& offset : offsets)
    {
      offset = scale > least * least ? std::exp(-offset * offset / scale) : 1.0;
    }
  }

  void FilterNormals(const PointSet& points, Buffer<Vec3>& filtered, Execution& execution) const
  {
    NormalFilter filter(points.Neighbors,
      this->Weights(GaussianNorm{ 1.0 / std::sqrt(2.0) }, NormalArgument::Angle));
    const bool likely = this->Settings.LikelihoodInNormals;
    filter.SetGeometry(this->Geometry(points, likely ? this->Likelihoods : this->Ones), execution);
    filter.Sweep(points.Normals, filtered, execution);
  }

  /// With the new normals.
  void FindMoves(const PointSet& points, Buffer<Vec3>& moves, Execution& execution)
  {
    const Buffer<Vec3>& normals = points.Normals;
    execution.For(points.Size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          double squares = 0.0;
          const Span<Index> row = points.Neighbors.Row(i);
          for (const Index j : row)
          {
            const double height = normals[i].dot(points.Positions[j] - points.Positions[i]);
            squares += height * height;
          }
          const double mean = squares / std::max(1.0, static_cast<double>(row.size()));
          const double sharper = 1.0 - this->Settings.FeatureSharpening * this->Intensities[i];
          this->Scales[i] = std::max(std::sqrt(mean) * sharper, LeastScale * points.Spacing);
        }
      });
    NormalFilter filter(points.Neighbors,
      this->Weights(GaussianNorm{ 1.0 / std::sqrt(2.0) }, NormalArgument::Height));
    filter.SetGeometry(this->Geometry(points, this->Likelihoods), execution);
    ComputeDisplacements(filter, { normals, normals, normals, normals }, points.Positions,
      { this->Settings.Scheme, 1.0, true }, moves, execution);
  }

  LikelihoodPointsSettings Settings;
  Buffer<double> Widths; ///< of the spatial kernel
  Buffer<double> Scales; ///< of angles, then of heights
  Buffer<double> Ones;
  Buffer<double> Likelihoods;
  Buffer<double> Intensities;
  Buffer<unsigned char> HasPlane;
};

}

std::unique_ptr<PointOperator> MakeLikelihoodPoints(const LikelihoodPointsSettings& settings)
{
  return std::make_unique<LikelihoodPoints>(settings);
}

}
