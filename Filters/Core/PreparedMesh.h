// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PreparedMesh.h
 * @brief A mesh as the methods want it: without seams, oriented, well ordered. And the way back.
 */

#ifndef SurfaceDenoising_PreparedMesh_h
#define SurfaceDenoising_PreparedMesh_h

#include "CoincidentVertices.h"
#include "SpatialOrder.h"
#include "TriangleMesh.h"

namespace SurfaceDenoising
{

/// What a surface is like, whatever is done to it.
struct MeshFacts
{
  double MeanEdgeLength = 0.0; ///< l
  std::size_t DegenerateFaces = 0;
  std::size_t BoundaryEdges = 0;
  std::size_t NonManifoldEdges = 0;
  std::size_t SeamVertices = 0; ///< stored again at the place of another vertex; treated as one
  std::size_t TurnedFaces = 0;  ///< oriented against their neighbours in the input
};

/// Of a mesh without repairs.
MeshFacts FactsOf(const TriangleMesh& mesh, const EdgeCensus& edges, Execution& execution);

/**
 * Takes a mesh over for the work: closes seams, turns faces that run against their neighbours, and
 * renumbers meshes whose neighbours are scattered over memory. Finish undoes all of it, so that the
 * caller finds the mesh as it was with other positions. Between the two, use Mesh().
 */
class PreparedMesh
{
public:
  /// The mesh must outlive the preparation.
  explicit PreparedMesh(TriangleMesh& mesh)
    : Given(mesh)
  {
  }

  /// To be called first. Returns false if the execution asked to stop.
  bool Prepare(Execution& execution);

  TriangleMesh& Mesh() { return this->Order.Faces.empty() ? this->Given : this->Ordered; }
  const CompressedRows& Stars() const { return this->VertexFaces; }
  const EdgeCensus& Edges() const { return this->Census; }
  const MeshFacts& Facts() const { return this->Found; }

  /// Vectors that belong to the faces of the given mesh become those of Mesh(): turned with the
  /// faces.
  void Enter(Buffer<Vec3>& faceVectors) const;

  /// The way back of Enter.
  void Leave(Buffer<Vec3>& faceVectors) const;

  /// The given mesh gets the positions of Mesh() and its own triangles.
  void Finish();

private:
  void CloseSeams(Execution& execution);
  void Turn(Buffer<Vec3>& faceVectors) const;

  TriangleMesh& Given;
  TriangleMesh Ordered;        ///< if the given mesh is scattered
  SpatialOrder Order;          ///< empty if it is not
  Buffer<Triangle> Unrepaired; ///< triangles before repair, if seams were closed or faces turned
  Buffer<unsigned char> Turned;
  std::vector<CoincidentVertex> Seams;
  CompressedRows VertexFaces;
  EdgeCensus Census;
  MeshFacts Found;
};

}

#endif
