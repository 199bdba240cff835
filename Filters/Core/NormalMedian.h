// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file NormalMedian.h
 * @brief Medians of normals: one of the normals at hand is selected, nothing is averaged.
 */

#ifndef SurfaceDenoising_NormalMedian_h
#define SurfaceDenoising_NormalMedian_h

#include "NeighborGraph.h"

namespace SurfaceDenoising
{

/// What "the median of normals" means.
enum class MedianKind : int
{
  Angular,    ///< the neighbour in the middle if they are sorted by the angle to the own normal
  Directional ///< the one with the least sum of angles to all others, the own normal among them
};

/**
 * The vector directional median: of the normals of a site and its neighbours, the one with the
 * least sum of angles to all of them; on a tie the own one, then the first. (P. Trahanias, A.
 * Venetsanopoulos, "Vector directional filters", IEEE Trans. Image Processing 2(4), 1993.) Zero
 * vectors are left out; a site that sees nothing else gets zero. Unoriented normals are turned to
 * the side of the own one first.
 */
void DirectionalMedians(const NeighborGraph& graph, const Buffer<Vec3>& normals,
  Buffer<Vec3>& medians, Execution& execution, bool unoriented = false);

/// How often neighbours count in an angular median; at least 0.
struct MedianRepetitions
{
  int EdgeAdjacent = 1; ///< those that share an edge with the face
  int Other = 1;
};

/**
 * The angular median: the neighbours, without the face itself, are sorted by the angle to the own
 * normal, each as often as it counts, and the normal in the middle is taken, for an even number the
 * lower of two. (H. Yagou, Y. Ohtake, A. Belyaev, GMP 2002.) A face without normal takes the
 * directional median instead. Without neighbours the normal stays; the number of such faces is
 * returned.
 */
std::size_t AngularMedians(const NeighborGraph& graph, const TriangleMesh& mesh,
  const MedianRepetitions& repetitions, const Buffer<Vec3>& normals, Buffer<Vec3>& medians,
  Execution& execution);

}

#endif
