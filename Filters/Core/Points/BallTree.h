// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file BallTree.h
 * @brief The balls, each with a radius of its own, that contain a place.
 *
 * Who reaches a place cannot be asked with one radius: where density varies, the largest radius
 * finds far too much. The tree takes eight successive balls as a leaf and eight successive nodes as
 * a node, so that it is built in one pass; it is fast for points that follow a curve through space
 * (PointSet.h) and right for all.
 */

#ifndef SurfaceDenoising_BallTree_h
#define SurfaceDenoising_BallTree_h

#include "Execution.h"
#include "Types.h"

namespace SurfaceDenoising
{

class BallTree
{
public:
  /// The arrays must outlive the tree. A ball whose radius is not above 0 contains nothing.
  BallTree(const Buffer<Vec3>& centres, const Buffer<double>& radii, Execution& execution);

  /**
   * Calls use(j) for all balls with |place - c_j| < r_j + margin, in the order of their numbers.
   * With a margin, these are the balls that contain any place closer than that.
   */
  template <typename Use>
  void Visit(const Vec3& place, double margin, Use use) const
  {
    if (!this->Levels.empty())
    {
      this->VisitNode(this->Levels.size() - 1, 0, place, margin, use);
    }
  }

private:
  static constexpr std::size_t Fan = 8;

  /// A box around the centres, and the largest radius.
  struct Node
  {
    Vec3 Lowest;
    Vec3 Highest;
    double Radius;
  };

  /// Rounding keeps the order of distances: where a centre is near enough, its box is.
  static bool Reaches(const Node& node, const Vec3& place, double margin)
  {
    const Vec3 outside = (node.Lowest - place).cwiseMax(place - node.Highest).cwiseMax(0.0);
    const double reach = node.Radius + margin;
    return node.Radius > 0.0 && outside.squaredNorm() <= reach * reach;
  }

  template <typename Use>
  void VisitNode(std::size_t level, std::size_t node, const Vec3& place, double margin,
    Use& use) const
  {
    if (!Reaches(this->Levels[level][node], place, margin))
    {
      return;
    }
    const std::size_t first = node * Fan;
    if (level > 0)
    {
      const std::size_t last = std::min(first + Fan, this->Levels[level - 1].size());
      for (std::size_t child = first; child < last; ++child)
      {
        this->VisitNode(level - 1, child, place, margin, use);
      }
      return;
    }
    for (std::size_t j = first; j < std::min(first + Fan, this->Centres.size()); ++j)
    {
      const double reach = this->Radii[j] + margin;
      if (this->Radii[j] > 0.0 && (place - this->Centres[j]).squaredNorm() < reach * reach)
      {
        use(static_cast<Index>(j));
      }
    }
  }

  const Buffer<Vec3>& Centres;
  const Buffer<double>& Radii;
  std::vector<Buffer<Node>> Levels; ///< leaves first, the root last
};

}

#endif
