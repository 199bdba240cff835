// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file TextbookOfMesh.h
 * @brief From the meshes of the core to those of the textbook.
 */

#ifndef TextbookOfMesh_h
#define TextbookOfMesh_h

#include "Textbook.h"
#include "TriangleMesh.h"

#include <algorithm>

inline Textbook::Mesh ToTextbook(const SurfaceDenoising::TriangleMesh& mesh)
{
  Textbook::Mesh copy;
  for (const SurfaceDenoising::Vec3& p : mesh.Positions)
  {
    copy.Points.push_back({ p[0], p[1], p[2] });
  }
  for (const SurfaceDenoising::Triangle& t : mesh.Triangles)
  {
    copy.Faces.push_back({ int(t[0]), int(t[1]), int(t[2]) });
  }
  return copy;
}

inline double Distance(const SurfaceDenoising::Vec3& a, const Textbook::Vector& b)
{
  return (a - SurfaceDenoising::Vec3(b[0], b[1], b[2])).norm();
}

inline double SizeOf(const SurfaceDenoising::TriangleMesh& mesh)
{
  double size = 0.0;
  for (const SurfaceDenoising::Vec3& p : mesh.Positions)
  {
    size = std::max(size, p.norm());
  }
  return size;
}

#endif
