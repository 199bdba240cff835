// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file AutomaticShapes.h
 * @brief Clean shapes of known truth, smooth and sharp, and meshes with nothing to denoise.
 */

#ifndef AutomaticShapes_h
#define AutomaticShapes_h

#include "RandomMeshes.h"

#include <array>
#include <cmath>
#include <map>
#include <vector>

struct AutomaticShape
{
  const char* Name;
  SurfaceDenoising::TriangleMesh (*Make)();
  bool Sharp;
};

inline double EdgeLengthOf(const SurfaceDenoising::TriangleMesh& mesh)
{
  SurfaceDenoising::Execution serial;
  return TakeEdgeCensus(mesh, VertexStars(mesh), serial).MeanEdgeLength;
}

/// A torus of n times 2 n squares of two triangles. Of an even n rings, every second may be nearer
/// to the one before by this share of a step: every second row of triangles is thin.
inline SurfaceDenoising::TriangleMesh Torus(int n, double nearer = 0.0)
{
  using namespace SurfaceDenoising;
  TriangleMesh mesh;
  const double step = 2.0 * 3.14159265358979323846 / n;
  for (int i = 0; i < 2 * n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const double a = 0.5 * step * (i + 0.5 * (j % 2));
      const double b = step * (j % 2 == 1 ? j - nearer : j);
      const double r = 1.0 + 0.5 * std::cos(b);
      mesh.Positions.push_back(Vec3(r * std::cos(a), r * std::sin(a), 0.5 * std::sin(b)));
      auto at = [n](int k, int m) { return Index((k % (2 * n)) * n + m % n); };
      mesh.Triangles.push_back({ at(i, j), at(i + 1, j), at(i, j + 1) });
      mesh.Triangles.push_back({ at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  return mesh;
}

/// A coarse torus with regular bumps, so high and so wide in mean edge lengths.
inline SurfaceDenoising::TriangleMesh BumpyTorus(double height, double width)
{
  using namespace SurfaceDenoising;
  TriangleMesh mesh = Torus(16);
  Execution serial;
  const double edge = EdgeLengthOf(mesh);
  const Buffer<Vec3> normals = VertexAreaVectors(mesh, VertexStars(mesh), serial);
  for (std::size_t v = 0; v < normals.size(); ++v)
  {
    const Vec3 phase = 2.0 * 3.14159265358979323846 / (width * edge) * mesh.Positions[v];
    const double wave = std::sin(phase[0]) * std::sin(phase[1] + 1.0) * std::cos(phase[2]);
    mesh.Positions[v] += height * edge * wave * normals[v].normalized();
  }
  return mesh;
}

/// The sides of a prism, open at both ends: each is cut into so many squares of two triangles.
inline SurfaceDenoising::TriangleMesh Prism(int sides, int cuts, int layers)
{
  using namespace SurfaceDenoising;
  TriangleMesh mesh;
  const double turn = 2.0 * 3.14159265358979323846 / sides;
  const int around = sides * cuts;
  for (int layer = 0; layer <= layers; ++layer)
  {
    for (int i = 0; i < around; ++i)
    {
      const double from = turn * (i / cuts);
      const double share = double(i % cuts) / cuts;
      mesh.Positions.push_back(Vec3((1.0 - share) * std::cos(from) + share * std::cos(from + turn),
        (1.0 - share) * std::sin(from) + share * std::sin(from + turn),
        2.0 * std::sin(0.5 * turn) / cuts * layer));
    }
  }
  auto at = [around](int layer, int i) { return Index(layer * around + i % around); };
  for (int layer = 0; layer < layers; ++layer)
  {
    for (int i = 0; i < around; ++i)
    {
      mesh.Triangles.push_back({ at(layer, i), at(layer, i + 1), at(layer + 1, i + 1) });
      mesh.Triangles.push_back({ at(layer, i), at(layer + 1, i + 1), at(layer + 1, i) });
    }
  }
  return mesh;
}

/// A square with ridges and valleys, of n x n points that are moved from their places in a grid by
/// up to so many steps.
inline SurfaceDenoising::TriangleMesh Ridges(int n, double jitter)
{
  using namespace SurfaceDenoising;
  TriangleMesh mesh;
  const auto fraction = [](double x) { return x - std::floor(x) - 0.5; };
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const int k = 1 + i * n + j;
      const double x = (i + 2.0 * jitter * fraction(0.6180339887498949 * k)) / n;
      const double y = (j + 2.0 * jitter * fraction(0.7548776662466927 * k)) / n;
      mesh.Positions.push_back(Vec3(x, y, 0.15 * std::abs(std::sin(6.0 * x + 2.0 * y))));
    }
  }
  for (int i = 0; i + 1 < n; ++i)
  {
    for (int j = 0; j + 1 < n; ++j)
    {
      const Index corner = Index(i * n + j);
      mesh.Triangles.push_back({ corner, corner + n, corner + n + 1 });
      mesh.Triangles.push_back({ corner, corner + n + 1, corner + 1 });
    }
  }
  return mesh;
}

/// The unit sphere: every side of an octahedron is cut into n x n triangles.
inline SurfaceDenoising::TriangleMesh Ball(int n)
{
  using namespace SurfaceDenoising;
  TriangleMesh mesh;
  std::map<std::array<int, 3>, Index> places;
  for (int octant = 0; octant < 8; ++octant)
  {
    const std::array<int, 3> signs = { octant & 1 ? -1 : 1, octant & 2 ? -1 : 1,
      octant & 4 ? -1 : 1 };
    auto at = [&](int i, int j)
    {
      const std::array<int, 3> p = { signs[0] * i, signs[1] * j, signs[2] * (n - i - j) };
      const auto added = places.insert({ p, static_cast<Index>(mesh.Positions.size()) });
      if (added.second)
      {
        mesh.Positions.push_back(Vec3(p[0], p[1], p[2]).normalized());
      }
      return added.first->second;
    };
    auto add = [&](Index a, Index b, Index c)
    {
      const bool mirrored = signs[0] * signs[1] * signs[2] < 0;
      mesh.Triangles.push_back({ a, mirrored ? c : b, mirrored ? b : c });
    };
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; i + j < n; ++j)
      {
        add(at(i, j), at(i + 1, j), at(i, j + 1));
        if (i + j + 1 < n)
        {
          add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
        }
      }
    }
  }
  return mesh;
}

