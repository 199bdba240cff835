// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// The methods of one stage: numbers worked out by hand, identities, and whole runs on a noisy cube
// against the figures of an independent program.

#include "Metrics.h"
#include "NeighborGraph.h"
#include "OneStage/AnisotropicCurvatureFlow.h"
#include "OneStage/BilateralVertices.h"
#include "OneStage/CotangentLaplacian.h"
#include "OneStage/MeanCurvatureFlow.h"
#include "OneStage/NonIterativeBilateral.h"
#include "RandomMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace SurfaceDenoising;

namespace
{

constexpr double Digits = 5.1e-7; // the numbers have six decimals
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Four faces around a vertex at height 0.5; the ring is a square with the corners (1, 0, 0) etc.
class Fan : public testing::Test
{
protected:
  Fan()
  {
    this->Mesh.Positions = { Vec3(0, 0, 0.5), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0),
      Vec3(0, -1, 0) };
    this->Mesh.Triangles = { Triangle{ 0, 1, 2 }, Triangle{ 0, 2, 3 }, Triangle{ 0, 3, 4 },
      Triangle{ 0, 4, 1 } };
    this->Stars = VertexStars(this->Mesh);
    this->Length = TakeEdgeCensus(this->Mesh, this->Stars, this->Serial).MeanEdgeLength;
    ComputeFaceGeometry(this->Mesh, this->Length, this->Faces, this->Serial);
  }

  /// Where method(prepared, execution) moves the tip; the border stays.
  template <typename Method>
  Vec3 Tip(Method method)
  {
    TriangleMesh moved = this->Mesh;
    PreparedMesh prepared(moved);
    EXPECT_TRUE(prepared.Prepare(this->Serial));
    EXPECT_TRUE(method(prepared, this->Serial));
    prepared.Finish();
    for (std::size_t v = 1; v < 5; ++v)
    {
      EXPECT_EQ(moved.Positions[v], this->Mesh.Positions[v]);
    }
    return moved.Positions[0];
  }

  /// A time as the flows take it.
  double Relative(double time) const { return time / (this->Length * this->Length); }

  TriangleMesh Mesh;
  CompressedRows Stars;
  double Length;
  FaceGeometry Faces;
  Execution Serial;
};

void ExpectVec(const Vec3& actual, const Vec3& expected)
{
  EXPECT_LT((actual - expected).cwiseAbs().maxCoeff(), Digits) << actual.transpose();
}

/// The sum over faces of 1/2 n x (r - q), for the face (v, q, r).
Vec3 AreaGradient(const TriangleMesh& mesh, const CompressedRows& stars, const FaceGeometry& faces,
  Index v)
{
  Vec3 gradient(0.0, 0.0, 0.0);
  for (const Index f : stars.Row(v))
  {
    const Triangle& t = mesh.Triangles[f];
    const int corner = t[0] == v ? 0 : (t[1] == v ? 1 : 2);
    const Vec3 opposite = mesh.Positions[t[(corner + 2) % 3]] - mesh.Positions[t[(corner + 1) % 3]];
    gradient += 0.5 * faces.Normals[f].cross(opposite);
  }
  return gradient;
}

}

TEST_F(Fan, AreaGradientAndMass)
{
  ExpectVec(AreaGradient(this->Mesh, this->Stars, this->Faces, 0), Vec3(0, 0, 1.632993));
  CotangentLaplacian laplacian(this->Mesh, this->Stars, this->Serial);
  laplacian.Update(this->Serial);
  ExpectVec(laplacian.Apply(this->Mesh.Positions, 0), Vec3(0, 0, 1.632993));
  EXPECT_NEAR(laplacian.Diagonal()[0], 4 * 0.816497, 4 * Digits);
  EXPECT_NEAR(laplacian.Masses()[0], 0.816497, Digits);
}

