// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RandomMeshes.h"

#include <cmath>
#include <map>
#include <ostream>

using namespace SurfaceDenoising;

namespace
{

constexpr double Pi = 3.14159265358979323846;

double MeanEdgeLength(const TriangleMesh& mesh)
{
  Execution serial;
  return TakeEdgeCensus(mesh, VertexStars(mesh), serial).MeanEdgeLength;
}

/// An n x n grid of squares of two triangles each; place(u, v) with u, v in [0, 1].
template <typename Place>
TriangleMesh Grid(int n, Place place)
{
  TriangleMesh mesh;
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      mesh.Positions.push_back(place(double(i) / n, double(j) / n));
    }
  }
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const Index a = Index(i * (n + 1) + j);
      const Index b = a + Index(n) + 1;
      mesh.Triangles.push_back({ a, b, b + 1 });
      mesh.Triangles.push_back({ a, b + 1, a + 1 });
    }
  }
  return mesh;
}

void Append(TriangleMesh& mesh, const TriangleMesh& other)
{
  const Index shift = Index(mesh.NumberOfVertices());
  mesh.Positions.insert(mesh.Positions.end(), other.Positions.begin(), other.Positions.end());
  for (const Triangle& t : other.Triangles)
  {
    mesh.Triangles.push_back({ t[0] + shift, t[1] + shift, t[2] + shift });
  }
}

TriangleMesh NoisyGrid(std::uint32_t seed)
{
  TriangleMesh mesh =
    Grid(6, [](double u, double v) { return Vec3(u, v, 0.3 * std::abs(u - 0.5) + 0.1 * v * v); });
  AddDirectionNoise(mesh, 0.15, seed);
  return mesh;
}

TriangleMesh NoisyCube(std::uint32_t seed)
{
  TriangleMesh mesh = Cube(3);
  AddNormalNoise(mesh, 0.2, seed);
  return mesh;
}

/// The octahedron with every face cut into four, levels times.
TriangleMesh Sphere(int levels)
{
  TriangleMesh mesh;
  mesh.Positions = { Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0, 1),
    Vec3(0, 0, -1) };
  mesh.Triangles = { Triangle{ 0, 2, 4 }, Triangle{ 2, 1, 4 }, Triangle{ 1, 3, 4 },
    Triangle{ 3, 0, 4 }, Triangle{ 2, 0, 5 }, Triangle{ 1, 2, 5 }, Triangle{ 3, 1, 5 },
    Triangle{ 0, 3, 5 } };
  for (int level = 0; level < levels; ++level)
  {
    std::map<std::pair<Index, Index>, Index> middles;
    auto middle = [&](Index a, Index b)
    {
      const auto found = middles.insert({ std::minmax(a, b), Index(mesh.NumberOfVertices()) });
      if (found.second)
      {
        mesh.Positions.push_back((mesh.Positions[a] + mesh.Positions[b]).normalized());
      }
      return found.first->second;
    };
    Buffer<Triangle> finer;
    for (const Triangle& t : mesh.Triangles)
    {
      const Index ab = middle(t[0], t[1]);
      const Index bc = middle(t[1], t[2]);
      const Index ca = middle(t[2], t[0]);
      finer.insert(finer.end(),
        { Triangle{ t[0], ab, ca }, Triangle{ ab, t[1], bc }, Triangle{ ca, bc, t[2] },
          Triangle{ ab, bc, ca } });
    }
    mesh.Triangles.swap(finer);
  }
  return mesh;
}

TriangleMesh NoisySphere(std::uint32_t seed)
{
  TriangleMesh mesh = Sphere(2);
  AddDirectionNoise(mesh, 0.2, seed);
  return mesh;
}

TriangleMesh NoisyTorus(std::uint32_t seed)
{
  constexpr int n = 7;
  TriangleMesh mesh = Grid(n,
    [](double u, double v)
    {
      const double r = 1.0 + 0.4 * std::cos(2.0 * Pi * v);
      return Vec3(r * std::cos(2.0 * Pi * u), r * std::sin(2.0 * Pi * u),
        0.4 * std::sin(2.0 * Pi * v));
    });
  // The last row and column of the grid are the first ones again; their vertices stay without
  // faces.
  for (Triangle& t : mesh.Triangles)
  {
    for (Index& v : t)
    {
      v = v / (n + 1) % n * (n + 1) + v % (n + 1) % n;
    }
  }
  AddNormalNoise(mesh, 0.2, seed);
  return mesh;
}

