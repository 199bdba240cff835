// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file SpatialOrder.h
 * @brief Numbers faces, vertices and points so that neighbours in space are neighbours in memory.
 *
 * Most files are written patch by patch, but some are not: then every look at a neighbour waits for
 * main memory, and the work takes about four times as long.
 */

#ifndef SurfaceDenoising_SpatialOrder_h
#define SurfaceDenoising_SpatialOrder_h

#include "TriangleMesh.h"

namespace SurfaceDenoising
{

/**
 * True if the mesh does not fit into caches and its successive faces, or successive vertices, lie
 * more than 20 edge lengths apart on average.
 */
bool IsScattered(const TriangleMesh& mesh, Execution& execution);

/// Old numbers in the new order.
struct SpatialOrder
{
  Buffer<Index> Faces;
  Buffer<Index> Vertices;
};

/// Faces along a Z-order curve through their centroids, vertices as faces use them, others last.
SpatialOrder FindSpatialOrder(const TriangleMesh& mesh, Execution& execution);

/**
 * The numbers of the finite points along a Z-order curve. Points in one cell of the curve follow
 * one another by their coordinates, coincident ones by their vectors (one per point, or none at
 * all): the order is that of the places, not that of the numbers; any order, if the execution asked
 * to stop.
 */
Buffer<Index> FindPointOrder(const Buffer<Vec3>& points, const Buffer<Vec3>& vectors,
  Execution& execution);

/// The mesh with new numbers.
TriangleMesh Reorder(const TriangleMesh& mesh, const SpatialOrder& order);

/// ordered[i] = values[order[i]].
template <typename Value>
Buffer<Value> Gather(const Buffer<Value>& values, const Buffer<Index>& order, Execution& execution)
{
  Buffer<Value> ordered(order.size());
  execution.For(order.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        ordered[i] = values[order[i]];
      }
    });
  return ordered;
}

/// The same on the calling thread.
template <typename Value>
Buffer<Value> Gather(const Buffer<Value>& values, const Buffer<Index>& order)
{
  Execution here;
  return Gather(values, order, here);
}

/// values[order[i]] = ordered[i].
template <typename Value>
void Scatter(const Buffer<Value>& ordered, const Buffer<Index>& order, Buffer<Value>& values)
{
  values.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    values[order[i]] = ordered[i];
  }
}

}

#endif
