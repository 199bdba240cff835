// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PointPatches.h
 * @brief Guidance normals of points: the mean normals of their most consistent patches.
 *
 * The patch of site j are j and its first neighbours of the graph. Its inconsistency is
 *
 *   H = Phi R,  Phi = max |n_a - n_b|,  R = max |n_a - n_b| / (1e-9 + sum |n_a - n_b|)
 *
 * over all pairs of its members, where |.| is zero for pairs without a normal. The guidance of site
 * i is the mean normal, of unit length, of the patch with the least H among those of i and its
 * first neighbours whose sites have normals n_j with n_i . n_j >= 0.7; n_i if there is none. Y.
 * Zheng, G. Li, S. Wu, Y. Liu, Y. Gao, "Guided point cloud denoising via sharp feature skeletons",
 * The Visual Computer 33, 2017.
 */

#ifndef SurfaceDenoising_PointPatches_h
#define SurfaceDenoising_PointPatches_h

#include "NeighborGraph.h"

#include <limits>

namespace SurfaceDenoising
{

struct PointPatchSettings
{
  std::size_t Neighbors = 10; ///< of a site that belong to its patch, and whose patches it may take
  double Agreement = 0.7;     ///< the least n_i . n_j; -1: any
  bool Unoriented = false;    ///< members are turned to the side of n_j before they are compared
  /// Members of the patch of site j have n_j . n_a of at least this, so that patches end at edges;
  /// -1: all. Where faces are narrow there is no patch without points beyond an edge, and half of
  /// one face and half of the other is more consistent by H than a few of the other alone.
  double MemberAgreement = -1.0;
};

struct PointPatch
{
  double Inconsistency = std::numeric_limits<double>::infinity(); ///< H
  Vec3 Mean = Vec3(0.0, 0.0, 0.0);                                ///< unit length; zero: no mean
};

/// The patch of these unit normals.
PointPatch JudgePatch(const std::vector<Vec3>& members);

/// Guidance normals of all sites. Of equally consistent patches the one that comes first counts,
/// that of the site itself before those of its neighbours.
void ComputePointPatches(const NeighborGraph& graph, const Buffer<Vec3>& normals,
  const PointPatchSettings& settings, Buffer<Vec3>& guidance, Execution& execution);

}

#endif
