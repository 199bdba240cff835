// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file SurfaceBall.h
 * @brief What lies around a vertex, within a radius and along the surface.
 */

#ifndef SurfaceDenoising_SurfaceBall_h
#define SurfaceDenoising_SurfaceBall_h

#include "../IndexSet.h"
#include "../TriangleMesh.h"

namespace SurfaceDenoising
{

/**
 * The elements within a radius of a vertex, and their weights in a bilateral filter. Growth starts
 * at the vertex and goes on only through what was within the radius: the far side of a thin wall is
 * close but not reached. Scratch memory for one thread, used again for every vertex.
 *
 * What lies on the sphere belongs to the ball. On regular meshes many elements do, so that the
 * radius has some slack: whether they belong must not be a matter of rounding.
 */
class SurfaceBall
{
public:
  /// Vertices, v itself first, reached along edges.
  void GrowVertices(const CompressedRows& rings, const Buffer<Vec3>& positions, Index v,
    double radius);

  /// Faces whose centroids are within the radius, reached through faces that share a vertex.
  void GrowFaces(const TriangleMesh& mesh, const CompressedRows& stars,
    const Buffer<Vec3>& centroids, Index v, double radius);

  std::size_t Size() const { return this->Found.size(); }
  Index operator[](std::size_t k) const { return this->Found[k]; }

  /// exp(-distance^2 / (2 spatialScale^2)) exp(-height^2 / (2 rangeScale^2)) for each element.
  const Buffer<double>& Weigh(double spatialScale, double rangeScale);

  /// Of the elements over a plane, 0 until the caller fills them in.
  Buffer<double> Heights;

private:
  Buffer<Index> Found;
  Buffer<double> Squares; ///< of distances from the vertex
  Buffer<double> Weights;
  Buffer<Index> Corners; ///< vertices of faces that were found
  IndexSet Seen;
  IndexSet SeenCorners;
};

}

#endif