/// Three sheets that meet at a common border, and a sphere that touches one of them in a vertex.
TriangleMesh NonManifold(std::uint32_t seed)
{
  constexpr int n = 4;
  TriangleMesh mesh;
  for (int sheet = 0; sheet < 3; ++sheet)
  {
    const double angle = 2.1 * sheet;
    TriangleMesh part = Grid(n,
      [angle](double u, double v) { return Vec3(u * std::cos(angle), u * std::sin(angle), v); });
    const Index shift = Index(mesh.NumberOfVertices());
    Append(mesh, part);
    for (std::size_t f = mesh.NumberOfFaces() - part.NumberOfFaces(); f < mesh.NumberOfFaces(); ++f)
    {
      for (Index& v : mesh.Triangles[f])
      {
        v = v - shift <= n ? v - shift : v;
      }
    }
  }
  const Index pole = Index(mesh.NumberOfVertices());
  Append(mesh, Sphere(1));
  for (std::size_t v = pole; v < mesh.NumberOfVertices(); ++v)
  {
    mesh.Positions[v] =
      mesh.Positions[Index(n * (n + 1) + 2)] + 0.3 * (mesh.Positions[v] - Vec3(-1.0, 0.0, 0.0));
  }
  for (Triangle& t : mesh.Triangles)
  {
    std::replace(t.begin(), t.end(), Index(pole + 1), Index(n * (n + 1) + 2));
  }
  AddDirectionNoise(mesh, 0.1, seed);
  return mesh;
}

/// Faces of no area, faces that repeat a vertex, a face stored twice, points in the same place, a
/// point without faces.
TriangleMesh Degenerate(std::uint32_t seed)
{
  TriangleMesh mesh = NoisyCube(seed);
  PortableRandom random(seed);
  const std::size_t faces = mesh.NumberOfFaces();
  for (int k = 0; k < 4; ++k)
  {
    const Triangle t = mesh.Triangles[random.Below(faces)];
    mesh.Positions[t[0]] = mesh.Positions[t[1]];
    const Triangle s = mesh.Triangles[random.Below(faces)];
    mesh.Positions[s[2]] = 0.5 * (mesh.Positions[s[0]] + mesh.Positions[s[1]]);
  }
  const Triangle a = mesh.Triangles[random.Below(faces)];
  const Triangle b = mesh.Triangles[random.Below(faces)];
  mesh.Triangles.push_back({ a[0], a[0], a[1] });
  mesh.Triangles.push_back({ a[2], b[1], a[2] });
  mesh.Triangles.push_back({ b[0], b[0], b[0] });
  mesh.Triangles.push_back(b);
  mesh.Positions.push_back(Vec3(3.0, 3.0, 3.0));
  return mesh;
}

/// A sheet, a sphere, and a cube that is a hundred times smaller.
TriangleMesh Components(std::uint32_t seed)
{
  TriangleMesh mesh = NoisyGrid(seed);
  TriangleMesh sphere = Sphere(1);
  AddDirectionNoise(sphere, 0.2, seed + 1);
  Append(mesh, sphere);
  TriangleMesh small = Cube(1);
  AddNormalNoise(small, 0.1, seed + 2);
  for (Vec3& p : small.Positions)
  {
    p = 0.01 * p + Vec3(0.0, 0.0, 2.0);
  }
  Append(mesh, small);
  return mesh;
}

TriangleMesh SingleTriangle(std::uint32_t seed)
{
  TriangleMesh mesh;
  PortableRandom random(seed);
  mesh.Positions = { random.Direction(), random.Direction(), random.Direction() };
  mesh.Triangles = { Triangle{ 0, 1, 2 } };
  return mesh;
}

TriangleMesh TurnedFaces(std::uint32_t seed)
{
  TriangleMesh mesh = NoisyTorus(seed);
  PortableRandom random(seed);
  for (int k = 0; k < 40; ++k)
  {
    Triangle& t = mesh.Triangles[random.Below(mesh.NumberOfFaces())];
    std::swap(t[1], t[2]);
  }
  return mesh;
}

/// Every face with vertices of its own, as in STL files.
TriangleMesh TriangleSoup(std::uint32_t seed)
{
  const TriangleMesh closed = NoisyCube(seed);
  TriangleMesh mesh;
  for (const Triangle& t : closed.Triangles)
  {
    const Index first = Index(mesh.NumberOfVertices());
    for (const Index v : t)
    {
      mesh.Positions.push_back(closed.Positions[v]);
    }
    mesh.Triangles.push_back({ first, first + 1, first + 2 });
  }
  return mesh;
}

}

