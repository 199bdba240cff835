// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file NormalTensor.h
 * @brief What the tensor of the normals around a point tells about features.
 *
 * T_i = sum_j w_ij n_j n_j^T / sum_j w_ij, with eigenvalues l1 >= l2 >= l3 whose sum is 1: (1, 0,
 * 0) on a face, (1/2, 1/2, 0) at a right-angled edge, (1/3, 1/3, 1/3) at the corner of a cube. The
 * signs of normals do not matter.
 */

#ifndef SurfaceDenoising_NormalTensor_h
#define SurfaceDenoising_NormalTensor_h

#include "NormalFilter.h"
#include "PointSet.h"

namespace SurfaceDenoising
{

/**
 * The eigenvalues l1, l2, l3 at site i from the weights of its row, those of the site itself first
 * if the filter includes it. All zero if no neighbour with a normal has weight.
 */
Vec3 NormalTensorValues(const NormalFilter& filter, const Buffer<Vec3>& normals, std::size_t i,
  const double* weights);

/// 1.5 (l2 + l3), in [0, 1].
inline double FeatureIntensity(const Vec3& values) { return 1.5 * (values[1] + values[2]); }

/**
 * Who lies on features, by the tensors with the weights of the filter: those with an intensity
 * above threshold and at least contrast times what a quarter of the site and its neighbours are
 * below. It is a corner if l3 > l2 - l3, else an edge.
 */
void FindFeatures(const NormalFilter& filter, const Buffer<Vec3>& normals, double threshold,
  double contrast, Buffer<FeatureClass>& classes, Execution& execution);

}

#endif
