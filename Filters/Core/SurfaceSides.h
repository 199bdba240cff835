// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file SurfaceSides.h
 * @brief On which side of a surface a position is, and which of its faces are equally near.
 *
 * Outside a convex edge or corner, the nearest face is not one but all those that meet there; which
 * one a search finds is a matter of rounding. What is told here depends on all of them, and so
 * neither on the order of the faces nor on how the surface is turned.
 */

#ifndef SurfaceDenoising_SurfaceSides_h
#define SurfaceDenoising_SurfaceSides_h

#include "TriangleMesh.h"

namespace SurfaceDenoising
{

/// The part of a triangle that is nearest to a position: its inside, an edge or a corner.
struct TrianglePart
{
  int NumberOfCorners;        ///< 3 for the inside, 2 for an edge, 1 for a corner
  std::array<int, 3> Corners; ///< numbers in the triangle, from 0 to 2; the first ones count
  Vec3 Point;                 ///< the nearest point itself, or for the inside a point in its plane
};

/**
 * What is less than a billionth of the triangle away from an edge or a corner belongs to it, so
 * that rounding does not decide. The triangle must have an area.
 */
TrianglePart NearestPart(const Vec3& position, const std::array<Vec3, 3>& corners);

class SurfaceSides
{
public:
  /**
   * Copies the mesh, with boundary vertices at the same place made one: seams and soups of
   * triangles are surfaces too. Refers to geometry, which must stay.
   */
  SurfaceSides(const TriangleMesh& mesh, const EdgeCensus& census, const FaceGeometry& geometry,
    Execution& execution);
  SurfaceSides(const SurfaceSides&) = delete;
  SurfaceSides& operator=(const SurfaceSides&) = delete;

  /// True if no two faces run along an edge that they alone share the same way.
  bool AgreeOnOutside() const { return this->Agree; }

  /// Calls visit(g) for face, the nearest face of the position, and all others that have the
  /// nearest point as well. Faces without area are left out.
  template <typename Visit>
  void VisitNearest(const Vec3& position, Index face, Visit visit) const
  {
    const TrianglePart part = this->PartOf(position, face);
    if (part.NumberOfCorners == 3)
    {
      visit(face);
      return;
    }
    const Triangle& t = this->Joined.Triangles[face];
    for (const Index g : this->Stars.Row(t[part.Corners[0]]))
    {
      if (this->Geometry.Areas[g] > 0.0 &&
        (part.NumberOfCorners == 1 || HasCorner(this->Joined.Triangles[g], t[part.Corners[1]])))
      {
        visit(g);
      }
    }
  }

  /**
   * The distance of a position, given its nearest face, with a sign: positive outside. The sign is
   * that of the angle-weighted pseudonormal (Baerentzen and Aanaes 2005) of the nearest part: the
   * normal of a face, the sum of the normals at an edge, the sum of the normals at a vertex, each
   * times the angle of its face there. Beyond the boundary of an open surface that is the side of
   * the plane; on this plane it is outside. NaN if there is no face.
   */
  double SignedDistance(const Vec3& position, Index face, double distance) const;

private:
  TrianglePart PartOf(const Vec3& position, Index face) const;

  TriangleMesh Joined;
  CompressedRows Stars;
  const FaceGeometry& Geometry;
  Buffer<Vec3> VertexNormals; ///< of any length
  bool Agree = false;
};

/// 1 for every position one of whose nearest faces is marked, else 0. Of each position, nearest has
/// one nearest face or NoIndex.
Buffer<unsigned char> MarkPositions(const SurfaceSides& sides, const Buffer<Vec3>& positions,
  const Buffer<Index>& nearest, const Buffer<unsigned char>& markedFaces, Execution& execution);

}

#endif
