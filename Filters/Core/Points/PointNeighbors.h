// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PointNeighbors.h
 * @brief The neighbours of points, and how far apart points are.
 */

#ifndef SurfaceDenoising_PointNeighbors_h
#define SurfaceDenoising_PointNeighbors_h

#include "NeighborGraph.h"

namespace SurfaceDenoising
{

enum class PointNeighborhood : int
{
  Nearest, ///< a number of nearest points
  Radius   ///< the points in a ball
};

struct PointNeighborSettings
{
  PointNeighborhood Kind = PointNeighborhood::Nearest;
  int Count = 16;          ///< how many nearest ones
  double Radius = 3.0;     ///< of the ball, in mean spacings, see PointSet
  int MaximumCount = 1000; ///< of more in the ball, the nearest count
};

/// The first count entries of every row.
NeighborGraph FirstNeighbors(const NeighborGraph& graph, std::size_t count, Execution& execution);

/// How many neighbours the spacing is taken from.
constexpr std::size_t SpacingNeighbors = 16;

/**
 * r_k sqrt(pi / k) for every point, where r_k is the distance of the last of its first k neighbours
 * and k = 16, or the length of the row if that is shorter; 0 without neighbours. The graph has
 * nearest points first.
 */
Buffer<double> PointSpacings(const Buffer<Vec3>& points, const NeighborGraph& nearest,
  Execution& execution);

/// The median of those above 0, see PointSet; 0 if there is none.
double MedianSpacing(const Buffer<double>& spacings);

/**
 * The count nearest other points of every point, nearest first, equally distant ones by number;
 * fewer if there are not as many points. Of more than count points at one place, any are taken, the
 * same for the same points in the same order.
 *
 * All points must be finite. They may have any order, but only that of FindPointOrder is fast:
 * several times as fast as a search tree, which is asked for one place after the other. Here every
 * point knows a bound for the distance of its last neighbour from the points before,
 * |p - q| + r_q.
 */
NeighborGraph NearestOrderedPoints(const Buffer<Vec3>& points, std::size_t count,
  Execution& execution);

/// The other points at most radius away from each point, nearest first, equally distant ones by
/// number, at most limit. Finite points in the order of FindPointOrder, likewise.
NeighborGraph PointsWithinRadius(const Buffer<Vec3>& points, double radius, std::size_t limit,
  Execution& execution);

}

#endif
