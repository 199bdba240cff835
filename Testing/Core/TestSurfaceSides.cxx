// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CompareMeshes.h"
#include "LineAngles.h"
#include "TriangleTree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>

using namespace SurfaceDenoising;

namespace
{

Execution Serial;

/// A mesh, the search for its nearest face, and its sides.
struct Sided
{
  explicit Sided(const TriangleMesh& mesh)
    : Mesh(mesh)
    , Census(TakeEdgeCensus(mesh, VertexStars(mesh), Serial))
    , Geometry(GeometryOf(mesh))
    , Tree(mesh, this->Geometry.Areas)
    , Sides(mesh, this->Census, this->Geometry, Serial)
  {
  }

  double Distance(const Vec3& p) const
  {
    const TriangleTree::Hit hit = this->Tree.Nearest(p);
    return this->Sides.SignedDistance(p, hit.Face, hit.Distance);
  }

  std::vector<Index> Nearest(const Vec3& p) const
  {
    std::vector<Index> faces;
    this->Sides.VisitNearest(p, this->Tree.Nearest(p).Face, [&](Index f) { faces.push_back(f); });
    return faces;
  }

  static FaceGeometry GeometryOf(const TriangleMesh& mesh)
  {
    FaceGeometry geometry;
    ComputeFaceGeometry(mesh, 1.0, geometry, Serial);
    return geometry;
  }

