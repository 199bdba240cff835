// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TensorRegions.h"

#include "InterruptedExecution.h"
#include "NormalTensor.h"
#include "PointUpdate.h"
#include "RowPlanes.h"

#include <cmath>
#include <limits>

namespace SurfaceDenoising
{

namespace
{

/// What divides a bend is at least so many spacings.
constexpr double ShortestWay = 0.5;

/// What a spacing of distance counts against one of height when seeds are chosen.
constexpr double DistanceShare = 0.25;

class TensorRegions : public PointOperator
{
public:
  explicit TensorRegions(const TensorRegionsSettings& settings)
    : Settings(settings)
  {
  }

  bool Run(PointSet& points, Execution& execution, double first, double last) override
  {
    const double step = (last - first) / 3.0;
    InterruptedExecution classifying(execution, first, first + step);
    this->WithArcs(points, nullptr, classifying,
      [&](const NormalFilter& filter)
      {
        FindFeatures(filter, points.Normals, this->Settings.FeatureThreshold,
          this->Settings.FeatureContrast, points.Classes, classifying);
      });
    if (!classifying.Proceed(first + step))
    {
      return false;
    }
    InterruptedExecution growing(execution, first + step, first + 2.0 * step);
    Buffer<Vec3> seedNormals(points.Size());
    NeighborGraph regions;
    this->FindRegions(points, seedNormals, regions, growing);
    return growing.Proceed(first + 2.0 * step) &&
      this->MovePoints(points, seedNormals, regions, execution, first + 2.0 * step, last);
  }

private:
  /// The filter whose weights are g, for every point and its neighbours.
  NormalFilterSettings WeightsOfArcs(const PointSet& points) const
  {
    const double s = points.Spacing;
    NormalFilterSettings settings;
    settings.Norm = GaussianNorm{ this->Settings.Range * s / std::sqrt(2.0) };
    settings.Argument = NormalArgument::BentArc;
    settings.BendFactor = this->Settings.BendFactor * s * s * s * s;
    settings.Weighting = SiteWeight::Uniform;
    settings.IncludeOwn = true;
    settings.Unoriented = true;
    return settings;
  }

  /// Calls use(filter) with a filter that sees every point from a place, if places are given, else
  /// from where it is.
  template <typename Use>
  void WithArcs(const PointSet& points, const Buffer<Vec3>* places, Execution& execution,
    Use use) const
  {
    NormalFilter filter(points.Neighbors, this->WeightsOfArcs(points));
    const Buffer<double> noAreas;
    SiteGeometry geometry{ points.Positions, noAreas, ShortestWay * points.Spacing };
    Buffer<double> factors;
    if (points.LocalScale)
    {
      factors = points.Spacings;
      for (double& factor : factors)
      {
        factor /= points.Spacing;
      }
      geometry.NormScaleFactors = &factors;
    }
    geometry.Centres = places;
    filter.SetGeometry(geometry, execution);
    use(filter);
  }

  static std::size_t SeedOf(const PointSet& points, std::size_t i)
  {
    std::size_t seed = i;
    double least = std::numeric_limits<double>::infinity();
    if (points.Classes[i] != FeatureClass::Flat)
    {
      for (const Index j : points.Neighbors.Row(i))
      {
        const Vec3& n = points.Normals[j];
        const Vec3 e = points.Positions[j] - points.Positions[i];
        const double distance = std::abs(n.dot(e)) + DistanceShare * e.norm();
        if (points.Classes[j] == FeatureClass::Flat && !n.isZero(0.0) && distance < least)
        {
          seed = j;
          least = distance;
        }
      }
    }
    return seed;
  }

  void FindRegions(const PointSet& points, Buffer<Vec3>& seedNormals, NeighborGraph& regions,
    Execution& execution) const
  {
    const NeighborGraph& graph = points.Neighbors;
    Buffer<Vec3> places(points.Size());
    execution.For(points.Size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          const std::size_t seed = SeedOf(points, i);
          places[i] = points.Positions[seed];
          seedNormals[i] = points.Normals[seed];
        }
      });
    // Who belongs to the region, of each point and its neighbours.
    Buffer<unsigned char> members(graph.NumberOfIds() + points.Size());
    const Buffer<Vec3>& normals = points.Normals;
    this->WithArcs(points, &places, execution,
      [&](const NormalFilter& filter)
      {
        filter.VisitWeights({ normals, seedNormals, normals, normals }, execution,
          [&](std::size_t i, const double* weights) {
            this->Choose(weights, graph.Row(i).size() + 1, members.data() + graph.Offsets[i] + i);
          });
      });
    regions = BuildRows(execution, points.Size(),
      [&](std::size_t i, Buffer<Index>& row)
      {
        const unsigned char* member = members.data() + graph.Offsets[i] + i;
        if (*member++)
        {
          row.push_back(static_cast<Index>(i));
        }
        for (const Index j : graph.Row(i))
        {
          if (*member++)
          {
            row.push_back(j);
          }
        }
      });
  }

