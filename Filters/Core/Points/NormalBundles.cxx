// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NormalBundles.h"

#include "BundleNodes.h"
#include "FeatureCandidates.h"
#include "InterruptedExecution.h"
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
    if (!FindFeatures(points, this->FeatureSettings(), features, execution, first, at(0.1)))
    {
      return false;
    }
    BundleNodes nodes;
    {
      BundleSettings settings;
      settings.Clusters.Angle = this->Settings.BundleAngle;
      settings.Clusters.Maximum = this->Settings.MaximumBundles;
      settings.Clusters.Separation = this->Settings.BundleSeparation;
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
    this->Areas.assign(nodes.Size(), 1.0);
    this->PlaceNodes(points, nodes, execution);
    if (!this->FilterNormals(points, nodes, execution, at(0.2), at(0.7)) ||
      !this->MovePoints(points, nodes, execution, at(0.7), last))
    {
      return false;
    }
    this->Finish(points, nodes);
    return true;
  }

private:
  FeatureCandidateSettings FeatureSettings() const
  {
    FeatureCandidateSettings settings;
    settings.Scale = this->Settings.CandidateScale;
    settings.Threshold = this->Settings.CandidateThreshold;
    settings.SkeletonRadius = this->Settings.UseSkeleton ? this->Settings.SkeletonRadius : 0.0;
    return settings;
  }

  /// Nodes are where their points are.
  void PlaceNodes(const PointSet& points, const BundleNodes& nodes, Execution& execution)
  {
    this->Positions.resize(nodes.Size());
    execution.For(nodes.Size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t k = begin; k < end; ++k)
        {
          this->Positions[k] = points.Positions[nodes.Points[k]];
        }
      });
  }

  /// The engine on nodes. Distances are those of points, so that rows may be matched anew.
  std::unique_ptr<NormalFilter> MakeFilter(const PointSet& points, const BundleNodes& nodes,
    bool includeOwn, Execution& execution)
  {
    const double width = this->Settings.SpatialScale / std::sqrt(2.0);
    NormalFilterSettings settings;
    settings.Norm = GaussianNorm{ this->Settings.RangeScale / std::sqrt(2.0) };
    settings.Argument = NormalArgument::Chord;
    settings.SpatialSigma = width * points.Spacing;
    settings.Weighting = SiteWeight::Area;
    settings.IncludeOwn = includeOwn;
    settings.Unoriented = this->Settings.Unoriented;
    auto filter = std::make_unique<NormalFilter>(nodes.Graph, settings);
    SiteGeometry geometry{ this->Positions, this->Areas, 1e-12 * points.Spacing };
    Buffer<double> widths;
    if (points.LocalScale)
    {
      widths.resize(nodes.Size());
      for (std::size_t k = 0; k < nodes.Size(); ++k)
      {
        widths[k] = width * points.SpacingAt(nodes.Points[k]);
      }
      geometry.SpatialSigmas = &widths;
    }
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
      settings.PatchAgreement, settings.Unoriented, settings.PatchMemberAgreement };
    const auto filter = this->MakeFilter(points, nodes, true, execution);
    Buffer<Vec3> guide;
    Buffer<Vec3> filtered;
    for (int iteration = 0; iteration < settings.NormalIterations; ++iteration)
    {
      const double begin = first + (last - first) * iteration / settings.NormalIterations;
      InterruptedExecution interrupted(execution, begin);
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
    Buffer<Vec3> ofNodes;
    Buffer<Vec3> ofPoints(points.Size());
    for (int iteration = 0; iteration < settings.PointIterations; ++iteration)
    {
      if (!execution.Proceed(first + (last - first) * iteration / settings.PointIterations))
      {
        return false;
      }
      ComputeDisplacements(*filter, fields, this->Positions, update, ofNodes, execution);
      execution.For(points.Size(),
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t i = begin; i < end; ++i)
          {
            ofPoints[i].setZero();
            for (Index k = nodes.First[i]; k < nodes.First[i + 1]; ++k)
            {
              ofPoints[i] += ofNodes[k];
            }
          }
        });
      MoveBy(ofPoints, points, execution);
      this->PlaceNodes(points, nodes, execution);
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
  std::vector<OwnNormal> OwnNormals;
};

}

std::unique_ptr<PointOperator> MakeNormalBundles(const NormalBundlesSettings& settings)
{
  return std::make_unique<NormalBundles>(settings);
}

}
