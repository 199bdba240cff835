// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// What follows from the connections of a mesh: edges, orientation, seams, and how denoising treats
// them.

#include "CoincidentVertices.h"
#include "FaceOrientation.h"
#include "MeshDenoising.h"
#include "RandomMeshes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace SurfaceDenoising;

namespace
{

EdgeCensus Census(const TriangleMesh& mesh)
{
  Execution serial;
  return TakeEdgeCensus(mesh, VertexStars(mesh), serial);
}

TriangleMesh Recipe(const std::string& name, std::uint32_t seed = 1)
{
  for (const MeshRecipe& recipe : MeshRecipes())
  {
    if (name == recipe.Name)
    {
      return recipe.Make(seed);
    }
  }
  ADD_FAILURE() << "no mesh " << name;
  return TriangleMesh();
}

/// A strip of n squares around a cylinder; twisted, it is a Moebius strip.
TriangleMesh Strip(Index n, bool twisted)
{
  TriangleMesh mesh;
  for (Index i = 0; i < n; ++i)
  {
    const double angle = 2.0 * 3.14159265358979 * i / n;
    const double tilt = twisted ? 0.5 * angle : 0.0;
    const Vec3 out(std::cos(angle), std::sin(angle), 0.0);
    const Vec3 across = std::sin(tilt) * out + Vec3(0, 0, std::cos(tilt));
    mesh.Positions.push_back(out + 0.3 * across);
    mesh.Positions.push_back(out - 0.3 * across);
    const Index a = 2 * i;
    const Index b = a + 1;
    const bool last = i + 1 == n;
    const Index c = last ? (twisted ? 1 : 0) : a + 2;
    const Index d = last ? (twisted ? 0 : 1) : a + 3;
    mesh.Triangles.push_back({ a, b, d });
    mesh.Triangles.push_back({ a, d, c });
  }
  return mesh;
}

}

TEST(EdgeCensus, Cube)
{
  const EdgeCensus edges = Census(Cube(8));
  EXPECT_EQ(edges.NumberOfEdges, 1152u);
  EXPECT_EQ(edges.NumberOfBoundaryEdges, 0u);
  EXPECT_EQ(edges.NumberOfNonManifoldEdges, 0u);
  EXPECT_EQ(edges.NumberOfInconsistentEdges, 0u);
  EXPECT_NEAR(edges.MeanEdgeLength, 0.142258898, 1e-9);
}

TEST(EdgeCensus, ThreeSheets)
{
  const EdgeCensus edges = Census(Recipe("NonManifold"));
  EXPECT_EQ(edges.NumberOfNonManifoldEdges, 4u);
  EXPECT_EQ(edges.NumberOfBoundaryEdges, 36u);
}

TEST(EdgeCensus, BoundaryVerticesAreTheEndsOfBoundaryEdges)
{
  constexpr int n = 5;
  const EdgeCensus edges = Census(PlaneSheet(n, 1));
  EXPECT_EQ(edges.NumberOfBoundaryEdges, std::size_t(4 * n));
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      const bool border = i % n == 0 || j % n == 0;
      EXPECT_EQ(bool(edges.BoundaryVertex[i * (n + 1) + j]), border);
    }
  }
}

TEST(FaceOrientation, TurnedFacesAreFoundAndTheMajorityWins)
{
  const TriangleMesh consistent = Recipe("NoisyTorus");
  TriangleMesh mesh = consistent;
  PortableRandom random(8);
  std::vector<int> expected(mesh.NumberOfFaces(), 0);
  for (std::size_t f = 0; f < expected.size(); ++f)
  {
    if (random.Uniform() < 0.3)
    {
      std::swap(mesh.Triangles[f][1], mesh.Triangles[f][2]);
      expected[f] = 1;
    }
  }
  EXPECT_GT(Census(mesh).NumberOfInconsistentEdges, 0u);
  const Buffer<unsigned char> turned = OrientFaces(mesh, VertexStars(mesh));
  EXPECT_EQ(std::vector<int>(turned.begin(), turned.end()), expected);
  EXPECT_EQ(mesh.Triangles, consistent.Triangles);
  EXPECT_EQ(Census(mesh).NumberOfInconsistentEdges, 0u);
}

TEST(FaceOrientation, EveryPartIsDecidedOnItsOwn)
{
  TriangleMesh mesh = Recipe("Components");
  const TriangleMesh consistent = mesh;
  const std::size_t faces = mesh.NumberOfFaces();
  for (std::size_t f = faces - 12; f < faces; ++f) // the small cube, all of it
  {
    std::swap(mesh.Triangles[f][1], mesh.Triangles[f][2]);
  }
  std::swap(mesh.Triangles[3][1], mesh.Triangles[3][2]);
  const Buffer<unsigned char> turned = OrientFaces(mesh, VertexStars(mesh));
  for (std::size_t f = 0; f < faces; ++f)
  {
    EXPECT_EQ(turned[f], f == 3) << f;
  }
}

TEST(FaceOrientation, MoebiusStrip)
{
  EXPECT_EQ(Census(Strip(20, false)).NumberOfInconsistentEdges, 0u);
  TriangleMesh strip = Strip(20, true);
  EXPECT_EQ(Census(strip).NumberOfInconsistentEdges, 1u);
  OrientFaces(strip, VertexStars(strip)); // cannot do it, but comes to an end
  EXPECT_EQ(Census(strip).NumberOfInconsistentEdges, 1u);
}

