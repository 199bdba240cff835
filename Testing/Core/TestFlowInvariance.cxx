// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// What the methods of one stage must not depend on, and how their results follow the input.

#include "CompareMeshes.h"
#include "Metrics.h"
#include "OddThreads.h"
#include "OneStage/AnisotropicCurvatureFlow.h"
#include "OneStage/BilateralVertices.h"
#include "OneStage/MeanCurvatureFlow.h"
#include "OneStage/NonIterativeBilateral.h"
#include "RandomMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace SurfaceDenoising;

namespace
{

struct OneStage
{
  const char* Name;
  bool (*Run)(PreparedMesh&, int iterations, bool fixBoundary, Execution&);
};

/// To which results agree that differ by rounding, relative to the size.
constexpr double Tolerance = 1e-9;

bool RunMeanCurvature(PreparedMesh& mesh, int iterations, bool fixBoundary, Execution& execution)
{
  MeanCurvatureFlowSettings settings;
  settings.Steps = iterations;
  settings.FixBoundary = fixBoundary;
  MeanCurvatureFlowReport report;
  return FlowByMeanCurvature(mesh, settings, report, execution);
}

template <bool Prescribe>
bool RunAnisotropic(PreparedMesh& mesh, int iterations, bool fixBoundary, Execution& execution)
{
  AnisotropicCurvatureFlowSettings settings;
  settings.Steps = iterations;
  settings.PrescribeCurvature = Prescribe;
  settings.FixBoundary = fixBoundary;
  return FlowByAnisotropicCurvature(mesh, settings, execution);
}

bool RunBilateral(PreparedMesh& mesh, int iterations, bool fixBoundary, Execution& execution)
{
  BilateralVerticesSettings settings;
  settings.Iterations = iterations;
  settings.SpatialScale = 1.3;
  settings.FixBoundary = fixBoundary;
  return FilterVerticesBilaterally(mesh, settings, execution);
}

bool RunNonIterative(PreparedMesh& mesh, int iterations, bool fixBoundary, Execution& execution)
{
  NonIterativeBilateralSettings settings;
  settings.SpatialScale = 1.2;
  settings.RangeScale = 0.7;
  settings.FixBoundary = fixBoundary;
  return iterations == 0 || FilterVerticesByPrediction(mesh, settings, execution);
}

const OneStage Methods[] = {
  { "MeanCurvature", RunMeanCurvature },
  { "Anisotropic", RunAnisotropic<false> },
  { "Prescribed", RunAnisotropic<true> },
  { "Bilateral", RunBilateral },
  { "NonIterative", RunNonIterative },
};

TriangleMesh Smooth(const OneStage& method, TriangleMesh mesh, Execution&& execution = {},
  int iterations = 3, bool fixBoundary = true)
{
  PreparedMesh prepared(mesh);
  EXPECT_TRUE(prepared.Prepare(execution));
  EXPECT_TRUE(method.Run(prepared, iterations, fixBoundary, execution));
  prepared.Finish();
  return mesh;
}

class OneStageInvariance : public testing::TestWithParam<MeshRecipe>
{
protected:
  /// The map x -> turn * scale * x + shift before the method or after it.
  void CheckMotion(const Mat3& turn, double scale, const Vec3& shift)
  {
    auto move = [&](TriangleMesh mesh)
    {
      for (Vec3& p : mesh.Positions)
      {
        p = turn * (scale * p) + shift;
      }
      return mesh;
    };
    for (const OneStage& method : Methods)
    {
      const TriangleMesh expected = move(Smooth(method, this->Mesh));
      const TriangleMesh result = Smooth(method, move(this->Mesh));
      EXPECT_LT(Distance(result.Positions, expected.Positions),
        Tolerance * scale * ExtentOf(this->Mesh))
        << method.Name;
    }
  }

  TriangleMesh Mesh = GetParam().Make(7);
};

}

TEST_P(OneStageInvariance, SameBitsOnAnyNumberOfThreads)
{
  for (const OneStage& method : Methods)
  {
    const TriangleMesh expected = Smooth(method, this->Mesh);
    for (const std::size_t threads : { 1, 2, 3, 7 })
    {
      EXPECT_EQ(Smooth(method, this->Mesh, OddThreads(threads)).Positions, expected.Positions)
        << method.Name;
    }
  }
}

TEST_P(OneStageInvariance, OrderOfVerticesFacesAndCorners)
{
  const ShuffledMesh other(this->Mesh);
  const std::vector<Index>& vertices = other.Vertices;
  const TriangleMesh& shuffled = other.Mesh;
  for (const OneStage& method : Methods)
  {
    const TriangleMesh expected = Smooth(method, this->Mesh);
    const TriangleMesh result = Smooth(method, shuffled);
    Buffer<Vec3> positions(vertices.size());
    std::transform(vertices.begin(), vertices.end(), positions.begin(),
      [&](Index v) { return result.Positions[v]; });
    EXPECT_LT(Distance(positions, expected.Positions), Tolerance * ExtentOf(this->Mesh))
      << method.Name;
  }
}

