// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file NormalFilter.h
 * @brief The engine: robust weighted means of normals over a neighbourhood graph.
 *
 * One sweep gives every site i, face or point,
 *
 *   n_i' = normalise( sum_j  a_j f(|c_i - c_j|) g(x_ij) n_j )
 *
 * over its neighbours j, and over itself if it counts among them. g is the weight function of an
 * error norm, x_ij measures how much the normals differ, f is the spatial kernel, a_j an area. All
 * methods are settings of this sum.
 *
 * The part a_j f(|c_i - c_j|) stays the same while only normals change. It is computed once, so
 * that a sweep streams through two flat arrays. A sweep reads one field and writes another
 * (Jacobi): the result depends neither on the order of sites nor on the number of threads.
 */

#ifndef SurfaceDenoising_NormalFilter_h
#define SurfaceDenoising_NormalFilter_h

#include "ErrorNorm.h"
#include "NeighborGraph.h"

namespace SurfaceDenoising
{

/// x_ij, what an error norm is applied to.
enum class NormalArgument : int
{
  Chord,               ///< |n_i - n_j|, in [0, 2]
  Angle,               ///< angle between n_i and n_j in radians, in [0, pi]
  DirectionalCurvature ///< angle / |c_i - c_j|, in radians per length
};

struct NormalFilterSettings
{
  ErrorNorm Norm = GaussianNorm{ 0.35 };
  NormalArgument Argument = NormalArgument::Chord;
  double SpatialSigma = 0.0; ///< f(d) = exp(-d^2 / (2 SpatialSigma^2)), a length; 0: f = 1
  bool AreaWeighted = true;  ///< a_j is the area of site j; otherwise 1
  bool IncludeOwn = false;   ///< site i is one of its own neighbours
};

class NormalFilter
{
public:
  /// The graph must outlive the filter.
  NormalFilter(const NeighborGraph& graph, const NormalFilterSettings& settings);

  /**
   * Where the sites are and how large they are; call it again when they moved. Sites with area 0
   * are degenerate: they get no weight, whether weights use areas or not. Distances are at least
   * shortest when a curvature divides by them.
   */
  void SetGeometry(const Buffer<Vec3>& positions, const Buffer<double>& areas, double shortest,
    Execution& execution);

  /// The fields of normals that a sweep reads.
  struct Fields
  {
    const Buffer<Vec3>& Current;  ///< kept where there is nothing to average
    const Buffer<Vec3>& Centre;   ///< x_ij compares Centre[i] ...
    const Buffer<Vec3>& Compared; ///< ... with Compared[j]
    const Buffer<Vec3>& Data;     ///< what is averaged
  };

  /**
   * One sweep. Normals are unit vectors or zero. A site whose centre is zero has no opinion: all
   * its neighbours get the weight of x = 0. A site keeps its current normal if no neighbour has
   * weight or the weighted normals cancel; the number of such sites is returned. filtered must be
   * none of the fields.
   */
  std::size_t Sweep(const Fields& fields, Buffer<Vec3>& filtered, Execution& execution) const;

  /// The usual sweep: the current normals are centre, compared and averaged.
  std::size_t Sweep(const Buffer<Vec3>& current, Buffer<Vec3>& filtered, Execution& execution) const
  {
    return this->Sweep({ current, current, current, current }, filtered, execution);
  }

private:
  const NeighborGraph& Graph;
  NormalFilterSettings Settings;
  std::size_t Capacity = 0; ///< entries of a block: some hundred, or those of the longest row

  /// Entries of row i, first the site itself if it is included, begin at Offsets[i] + i *
  /// IncludeOwn.
  Buffer<double> FixedWeights;
  Buffer<double> InverseSquaredDistances; ///< for directional curvature only
};

}

#endif
