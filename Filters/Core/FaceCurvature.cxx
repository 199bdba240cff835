// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaceCurvature.h"

namespace SurfaceDenoising
{

Buffer<double> FaceCurvatures(const TriangleMesh& mesh, const CompressedRows& stars,
  const Buffer<unsigned char>& boundary, const FaceGeometry& geometry, Execution& execution)
{
  Buffer<double> atVertex(mesh.NumberOfVertices());
  execution.For(atVertex.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t v = begin; v < end; ++v)
      {
        Vec3 gradient(0.0, 0.0, 0.0);
        double area = 0.0;
        for (const Index f : stars.Row(v))
        {
          const Triangle& t = mesh.Triangles[f];
          const int corner = t[0] == v ? 0 : (t[1] == v ? 1 : 2);
          const Vec3& q = mesh.Positions[t[(corner + 1) % 3]];
          const Vec3& r = mesh.Positions[t[(corner + 2) % 3]];
          gradient += 0.5 * geometry.Normals[f].cross(r - q);
          area += geometry.Areas[f];
        }
        atVertex[v] = area > 0.0 ? gradient.norm() / (2.0 * area / 3.0) : 0.0;
      }
    });

  Buffer<double> smoothed = atVertex;
  execution.For(smoothed.size(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Spoke> spokes;
      for (std::size_t v = begin; v < end; ++v)
      {
        if (!boundary[v])
        {
          continue;
        }
        CollectSpokes(mesh, stars.Row(v), static_cast<Index>(v), spokes);
        double sum = 0.0;
        double count = 0.0;
        for (const Spoke& spoke : spokes)
        {
          if (!boundary[spoke.Vertex])
          {
            sum += atVertex[spoke.Vertex];
            count += 1.0;
          }
        }
        smoothed[v] = count > 0.0 ? sum / count : 0.0;
      }
    });

  Buffer<double> atFace(mesh.NumberOfFaces());
  execution.For(atFace.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t f = begin; f < end; ++f)
      {
        const Triangle& t = mesh.Triangles[f];
        atFace[f] = (smoothed[t[0]] + smoothed[t[1]] + smoothed[t[2]]) / 3.0;
      }
    });
  return atFace;
}

}