  TriangleMesh Mesh;
  EdgeCensus Census;
  FaceGeometry Geometry;
  TriangleTree Tree;
  SurfaceSides Sides;
};

/// An octahedron of which every triangle is cut into four, with random distances of its 18 vertices
/// from the middle: acute and obtuse edges, hills and hollows.
TriangleMesh Star(std::uint32_t seed)
{
  TriangleMesh mesh;
  PortableRandom random(seed);
  std::map<std::array<int, 3>, Index> ids;
  auto vertex = [&](const Vec3& direction)
  {
    const std::array<int, 3> key{ static_cast<int>(2.0 * direction[0]),
      static_cast<int>(2.0 * direction[1]), static_cast<int>(2.0 * direction[2]) };
    const auto [place, isNew] = ids.emplace(key, static_cast<Index>(mesh.NumberOfVertices()));
    if (isNew)
    {
      mesh.Positions.push_back((0.15 + random.Uniform()) * direction.normalized());
    }
    return place->second;
  };
  for (int octant = 0; octant < 8; ++octant)
  {
    const Vec3 x(octant & 1 ? 1.0 : -1.0, 0.0, 0.0);
    Vec3 y(0.0, octant & 2 ? 1.0 : -1.0, 0.0);
    Vec3 z(0.0, 0.0, octant & 4 ? 1.0 : -1.0);
    if (x.cross(y).dot(z) < 0.0)
    {
      std::swap(y, z);
    }
    const Index a = vertex(x);
    const Index b = vertex(y);
    const Index c = vertex(z);
    const Index ab = vertex(0.5 * (x + y));
    const Index bc = vertex(0.5 * (y + z));
    const Index ca = vertex(0.5 * (z + x));
    for (const Triangle& t :
      { Triangle{ a, ab, ca }, { ab, b, bc }, { ca, bc, c }, { ab, bc, ca } })
    {
      mesh.Triangles.push_back(t);
    }
  }
  return mesh;
}

/// Every triangle with vertices of its own.
TriangleMesh Soup(const TriangleMesh& mesh)
{
  TriangleMesh soup;
  for (const Triangle& t : mesh.Triangles)
  {
    const Index first = static_cast<Index>(soup.NumberOfVertices());
    for (const Index v : t)
    {
      soup.Positions.push_back(mesh.Positions[v]);
    }
    soup.Triangles.push_back({ first, first + 1, first + 2 });
  }
  return soup;
}

/// How often the mesh winds around a position: the solid angles of its faces (van Oosterom and
/// Strackee 1983). 1 inside and 0 outside.
double WindingNumber(const TriangleMesh& mesh, const Vec3& p)
{
  double sum = 0.0;
  for (const Triangle& t : mesh.Triangles)
  {
    const Vec3 a = (mesh.Positions[t[0]] - p).normalized();
    const Vec3 b = (mesh.Positions[t[1]] - p).normalized();
    const Vec3 c = (mesh.Positions[t[2]] - p).normalized();
    sum += 2.0 * std::atan2(a.dot(b.cross(c)), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
  }
  return sum / (4.0 * std::acos(-1.0));
}

}

TEST(SurfaceSides, PartsOfATriangle)
{
  const std::array<Vec3, 3> corners{ Vec3(0.0, 0.0, 0.0), Vec3(4.0, 0.0, 0.0),
    Vec3(0.0, 4.0, 0.0) };
  auto part = [&](double x, double y, double z)
  {
    const TrianglePart nearest = NearestPart(Vec3(x, y, z), corners);
    std::string name;
    for (int i = 0; i < nearest.NumberOfCorners; ++i)
    {
      name += std::to_string(nearest.Corners[i]);
    }
    return name;
  };
  for (const double z : { -2.0, 0.0, 0.5 })
  {
    EXPECT_EQ(part(1.0, 1.0, z), "012");
    EXPECT_EQ(part(2.0, -3.0, z), "01");
    EXPECT_EQ(part(3.0, 3.0, z), "12");
    EXPECT_EQ(part(-3.0, 2.0, z), "20");
    EXPECT_EQ(part(-2.0, -1.0, z), "0");
    EXPECT_EQ(part(7.0, 0.0, z), "1");
    EXPECT_EQ(part(-1.0, 8.0, z), "2");
    // On the borders of these regions, the smaller part; rounding must not matter there.
    EXPECT_EQ(part(2.0, 0.0, z), "01");
    EXPECT_EQ(part(2.0, 1e-12, z), "01");
    EXPECT_EQ(part(1.0, 3.0 - 1e-12, z), "12");
    EXPECT_EQ(part(0.0, 0.0, z), "0");
    EXPECT_EQ(part(4.0 - 1e-12, 1e-12, z), "1");
    EXPECT_EQ(part(-1e-12, 4.0, z), "2");
  }
  const Vec3 point = NearestPart(Vec3(3.0, 3.0, 1.0), corners).Point;
  EXPECT_NEAR((point - Vec3(2.0, 2.0, 0.0)).norm(), 0.0, 1e-15);
}

TEST(SurfaceSides, TheSignIsThatOfTheWindingNumber)
{
  std::array<int, 4> parts{};
  for (std::uint32_t seed = 1; seed <= 20; ++seed)
  {
    const TriangleMesh star = Star(seed);
    const Sided sided(star);
    const Sided soup(Soup(star));
    ASSERT_EQ(sided.Census.NumberOfBoundaryEdges, 0u);
    ASSERT_TRUE(sided.Sides.AgreeOnOutside());
    PortableRandom random(100 + seed);
    for (int i = 0; i < 500; ++i)
    {
      const Vec3 p = 1.2 * random.Uniform() * random.Direction();
      const TriangleTree::Hit hit = sided.Tree.Nearest(p);
      if (hit.Distance < 1e-6)
      {
        continue; // the winding number jumps there
      }
      const Triangle& t = star.Triangles[hit.Face];
      ++parts[NearestPart(p, { star.Positions[t[0]], star.Positions[t[1]], star.Positions[t[2]] })
                .NumberOfCorners];
      const double expected = WindingNumber(star, p) > 0.5 ? -hit.Distance : hit.Distance;
      EXPECT_EQ(sided.Distance(p), expected) << "star " << seed << " at " << p.transpose();
      EXPECT_NEAR(soup.Distance(p), expected, 1e-15) << "soup " << seed;
    }
  }
  EXPECT_GT(*std::min_element(parts.begin() + 1, parts.end()), 500) << "all parts are tried";
}

/// The sum of the normals of a vertex, however many triangles a side is cut into, would be wrong.
TEST(SurfaceSides, NormalsOfVerticesAreWeighedByAngles)
{
  // A roof with an acute ridge along y. One side is cut into a fan of many triangles at the origin.
  const int fan = 50;
  TriangleMesh mesh;
  mesh.Positions.assign(
    { Vec3(0.0, 0.0, 0.0), Vec3(0.0, -1.0, 0.0), Vec3(0.0, 1.0, 0.0), Vec3(-0.3, 0.0, -1.0) });
  mesh.Triangles.assign({ Triangle{ 0, 3, 1 }, Triangle{ 0, 2, 3 } });
  for (int i = 1; i < fan; ++i)
  {
    const double angle = std::acos(-1.0) * (i / static_cast<double>(fan) - 0.5);
    mesh.Positions.push_back(Vec3(0.3 * std::cos(angle), std::sin(angle), -1.0 * std::cos(angle)));
  }
  for (Index i = 0; i < fan; ++i)
  {
    const Index from = i == 0 ? 1 : i + 3;
    const Index to = i == fan - 1 ? 2 : i + 4;
    mesh.Triangles.push_back({ 0, from, to });
  }
  const Sided roof(mesh);
  const Vec3 p(-0.4, 0.0, 0.13); // above the left side's normal, behind the right side's plane
  ASSERT_LT(p.dot(roof.Geometry.Normals[2]), 0.0);
  ASSERT_EQ(roof.Nearest(p).size(), 2u + fan) << "the nearest part is the tip of the fan";
  EXPECT_DOUBLE_EQ(roof.Distance(p), p.norm());
  Vec3 sum(0.0, 0.0, 0.0);
  for (const Vec3& n : roof.Geometry.Normals)
  {
    sum += n;
  }
  EXPECT_LT(p.dot(sum), 0.0) << "without weights it would be inside";
}

TEST(SurfaceSides, OpenSurfaces)
{
  TriangleMesh square;
  square.Positions.assign(
    { Vec3(0.0, 0.0, 0.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0), Vec3(1.0, 1.0, 0.0) });
  square.Triangles.assign({ Triangle{ 0, 1, 3 }, Triangle{ 0, 3, 2 } });
  const Sided sheet(square);
  EXPECT_DOUBLE_EQ(sheet.Distance(Vec3(0.4, 0.3, 0.5)), 0.5);
  EXPECT_DOUBLE_EQ(sheet.Distance(Vec3(0.4, 0.3, -0.5)), -0.5);
  EXPECT_DOUBLE_EQ(sheet.Distance(Vec3(0.4, -3.0, 4.0)), 5.0);
  EXPECT_DOUBLE_EQ(sheet.Distance(Vec3(0.4, -3.0, -4.0)), -5.0);
  EXPECT_DOUBLE_EQ(sheet.Distance(Vec3(-2.0, -1.0, -2.0)), -3.0);
  EXPECT_EQ(sheet.Distance(Vec3(0.4, 0.3, 0.0)), 0.0);
  EXPECT_EQ(sheet.Distance(Vec3(0.4, -3.0, 0.0)), 3.0) << "in the plane is outside";
  EXPECT_TRUE(std::isnan(sheet.Distance(Vec3(0.4, std::nan(""), 0.0))));
}

TEST(SurfaceSides, NeighboursMayDisagree)
{
  TriangleMesh box = Cube(2);
  EXPECT_TRUE(Sided(box).Sides.AgreeOnOutside());
  EXPECT_TRUE(Sided(Soup(box)).Sides.AgreeOnOutside());
  std::swap(box.Triangles[5][0], box.Triangles[5][1]);
  EXPECT_FALSE(Sided(box).Sides.AgreeOnOutside());
  EXPECT_FALSE(Sided(Soup(box)).Sides.AgreeOnOutside()) << "soups have neighbours too";
}

TEST(SurfaceSides, AllNearestFaces)
{
  const TriangleMesh box = Cube(2);
  for (const Sided& sided : { Sided(box), Sided(Soup(box)) })
  {
    EXPECT_EQ(sided.Nearest(Vec3(0.3, 0.1, 1.5)).size(), 1u);
    EXPECT_EQ(sided.Nearest(Vec3(0.2, -1.0, 2.0)).size(), 2u) << "an edge";
    const std::size_t corner = sided.Nearest(Vec3(2.0, 3.0, 4.0)).size();
    EXPECT_TRUE(corner >= 3 && corner <= 6) << "a corner";
    EXPECT_EQ(sided.Nearest(Vec3(1.0, 1.0, 1.0)).size(), corner) << "on the corner";
  }
  TriangleMesh sliver = box;
  sliver.Triangles.push_back({ 0, 1, 1 });
  const std::size_t faces = Sided(box).Nearest(box.Positions[0]).size();
  EXPECT_EQ(Sided(sliver).Nearest(box.Positions[0]).size(), faces) << "without area";
}

TEST(SurfaceSides, MarksAndNormalsDependOnAllNearestFaces)
{
  const TriangleMesh box = Cube(2);
  const Sided sided(box);
  const Buffer<Vec3> positions{ Vec3(0.2, -1.0, 2.0), Vec3(0.3, 0.1, 1.5), Vec3(0.0, 0.0, 0.0) };
  Buffer<Index> nearest;
  for (const Vec3& p : positions)
  {
    nearest.push_back(sided.Tree.Nearest(p).Face);
  }
  nearest[2] = NoIndex;
  // Mark one side of the edge after the other; the position sees both.
  for (const int axis : { 1, 2 })
  {
    Buffer<unsigned char> marked(box.NumberOfFaces(), 0);
    for (std::size_t f = 0; f < marked.size(); ++f)
    {
      marked[f] = std::abs(sided.Geometry.Normals[f][axis]) == 1.0;
    }
    EXPECT_EQ(MarkPositions(sided.Sides, positions, nearest, marked, Serial),
      (Buffer<unsigned char>{ 1, static_cast<unsigned char>(axis == 2), 0 }));
    const Vec3 normal = -Vec3::Unit(axis);
    const LineAngles angles = CompareWithFaces({ normal, normal, normal }, positions, nearest,
      sided.Sides, sided.Geometry.Normals, Serial);
    EXPECT_EQ(angles.Degrees[0], 0.0) << "on an edge either normal is right";
    EXPECT_EQ(angles.Degrees[1], axis == 2 ? 0.0 : 90.0);
    EXPECT_EQ(angles.Flipped[0], axis == 2) << "the sides look to -y and +z";
    EXPECT_TRUE(std::isnan(angles.Degrees[2]));
  }
  // As far from both sides, with the sign of one of them.
  for (const Vec3& normal : { Vec3(0.0, 1.0, 1.0), Vec3(0.0, -1.0, -1.0) })
  {
    const LineAngles angles = CompareWithFaces({ normal }, { positions[0] }, { nearest[0] },
      sided.Sides, sided.Geometry.Normals, Serial);
    EXPECT_DOUBLE_EQ(angles.Degrees[0], 45.0);
    EXPECT_FALSE(angles.Flipped[0]);
  }
}
