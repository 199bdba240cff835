// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file KdTree.h
 * @brief The points near a place. Hides nanoflann.
 */

#ifndef SurfaceDenoising_KdTree_h
#define SurfaceDenoising_KdTree_h

#include "Types.h"

#include <limits>

namespace SurfaceDenoising
{

/**
 * A search tree over points, which it copies. Queries may run on many threads at once.
 *
 * Points that are not finite are never found, and a query that is not finite finds nothing. Squared
 * distances must fit into a double. Of equally distant points at the border of what is found, those
 * with the lower numbers are meant; where distances to boxes are rounded, it may be another.
 */
class KdTree
{
public:
  explicit KdTree(const Buffer<Vec3>& points);
  ~KdTree();
  KdTree(const KdTree&) = delete;
  KdTree& operator=(const KdTree&) = delete;

  /**
   * The count points nearest to query, nearest first, equally distant ones by number; fewer if
   * there are fewer. A point of the tree finds itself. Of more than count points at the query, any
   * are found, the same for the same points in the same order: heaps of points would take too long
   * otherwise.
   */
  void Nearest(const Vec3& query, std::size_t count, std::vector<Index>& found) const;

  /// All points at most radius away from query, nearest first, equally distant ones by number; of
  /// more than limit, the nearest.
  void Within(const Vec3& query, double radius, std::vector<Index>& found,
    std::size_t limit = std::numeric_limits<std::size_t>::max()) const;

private:
  struct Tree;
  std::unique_ptr<Tree> Hidden;
};

}

#endif
