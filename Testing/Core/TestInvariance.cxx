// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// What denoising must not depend on, and how its result must follow its input, on every mesh.

#include "CompareMeshes.h"
#include "Methods.h"
#include "OddThreads.h"
#include "RandomMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace SurfaceDenoising;

namespace
{

struct Result
{
  TriangleMesh Mesh;
  Buffer<Vec3> Normals;
  MeshDenoisingReport Report;
};

Result Denoise(TriangleMesh mesh, const MeshDenoisingSettings& settings, Execution&& execution = {})
{
  Result result;
  result.Mesh = std::move(mesh);
  EXPECT_TRUE(DenoiseMesh(result.Mesh, result.Normals, settings, result.Report, execution));
  return result;
}

/// Settings with what to call them.
struct Variant
{
  std::string Name;
  MeshDenoisingSettings Settings;
};

/// Settings that differ in as many ways as possible, without norms that jump.
std::vector<MeshDenoisingSettings> Mixtures()
{
  std::vector<MeshDenoisingSettings> all(5);
  for (MeshDenoisingSettings& settings : all)
  {
    settings.NormalIterations = 4;
    settings.VertexIterations = 3;
  }
  all[1].Norm = NormId::Tukey;
  all[1].NormScale = 0.9;
  all[1].IncludeOwn = true;
  all[1].Neighborhood = FaceNeighborhood::EdgeAdjacent;
  all[1].Vertices.Boundary = BoundaryHandling::Slide;
  all[2].Norm = NormId::Huber;
  all[2].Argument = NormalArgument::DirectionalCurvature;
  all[2].OuterIterations = 3;
  all[2].NormalIterations = 1;
  all[2].Vertices.Scheme = VertexScheme::AreaWeighted;
  all[2].Vertices.Boundary = BoundaryHandling::Free;
  all[3].Norm = NormId::Lorentzian;
  all[3].NormScale = 0.0; // from the data
  all[3].Data = NormalData::Original;
  all[3].Weighting = SiteWeight::Uniform;
  all[3].IncludeOwn = true;
  all[3].SpatialScale = 0.0;
  all[3].Vertices.Scheme = VertexScheme::IntegralFit;
  all[3].Vertices.InputPull = 0.1;
  all[4].Norm = NormId::Centin;
  all[4].Argument = NormalArgument::Angle;
  all[4].Neighborhood = FaceNeighborhood::Radius;
  all[4].Radius = 1.7;
  all[4].Vertices.PreventFlips = true;
  all[4].Vertices.MaximumDisplacement = 0.3;
  return all;
}

/// The mixtures and every two-stage method of the table, with a few iterations.
std::vector<Variant> Variety()
{
  std::vector<Variant> all;
  for (const MeshDenoisingSettings& settings : Mixtures())
  {
    // Each has its own norm.
    all.push_back({ NameOf(MakeErrorNorm(settings.Norm, 1.0)), settings });
  }
  for (const MethodRow& row : Methods())
  {
    if (row.TwoStage)
    {
      MeshDenoisingSettings settings = row.Settings;
      settings.OuterIterations = std::min(2, settings.OuterIterations);
      settings.NormalIterations = std::min(3, settings.NormalIterations);
      settings.VertexIterations = std::min(3, settings.VertexIterations);
      settings.Vertices.PreventFlips = true;
      settings.Global.Tolerance = 1e-13;
      all.push_back({ row.Name, settings });
    }
  }
  return all;
}

const Mat3 Rotation = Eigen::AngleAxisd(1.1, Vec3(0.3, -0.7, 0.5).normalized()).toRotationMatrix();

class Invariance : public testing::TestWithParam<MeshRecipe>
{
protected:
  /**
   * Moves the mesh by the map x -> turn * scale * x + shift and compares with the moved result,
   * to tolerances for normals and for positions relative to the size.
   */
  void CheckMotion(const Mat3& turn, double scale, const Vec3& shift, double tolerance)
  {
    for (const auto& [name, settings] : Variety())
    {
      Result expected = Denoise(this->Mesh, settings);
      TriangleMesh moved = this->Mesh;
      auto move = [&](Vec3& p) { p = turn * (scale * p) + shift; };
      std::for_each(moved.Positions.begin(), moved.Positions.end(), move);
      const Result result = Denoise(moved, settings);
      std::for_each(expected.Mesh.Positions.begin(), expected.Mesh.Positions.end(), move);
      for (Vec3& n : expected.Normals)
      {
        n = turn * n;
      }
      EXPECT_LT(Distance(result.Normals, expected.Normals), tolerance) << name;
      EXPECT_LT(Distance(result.Mesh.Positions, expected.Mesh.Positions),
        tolerance * scale * ExtentOf(this->Mesh))
        << name;
    }
  }

