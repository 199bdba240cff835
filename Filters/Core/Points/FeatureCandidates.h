// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file FeatureCandidates.h
 * @brief Points whose normals differ from those around them.
 *
 * The score of point i is the mean similarity of its normal to those of its neighbours,
 *
 *   a_i = 1 / |N(i)|  sum_j exp(-(|n_i - s_ij n_j| / sigma)^2),   s_ij = sign(n_i . n_j),
 *
 * in [0, 1], whatever the signs of normals; points with a low score are candidates for features. Y.
 * Zheng, G. Li, S. Wu, Y. Liu, Y. Gao, "Guided point cloud denoising via sharp feature skeletons",
 * The Visual Computer 33, 2017. The threshold is reconstructed.
 */

#ifndef SurfaceDenoising_FeatureCandidates_h
#define SurfaceDenoising_FeatureCandidates_h

#include "PointSet.h"

namespace SurfaceDenoising
{

struct FeatureCandidateSettings
{
  double Scale = 0.3;          ///< sigma, a chord above 0
  double Threshold = 0.6;      ///< candidates have lower scores
  double SkeletonRadius = 0.0; ///< h of the skeleton, in spacings; 0: no skeleton
};

/// a_i of all points; 1 without a normal or without neighbours.
Buffer<double> SimilarityScores(const NeighborGraph& neighbors, const Buffer<Vec3>& positions,
  const Buffer<Vec3>& normals, double sigma, Execution& execution);

/**
 * Marks the points that are features: the candidates, or of them only those at most h / 2 from
 * their skeleton (MedialSkeleton.h), which is where candidates are many and not a stray one.
 * Returns false if the execution asked to stop.
 */
bool FindFeatures(const PointSet& points, const FeatureCandidateSettings& settings,
  Buffer<unsigned char>& features, Execution& execution, double first, double last);

}

#endif
