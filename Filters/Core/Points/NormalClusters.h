// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file NormalClusters.h
 * @brief Groups unit vectors by direction: spherical k-means.
 */

#ifndef SurfaceDenoising_NormalClusters_h
#define SurfaceDenoising_NormalClusters_h

#include "Types.h"

namespace SurfaceDenoising
{

struct NormalClusterSettings
{
  double Angle = 0.5235987755982988; ///< no member may be farther from its centre, radians
  int Maximum = 3;                   ///< clusters
  int Rounds = 10;
  /// Centres that are not this many times farther from one another than members are from theirs
  /// (root mean square, chords) are no clusters; 0: all are. A disc of evenly spread normals cut in
  /// two has 1.5, a line 3.5: that is how surfaces curve, edges have more.
  double Separation = 4.0;
  bool Unoriented = false; ///< n and -n are the same
};

struct NormalClusters
{
  std::vector<Vec3> Centres; ///< unit vectors
  std::vector<int> Of;       ///< the cluster of every normal
};

/**
 * Spherical k-means with one cluster, then two, and so on up to the maximum, until no member makes
 * a larger angle with its centre than the limit. A normal belongs to the centre with which it has
 * the largest dot product (of equal ones, the first), a centre is the normalised sum of its
 * members. It starts from the mean for one cluster; else from the member farthest from the mean,
 * the one farthest from that, the one farthest from both, and so on. Clusters that lose all members
 * are left out; if the others are not separated, all members are one cluster around their mean.
 *
 * Without orientation members count by |n . c| and are added with the sign that makes an acute
 * angle with the centre, in the first mean with side.
 *
 * Normals must be unit vectors and at least one.
 */
void ClusterNormals(const std::vector<Vec3>& normals, const Vec3& side,
  const NormalClusterSettings& settings, NormalClusters& clusters);

}

#endif