TEST_F(Fan, ImplicitFlow)
{
  MeanCurvatureFlowSettings settings;
  settings.Steps = 1;
  settings.TimeStep = this->Relative(0.05);
  MeanCurvatureFlowReport report;
  ExpectVec(this->Tip([&](PreparedMesh& mesh, Execution& execution)
              { return FlowByMeanCurvature(mesh, settings, report, execution); }),
    Vec3(0, 0, 0.416667));
}

TEST_F(Fan, AnisotropicFlow)
{
  std::vector<CurvatureSpoke> spokes;
  auto curvature = [&](double lambda)
  {
    return AnisotropicCurvature(this->Mesh, this->Stars.Row(0), this->Faces.Normals, 0, lambda,
      spokes);
  };
  ExpectVec(curvature(0.5), Vec3(0, 0, 0.208863));
  EXPECT_EQ(spokes.size(), 4u);
  EXPECT_NEAR(spokes[2].Curvature, 0.912871, Digits);
  EXPECT_NEAR(AnisotropicWeight(0.912871, 0.5), 0.127902, Digits);
  EXPECT_NEAR(AnisotropicWeight(-0.912871, 0.5), 0.127902, Digits);
  EXPECT_EQ(AnisotropicWeight(0.5, 0.5), 1.0);
  ExpectVec(curvature(Infinity), Vec3(0, 0, 1.632993));

  AnisotropicCurvatureFlowSettings settings;
  settings.Steps = 1;
  settings.TimeStep = this->Relative(0.05);
  auto run = [&](PreparedMesh& mesh, Execution& execution)
  { return FlowByAnisotropicCurvature(mesh, settings, execution); };
  settings.EdgeThreshold = 0.5 / this->Length;
  ExpectVec(this->Tip(run), Vec3(0, 0, 0.487210));
  settings.EdgeThreshold = Infinity; // an explicit step of mean curvature flow
  ExpectVec(this->Tip(run), Vec3(0, 0, 0.400000));
  settings.PrescribeCurvature = true; // the only one that has a curvature keeps it
  ExpectVec(this->Tip(run), Vec3(0, 0, 0.5));
}

TEST_F(Fan, BilateralVertices)
{
  BilateralVerticesSettings settings;
  settings.Iterations = 1;
  settings.SpatialScale = 1.0 / std::sqrt(1.25); // s_c = 1
  settings.RangeScale = 0.3 / 0.2;               // s_s = 0.3
  ExpectVec(this->Tip([&](PreparedMesh& mesh, Execution& execution)
              { return FilterVerticesBilaterally(mesh, settings, execution); }),
    Vec3(0, 0, 0.325972));
}

TEST_F(Fan, NonIterativeBilateral)
{
  this->Faces.Normals.assign(4, Vec3(0, 0, 1));
  Buffer<Vec3> predicted;
  PredictVertices(this->Mesh, this->Stars, this->Faces, 1.0, 0.5, {}, predicted, this->Serial);
  ExpectVec(predicted[0], Vec3(0, 0, 0.166667));
  // No face within reach.
  PredictVertices(this->Mesh, this->Stars, this->Faces, 0.1, 0.5, {}, predicted, this->Serial);
  EXPECT_EQ(predicted, this->Mesh.Positions);
}

// Three ways to the gradient of the area: by faces, by cotangents, by edges.
TEST(Identity, AreaGradients)
{
  for (const MeshRecipe& recipe : MeshRecipes())
  {
    TriangleMesh given = recipe.Make(5);
    Execution serial;
    PreparedMesh prepared(given);
    prepared.Prepare(serial);
    if (prepared.Facts().DegenerateFaces > 0)
    {
      continue; // there is no gradient
    }
    const TriangleMesh& mesh = prepared.Mesh();
    const CompressedRows& stars = prepared.Stars();
    FaceGeometry faces;
    ComputeFaceGeometry(mesh, prepared.Facts().MeanEdgeLength, faces, serial);
    CotangentLaplacian laplacian(mesh, stars, serial);
    laplacian.Update(serial);
    std::vector<CurvatureSpoke> spokes;
    for (Index v = 0; v < mesh.NumberOfVertices(); ++v)
    {
      const Vec3 expected = AreaGradient(mesh, stars, faces, v);
      EXPECT_LT((laplacian.Apply(mesh.Positions, v) - expected).norm(), 1e-12) << recipe.Name;
      EXPECT_LT(
        (AnisotropicCurvature(mesh, stars.Row(v), faces.Normals, v, Infinity, spokes) - expected)
          .norm(),
        1e-12)
        << recipe.Name;
    }
  }
}

