// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NormalBundles.h"

#include "BundleNodes.h"
#include "FeatureCandidates.h"
#include "InterruptedExecution.h"
#include "KdTree.h"
#include "MedialSkeleton.h"
#include "PointPatches.h"
#include "PointUpdate.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

class NormalBundles : public PointOperator
{
public:
  explicit NormalBundles(const NormalBundlesSettings& settings)
    : Settings(settings)
  {
  }

  bool Run(PointSet& points, Execution& execution, double first, double last) override
  {
    this->Done.NormScale = this->Settings.RangeScale;
    this->TakeOwnNormals(points);
    auto at = [&](double share) { return first + (last - first) * share; };
    Buffer<unsigned char> features;
    if (!this->FindFeatures(points, features, execution, first, at(0.1)))
    {
      return false;
    }
    BundleNodes nodes;
    {
      BundleSettings settings;
      settings.Clusters.Angle = this->Settings.BundleAngle;
      settings.Clusters.Maximum = this->Settings.MaximumBundles;
      settings.Clusters.Unoriented = this->Settings.Unoriented;
      settings.SpatialScale = this->Settings.SpatialScale;
      settings.Reach = this->Settings.BundleReach;
      InterruptedExecution interrupted(execution, at(0.1), at(0.2));
      nodes = MakeBundles(points, features, settings, interrupted);
      if (!interrupted.Proceed(0.0))
      {
        return false;
      }
    }
    this->GatherNodes(points, nodes, execution);
    if (!this->FilterNormals(points, nodes, execution, at(0.2), at(0.7)) ||
      !this->MovePoints(points, nodes, execution, at(0.7), last))
    {
      return false;
    }
    this->Finish(points, nodes);
    return true;
  }

private:
  bool FindFeatures(const PointSet& points, Buffer<unsigned char>& features, Execution& execution,
    double first, double last)
  {
    const NormalBundlesSettings& settings = this->Settings;
    const Buffer<double> scores = SimilarityScores(points.Neighbors, points.Positions,
      points.Normals, settings.CandidateScale, execution);
    features.resize(points.Size());
    Buffer<Vec3> candidates;
    for (std::size_t i = 0; i < points.Size(); ++i)
    {
      features[i] = scores[i] < settings.CandidateThreshold;
      if (features[i] && settings.UseSkeleton)
      {
        candidates.push_back(points.Positions[i]);
      }
    }
    if (candidates.empty())
    {
      return execution.Proceed(last);
    }
    MedialSkeletonSettings medial;
    medial.Radius = settings.SkeletonRadius * points.Spacing;
    Buffer<Vec3> skeleton;
    if (!FindMedialSkeleton(candidates, medial, skeleton, execution, first, last))
    {
      return false;
    }
    const KdTree tree(skeleton);
    execution.For(points.Size(),
      [&](std::size_t begin, std::size_t end)
      {
        std::vector<Index> nearest;
        for (std::size_t i = begin; i < end; ++i)
        {
          if (features[i])
          {
            tree.Within(points.Positions[i], 0.5 * medial.Radius, nearest, 1);
            features[i] = !nearest.empty();
          }
        }
      });
    return execution.Proceed(last);
  }