  TriangleMesh Mesh = GetParam().Make(7);
};

}

TEST_P(Invariance, SameBitsOnAnyNumberOfThreads)
{
  for (const auto& [name, settings] : Variety())
  {
    const Result expected = Denoise(this->Mesh, settings);
    for (const std::size_t threads : { 1, 2, 3, 7 })
    {
      const Result result = Denoise(this->Mesh, settings, OddThreads(threads));
      EXPECT_EQ(result.Mesh.Positions, expected.Mesh.Positions);
      EXPECT_EQ(result.Normals, expected.Normals);
      EXPECT_EQ(result.Report.NormScale, expected.Report.NormScale);
      EXPECT_EQ(result.Report.UnfilteredFaces, expected.Report.UnfilteredFaces);
      EXPECT_EQ(result.Report.GuardedVertices, expected.Report.GuardedVertices);
    }
  }
}

TEST_P(Invariance, OrderOfVerticesFacesAndCorners)
{
  const ShuffledMesh other(this->Mesh);
  const std::vector<Index>& vertices = other.Vertices;
  const std::vector<Index>& faces = other.Faces;
  const TriangleMesh& shuffled = other.Mesh;
  for (const auto& [name, settings] : Variety())
  {
    const Result expected = Denoise(this->Mesh, settings);
    const Result result = Denoise(shuffled, settings);
    Buffer<Vec3> positions(vertices.size());
    Buffer<Vec3> normals(faces.size());
    std::transform(vertices.begin(), vertices.end(), positions.begin(),
      [&](Index v) { return result.Mesh.Positions[v]; });
    std::transform(faces.begin(), faces.end(), normals.begin(),
      [&](Index f) { return result.Normals[f]; });
    EXPECT_LT(Distance(positions, expected.Mesh.Positions), 1e-10 * ExtentOf(this->Mesh)) << name;
    EXPECT_LT(Distance(normals, expected.Normals), 1e-10) << name;
  }
}

TEST_P(Invariance, RigidMotion) { this->CheckMotion(Rotation, 1.0, Vec3(0.3, -0.2, 0.5), 1e-9); }

TEST_P(Invariance, Scale)
{
  this->CheckMotion(Mat3::Identity(), 1000.0, Vec3::Zero(), 1e-9);
  this->CheckMotion(Mat3::Identity(), 0.001, Vec3::Zero(), 1e-9);
}

// At a distance of 1e6 coordinates have a spacing of 1.2e-10. A triangle with edges of 0.02, the
// smallest here, then turns by up to 1e-8 or so, ten times more if it is thin.
TEST_P(Invariance, FarFromTheOrigin)
{
  if (Denoise(this->Mesh, {}).Report.DegenerateFaces > 0)
  {
    return; // there, rounding decides which faces have an area
  }
  this->CheckMotion(Mat3::Identity(), 1.0, Vec3(1e6, -1e6, 1e6), 3e-7);
}

TEST_P(Invariance, NoIterationsChangeNoBit)
{
  MeshDenoisingSettings settings;
  settings.NormalIterations = 0;
  settings.VertexIterations = 0;
  const Result result = Denoise(this->Mesh, settings);
  EXPECT_EQ(result.Mesh.Positions, this->Mesh.Positions);
  EXPECT_EQ(result.Mesh.Triangles, this->Mesh.Triangles);
  settings.OuterIterations = 0;
  const Result nothing = Denoise(this->Mesh, settings);
  EXPECT_EQ(nothing.Mesh.Positions, this->Mesh.Positions);
  EXPECT_EQ(nothing.Normals, result.Normals);
}

