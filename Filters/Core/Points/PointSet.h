// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PointSet.h
 * @brief A surface given by points, as the methods see it: positions, normals, neighbours.
 *
 * Points are sites of the normal filter as the faces of a mesh are. All positions are finite, and
 * numbers follow a curve through space, so that neighbours in space are neighbours in memory and
 * results do not depend on the order of the input.
 */

#ifndef SurfaceDenoising_PointSet_h
#define SurfaceDenoising_PointSet_h

#include "NeighborGraph.h"

namespace SurfaceDenoising
{

/// What a point lies on, if a method tells.
enum class FeatureClass : unsigned char
{
  Flat = 0,
  Edge = 1,
  Corner = 2
};

/// What became of a point.
enum class PointStatus : unsigned char
{
  Filtered = 0,
  Kept = 1,     ///< too few neighbours, no weight, or moved too far: left as it was
  NotFinite = 2 ///< a coordinate is not a number; nobody's neighbour
};

struct PointSet
{
  Buffer<Vec3> Positions;
  Buffer<Vec3> Normals; ///< unit vectors, or zero where there is none

  Buffer<Vec3> Start;      ///< positions before the first step
  NeighborGraph Neighbors; ///< nearest first, without the point itself

  /**
   * The spacing s_i of every point, r_k sqrt(pi / k) with the distance r_k of its k-th nearest
   * point, k = 16: that of a square grid with as many points per area. Spacing is the median, a
   * length that neither outliers nor double points nor noise change much.
   */
  Buffer<double> Spacings;
  double Spacing = 0.0;
  bool LocalScale = false; ///< lengths of methods are relative to s_i, not to the median

  double MaximumDisplacement = 0.0; ///< from the start, a length; 0: as far as it goes

  Buffer<FeatureClass> Classes; ///< if the method tells
  Buffer<PointStatus> Status;

  std::size_t Size() const { return this->Positions.size(); }

  /// What lengths are relative to at a point.
  double SpacingAt(std::size_t i) const
  {
    return this->LocalScale ? this->Spacings[i] : this->Spacing;
  }
};

}

#endif