  /// What the filter needs to know of nodes.
  void GatherNodes(const PointSet& points, const BundleNodes& nodes, Execution& execution)
  {
    const std::size_t size = nodes.Size();
    this->Areas.assign(size, 1.0);
    this->Positions.resize(size);
    this->Widths.resize(points.LocalScale ? size : 0);
    execution.For(size,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t k = begin; k < end; ++k)
        {
          const Index i = nodes.Points[k];
          this->Positions[k] = points.Positions[i];
          if (points.LocalScale)
          {
            this->Widths[k] = this->Settings.SpatialScale / std::sqrt(2.0) * points.SpacingAt(i);
          }
        }
      });
  }

  /// The engine on nodes. Distances are those of points, so that rows may be matched anew.
  std::unique_ptr<NormalFilter> MakeFilter(const PointSet& points, const BundleNodes& nodes,
    bool includeOwn, Execution& execution)
  {
    NormalFilterSettings settings;
    settings.Norm = GaussianNorm{ this->Settings.RangeScale / std::sqrt(2.0) };
    settings.Argument = NormalArgument::Chord;
    settings.SpatialSigma = this->Settings.SpatialScale / std::sqrt(2.0) * points.Spacing;
    settings.Weighting = SiteWeight::Area;
    settings.IncludeOwn = includeOwn;
    settings.Unoriented = this->Settings.Unoriented;
    auto filter = std::make_unique<NormalFilter>(nodes.Graph, settings);
    SiteGeometry geometry{ this->Positions, this->Areas, 1e-12 * points.Spacing };
    geometry.SpatialSigmas = points.LocalScale ? &this->Widths : nullptr;
    filter->SetGeometry(geometry, execution);
    return filter;
  }

  bool FilterNormals(const PointSet& points, BundleNodes& nodes, Execution& execution, double first,
    double last)
  {
    const NormalBundlesSettings& settings = this->Settings;
    MatchNodes(points.Neighbors, nodes.Normals, settings.Unoriented, nodes, execution);
    if (settings.NormalIterations < 1)
    {
      return true;
    }
    const PointPatchSettings patches{ static_cast<std::size_t>(
                                        std::max(0, settings.PatchNeighbors)),
      settings.PatchAgreement, settings.Unoriented, settings.PatchAgreement };
    const auto filter = this->MakeFilter(points, nodes, true, execution);
    Buffer<Vec3> guide;
    Buffer<Vec3> filtered;
    for (int iteration = 0; iteration < settings.NormalIterations; ++iteration)
    {
      const double begin = first + (last - first) * iteration / settings.NormalIterations;
      const double end = first + (last - first) * (iteration + 1) / settings.NormalIterations;
      InterruptedExecution interrupted(execution, begin, end);
      ComputePointPatches(nodes.Graph, nodes.Normals, patches, guide, interrupted);
      if (!interrupted.Proceed(begin))
      {
        return false;
      }
      MatchNodes(points.Neighbors, guide, settings.Unoriented, nodes, execution);
      filter->Sweep({ nodes.Normals, guide, guide, nodes.Normals }, filtered, execution);
      nodes.Normals.swap(filtered);
      MatchNodes(points.Neighbors, nodes.Normals, settings.Unoriented, nodes, execution);
    }
    return true;
  }

  bool MovePoints(PointSet& points, const BundleNodes& nodes, Execution& execution, double first,
    double last)
  {
    const NormalBundlesSettings& settings = this->Settings;
    if (settings.PointIterations < 1)
    {
      return true;
    }
    for (std::size_t k = 0; k < nodes.Size(); ++k)
    {
      const bool feature = nodes.CountAt(nodes.Points[k]) > 1;
      this->Areas[k] = feature ? std::max(0.0, settings.FeaturePull) : 1.0;
    }
    const auto filter = this->MakeFilter(points, nodes, false, execution);
    PointUpdateSettings update;
    update.Scheme = PointScheme::Gradient;
    update.Unoriented = settings.Unoriented;
    const NormalFilter::Fields fields{ nodes.Normals, nodes.Normals, nodes.Normals, nodes.Normals };
    Buffer<Vec3> displacements;
    Buffer<Vec3> places(points.Size());
    for (int iteration = 0; iteration < settings.PointIterations; ++iteration)
    {
      if (!execution.Proceed(first + (last - first) * iteration / settings.PointIterations))
      {
        return false;
      }
      ComputeDisplacements(*filter, fields, this->Positions, update, displacements, execution);
      execution.For(points.Size(),
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t i = begin; i < end; ++i)
          {
            places[i] = points.Positions[i];
            for (Index k = nodes.First[i]; k < nodes.First[i + 1]; ++k)
            {
              places[i] += displacements[k];
            }
          }
        });
      MoveTo(places, points, execution);
      execution.For(points.Size(),
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t i = begin; i < end; ++i)
          {
            for (Index k = nodes.First[i]; k < nodes.First[i + 1]; ++k)
            {
              this->Positions[k] = points.Positions[i];
            }
          }
        });
    }
    return true;
  }

  /// The mean of bundles is the normal that features leave with, but between two faces it is that
  /// of neither: what they start from is a normal of their bundle.
  void TakeOwnNormals(PointSet& points)
  {
    for (const OwnNormal& own : this->OwnNormals)
    {
      if (own.Point < points.Size() && points.Normals[own.Point] == own.Mean)
      {
        points.Normals[own.Point] = own.Normal;
      }
    }
    this->OwnNormals.clear();
  }

  void Finish(PointSet& points, const BundleNodes& nodes)
  {
    points.Classes.resize(points.Size());
    for (std::size_t i = 0; i < points.Size(); ++i)
    {
      const std::size_t count = nodes.CountAt(i);
      points.Classes[i] = count < 2 ? FeatureClass::Flat
        : count == 2                ? FeatureClass::Edge
                                    : FeatureClass::Corner;
      const Vec3 before = points.Normals[i];
      OwnNormal own{ static_cast<Index>(i), Vec3(0.0, 0.0, 0.0), before };
      double most = -2.0;
      for (Index k = nodes.First[i]; k < nodes.First[i + 1]; ++k)
      {
        const bool turned = this->Settings.Unoriented && nodes.Normals[k].dot(before) < 0.0;
        const Vec3 n = turned ? Vec3(-nodes.Normals[k]) : nodes.Normals[k];
        own.Mean += n;
        if (n.dot(before) > most)
        {
          most = n.dot(before);
          own.Normal = n;
        }
      }
      if (count > 1)
      {
        const double length = own.Mean.norm();
        own.Mean = length > 1e-12 ? Vec3(own.Mean / length) : own.Normal;
        this->OwnNormals.push_back(own);
      }
      points.Normals[i] = own.Mean;
      if (own.Mean.isZero(0.0))
      {
        points.Status[i] = PointStatus::Kept;
      }
    }
  }

  struct OwnNormal
  {
    Index Point;
    Vec3 Mean;   ///< of its bundle, what it left with
    Vec3 Normal; ///< of its bundle, the closest to what it came with
  };

  NormalBundlesSettings Settings;
  Buffer<double> Areas;
  Buffer<Vec3> Positions; ///< of nodes
  Buffer<double> Widths;  ///< of the spatial kernel, if scales are local
  std::vector<OwnNormal> OwnNormals;
};

}

std::unique_ptr<PointOperator> MakeNormalBundles(const NormalBundlesSettings& settings)
{
  return std::make_unique<NormalBundles>(settings);
}

}
