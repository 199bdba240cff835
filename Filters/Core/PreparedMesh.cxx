// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PreparedMesh.h"

#include "FaceOrientation.h"

#include <numeric>

namespace SurfaceDenoising
{

MeshFacts FactsOf(const TriangleMesh& mesh, const EdgeCensus& edges, Execution& execution)
{
  MeshFacts facts;
  facts.MeanEdgeLength = edges.MeanEdgeLength;
  facts.BoundaryEdges = edges.NumberOfBoundaryEdges;
  facts.NonManifoldEdges = edges.NumberOfNonManifoldEdges;
  facts.DegenerateFaces = OrderedSum(execution, mesh.NumberOfFaces(), std::size_t(0),
    [&](std::size_t f)
    { return std::size_t(IsDegenerate(mesh.DoubleAreaVector(f), edges.MeanEdgeLength)); });
  return facts;
}

bool PreparedMesh::Prepare(Execution& execution)
{
  if (IsScattered(this->Given, execution))
  {
    this->Order = FindSpatialOrder(this->Given, execution);
    this->Ordered = Reorder(this->Given, this->Order);
  }
  TriangleMesh& mesh = this->Mesh();
  this->VertexFaces = VertexStars(mesh);
  if (!execution.Proceed(0.01))
  {
    return false;
  }
  this->Census = TakeEdgeCensus(mesh, this->VertexFaces, execution);
  if (this->Census.NumberOfBoundaryEdges > 0)
  {
    this->Seams = FindCoincidentVertices(mesh, this->Census.BoundaryVertex);
    this->CloseSeams(execution);
  }
  if (this->Census.NumberOfInconsistentEdges > 0)
  {
    if (this->Unrepaired.empty())
    {
      this->Unrepaired = mesh.Triangles;
    }
    this->Turned = OrientFaces(mesh, this->VertexFaces);
  }

  this->Found = FactsOf(mesh, this->Census, execution);
  this->Found.SeamVertices = this->Seams.size();
  this->Found.TurnedFaces = static_cast<std::size_t>(
    std::count(this->Turned.begin(), this->Turned.end(), static_cast<unsigned char>(1)));
  return execution.Proceed(0.03);
}

void PreparedMesh::CloseSeams(Execution& execution)
{
  if (this->Seams.empty())
  {
    return;
  }
  TriangleMesh& mesh = this->Mesh();
  this->Unrepaired = mesh.Triangles;
  Buffer<Index> original(mesh.NumberOfVertices());
  std::iota(original.begin(), original.end(), Index(0));
  for (const CoincidentVertex& seam : this->Seams)
  {
    original[seam.Vertex] = seam.Original;
  }
  for (Triangle& t : mesh.Triangles)
  {
    t = { original[t[0]], original[t[1]], original[t[2]] };
  }
  this->VertexFaces = VertexStars(mesh);
  this->Census = TakeEdgeCensus(mesh, this->VertexFaces, execution);
}

void PreparedMesh::Turn(Buffer<Vec3>& faceVectors) const
{
  for (std::size_t f = 0; f < this->Turned.size(); ++f)
  {
    if (this->Turned[f])
    {
      faceVectors[f] = -faceVectors[f];
    }
  }
}

void PreparedMesh::Enter(Buffer<Vec3>& faceVectors) const
{
  if (!this->Order.Faces.empty())
  {
    faceVectors = Gather(faceVectors, this->Order.Faces);
  }
  this->Turn(faceVectors);
}

void PreparedMesh::Leave(Buffer<Vec3>& faceVectors) const
{
  this->Turn(faceVectors);
  if (!this->Order.Faces.empty())
  {
    Buffer<Vec3> scattered;
    Scatter(faceVectors, this->Order.Faces, scattered);
    faceVectors.swap(scattered);
  }
}

void PreparedMesh::Finish()
{
  TriangleMesh& mesh = this->Mesh();
  for (const CoincidentVertex& seam : this->Seams)
  {
    mesh.Positions[seam.Vertex] = mesh.Positions[seam.Original];
  }
  if (!this->Unrepaired.empty())
  {
    mesh.Triangles.swap(this->Unrepaired);
  }
  if (!this->Order.Faces.empty())
  {
    Scatter(this->Ordered.Positions, this->Order.Vertices, this->Given.Positions);
  }
}

}
