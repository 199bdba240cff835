// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PointMetrics.h
 * @brief How far one set of points is from another, in numbers.
 *
 * Points that are not finite, or beyond 1e100, are no points of a set: they have no distance and
 * count nowhere. As in Metrics.h, what is not defined is NaN.
 */

#ifndef SurfaceDenoising_PointMetrics_h
#define SurfaceDenoising_PointMetrics_h

#include "Execution.h"
#include "Types.h"

namespace SurfaceDenoising
{

/// True unless the point is not finite or so far away that squares of distances overflow.
inline bool IsPlace(const Vec3& point) { return point.squaredNorm() < 1e200; }

/// The nearest face or point of something for many positions.
struct NearestElements
{
  Buffer<double> Distances; ///< NaN if there is none
  Buffer<Index> Numbers;    ///< NoIndex if there is none
};

/// The point nearest to each position, of equally near ones that with the lowest number.
NearestElements FindNearestPoints(const Buffer<Vec3>& points, const Buffer<Vec3>& positions,
  Execution& execution);

/// Distances between a set of points X and a reference Y.
struct PointSetDistances
{
  double Chamfer;        ///< (mean_x min_y |x - y| + mean_y min_x |x - y|) / 2
  double SquaredChamfer; ///< mean_x min_y |x - y|^2 + mean_y min_x |x - y|^2
  double ToReference;    ///< max_x min_y |x - y|
  double FromReference;  ///< max_y min_x |x - y|
  double Hausdorff;      ///< the larger of the two
};

/// From the distances of the points of either set to the other set; NaN for an empty set.
PointSetDistances ComparePointSets(const Buffer<double>& toReference,
  const Buffer<double>& fromReference, Execution& execution);

/// The distance of each point to the nearest other one, 0 if there is one at the same place; NaN
/// without another one.
Buffer<double> NearestSpacings(const Buffer<Vec3>& points, Execution& execution);

/// Standard deviation (of the population) / mean. NaN if there are no values or their mean is 0.
double Variation(const Buffer<double>& values, Execution& execution);

}

#endif
