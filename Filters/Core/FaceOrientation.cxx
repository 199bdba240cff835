// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaceOrientation.h"

namespace SurfaceDenoising
{

namespace
{

/// +1 if a face runs from u to v, -1 if from v to u, 0 if it has no such edge or both (a repeated
/// vertex).
int Sense(const Triangle& t, Index u, Index v)
{
  int sense = 0;
  for (int corner = 0; corner < 3; ++corner)
  {
    const Index from = t[corner];
    const Index to = t[(corner + 1) % 3];
    sense += (from == u && to == v) - (from == v && to == u);
  }
  return sense;
}

/// The only other face at edge (u, v) of a face, or NoIndex.
Index AcrossEdge(const TriangleMesh& mesh, const CompressedRows& stars, Index face, Index u,
  Index v)
{
  Index other = NoIndex;
  for (const Index g : stars.Row(u))
  {
    if (g != face && HasCorner(mesh.Triangles[g], v))
    {
      if (other != NoIndex)
      {
        return NoIndex;
      }
      other = g;
    }
  }
  return other;
}

}

Buffer<unsigned char> OrientFaces(TriangleMesh& mesh, const CompressedRows& stars)
{
  const std::size_t faces = mesh.NumberOfFaces();
  Buffer<unsigned char> turned(faces, 0);
  Buffer<unsigned char> seen(faces, 0);
  std::vector<Index> part;
  for (std::size_t seed = 0; seed < faces; ++seed)
  {
    if (seen[seed])
    {
      continue;
    }
    part.assign(1, static_cast<Index>(seed));
    seen[seed] = 1;
    std::size_t turns = 0;
    for (std::size_t next = 0; next < part.size(); ++next)
    {
      const Index f = part[next];
      const Triangle& t = mesh.Triangles[f];
      turns += turned[f];
      for (int corner = 0; corner < 3; ++corner)
      {
        const Index u = t[corner];
        const Index v = t[(corner + 1) % 3];
        const Index g = u == v ? NoIndex : AcrossEdge(mesh, stars, f, u, v);
        if (g != NoIndex && !seen[g])
        {
          const int sense = Sense(t, u, v) * Sense(mesh.Triangles[g], u, v);
          turned[g] = sense > 0 ? !turned[f] : turned[f];
          seen[g] = 1;
          part.push_back(g);
        }
      }
    }
    if (2 * turns > part.size())
    {
      for (const Index f : part)
      {
        turned[f] = !turned[f];
      }
    }
  }
  for (std::size_t f = 0; f < faces; ++f)
  {
    if (turned[f])
    {
      std::swap(mesh.Triangles[f][1], mesh.Triangles[f][2]);
    }
  }
  return turned;
}

}