/// A wheel with teeth of two corners each: flat sides of long triangles. Its caps are fans.
inline SurfaceDenoising::TriangleMesh Gear(int corners, int layers, double height)
{
  using namespace SurfaceDenoising;
  TriangleMesh mesh;
  for (int layer = 0; layer <= layers; ++layer)
  {
    for (int i = 0; i < corners; ++i)
    {
      const double angle = 2.0 * 3.14159265358979323846 * i / corners;
      const double radius = i / 2 % 2 == 1 ? 1.0 : 0.7;
      mesh.Positions.push_back(
        Vec3(radius * std::cos(angle), radius * std::sin(angle), height * layer / layers));
    }
  }
  auto at = [corners](int layer, int i) { return Index(layer * corners + i % corners); };
  for (int layer = 0; layer < layers; ++layer)
  {
    for (int i = 0; i < corners; ++i)
    {
      mesh.Triangles.push_back({ at(layer, i), at(layer, i + 1), at(layer + 1, i + 1) });
      mesh.Triangles.push_back({ at(layer, i), at(layer + 1, i + 1), at(layer + 1, i) });
    }
  }
  for (const int layer : { 0, layers })
  {
    const Index middle = Index(mesh.Positions.size());
    mesh.Positions.push_back(Vec3(0.0, 0.0, layer == 0 ? 0.0 : height));
    for (int i = 0; i < corners; ++i)
    {
      const int next = layer == 0 ? i : i + 1;
      const int last = layer == 0 ? i + 1 : i;
      mesh.Triangles.push_back({ middle, at(layer, last), at(layer, next) });
    }
  }
  return mesh;
}

