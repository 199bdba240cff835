// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file NormalBundles.h
 * @brief Several normals at features, guided by consistent patches.
 *
 * One iteration:
 *
 * 1. Candidates for features are points whose normals differ from those around them
 *    (FeatureCandidates.h); if wanted, of these only the ones at most h / 2 from their L1-medial
 *    skeleton (MedialSkeleton.h).
 * 2. A feature gets a bundle of one to three normals by spherical k-means over those of its
 *    neighbours (BundleNodes.h): two at edges, three at corners. Every point with one of its
 *    normals is a node; it sees of each neighbour the node whose normal matches best.
 * 3. Several times: guidance normals G of nodes from their most consistent patches
 *    (PointPatches.h), then n_k' = normalise(sum_l exp(-(d_kl / sigma_d)^2) exp(-(|G_k - G_l| /
 *    sigma)^2) n_l) over the node itself and the nodes it sees, matched by G_k.
 * 4. Several times: points move by the gradient step of PointUpdate.h, summed over their bundle,
 *    with the weights exp(-(d_kl / sigma_d)^2) exp(-(|n_k - n_l| / sigma)^2). Two planes pull a
 * point to an edge, three to a corner.
 *
 * The normal of a point with several is their normalised mean; the next iteration starts with that
 * of the bundle closest to what it had. Y. Zheng, G. Li, S. Wu, Y. Liu, Y. Gao, "Guided point cloud
 * denoising via sharp feature skeletons", The Visual Computer 33, 2017.
 *
 * Reconstructed: the threshold of candidates, how many clusters, the matching of nodes, the
 * agreement of patches and the position update. Changed against the plain reading, each for errors
 * near edges that it causes:
 *
 * - Patches end where normals do not agree with that of their centre. Near an edge no patch of ten
 *   is free of points beyond it.
 * - A bundle has the planes that pass near its point. Without that points as far as a
 *   neighbourhood from an edge jump onto it.
 * - Clusters must be apart for the spread within them. Normals of curved surfaces fill the space in
 *   between, and so do those of fits across edges.
 * - Where all normals around are alike, a candidate keeps its own. Their mean, for which the edges
 *   of flat roofs are narrow enough, is that of a bevel.
 * - Points with several normals pull others with a small weight. They start beside the edge, below
 *   the plane of the other face, and pull that face down to them: the edge gets a chamfer, and a
 *   valley fills.
 *
 * For n and -n alike (Unoriented), clusters are those of axes, which is weaker: opposite faces of a
 * thin plate are one.
 *
 * Limit displacements to one or two spacings (PointDenoising.h): a feature with a wrong bundle runs
 * away along its planes.
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
  double BundleAngle = 0.4363323129985824; ///< largest angle of a member to its bundle, radians
  double BundleSeparation = 4.0;           ///< of clusters, see NormalClusters.h; 0: any
  int MaximumBundles = 3;    ///< normals per point: 2 at edges, 3 at corners; 1: no bundles
  double BundleReach = 0.75; ///< how far a point may be from its planes, in spacings; 0: any
  double RangeScale = 0.35;  ///< sigma of exp(-(|G_i - G_j| / sigma)^2), a chord
  double SpatialScale = 1.5; ///< sigma_d of exp(-(d / sigma_d)^2), in spacings
  int PatchNeighbors = 6;    ///< of a node that belong to its patch, and whose patches it may take
  double PatchAgreement = 0.9;       ///< least n_i . n_j of patches taken
  double PatchMemberAgreement = 0.9; ///< least n_j . n_a of the members of a patch
  int NormalIterations = 5;
  int PointIterations = 10;
  double FeaturePull = 0.1; ///< weight of points with several normals in updates of positions
  bool Unoriented = false;
};

std::unique_ptr<PointOperator> MakeNormalBundles(const NormalBundlesSettings& settings);

}

#endif