TEST_P(OneStageInvariance, MotionAndScale)
{
  const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(0.3, -0.7, 0.5).normalized()).toRotationMatrix();
  this->CheckMotion(turn, 1.0, Vec3(0.3, -0.2, 0.5));
  this->CheckMotion(Mat3::Identity(), 1000.0, Vec3::Zero());
  this->CheckMotion(Mat3::Identity(), 0.001, Vec3::Zero());
}

TEST_P(OneStageInvariance, NoIterationsChangeNoBit)
{
  for (const OneStage& method : Methods)
  {
    const TriangleMesh result = Smooth(method, this->Mesh, {}, 0);
    EXPECT_EQ(result.Positions, this->Mesh.Positions);
    EXPECT_EQ(result.Triangles, this->Mesh.Triangles);
  }
}

TEST_P(OneStageInvariance, FiniteAndBounded)
{
  for (const OneStage& method : Methods)
  {
    for (const bool fixBoundary : { true, false })
    {
      const TriangleMesh result = Smooth(method, this->Mesh, {}, 20, fixBoundary);
      for (const Vec3& p : result.Positions)
      {
        ASSERT_TRUE(p.allFinite());
      }
      EXPECT_LT(Distance(result.Positions, this->Mesh.Positions), ExtentOf(this->Mesh))
        << method.Name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, OneStageInvariance, testing::ValuesIn(MeshRecipes()),
  [](const auto& info) { return std::string(info.param.Name); });

TEST(OneStageFixedPoint, PlaneSheet)
{
  const TriangleMesh sheet = PlaneSheet(9, 3);
  for (const OneStage& method : Methods)
  {
    EXPECT_LT(Distance(Smooth(method, sheet).Positions, sheet.Positions), 1e-12) << method.Name;
  }
}

// What is flat stays flat until the news of the edges gets there.
TEST(OneStageFixedPoint, MiddlesOfTheSidesOfACube)
{
  const TriangleMesh cube = Cube(24);
  for (const OneStage& method : Methods)
  {
    const bool implicit = method.Run == RunMeanCurvature;
    const TriangleMesh result = Smooth(method, cube, {}, 1);
    EXPECT_GT(Distance(result.Positions, cube.Positions), 1e-4) << method.Name;
    for (std::size_t v = 0; v < cube.NumberOfVertices() && !implicit; ++v)
    {
      const Vec3 offset = (cube.Positions[v] - Vec3::Constant(0.5)).cwiseAbs();
      if (offset.sum() - offset.maxCoeff() < 0.05) // next to the axes
      {
        EXPECT_LT((result.Positions[v] - cube.Positions[v]).norm(), 1e-12) << method.Name;
      }
    }
  }
}

TEST(OneStageFixedPoint, BordersStayOrMove)
{
  TriangleMesh sheet = PlaneSheet(9, 3);
  AddDirectionNoise(sheet, 0.2, 5);
  Execution serial;
  const EdgeCensus census = TakeEdgeCensus(sheet, VertexStars(sheet), serial);
  for (const OneStage& method : Methods)
  {
    const TriangleMesh fixed = Smooth(method, sheet);
    const TriangleMesh free = Smooth(method, sheet, {}, 3, false);
    std::size_t moved = 0;
    for (std::size_t v = 0; v < sheet.NumberOfVertices(); ++v)
    {
      if (census.BoundaryVertex[v])
      {
        EXPECT_EQ(fixed.Positions[v], sheet.Positions[v]);
        moved += free.Positions[v] != sheet.Positions[v];
      }
    }
    EXPECT_GT(moved, 30u) << method.Name;
  }
}

TEST(OneStageVolume, IsRestoredForClosedMeshesOnly)
{
  Execution serial;
  for (const MeshRecipe& recipe : MeshRecipes())
  {
    TriangleMesh mesh = recipe.Make(3);
    PreparedMesh prepared(mesh);
    prepared.Prepare(serial);
    const double before = SignedVolume(prepared.Mesh(), serial);
    MeanCurvatureFlowSettings settings;
    settings.RestoreVolume = true;
    MeanCurvatureFlowReport report;
    EXPECT_TRUE(FlowByMeanCurvature(prepared, settings, report, serial));
    const std::string name = recipe.Name;
    const bool closed = name == "NoisyCube" || name == "NoisySphere" || name == "NoisyTorus" ||
      name == "TurnedFaces" || name == "TriangleSoup";
    EXPECT_EQ(report.VolumeRestored, closed) << name;
    if (closed)
    {
      EXPECT_NEAR(SignedVolume(prepared.Mesh(), serial) / before, 1.0, 1e-12) << name;
    }
  }
}
