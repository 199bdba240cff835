// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleTree.h"

#include <algorithm>
#include <cmath>

namespace SurfaceDenoising
{

namespace
{

constexpr std::size_t LeavesPerNode = 4;

/// Positions beyond are as good as infinite: products of differences would overflow.
constexpr double LargestSquare = 1e200;

/// Each level halves the leaves, of which there are fewer than 2^32.
constexpr int LargestDepth = 32;

double SquaredDistanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b)
{
  const Vec3 edge = b - a;
  const double t = (p - a).dot(edge) / edge.squaredNorm();
  return (a + std::clamp(t, 0.0, 1.0) * edge - p).squaredNorm();
}

double SquaredDistanceToBox(const Vec3& p, const Vec3& low, const Vec3& high)
{
  return (low - p).cwiseMax(p - high).cwiseMax(0.0).squaredNorm();
}

}

double SquaredDistanceToTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 normal = (b - a).cross(c - a);
  auto isInside = [&](const Vec3& from, const Vec3& to)
  { return (to - from).cross(p - from).dot(normal) >= 0.0; };
  if (isInside(a, b) && isInside(b, c) && isInside(c, a))
  {
    const double height = (p - a).dot(normal);
    return height * height / normal.squaredNorm();
  }
  return std::min({ SquaredDistanceToSegment(p, a, b), SquaredDistanceToSegment(p, b, c),
    SquaredDistanceToSegment(p, c, a) });
}

TriangleTree::TriangleTree(const TriangleMesh& mesh, const Buffer<double>& areas)
{
  this->Leaves.reserve(mesh.NumberOfFaces());
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    if (areas[f] > 0.0)
    {
      const Triangle& t = mesh.Triangles[f];
      this->Leaves.push_back({ { mesh.Positions[t[0]], mesh.Positions[t[1]], mesh.Positions[t[2]] },
        static_cast<Index>(f) });
    }
  }
  if (!this->Leaves.empty())
  {
    this->Build(0, this->Leaves.size());
  }
}

void TriangleTree::Build(std::size_t first, std::size_t last)
{
  const auto begin = this->Leaves.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = this->Leaves.begin() + static_cast<std::ptrdiff_t>(last);
  Eigen::AlignedBox3d box;
  Eigen::AlignedBox3d centroids; // thrice as large
  for (auto leaf = begin; leaf != end; ++leaf)
  {
    for (const Vec3& corner : leaf->Corners)
    {
      box.extend(corner);
    }
    centroids.extend(leaf->Corners[0] + leaf->Corners[1] + leaf->Corners[2]);
  }

  const std::size_t node = this->Nodes.size();
  const bool isLast = last - first <= LeavesPerNode;
  this->Nodes.push_back({ box.min(), box.max(), static_cast<Index>(first),
    isLast ? static_cast<Index>(last - first) : 0, NoIndex });
  if (isLast)
  {
    return;
  }
  Eigen::Index axis = 0;
  centroids.sizes().maxCoeff(&axis);
  const std::size_t half = first + (last - first) / 2;
  auto isBefore = [axis](const Leaf& a, const Leaf& b)
  {
    const double atA = a.Corners[0][axis] + a.Corners[1][axis] + a.Corners[2][axis];
    const double atB = b.Corners[0][axis] + b.Corners[1][axis] + b.Corners[2][axis];
    return atA < atB;
  };
  std::nth_element(begin, this->Leaves.begin() + static_cast<std::ptrdiff_t>(half), end, isBefore);
  this->Build(first, half);
  this->Nodes[node].SecondChild = static_cast<Index>(this->Nodes.size());
  this->Build(half, last);
}

TriangleTree::Hit TriangleTree::Nearest(const Vec3& position) const
{
  if (this->Nodes.empty() || !(position.squaredNorm() < LargestSquare))
  {
    return Hit();
  }
  struct Visit
  {
    Index Node;
    double SquaredDistance;
  };
  // Of two children the farther one waits, so that no more wait than the tree has levels.
  std::array<Visit, LargestDepth + 1> waiting;
  std::size_t size = 0;
  double best = std::numeric_limits<double>::infinity();
  Index nearest = NoIndex;
  auto distanceTo = [&](Index n)
  { return SquaredDistanceToBox(position, this->Nodes[n].Low, this->Nodes[n].High); };

  waiting[size++] = { 0, 0.0 };
  while (size > 0)
  {
    const Visit visit = waiting[--size];
    if (visit.SquaredDistance > best)
    {
      continue;
    }
    const Node& node = this->Nodes[visit.Node];
    if (node.NumberOfLeaves == 0)
    {
      Visit near{ visit.Node + 1, distanceTo(visit.Node + 1) };
      Visit far{ node.SecondChild, distanceTo(node.SecondChild) };
      if (far.SquaredDistance < near.SquaredDistance)
      {
        std::swap(near, far);
      }
      waiting[size++] = far;
      waiting[size++] = near;
      continue;
    }
    for (Index i = node.FirstLeaf; i < node.FirstLeaf + node.NumberOfLeaves; ++i)
    {
      const Leaf& leaf = this->Leaves[i];
      const double squared =
        SquaredDistanceToTriangle(position, leaf.Corners[0], leaf.Corners[1], leaf.Corners[2]);
      if (squared < best || (squared == best && leaf.Face < nearest))
      {
        best = squared;
        nearest = leaf.Face;
      }
    }
  }
  return nearest == NoIndex ? Hit() : Hit{ std::sqrt(best), nearest };
}

}
