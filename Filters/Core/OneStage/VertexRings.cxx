// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VertexRings.h"

namespace SurfaceDenoising
{

CompressedRows VertexRings(const TriangleMesh& mesh, const CompressedRows& stars,
  Execution& execution)
{
  return BuildRows(execution, mesh.NumberOfVertices(),
    [&](std::size_t v, Buffer<Index>& row)
    {
      const std::size_t first = row.size();
      for (const Index f : stars.Row(v))
      {
        for (const Index w : mesh.Triangles[f])
        {
          if (w != v && std::find(row.begin() + first, row.end(), w) == row.end())
          {
            row.push_back(w);
          }
        }
      }
    });
}

Buffer<Vec3> SmoothNormals(const TriangleMesh& mesh, const CompressedRows& stars,
  const CompressedRows& rings, int rounds, Execution& execution)
{
  Buffer<Vec3> normals = VertexAreaVectors(mesh, stars, execution);
  Buffer<Vec3> smoothed(normals.size());
  for (int round = 0; round < rounds; ++round)
  {
    execution.For(normals.size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t v = begin; v < end; ++v)
        {
          smoothed[v] = normals[v];
          for (const Index w : rings.Row(v))
          {
            smoothed[v] += normals[w];
          }
        }
      });
    normals.swap(smoothed);
  }
  return normals;
}

}
