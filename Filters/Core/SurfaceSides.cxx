// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceSides.h"

#include "CoincidentVertices.h"

#include <cmath>
#include <limits>

namespace SurfaceDenoising
{

namespace
{

constexpr double Tolerance = 1e-9;

/// The edge from corner k to the next one, or the end of it that is nearest.
TrianglePart NearestPartOfEdge(const Vec3& position, const std::array<Vec3, 3>& corners, int k)
{
  const int next = (k + 1) % 3;
  const Vec3 edge = corners[next] - corners[k];
  const double t = (position - corners[k]).dot(edge) / edge.squaredNorm();
  if (t <= Tolerance)
  {
    return { 1, { k, next, 0 }, corners[k] };
  }
  if (t >= 1.0 - Tolerance)
  {
    return { 1, { next, k, 0 }, corners[next] };
  }
  return { 2, { k, next, 0 }, corners[k] + t * edge };
}

/// Angle of the triangle at corner k in radians.
double CornerAngle(const TriangleMesh& mesh, const Triangle& t, int k)
{
  const Vec3& tip = mesh.Positions[t[k]];
  const Vec3 a = mesh.Positions[t[(k + 1) % 3]] - tip;
  const Vec3 b = mesh.Positions[t[(k + 2) % 3]] - tip;
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}

TrianglePart NearestPart(const Vec3& position, const std::array<Vec3, 3>& corners)
{
  const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  // The barycentric coordinate that is 0 on the edge from corner k to the next one.
  auto isInside = [&](int k)
  {
    const Vec3& from = corners[k];
    const Vec3& to = corners[(k + 1) % 3];
    return (to - from).cross(position - from).dot(normal) > Tolerance * normal.squaredNorm();
  };
  if (isInside(0) && isInside(1) && isInside(2))
  {
    return { 3, { 0, 1, 2 }, corners[0] };
  }
  TrianglePart best = NearestPartOfEdge(position, corners, 0);
  for (int k = 1; k < 3; ++k)
  {
    const TrianglePart part = NearestPartOfEdge(position, corners, k);
    if ((part.Point - position).squaredNorm() < (best.Point - position).squaredNorm())
    {
      best = part;
    }
  }
  return best;
}

SurfaceSides::SurfaceSides(const TriangleMesh& mesh, const EdgeCensus& census,
  const FaceGeometry& geometry, Execution& execution)
  : Joined(mesh)
  , Geometry(geometry)
{
  const std::vector<CoincidentVertex> seams = FindCoincidentVertices(mesh, census.BoundaryVertex);
  Buffer<Index> original(mesh.NumberOfVertices());
  for (std::size_t v = 0; v < original.size(); ++v)
  {
    original[v] = static_cast<Index>(v);
  }
  for (const CoincidentVertex& seam : seams)
  {
    original[seam.Vertex] = seam.Original;
  }
  for (Triangle& t : this->Joined.Triangles)
  {
    t = { original[t[0]], original[t[1]], original[t[2]] };
  }
  this->Stars = VertexStars(this->Joined);
  this->Agree = TakeEdgeCensus(this->Joined, this->Stars, execution).NumberOfInconsistentEdges == 0;

  this->VertexNormals.resize(mesh.NumberOfVertices());
  execution.For(this->VertexNormals.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t v = begin; v < end; ++v)
      {
        Vec3 sum(0.0, 0.0, 0.0);
        for (const Index f : this->Stars.Row(v))
        {
          const Triangle& t = this->Joined.Triangles[f];
          const int corner = t[0] == v ? 0 : (t[1] == v ? 1 : 2);
          sum += CornerAngle(this->Joined, t, corner) * geometry.Normals[f];
        }
        this->VertexNormals[v] = sum;
      }
    });
}

TrianglePart SurfaceSides::PartOf(const Vec3& position, Index face) const
{
  const Triangle& t = this->Joined.Triangles[face];
  const Buffer<Vec3>& p = this->Joined.Positions;
  return NearestPart(position, { p[t[0]], p[t[1]], p[t[2]] });
}

double SurfaceSides::SignedDistance(const Vec3& position, Index face, double distance) const
{
  if (face == NoIndex)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const TrianglePart part = this->PartOf(position, face);
  Vec3 normal(0.0, 0.0, 0.0);
  if (part.NumberOfCorners == 1)
  {
    normal = this->VertexNormals[this->Joined.Triangles[face][part.Corners[0]]];
  }
  else
  {
    this->VisitNearest(position, face, [&](Index g) { normal += this->Geometry.Normals[g]; });
  }
  return (position - part.Point).dot(normal) < 0.0 ? -distance : distance;
}

Buffer<unsigned char> MarkPositions(const SurfaceSides& sides, const Buffer<Vec3>& positions,
  const Buffer<Index>& nearest, const Buffer<unsigned char>& markedFaces, Execution& execution)
{
  Buffer<unsigned char> marks(positions.size());
  execution.For(marks.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        marks[i] = 0;
        if (nearest[i] != NoIndex)
        {
          sides.VisitNearest(positions[i], nearest[i],
            [&](Index f) { marks[i] |= markedFaces[f]; });
        }
      }
    });
  return marks;
}

}
