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

}