  /// Marks the members with enough weight, or the best if these are too few; of equal ones the
  /// first.
  void Choose(const double* weights, std::size_t count, unsigned char* chosen) const
  {
    std::size_t found = 0;
    for (std::size_t k = 0; k < count; ++k)
    {
      chosen[k] = weights[k] >= this->Settings.RegionThreshold;
      found += chosen[k];
    }
    const auto least = static_cast<std::size_t>(std::max(1, this->Settings.LeastMembers));
    for (; found < std::min(least, count); ++found)
    {
      std::size_t best = count;
      for (std::size_t k = 0; k < count; ++k)
      {
        if (!chosen[k] && (best == count || weights[k] > weights[best]))
        {
          best = k;
        }
      }
      chosen[best] = 1;
    }
  }

  bool MovePoints(PointSet& points, const Buffer<Vec3>& seedNormals, const NeighborGraph& regions,
    Execution& execution, double first, double last) const
  {
    InterruptedExecution interrupted(execution, first, last);
    const std::size_t count = points.Size();
    const double width = 0.5 * this->Settings.Range / std::sqrt(2.0);
    NormalFilterSettings settings;
    settings.Norm = L2Norm{ 1.0 };
    settings.SpatialSigma = width * points.Spacing;
    settings.Weighting = SiteWeight::Uniform;
    settings.KeepFixedWeights = false; // of two sweeps, they would not pay
    NormalFilter filter(regions, settings);
    const Buffer<double> noAreas;
    SiteGeometry geometry{ points.Positions, noAreas, 0.0 };
    Buffer<double> widths;
    if (points.LocalScale)
    {
      widths = points.Spacings;
      for (double& w : widths)
      {
        w *= width;
      }
      geometry.SpatialSigmas = &widths;
    }
    filter.SetGeometry(geometry, interrupted);
    const Buffer<Vec3> none(count, Vec3(0.0, 0.0, 0.0));
    Buffer<Vec3> normals;
    FitPlanes(filter, { none, none, none, none }, points.Positions, normals, interrupted);
    if (!interrupted.Proceed(last))
    {
      return false;
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      Vec3& n = normals[i];
      if (n.isZero(0.0))
      {
        n = points.Normals[i];
        points.Status[i] = PointStatus::Kept;
      }
      else if (n.dot(seedNormals[i]) < 0.0)
      {
        n = -n;
      }
    }
    Buffer<Vec3> moves;
    ComputeDisplacements(filter, { normals, normals, normals, normals }, points.Positions,
      { PointScheme::BalancedHeight, 1.0, true }, moves, interrupted);
    if (this->Settings.QuadricAtFeatures)
    {
      this->GoToQuadrics(points, normals, moves, interrupted);
    }
    if (!interrupted.Proceed(last))
    {
      return false;
    }
    points.Normals.swap(normals);
    for (std::size_t i = 0; i < count; ++i)
    {
      if (points.Status[i] == PointStatus::Kept)
      {
        moves[i].setZero();
      }
    }
    MoveBy(moves, points, execution);
    return true;
  }

  void GoToQuadrics(const PointSet& points, const Buffer<Vec3>& normals, Buffer<Vec3>& moves,
    Execution& execution) const
  {
    NormalFilterSettings settings;
    settings.Norm = L2Norm{ 1.0 };
    settings.Weighting = SiteWeight::Uniform;
    settings.IncludeOwn = true;
    NormalFilter filter(points.Neighbors, settings);
    const Buffer<double> noAreas;
    filter.SetGeometry({ points.Positions, noAreas, 0.0 }, execution);
    Buffer<Vec3> toQuadrics;
    ComputeDisplacements(filter, { normals, normals, normals, normals }, points.Positions,
      { PointScheme::QuadricFit, 1.0, true }, toQuadrics, execution);
    for (std::size_t i = 0; i < points.Size(); ++i)
    {
      if (points.Classes[i] != FeatureClass::Flat && toQuadrics[i].norm() <= points.SpacingAt(i))
      {
        moves[i] = toQuadrics[i];
      }
    }
  }

  TensorRegionsSettings Settings;
};

}

std::unique_ptr<PointOperator> MakeTensorRegions(const TensorRegionsSettings& settings)
{
  return std::make_unique<TensorRegions>(settings);
}

}
