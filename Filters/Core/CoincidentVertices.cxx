// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CoincidentVertices.h"

#include <tuple>

namespace SurfaceDenoising
{

std::vector<CoincidentVertex> FindCoincidentVertices(const TriangleMesh& mesh,
  const Buffer<unsigned char>& boundary)
{
  std::vector<Index> vertices;
  for (std::size_t v = 0; v < boundary.size(); ++v)
  {
    if (boundary[v])
    {
      vertices.push_back(static_cast<Index>(v));
    }
  }
  const Buffer<Vec3>& p = mesh.Positions;
  std::sort(vertices.begin(), vertices.end(),
    [&p](Index a, Index b)
    {
      return std::make_tuple(p[a][0], p[a][1], p[a][2], a) <
        std::make_tuple(p[b][0], p[b][1], p[b][2], b);
    });

  std::vector<CoincidentVertex> coincident;
  for (std::size_t first = 0, next = 0; next < vertices.size(); ++next)
  {
    if (p[vertices[next]] != p[vertices[first]])
    {
      first = next;
    }
    else if (next > first)
    {
      coincident.push_back({ vertices[next], vertices[first] });
    }
  }
  return coincident;
}

}
