// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleTree.h"

#include <algorithm>
#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// Positions beyond are as good as infinite: products of differences would overflow.
constexpr double LargestSquare = 1e200;

double SquaredDistanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b)
{
  const Vec3 edge = b - a;
  const double t = (p - a).dot(edge) / edge.squaredNorm();
  return (a + std::clamp(t, 0.0, 1.0) * edge - p).squaredNorm();
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

/// What Eigen::BVMinimize asks for; keeps the best face.
class TriangleTree::Search
{
public:
  using Scalar = double;

  explicit Search(const Vec3& position)
    : Position(position)
  {
  }

  /// A little less than the distance, so that boxes with an equally near face are opened too.
  double minimumOnVolume(const Eigen::AlignedBox3d& box) const
  {
    return box.squaredExteriorDistance(this->Position) * (1.0 - 1e-12) - 1e-300;
  }

  double minimumOnObject(const Leaf& leaf)
  {
    const double squared =
      SquaredDistanceToTriangle(this->Position, leaf.Corners[0], leaf.Corners[1], leaf.Corners[2]);
    if (squared < this->Best || (squared == this->Best && leaf.Face < this->Nearest))
    {
      this->Best = squared;
      this->Nearest = leaf.Face;
    }
    return squared;
  }

  Hit Found() const
  {
    return this->Nearest == NoIndex ? Hit() : Hit{ std::sqrt(this->Best), this->Nearest };
  }

private:
  Vec3 Position;
  double Best = std::numeric_limits<double>::infinity();
  Index Nearest = NoIndex;
};

TriangleTree::TriangleTree(const TriangleMesh& mesh, const Buffer<double>& areas)
{
  std::vector<Leaf> leaves;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    if (areas[f] > 0.0)
    {
      const Triangle& t = mesh.Triangles[f];
      const std::array<Vec3, 3> corners{ mesh.Positions[t[0]], mesh.Positions[t[1]],
        mesh.Positions[t[2]] };
      leaves.push_back({ corners, static_cast<Index>(f) });
      Eigen::AlignedBox3d box(corners[0]);
      boxes.push_back(box.extend(corners[1]).extend(corners[2]));
    }
  }
  this->IsEmpty = leaves.empty();
  if (!this->IsEmpty)
  {
    this->Tree.init(leaves.begin(), leaves.end(), boxes.begin(), boxes.end());
  }
}

TriangleTree::Hit TriangleTree::Nearest(const Vec3& position) const
{
  if (this->IsEmpty || !(position.squaredNorm() < LargestSquare))
  {
    return Hit();
  }
  Search search(position);
  Eigen::BVMinimize(this->Tree, search);
  return search.Found();
}

}
