// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file TriangleTree.h
 * @brief The face of a mesh that is nearest to a position, and its distance.
 *
 * The hierarchy of bounding boxes is Eigen's. VTK's cell locators took some twenty times as long
 * for the distances between two meshes of half a million faces.
 */

#ifndef SurfaceDenoising_TriangleTree_h
#define SurfaceDenoising_TriangleTree_h

#include "TriangleMesh.h"

#include <unsupported/Eigen/BVH>

#include <limits>

namespace SurfaceDenoising
{

/// Squared distance of p from the triangle a, b, c, which must have an area.
double SquaredDistanceToTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

class TriangleTree
{
public:
  struct Hit
  {
    double Distance = std::numeric_limits<double>::quiet_NaN();
    Index Face = NoIndex;
  };

  /// Of the faces with an area above 0, whose corners it copies. They must be finite.
  TriangleTree(const TriangleMesh& mesh, const Buffer<double>& areas);

  /**
   * The nearest face; of equally near ones that with the lowest number. An empty Hit if there are
   * no faces or the position is not finite (or beyond 1e100). May be asked from many threads at
   * once.
   */
  Hit Nearest(const Vec3& position) const;

private:
  struct Leaf
  {
    std::array<Vec3, 3> Corners;
    Index Face;
  };
  class Search;

  Eigen::KdBVH<double, 3, Leaf> Tree;
  bool IsEmpty = true;
};

}

#endif