namespace
{

struct Figures
{
  double MeanAngle; ///< between the normals of the faces and those of the clean cube, degrees
  double Volume;
  double FeatureEdges; ///< sharper than 70 degrees
};

/// A method on the cube with noise along normals (k = 0.2), then in random directions (k = 0.3).
template <typename Method>
void ExpectFigures(const Figures& alongNormals, const Figures& inAnyDirection, Method method)
{
  const TriangleMesh clean = Cube(8);
  for (const bool random : { false, true })
  {
    TriangleMesh mesh = clean;
    (random ? AddDirectionNoise : AddNormalNoise)(mesh, random ? 0.3 : 0.2, 12345);
    Execution serial;
    PreparedMesh prepared(mesh);
    prepared.Prepare(serial);
    EXPECT_TRUE(method(prepared, serial));
    prepared.Finish();

    FaceGeometry faces;
    FaceGeometry reference;
    ComputeFaceGeometry(mesh, 1.0, faces, serial);
    ComputeFaceGeometry(clean, 1.0, reference, serial);
    double angle = 0.0;
    for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
    {
      angle += AngleBetween(faces.Normals[f], reference.Normals[f]) / double(mesh.NumberOfFaces());
    }
    const NeighborGraph edges = EdgeAdjacentFaces(mesh, VertexStars(mesh), serial);
    const std::size_t features =
      CompareFeatureEdges(edges, faces.Normals, faces.Normals, 70.0, serial).Reference;
    const Figures& expected = random ? inAnyDirection : alongNormals;
    EXPECT_NEAR(angle, expected.MeanAngle, 6e-4) << (random ? "random" : "normal");
    EXPECT_NEAR(SignedVolume(mesh, serial), expected.Volume, 6e-6);
    EXPECT_EQ(features, expected.FeatureEdges);
  }
}

}

TEST(OneStageCube, MeanCurvatureFlow)
{
  MeanCurvatureFlowSettings settings;
  settings.TimeStep = 1.0;
  MeanCurvatureFlowReport report;
  ExpectFigures({ 29.366, 0.37159, 0 }, { 29.581, 0.34909, 0 },
    [&](PreparedMesh& mesh, Execution& execution)
    { return FlowByMeanCurvature(mesh, settings, report, execution); });
  EXPECT_FALSE(report.VolumeRestored);
}

TEST(OneStageCube, AnisotropicFlow)
{
  AnisotropicCurvatureFlowSettings settings;
  settings.Steps = 20;
  settings.MaximumRate = Infinity; // as in the paper
  auto run = [&](PreparedMesh& mesh, Execution& execution)
  { return FlowByAnisotropicCurvature(mesh, settings, execution); };
  ExpectFigures({ 9.792, 0.88513, 56 }, { 11.439, 0.88050, 66 }, run);
  settings.EdgeThreshold = Infinity;
  ExpectFigures({ 33.672, 0.57900, 60 }, { 32.665, 0.56990, 54 }, run);
}

TEST(OneStageCube, BilateralVertices)
{
  const BilateralVerticesSettings settings;
  ExpectFigures({ 9.122, 0.90869, 40 }, { 13.946, 0.94174, 63 },
    [&](PreparedMesh& mesh, Execution& execution)
    { return FilterVerticesBilaterally(mesh, settings, execution); });
}

TEST(OneStageCube, NonIterativeBilateral)
{
  const NonIterativeBilateralSettings settings;
  ExpectFigures({ 9.613, 1.03640, 38 }, { 11.827, 1.03872, 68 },
    [&](PreparedMesh& mesh, Execution& execution)
    { return FilterVerticesByPrediction(mesh, settings, execution); });
}