TEST_P(Invariance, NormalsGoOnWhereVerticesStay)
{
  MeshDenoisingSettings settings;
  settings.VertexIterations = 0;
  settings.NormalIterations = 6;
  const Result expected = Denoise(this->Mesh, settings);
  settings.OuterIterations = 3;
  settings.NormalIterations = 2;
  const Result result = Denoise(this->Mesh, settings);
  EXPECT_EQ(result.Normals, expected.Normals);
  EXPECT_EQ(result.Mesh.Positions, this->Mesh.Positions);
}

TEST_P(Invariance, FiniteForAllNormsWithUnitNormals)
{
  for (int norm = 0; norm < NumberOfNorms; ++norm)
  {
    MeshDenoisingSettings settings;
    settings.Norm = static_cast<NormId>(norm);
    settings.OuterIterations = 2;
    settings.Vertices.PreventFlips = norm % 2;
    const Result result = Denoise(this->Mesh, settings);
    for (const Vec3& p : result.Mesh.Positions)
    {
      ASSERT_TRUE(p.allFinite());
    }
    for (const Vec3& n : result.Normals)
    {
      ASSERT_TRUE(n.isZero() || std::abs(n.norm() - 1.0) < 1e-12);
    }
  }
}

TEST_P(Invariance, TurnedFaceHasTheOppositeNormalAndTheSamePoints)
{
  if (GetParam().NeedsRepair || this->Mesh.NumberOfFaces() < 2)
  {
    return; // there is no face to turn against others
  }
  const std::size_t face = 5;
  TriangleMesh turned = this->Mesh;
  std::swap(turned.Triangles[face][1], turned.Triangles[face][2]);
  for (const auto& [name, settings] : Variety())
  {
    const Result expected = Denoise(this->Mesh, settings);
    Result result = Denoise(turned, settings);
    EXPECT_EQ(result.Report.TurnedFaces, 1u);
    EXPECT_EQ(result.Mesh.Triangles, turned.Triangles);
    result.Normals[face] = -result.Normals[face];
    EXPECT_LT(Distance(result.Normals, expected.Normals), 1e-10);
    EXPECT_LT(Distance(result.Mesh.Positions, expected.Mesh.Positions), 1e-10);
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, Invariance, testing::ValuesIn(MeshRecipes()),
  [](const auto& info) { return std::string(info.param.Name); });

TEST(FixedPoint, PlaneSheet)
{
  const TriangleMesh sheet = PlaneSheet(9, 3);
  for (Variant variant : Variety())
  {
    SCOPED_TRACE(variant.Name);
    MeshDenoisingSettings& settings = variant.Settings;
    settings.Vertices.Boundary = BoundaryHandling::Fixed;
    settings.Vertices.Relaxation = 0.0; // it evens out triangles
    const Result result = Denoise(sheet, settings);
    EXPECT_LT(Distance(result.Mesh.Positions, sheet.Positions), 1e-12);
    for (const Vec3& n : result.Normals)
    {
      EXPECT_LT((n - Vec3(0.0, 0.0, 1.0)).norm(), 1e-14);
    }
  }
}

TEST(FixedPoint, CleanCubeForNormsWithACutOff)
{
  const TriangleMesh cube = Cube(8);
  for (const NormId norm : { NormId::TruncatedL2, NormId::TruncatedL1, NormId::Tukey })
  {
    for (const NormalArgument argument : { NormalArgument::Chord, NormalArgument::Angle })
    {
      MeshDenoisingSettings settings;
      settings.Norm = norm;
      settings.NormScale = 1.2; // less than the difference across the edges
      settings.Argument = argument;
      EXPECT_LT(Distance(Denoise(cube, settings).Mesh.Positions, cube.Positions), 1e-14);
    }
  }
}

TEST(FixedPoint, CleanCubeNotForNormsWithoutACutOff)
{
  const TriangleMesh cube = Cube(8);
  for (const NormId norm : { NormId::L2, NormId::Huber, NormId::Lorentzian, NormId::Centin })
  {
    MeshDenoisingSettings settings;
    settings.Norm = norm;
    EXPECT_GT(Distance(Denoise(cube, settings).Mesh.Positions, cube.Positions), 1e-3);
  }
}
