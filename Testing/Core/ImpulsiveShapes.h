// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file ImpulsiveShapes.h
 * @brief Meshes with noise at some vertices, and one whose details hide it.
 */

#ifndef ImpulsiveShapes_h
#define ImpulsiveShapes_h

#include "AutomaticShapes.h"
#include "RandomMeshes.h"

/// A coarse torus with bumps in all directions, a few edges wide.
inline SurfaceDenoising::TriangleMesh RoughTorus(double height = 0.025, int rings = 26)
{
  using namespace SurfaceDenoising;
  TriangleMesh mesh = Torus(rings);
  for (Vec3& p : mesh.Positions)
  {
    p *=
      1.0 + height * (std::sin(13.0 * p[0] + 1.0) + std::sin(12.0 * p[1]) + std::sin(14.0 * p[2]));
  }
  return mesh;
}

/// Gaussian displacements of that many mean edge lengths at a share of the vertices.
inline SurfaceDenoising::TriangleMesh WithImpulses(const SurfaceDenoising::TriangleMesh& clean,
  double share, bool alongNormals, double level = 0.5)
{
  using namespace SurfaceDenoising;
  TriangleMesh noisy = clean;
  if (alongNormals)
  {
    AddNormalNoise(noisy, level, 12345);
  }
  else
  {
    AddDirectionNoise(noisy, level, 12345);
  }
  PortableRandom random(9);
  for (std::size_t v = 0; v < noisy.NumberOfVertices(); ++v)
  {
    if (random.Uniform() >= share)
    {
      noisy.Positions[v] = clean.Positions[v];
    }
  }
  return noisy;
}

/// A tenth of the vertices, moved by 0.7 mean edge lengths in random directions.
inline SurfaceDenoising::TriangleMesh WithJumps(SurfaceDenoising::TriangleMesh mesh)
{
  using namespace SurfaceDenoising;
  const double length = 0.7 * EdgeLengthOf(mesh);
  PortableRandom random(9);
  for (Vec3& p : mesh.Positions)
  {
    p += random.Uniform() < 0.1 ? Vec3(length * random.Direction()) : Vec3(0.0, 0.0, 0.0);
  }
  return mesh;
}

#endif
