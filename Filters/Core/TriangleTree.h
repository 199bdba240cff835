// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file TriangleTree.h
 * @brief The face of a mesh that is nearest to a position, and its distance.
 *
 * A binary tree of bounding boxes. Unlike the cell locators of VTK it does not mark visited cells,
 * so that a query takes a small fraction of their time on large meshes.
 */

#ifndef SurfaceDenoising_TriangleTree_h
#define SurfaceDenoising_TriangleTree_h

#include "TriangleMesh.h"

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

  /// An inner node is followed by its first child.
  struct Node
  {
    Vec3 Low;
    Vec3 High;
    Index FirstLeaf;
    Index NumberOfLeaves; ///< 0: an inner node
    Index SecondChild;
  };

  void Build(std::size_t first, std::size_t last);

  Buffer<Leaf> Leaves;
  Buffer<Node> Nodes;
};

}

#endif