double PortableRandom::Uniform()
{
  this->State = 1664525u * this->State + 1013904223u;
  return (this->State + 0.5) / 4294967296.0;
}

double PortableRandom::Gaussian()
{
  const double first = this->Uniform();
  const double second = this->Uniform();
  return std::sqrt(-2.0 * std::log(first)) * std::cos(2.0 * Pi * second);
}

Vec3 PortableRandom::Direction()
{
  const double z = 2.0 * this->Uniform() - 1.0;
  const double longitude = 2.0 * Pi * this->Uniform();
  const double r = std::sqrt(1.0 - z * z);
  return Vec3(r * std::cos(longitude), r * std::sin(longitude), z);
}

std::uint32_t PortableRandom::Below(std::size_t count)
{
  return static_cast<std::uint32_t>(this->Uniform() * static_cast<double>(count));
}

TriangleMesh Cube(int n)
{
  TriangleMesh mesh;
  std::map<std::array<int, 3>, Index> ids;
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      for (int k = 0; k <= n; ++k)
      {
        if (i % n == 0 || j % n == 0 || k % n == 0)
        {
          ids[{ i, j, k }] = Index(mesh.NumberOfVertices());
          mesh.Positions.push_back(Vec3(i, j, k) / n);
        }
      }
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int side : { 0, n })
    {
      for (int u = 0; u < n; ++u)
      {
        for (int v = 0; v < n; ++v)
        {
          auto corner = [&](int du, int dv)
          {
            std::array<int, 3> at;
            at[axis] = side;
            at[(axis + 1) % 3] = u + du;
            at[(axis + 2) % 3] = v + dv;
            return ids.at(at);
          };
          const Index c00 = corner(0, 0);
          const Index c10 = corner(1, 0);
          const Index c11 = corner(1, 1);
          const Index c01 = corner(0, 1);
          mesh.Triangles.push_back(
            side > 0 ? Triangle{ c00, c10, c11 } : Triangle{ c00, c11, c10 });
          mesh.Triangles.push_back(
            side > 0 ? Triangle{ c00, c11, c01 } : Triangle{ c00, c01, c11 });
        }
      }
    }
  }
  return mesh;
}

void AddNormalNoise(TriangleMesh& mesh, double relative, std::uint32_t seed)
{
  const double sigma = relative * MeanEdgeLength(mesh);
  Execution serial;
  const Buffer<Vec3> normals = VertexAreaVectors(mesh, VertexStars(mesh), serial);
  PortableRandom random(seed);
  for (std::size_t v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    mesh.Positions[v] += sigma * random.Gaussian() * normals[v].normalized();
  }
}

void AddDirectionNoise(TriangleMesh& mesh, double relative, std::uint32_t seed)
{
  const double sigma = relative * MeanEdgeLength(mesh);
  PortableRandom random(seed);
  for (Vec3& p : mesh.Positions)
  {
    const double amplitude = sigma * random.Gaussian();
    p += amplitude * random.Direction();
  }
}

TriangleMesh PlaneSheet(int n, std::uint32_t seed)
{
  PortableRandom random(seed);
  return Grid(n,
    [&random, n](double u, double v)
    {
      const double du = 0.3 / n * (2.0 * random.Uniform() - 1.0);
      const double dv = 0.3 / n * (2.0 * random.Uniform() - 1.0);
      return Vec3(u + du, v + dv, 0.0);
    });
}

const std::vector<MeshRecipe>& MeshRecipes()
{
  static const std::vector<MeshRecipe> recipes = {
    { "NoisyGrid", NoisyGrid, false },
    { "NoisyCube", NoisyCube, false },
    { "NoisySphere", NoisySphere, false },
    { "NoisyTorus", NoisyTorus, false },
    { "NonManifold", NonManifold, false },
    { "Degenerate", Degenerate, false },
    { "Components", Components, false },
    { "SingleTriangle", SingleTriangle, false },
    { "TurnedFaces", TurnedFaces, true },
    { "TriangleSoup", TriangleSoup, true },
  };
  return recipes;
}

void PrintTo(const MeshRecipe& recipe, std::ostream* out) { *out << recipe.Name; }
