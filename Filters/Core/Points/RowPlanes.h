// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file RowPlanes.h
 * @brief Planes through points and their neighbours with the weights of a NormalFilter.
 */

#ifndef SurfaceDenoising_RowPlanes_h
#define SurfaceDenoising_RowPlanes_h

#include "NormalFilter.h"
#include "PlaneFit.h"

namespace SurfaceDenoising
{

/**
 * The normals of the planes that fit the weighted rows best, see PlaneFit.h, on the side of the
 * current normals; those where there is no plane. The plane at site i is that of its neighbours'
 * positions, with its own if the filter includes it.
 */
void FitPlanes(const NormalFilter& filter, const NormalFilter::Fields& fields,
  const Buffer<Vec3>& positions, Buffer<Vec3>& fitted, Execution& execution);

/// A point and its neighbours relative to it, and what they count in a fit.
struct WeightedPatch
{
  std::vector<Vec3> Points; ///< first the point itself
  std::vector<double> Weights;
  bool Uniform = false; ///< weights were not taken over: all are 1

  /**
   * Takes the row of point i with the weights of a filter that includes it. Fewer than four weights
   * above 0.001 leave no plane to be found, and all count 1: a point with a normal unlike all
   * others, which its neighbours ignore, then has a chance to join them.
   */
  void Take(const Buffer<Vec3>& positions, std::size_t i, Span<Index> row, const double* weights);
};

/// A filter over the graph with the weights exp(-(theta_ij / sigma)^2), theta_ij the angle between
/// normals whatever their signs, for a point and its neighbours.
NormalFilterSettings WeightsBySimilarNormals(double sigma);

}

#endif
