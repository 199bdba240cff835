// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureCandidates.h"

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
  const Buffer<double> ones(normals.size(), 1.0);
  filter.SetGeometry({ positions, ones, 0.0 }, execution);
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

}
