// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureCandidates.h"

#include "KdTree.h"
#include "MedialSkeleton.h"
#include "NormalFilter.h"

#include <cmath>

namespace SurfaceDenoising
{

Buffer<double> SimilarityScores(const NeighborGraph& neighbors, const Buffer<Vec3>& positions,
  const Buffer<Vec3>& normals, double sigma, Execution& execution)
{
  NormalFilterSettings settings;
  settings.Norm = GaussianNorm{ sigma / std::sqrt(2.0) };
  settings.Argument = NormalArgument::Chord;
  settings.Weighting = SiteWeight::Uniform;
  settings.Unoriented = true;
  NormalFilter filter(neighbors, settings);
  const Buffer<double> noAreas;
  filter.SetGeometry({ positions, noAreas, 0.0 }, execution);
  Buffer<double> scores(normals.size());
  filter.VisitWeights({ normals, normals, normals, normals }, execution,
    [&](std::size_t i, const double* weights)
    {
      const std::size_t count = neighbors.Row(i).size();
      double sum = 0.0;
      for (std::size_t k = 0; k < count; ++k)
      {
        sum += weights[k];
      }
      scores[i] = count > 0 ? sum / static_cast<double>(count) : 1.0;
    });
  return scores;
}

bool FindFeatures(const PointSet& points, const FeatureCandidateSettings& settings,
  Buffer<unsigned char>& features, Execution& execution, double first, double last)
{
  const Buffer<double> scores =
    SimilarityScores(points.Neighbors, points.Positions, points.Normals, settings.Scale, execution);
  features.resize(points.Size());
  Buffer<Vec3> candidates;
  for (std::size_t i = 0; i < points.Size(); ++i)
  {
    features[i] = scores[i] < settings.Threshold;
    if (features[i] && settings.SkeletonRadius > 0.0)
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

}
