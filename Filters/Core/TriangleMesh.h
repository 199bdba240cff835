// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file TriangleMesh.h
 * @brief A triangle mesh as two arrays, and what follows from them.
 *
 * Nothing is assumed of the mesh: edges may have one, two or many faces, faces may have no area or
 * repeat a vertex, vertices may have no face.
 */

#ifndef SurfaceDenoising_TriangleMesh_h
#define SurfaceDenoising_TriangleMesh_h

#include "CompressedRows.h"

namespace SurfaceDenoising
{

struct TriangleMesh
{
  Buffer<Vec3> Positions;
  Buffer<Triangle> Triangles;

  std::size_t NumberOfVertices() const { return this->Positions.size(); }
  std::size_t NumberOfFaces() const { return this->Triangles.size(); }

  /// Twice the area vector of a face: (b - a) x (c - a).
  Vec3 DoubleAreaVector(std::size_t face) const
  {
    const Triangle& t = this->Triangles[face];
    const Vec3& a = this->Positions[t[0]];
    return (this->Positions[t[1]] - a).cross(this->Positions[t[2]] - a);
  }

  Vec3 Centroid(std::size_t face) const
  {
    const Triangle& t = this->Triangles[face];
    return (this->Positions[t[0]] + this->Positions[t[1]] + this->Positions[t[2]]) / 3.0;
  }
};

/// True if vertex v is a corner of the triangle.
inline bool HasCorner(const Triangle& t, Index v) { return t[0] == v || t[1] == v || t[2] == v; }

/// The faces of every vertex in ascending order, each once even if it repeats the vertex.
CompressedRows VertexStars(const TriangleMesh& mesh);

/// Sums of the double area vectors of the faces around every vertex, which are along its normal.
Buffer<Vec3> VertexAreaVectors(const TriangleMesh& mesh, const CompressedRows& stars,
  Execution& execution);

/// A vertex at the other end of an edge, and how the faces of that edge pass it.
struct Spoke
{
  Index Vertex;
  unsigned Out; ///< faces that run from the centre to Vertex
  unsigned In;  ///< faces that run from Vertex to the centre
};

/// All edges at a vertex with the given star, each once.
void CollectSpokes(const TriangleMesh& mesh, Span<Index> star, Index centre,
  std::vector<Spoke>& spokes);

/// What the edges of a mesh look like, from one pass over the vertex stars.
struct EdgeCensus
{
  std::size_t NumberOfEdges = 0;            ///< distinct pairs of vertices joined by a face
  std::size_t NumberOfBoundaryEdges = 0;    ///< edges of one face
  std::size_t NumberOfNonManifoldEdges = 0; ///< edges of three and more faces
  std::size_t NumberOfInconsistentEdges =
    0;                                  ///< edges of two faces that run along them the same way
  double MeanEdgeLength = 0.0;          ///< over distinct edges; 0 without edges
  Buffer<unsigned char> BoundaryVertex; ///< 1 for the ends of boundary edges, else 0
};

EdgeCensus TakeEdgeCensus(const TriangleMesh& mesh, const CompressedRows& stars,
  Execution& execution);

/**
 * Faces with an area below 1e-12 * scale^2 are degenerate: their normal is rounding error. scale is
 * the mean edge length.
 */
inline bool IsDegenerate(const Vec3& doubleAreaVector, double scale)
{
  return !(0.5 * doubleAreaVector.norm() > 1e-12 * scale * scale);
}

/// Unit normal (zero for a degenerate face), area and centroid of every face.
struct FaceGeometry
{
  Buffer<Vec3> Normals;
  Buffer<double> Areas;
  Buffer<Vec3> Centroids;
};

/// Degenerate faces get area 0 and normal 0, and so no weight anywhere.
void ComputeFaceGeometry(const TriangleMesh& mesh, double scale, FaceGeometry& geometry,
  Execution& execution);

}

#endif