TEST(CoincidentVertices, OnTheBoundaryOnly)
{
  TriangleMesh mesh = PlaneSheet(4, 1);
  mesh.Positions[0] = mesh.Positions[4];  // both corners
  mesh.Positions[24] = mesh.Positions[4]; // and a third one
  mesh.Positions[12] = mesh.Positions[7]; // both inside
  const auto found = FindCoincidentVertices(mesh, Census(mesh).BoundaryVertex);
  ASSERT_EQ(found.size(), 2u);
  for (const CoincidentVertex& seam : found)
  {
    EXPECT_EQ(seam.Original, 0u);
    EXPECT_TRUE(seam.Vertex == 4 || seam.Vertex == 24);
  }
}

TEST(CoincidentVertices, TriangleSoupIsDenoisedAsTheClosedSurface)
{
  TriangleMesh soup = Recipe("TriangleSoup");
  TriangleMesh closed = Recipe("NoisyCube"); // the soup was made of it
  const Buffer<Triangle> triangles = soup.Triangles;
  Buffer<Vec3> soupNormals;
  Buffer<Vec3> closedNormals;
  MeshDenoisingReport soupReport;
  MeshDenoisingReport closedReport;
  Execution serial;
  MeshDenoisingSettings settings;
  settings.Vertices.PreventFlips = true;
  ASSERT_TRUE(DenoiseMesh(soup, soupNormals, settings, soupReport, serial));
  ASSERT_TRUE(DenoiseMesh(closed, closedNormals, settings, closedReport, serial));
  EXPECT_EQ(soupReport.SeamVertices, soup.NumberOfVertices() - closed.NumberOfVertices());
  EXPECT_EQ(soupReport.BoundaryEdges, 0u);
  EXPECT_EQ(closedReport.SeamVertices, 0u);
  EXPECT_EQ(soup.Triangles, triangles);
  for (std::size_t f = 0; f < soup.NumberOfFaces(); ++f)
  {
    EXPECT_LT((soupNormals[f] - closedNormals[f]).norm(), 1e-12);
    for (int corner = 0; corner < 3; ++corner)
    {
      const Vec3& p = soup.Positions[soup.Triangles[f][corner]];
      EXPECT_LT((p - closed.Positions[closed.Triangles[f][corner]]).norm(), 1e-12);
    }
  }
}

TEST(MeshDenoising, ReportsWhatIsWrongWithAMesh)
{
  auto report = [](TriangleMesh mesh)
  {
    Buffer<Vec3> normals;
    MeshDenoisingReport result;
    Execution serial;
    EXPECT_TRUE(DenoiseMesh(mesh, normals, MeshDenoisingSettings(), result, serial));
    return result;
  };
  const MeshDenoisingReport nonManifold = report(Recipe("NonManifold"));
  EXPECT_EQ(nonManifold.NonManifoldEdges, 4u);
  EXPECT_EQ(nonManifold.BoundaryEdges, 36u);
  EXPECT_GT(report(Recipe("Degenerate")).DegenerateFaces, 3u);
  EXPECT_GT(report(Recipe("TurnedFaces")).TurnedFaces, 10u);
  EXPECT_EQ(report(Recipe("SingleTriangle")).UnfilteredFaces, 1u);
  EXPECT_EQ(report(TriangleMesh()).MeanEdgeLength, 0.0);
}

TEST(MeshDenoising, GivenNormalsAreTheStart)
{
  const TriangleMesh clean = Cube(4);
  TriangleMesh noisy = clean;
  AddNormalNoise(noisy, 0.2, 1);
  Execution serial;
  FaceGeometry geometry;
  ComputeFaceGeometry(clean, 1.0, geometry, serial);
  Buffer<Vec3> normals = geometry.Normals;
  MeshDenoisingSettings settings;
  settings.NormalIterations = 0;
  settings.VertexIterations = 200;
  MeshDenoisingReport report;
  ASSERT_TRUE(DenoiseMesh(noisy, normals, settings, report, serial));
  EXPECT_EQ(normals, geometry.Normals);
  ComputeFaceGeometry(noisy, 1.0, geometry, serial);
  for (std::size_t f = 0; f < normals.size(); ++f)
  {
    EXPECT_GT(geometry.Normals[f].dot(normals[f]), 0.9999) << f;
  }
}

TEST(MeshDenoising, StopsWhenAskedTo)
{
  struct Impatient : Execution
  {
    bool Proceed(double fraction) override
    {
      EXPECT_GE(fraction, this->Fraction);
      EXPECT_LE(fraction, 1.0);
      this->Fraction = fraction;
      return ++this->Asked <= this->Patience;
    }
    double Fraction = 0.0;
    int Asked = 0;
    int Patience = 1000;
  };
  Impatient all;
  TriangleMesh mesh = Recipe("NoisyCube");
  Buffer<Vec3> normals;
  MeshDenoisingReport report;
  MeshDenoisingSettings settings;
  settings.OuterIterations = 2;
  EXPECT_TRUE(DenoiseMesh(mesh, normals, settings, report, all));
  EXPECT_EQ(all.Fraction, 1.0);
  EXPECT_GT(all.Asked, 60);
  for (int patience = 0; patience < all.Asked; ++patience)
  {
    Impatient some;
    some.Patience = patience;
    mesh = Recipe("NoisyCube");
    normals.clear();
    EXPECT_FALSE(DenoiseMesh(mesh, normals, settings, report, some));
    EXPECT_EQ(some.Asked, patience + 1) << "asked again after the answer was no";
  }
}

TEST(MeshDenoising, NoNoiseFoundChangesNothing)
{
  TriangleMesh mesh = PlaneSheet(5, 1);
  const Buffer<Vec3> before = mesh.Positions;
  Buffer<Vec3> normals;
  MeshDenoisingReport report;
  MeshDenoisingSettings settings;
  settings.NormScale = 0.0;
  Execution serial;
  EXPECT_TRUE(DenoiseMesh(mesh, normals, settings, report, serial));
  EXPECT_TRUE(report.NoNoiseFound);
  EXPECT_EQ(mesh.Positions, before);
}
