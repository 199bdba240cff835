// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file InputNeighbors.h
 * @brief Neighbours among points whose numbers matter: of equally distant ones, that with the
 * smaller number of the input comes first, although the search goes along a curve through space.
 */

#ifndef SurfaceDenoising_InputNeighbors_h
#define SurfaceDenoising_InputNeighbors_h

#include "NeighborGraph.h"

namespace SurfaceDenoising
{

/// Finite points in the order of FindPointOrder and FormRuns.
struct OrderedPoints
{
  Buffer<Index> Numbers; ///< in the input
  Buffer<Index> Places;  ///< where the points of the input are here
  Buffer<Vec3> Positions;

  OrderedPoints() = default;
  /// Positions are incomplete if the execution asked to stop.
  OrderedPoints(const Buffer<Vec3>& input, Execution& execution);
};

/// The rows of NearestPoints for the input, with its numbers. Of more than count points at one
/// place, any are taken.
NeighborGraph NearestOfInput(const OrderedPoints& points, std::size_t count, Execution& execution);

/// The other points at most radius away, nearest first; rows and entries are places.
NeighborGraph BallsOfInput(const OrderedPoints& points, double radius, Execution& execution);

}

#endif
