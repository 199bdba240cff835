// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file CompareMeshes.h
 * @brief How far two results are apart, and orders to shuffle meshes with.
 */

#ifndef CompareMeshes_h
#define CompareMeshes_h

#include "RandomMeshes.h"

#include <algorithm>
#include <limits>
#include <numeric>

/// Largest distance of a vertex from the first one.
inline double ExtentOf(const SurfaceDenoising::TriangleMesh& mesh)
{
  double size = 0.0;
  for (const SurfaceDenoising::Vec3& p : mesh.Positions)
  {
    size = std::max(size, (p - mesh.Positions[0]).norm());
  }
  return size;
}

/// Largest distance between vectors with the same number; infinite if their numbers differ.
inline double Distance(const SurfaceDenoising::Buffer<SurfaceDenoising::Vec3>& a,
  const SurfaceDenoising::Buffer<SurfaceDenoising::Vec3>& b)
{
  double distance = a.size() == b.size() ? 0.0 : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    distance = std::max(distance, (a[i] - b[i]).norm());
  }
  return distance;
}

inline std::vector<SurfaceDenoising::Index> Shuffled(std::size_t count, std::uint32_t seed)
{
  std::vector<SurfaceDenoising::Index> order(count);
  std::iota(order.begin(), order.end(), SurfaceDenoising::Index(0));
  PortableRandom random(seed);
  for (std::size_t i = count; i > 1; --i)
  {
    std::swap(order[i - 1], order[random.Below(i)]);
  }
  return order;
}

/// A mesh with its vertices and faces in another order, and faces that begin at other corners.
struct ShuffledMesh
{
  explicit ShuffledMesh(const SurfaceDenoising::TriangleMesh& mesh)
    : Vertices(Shuffled(mesh.NumberOfVertices(), 3))
    , Faces(Shuffled(mesh.NumberOfFaces(), 4))
    , Mesh(mesh)
  {
    for (std::size_t v = 0; v < this->Vertices.size(); ++v)
    {
      this->Mesh.Positions[this->Vertices[v]] = mesh.Positions[v];
    }
    for (std::size_t f = 0; f < this->Faces.size(); ++f)
    {
      const SurfaceDenoising::Triangle& t = mesh.Triangles[f];
      SurfaceDenoising::Triangle& s = this->Mesh.Triangles[this->Faces[f]];
      s = { this->Vertices[t[0]], this->Vertices[t[1]], this->Vertices[t[2]] };
      std::rotate(s.begin(), s.begin() + f % 3, s.end());
    }
  }

  std::vector<SurfaceDenoising::Index> Vertices; ///< new numbers of the old ones
  std::vector<SurfaceDenoising::Index> Faces;
  SurfaceDenoising::TriangleMesh Mesh;
};

#endif