/// The boundary of an ellipsoid of unit voxels, two triangles per side of a voxel.
inline SurfaceDenoising::TriangleMesh Voxels(int radius)
{
  using namespace SurfaceDenoising;
  TriangleMesh mesh;
  std::map<std::array<int, 3>, Index> places;
  const auto inside = [radius](const std::array<int, 3>& p)
  {
    const double x = p[0] + 0.5;
    const double y = p[1] + 0.5;
    const double z = p[2] + 0.5;
    return x * x + 1.7 * y * y + 0.8 * z * z + 0.3 * x * y < radius * radius;
  };
  const auto vertex = [&](const std::array<int, 3>& p)
  {
    const auto added = places.insert({ p, static_cast<Index>(mesh.Positions.size()) });
    if (added.second)
    {
      mesh.Positions.push_back(Vec3(p[0], p[1], p[2]));
    }
    return added.first->second;
  };
  const int size = 3 * radius;
  for (int cell = 0; cell < size * size * size; ++cell)
  {
    const std::array<int, 3> p = { cell % size - size / 2, cell / size % size - size / 2,
      cell / size / size - size / 2 };
    for (int side = 0; inside(p) && side < 6; ++side)
    {
      const int axis = side / 2;
      std::array<int, 3> next = p;
      next[axis] += side % 2 == 1 ? 1 : -1;
      if (inside(next))
      {
        continue;
      }
      std::array<Index, 4> corners;
      for (int k = 0; k < 4; ++k)
      {
        std::array<int, 3> corner = p;
        corner[axis] += side % 2;
        corner[(axis + 1) % 3] += k == 1 || k == 2 ? 1 : 0;
        corner[(axis + 2) % 3] += k >= 2 ? 1 : 0;
        corners[side % 2 == 1 ? k : 3 - k] = vertex(corner);
      }
      mesh.Triangles.push_back({ corners[0], corners[1], corners[2] });
      mesh.Triangles.push_back({ corners[0], corners[2], corners[3] });
    }
  }
  return mesh;
}

inline const std::vector<AutomaticShape>& AutomaticShapes()
{
  static const std::vector<AutomaticShape> shapes = {
    { "Cube", [] { return Cube(16); }, true },
    // A third as high: two pairs of edges are closer, and triangles are long.
    { "Slab",
      []
      {
        SurfaceDenoising::TriangleMesh mesh = Cube(16);
        for (SurfaceDenoising::Vec3& p : mesh.Positions)
        {
          p[2] *= 0.4;
        }
        return mesh;
      },
      true },
    { "Torus", [] { return Torus(28); }, false },
  };
  return shapes;
}

/// Empty, of points alone, of one triangle, of four, of triangles without area.
inline std::vector<SurfaceDenoising::TriangleMesh> OddMeshes()
{
  using namespace SurfaceDenoising;
  std::vector<TriangleMesh> meshes(5);
  meshes[1].Positions.assign(20, Vec3(1.0, 2.0, 3.0));
  for (const Vec3& p : { Vec3(0.0, 0.0, 0.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0) })
  {
    meshes[2].Positions.push_back(p);
  }
  meshes[2].Triangles.push_back({ 0, 1, 2 });
  meshes[3] = meshes[2];
  meshes[3].Positions.push_back(Vec3(0.3, 0.3, 1.0));
  meshes[3].Triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };
  meshes[4].Positions.assign(60, Vec3(1.0, 1.0, 1.0));
  for (Index v = 0; v + 2 < 60; ++v)
  {
    meshes[4].Triangles.push_back({ v, Index(v + 1), Index(v + 2) });
  }
  meshes[4].Triangles.push_back({ 5, 5, 7 });
  return meshes;
}

#endif
