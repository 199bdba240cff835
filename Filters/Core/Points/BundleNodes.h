// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file BundleNodes.h
 * @brief Points with several normals as sites of the normal filter.
 *
 * A node is a point with one of its normals; the nodes of a point are its bundle. The neighbours of
 * a node are the nodes of the neighbours of its point, of each the one whose normal matches best.
 */

#ifndef SurfaceDenoising_BundleNodes_h
#define SurfaceDenoising_BundleNodes_h

#include "NormalClusters.h"
#include "PointSet.h"

namespace SurfaceDenoising
{

struct BundleNodes
{
  Buffer<Index> First;  ///< nodes of point i are First[i] .. First[i + 1] - 1
  Buffer<Index> Points; ///< the point of every node
  Buffer<Vec3> Normals; ///< of every node
  NeighborGraph Graph;  ///< of nodes; rows are as long as those of their points

  std::size_t Size() const { return this->Points.size(); }
  std::size_t CountAt(std::size_t point) const
  {
    return this->First[point + 1] - this->First[point];
  }
};

struct BundleSettings
{
  NormalClusterSettings Clusters;
  double SpatialScale = 1.5; ///< sigma of exp(-(d / sigma)^2), in spacings; 0: no such factor
  double Reach = 0.75;       ///< largest distance of a point from its planes, spacings; 0: any
  std::size_t FewestFlat = 4;
};

/**
 * The bundles of all points. Points that are no features have their own normal. For a feature i,
 * the normals of the neighbours that are no features themselves (of all neighbours, if these are
 * fewer than FewestFlat) are clustered, see NormalClusters.h; if they are one cluster, i keeps its
 * own normal. With w_j = exp(-(d_ij / sigma)^2) over the members of a cluster, its plane has the
 * normal n = sum w_j n_j, normalised, and goes through sum w_j p_j / sum w_j. The bundle are the
 * normals of the planes within Reach of p_i; if there are none, all neighbours are clustered; if
 * there still are none, i keeps its own normal.
 *
 * Neighbours without a normal have no say. The graph has rows of the right lengths, without
 * neighbours yet.
 */
BundleNodes MakeBundles(const PointSet& points, const Buffer<unsigned char>& features,
  const BundleSettings& settings, Execution& execution);

/**
 * Fills the rows of the graph: node k sees of every neighbour of its point the node whose normal
 * has the largest dot product with directions[k] (of equal ones, the first), without orientation
 * the largest in absolute value. Order within rows is that of the neighbours of points.
 */
void MatchNodes(const NeighborGraph& neighbors, const Buffer<Vec3>& directions, bool unoriented,
  BundleNodes& nodes, Execution& execution);

}

#endif
