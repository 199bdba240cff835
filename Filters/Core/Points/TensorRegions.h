// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file TensorRegions.h
 * @brief Plane fits to the part of the neighbourhood that lies on one face.
 *
 * Between two points a and b, a at the place p_a with the normal n_a,
 *
 *   g_ab = exp(-(s^2 + c kappa^2) / sigma^2),  kappa = 2 sin(theta / 2) / d,  s = theta / kappa
 *
 * with the angle theta between the normals, whatever their signs, and d = max(|p_a - p_b|, s_0 /
 * 2): kappa and s are the curvature and the length of the arc from one to the other. The bound on d
 * keeps noise between close points from looking like a bend. An outer iteration is
 *
 *   1. The tensor of the normals around i with the weights g_ij (NormalTensor.h) has the
 *      eigenvalues l1 >= l2 >= l3. i lies on a feature if 1.5 (l2 + l3) is above a threshold and
 *      stands out: at least 1.5 times what a quarter of i and its neighbours are below. It is on a
 *      corner if l3 > l2 - l3, else on an edge.
 *   2. The seed of i is i itself, or if that is on a feature, the neighbour a on no feature with
 *      the least |n_a . (p_a - p_i)| + |p_a - p_i| / 4: the face whose plane is closest.
 *   3. The region R_i are those of i and its neighbours with g_aj at least a threshold, seen from
 *      the seed a, and not fewer than the best five. The new normal is that of the plane that fits
 *      them best with weights exp(-(|p_i - p_j| / (sigma / 2))^2), on the side of n_a.
 *   4. i moves by its balanced height (PointUpdate.h) over R_i with these weights, the point itself
 *      among them if it belongs to R_i.
 *
 * M. K. Park, S. J. Lee, I. Y. Jang, Y. Y. Lee, K. H. Lee, "Feature-aware filtering for point-set
 * surface denoising", Computers and Graphics 37(6), 2013. The weight g and the three stages (detect
 * features, compute normals, move points) are those of the paper. Seeds, how regions grow and the
 * kind of update are reconstructed, and classes are told apart as tensor voting does. That features
 * stand out is ours: where a surface is bent all over, a threshold alone finds features in places,
 * and their points leave the surface for the planes of seeds far away.
 */

#ifndef SurfaceDenoising_TensorRegions_h
#define SurfaceDenoising_TensorRegions_h

#include "PointOperator.h"

namespace SurfaceDenoising
{

struct TensorRegionsSettings
{
  double Range = 4.0; ///< sigma, in spacings
  /// c over the fourth power of the spacing: -16 ln(0.1) (Range - 1) / pi^2, that of tensor voting.
  double BendFactor = 11.198431;
  double FeatureThreshold = 0.1; ///< of 1.5 (l2 + l3), in [0, 1]
  double FeatureContrast = 1.5;  ///< how much features stand out; 0: the threshold alone
  double RegionThreshold = 0.6;  ///< of g, in [0, 1]
  int LeastMembers = 5;          ///< of the region
  /// Points on features go where the quadric of their own and all their neighbours' planes is
  /// least, without weights, unless that is more than a spacing away.
  bool QuadricAtFeatures = false;
};

std::unique_ptr<PointOperator> MakeTensorRegions(const TensorRegionsSettings& settings);

}

#endif
