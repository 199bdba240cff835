// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file NormalBundles.h
 * @brief Several normals at features, guided by consistent patches.
 *
 * Y. Zheng, G. Li, S. Wu, Y. Liu, Y. Gao, "Guided point cloud denoising via sharp feature
 * skeletons", The Visual Computer 33, 2017. Partly reconstructed.
 */

#ifndef SurfaceDenoising_NormalBundles_h
#define SurfaceDenoising_NormalBundles_h

#include "PointOperator.h"

namespace SurfaceDenoising
{

struct NormalBundlesSettings
{
  double CandidateScale = 0.3;     ///< sigma of the similarity score, a chord
  double CandidateThreshold = 0.6; ///< tau_c: points with a lower score are candidates
  bool UseSkeleton = false;        ///< of the candidates, only those near their L1-medial skeleton
  double SkeletonRadius = 3.0;     ///< h of the skeleton, in spacings
  double BundleAngle = 0.5235987755982988; ///< largest angle of a member to its bundle, radians
  int MaximumBundles = 3;                  ///< normals per point: 2 at edges, 3 at corners
  double RangeScale = 0.3;                 ///< sigma of exp(-(|G_i - G_j| / sigma)^2), a chord
  double SpatialScale = 1.5;               ///< sigma_d of exp(-(d / sigma_d)^2), in spacings
  int PatchNeighbors = 10;
  double PatchAgreement = 0.7;
  int NormalIterations = 5;
  int PointIterations = 10;
  bool Unoriented = false;
};

std::unique_ptr<PointOperator> MakeNormalBundles(const NormalBundlesSettings& settings);

}

#endif
