// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PointNormals.h
 * @brief Normals of points from the positions around them, and consistent signs.
 */

#ifndef SurfaceDenoising_PointNormals_h
#define SurfaceDenoising_PointNormals_h

#include "NeighborGraph.h"

namespace SurfaceDenoising
{

/// Where the normals come from that a method starts with.
enum class NormalSource : int
{
  Automatic, ///< those given, if there are any; else RobustFit
  Given,     ///< those given; it is an error if there are none
  PlaneFit,  ///< of the plane that fits the neighbours best
  RobustFit  ///< the same with what lies on other planes left out
};

/// What is done about the signs of normals.
enum class NormalOrientation : int
{
  Automatic, ///< SpanningTree, unless given normals agree among neighbours already
  Keep,      ///< signs as they come; those of fits are arbitrary
  SpanningTree
};

struct PointNormalSettings
{
  NormalSource Source = NormalSource::Automatic;
  NormalOrientation Orientation = NormalOrientation::Automatic;
  int NumberOfNeighbors = 16; ///< that fits look at
};

/**
 * The normals of the planes through every point and its first count neighbours, see PlaneFit.h.
 * Zero where there is no plane: fewer than three different points, or all on a line.
 */
Buffer<Vec3> PlaneFitNormals(const Buffer<Vec3>& points, const NeighborGraph& nearest,
  std::size_t count, Execution& execution);

/**
 * Sharpens the normals of plane fits at edges, where they bisect the faces: three rounds of a
 * robust plane fit (PlaneFit.h, residuals held at 1% of the spacing) to the same neighbours and the
 * point itself, weighted by exp(-(theta_ij / (pi / 8))^2) with the angle theta_ij between the
 * normals of the round before, whatever their signs; all count the same if hardly any does (see
 * WeightedPatch). These are the first steps of moving robust PCA (E. Mattei, A. Castrodad 2016).
 * Returns false if the execution asked to stop.
 */
bool SharpenNormals(const Buffer<Vec3>& points, const NeighborGraph& nearest, double spacing,
  Buffer<Vec3>& normals, Execution& execution, double first, double last);

/// Share of the points, of those with a normal and a nearest point that has one as well, whose
/// normal makes an obtuse angle with that one's.
double ShareOfOpposedNormals(const NeighborGraph& nearest, const Buffer<Vec3>& normals,
  Execution& execution);

/**
 * Gives normals consistent signs along a minimum spanning tree of the graph with edges in either
 * direction and the lengths 1 - |n_i . n_j|: where the tree goes, normals make acute angles. (H.
 * Hoppe et al. 1992.) Each connected part then points outwards, sum n_i . (p_i - c) > 0 with the
 * mean c of its points; if it has no inside (the sum is below 5% of sum |p_i - c|), the normal of
 * its highest point has a positive z. Returns the number of connected parts; 0, with signs left as
 * they were, if the execution asked to stop.
 */
std::size_t OrientNormals(const Buffer<Vec3>& points, const NeighborGraph& graph,
  Buffer<Vec3>& normals, Execution& execution, double fraction);

}

#endif
