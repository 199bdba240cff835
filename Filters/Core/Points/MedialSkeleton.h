// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file MedialSkeleton.h
 * @brief The L1-medial skeleton of a cloud: fewer points, drawn to its middle and spread along it.
 *
 * With theta(r) = exp(-(2 r / h)^2) each of the skeleton's points x_i goes, step by step, to
 *
 *   sum_j a_ij q_j / sum_j a_ij  +  0.35 D_i sum_k b_ik (x_i - x_k) / sum_k b_ik,
 *   a_ij = theta(|x_i - q_j|) / |x_i - q_j|,   b_ik = theta(|x_i - x_k|) / |x_i - x_k|^2,
 *
 * over the points q_j of the cloud and x_k of the skeleton at most h away: to the median of what is
 * around and away from one another. D_i in [1/3, 1] is the share of the largest eigenvalue of
 * sum_k theta (x_i - x_k) (x_i - x_k)^T, large on branches; 0 without neighbours. H. Huang, S. Wu,
 * D. Cohen-Or, M. Gong, H. Zhang, G. Li, B. Chen, "L1-medial skeleton of point cloud", SIGGRAPH
 * 2013, with one h throughout.
 *
 * Reconstructed: distances count as at least h / 10, where a point would stay on its own place for
 * ever. The skeleton starts from evenly picked points of the cloud, not random ones, and from half
 * of them, not a twentieth: the candidates for features are narrow bands, along which a twentieth
 * would be ten spacings apart.
 */

#ifndef SurfaceDenoising_MedialSkeleton_h
#define SurfaceDenoising_MedialSkeleton_h

#include "Execution.h"

namespace SurfaceDenoising
{

struct MedialSkeletonSettings
{
  double Radius = 1.0;     ///< h, a length
  double Repulsion = 0.35; ///< factor of the second sum
  double Share = 0.5;      ///< of the points of the cloud that the skeleton starts from ...
  std::size_t Fewest = 50; ///< ... but at least so many, if there are
  int Iterations = 30;
};

/// Returns false if the execution asked to stop. Points of the cloud must be finite.
bool FindMedialSkeleton(const Buffer<Vec3>& cloud, const MedialSkeletonSettings& settings,
  Buffer<Vec3>& skeleton, Execution& execution, double first, double last);

}

#endif
