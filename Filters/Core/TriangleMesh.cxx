// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleMesh.h"

#include <cmath>

namespace SurfaceDenoising
{

CompressedRows VertexStars(const TriangleMesh& mesh)
{
  const std::size_t vertices = mesh.NumberOfVertices();
  const std::size_t faces = mesh.NumberOfFaces();

  // Calls use(v) once for every distinct corner of a face.
  auto forCorners = [](const Triangle& t, auto use)
  {
    use(t[0]);
    if (t[1] != t[0])
    {
      use(t[1]);
    }
    if (t[2] != t[0] && t[2] != t[1])
    {
      use(t[2]);
    }
  };

  CompressedRows stars;
  stars.Offsets.assign(vertices + 1, 0);
  std::uint64_t* offsets = stars.Offsets.data();
  for (const Triangle& t : mesh.Triangles)
  {
    forCorners(t, [offsets](Index v) { ++offsets[v + 1]; });
  }
  for (std::size_t v = 0; v < vertices; ++v)
  {
    offsets[v + 1] += offsets[v];
  }
  stars.Ids.resize(offsets[vertices]);

  // Filling moves every offset to the start of the next row; the shift afterwards moves it back.
  Index* ids = stars.Ids.data();
  for (std::size_t f = 0; f < faces; ++f)
  {
    forCorners(mesh.Triangles[f],
      [offsets, ids, f](Index v) { ids[offsets[v]++] = static_cast<Index>(f); });
  }
  for (std::size_t v = vertices; v > 0; --v)
  {
    offsets[v] = offsets[v - 1];
  }
  offsets[0] = 0;
  return stars;
}

Buffer<Vec3> VertexAreaVectors(const TriangleMesh& mesh, const CompressedRows& stars,
  Execution& execution)
{
  Buffer<Vec3> sums(mesh.NumberOfVertices(), Vec3(0.0, 0.0, 0.0));
  execution.For(sums.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t v = begin; v < end; ++v)
      {
        for (const Index f : stars.Row(v))
        {
          sums[v] += mesh.DoubleAreaVector(f);
        }
      }
    });
  return sums;
}

void CollectSpokes(const TriangleMesh& mesh, Span<Index> star, Index centre,
  std::vector<Spoke>& spokes)
{
  spokes.clear();
  auto find = [&spokes](Index v) -> Spoke&
  {
    for (Spoke& spoke : spokes)
    {
      if (spoke.Vertex == v)
      {
        return spoke;
      }
    }
    spokes.push_back({ v, 0, 0 });
    return spokes.back();
  };
  for (const Index f : star)
  {
    const Triangle& t = mesh.Triangles[f];
    for (int corner = 0; corner < 3; ++corner)
    {
      const Index from = t[corner];
      const Index to = t[(corner + 1) % 3];
      if (from == centre && to != centre)
      {
        ++find(to).Out;
      }
      else if (to == centre && from != centre)
      {
        ++find(from).In;
      }
    }
  }
}

namespace
{

/// The additive part of an EdgeCensus.
struct EdgeSums
{
  std::size_t Edges = 0;
  std::size_t Boundary = 0;
  std::size_t NonManifold = 0;
  std::size_t Inconsistent = 0;
  double Length = 0.0;

  EdgeSums& operator+=(const EdgeSums& other)
  {
    this->Edges += other.Edges;
    this->Boundary += other.Boundary;
    this->NonManifold += other.NonManifold;
    this->Inconsistent += other.Inconsistent;
    this->Length += other.Length;
    return *this;
  }
};

}

EdgeCensus TakeEdgeCensus(const TriangleMesh& mesh, const CompressedRows& stars,
  Execution& execution)
{
  EdgeCensus census;
  census.BoundaryVertex.resize(mesh.NumberOfVertices());
  const EdgeSums sums = OrderedSum(execution, mesh.NumberOfVertices(), EdgeSums(),
    [&](std::size_t v)
    {
      static thread_local std::vector<Spoke> spokes;
      CollectSpokes(mesh, stars.Row(v), static_cast<Index>(v), spokes);
      EdgeSums here;
      unsigned char boundary = 0;
      for (const Spoke& spoke : spokes)
      {
        const unsigned faces = spoke.Out + spoke.In;
        boundary |= faces == 1;
        if (spoke.Vertex > v) // the other end sees the same edge
        {
          ++here.Edges;
          here.Boundary += faces == 1;
          here.NonManifold += faces > 2;
          here.Inconsistent += faces == 2 && spoke.Out != spoke.In;
          here.Length += (mesh.Positions[spoke.Vertex] - mesh.Positions[v]).norm();
        }
      }
      census.BoundaryVertex[v] = boundary;
      return here;
    });
  census.NumberOfEdges = sums.Edges;
  census.NumberOfBoundaryEdges = sums.Boundary;
  census.NumberOfNonManifoldEdges = sums.NonManifold;
  census.NumberOfInconsistentEdges = sums.Inconsistent;
  census.MeanEdgeLength = sums.Edges > 0 ? sums.Length / static_cast<double>(sums.Edges) : 0.0;
  return census;
}

void ComputeFaceGeometry(const TriangleMesh& mesh, double scale, FaceGeometry& geometry,
  Execution& execution)
{
  const std::size_t faces = mesh.NumberOfFaces();
  geometry.Normals.resize(faces);
  geometry.Areas.resize(faces);
  geometry.Centroids.resize(faces);
  execution.For(faces,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t f = begin; f < end; ++f)
      {
        const Vec3 s = mesh.DoubleAreaVector(f);
        const double length = s.norm();
        const bool degenerate = IsDegenerate(s, scale);
        geometry.Areas[f] = degenerate ? 0.0 : 0.5 * length;
        geometry.Normals[f] = degenerate ? Vec3(0.0, 0.0, 0.0) : Vec3(s / length);
        geometry.Centroids[f] = mesh.Centroid(f);
      }
    });
}

}
