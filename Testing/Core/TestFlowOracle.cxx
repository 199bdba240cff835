// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// The methods of one stage against the textbook.

#include "OneStage/AnisotropicCurvatureFlow.h"
#include "OneStage/BilateralVertices.h"
#include "OneStage/MeanCurvatureFlow.h"
#include "OneStage/NonIterativeBilateral.h"
#include "PreparedMesh.h"
#include "RandomMeshes.h"
#include "TextbookFlows.h"
#include "TextbookOfMesh.h"

#include <gtest/gtest.h>

#include <limits>

using namespace SurfaceDenoising;

namespace
{

class FlowOracle : public testing::TestWithParam<MeshRecipe>
{
protected:
  /// Moves a copy of the mesh with both, and compares.
  template <typename Move, typename Print>
  void Check(Move move, Print print)
  {
    TriangleMesh mesh = this->Mesh;
    Execution serial;
    PreparedMesh prepared(mesh);
    ASSERT_TRUE(prepared.Prepare(serial));
    ASSERT_TRUE(move(prepared, serial));
    prepared.Finish();
    Textbook::Mesh printed = ToTextbook(this->Mesh);
    print(printed);
    double distance = 0.0;
    for (std::size_t v = 0; v < mesh.NumberOfVertices(); ++v)
    {
      distance = std::max(distance, Distance(mesh.Positions[v], printed.Points[v]));
    }
    EXPECT_LT(distance, 1e-9 * SizeOf(this->Mesh));
  }

  TriangleMesh Mesh = GetParam().Make(1);
};

}

TEST_P(FlowOracle, MeanCurvatureFlow)
{
  if (std::string(GetParam().Name) == "Components")
  {
    return; // the vertices of its smallest part have less than the least mass
  }
  for (const double timeStep : { 0.05, 0.3 })
  {
    MeanCurvatureFlowSettings settings;
    settings.Steps = 2;
    settings.TimeStep = timeStep;
    this->Check(
      [&](PreparedMesh& prepared, Execution& serial)
      {
        MeanCurvatureFlowReport report;
        return FlowByMeanCurvature(prepared, settings, report, serial);
      },
      [&](Textbook::Mesh& mesh) { Textbook::MeanCurvatureFlow(mesh, timeStep, 2, false); });
  }
}

TEST_P(FlowOracle, AnisotropicCurvatureFlow)
{
  for (const double threshold : { 0.3, 0.8, 1e9 })
  {
    AnisotropicCurvatureFlowSettings settings;
    settings.Steps = 3;
    settings.TimeStep = 0.03;
    settings.EdgeThreshold = threshold;
    settings.MaximumRate = std::numeric_limits<double>::infinity();
    this->Check([&](PreparedMesh& prepared, Execution& serial)
      { return FlowByAnisotropicCurvature(prepared, settings, serial); },
      [&](Textbook::Mesh& mesh)
      {
        // The mean edge length is that of each step, in the textbook that of each call.
        for (int step = 0; step < settings.Steps; ++step)
        {
          Textbook::AnisotropicMeanCurvature(mesh, threshold, settings.TimeStep, 10.0, 1);
        }
      });
  }
}

TEST_P(FlowOracle, BilateralVertices)
{
  for (const double range : { 0.7, 1.5 })
  {
    BilateralVerticesSettings settings;
    settings.Iterations = 2;
    settings.SpatialScale = 1.3;
    settings.RangeScale = range;
    this->Check([&](PreparedMesh& prepared, Execution& serial)
      { return FilterVerticesBilaterally(prepared, settings, serial); },
      [&](Textbook::Mesh& mesh) { Textbook::BilateralVertices(mesh, 2, 1.3, range); });
  }
}

TEST_P(FlowOracle, NonIterativeBilateral)
{
  for (const double spatial : { 0.83, 1.37 })
  {
    NonIterativeBilateralSettings settings;
    settings.SpatialScale = spatial;
    settings.RangeScale = 0.9;
    this->Check([&](PreparedMesh& prepared, Execution& serial)
      { return FilterVerticesByPrediction(prepared, settings, serial); },
      [&](Textbook::Mesh& mesh) { Textbook::NonIterativeBilateral(mesh, spatial, 0.9); });
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, FlowOracle,
  testing::ValuesIn(
    []
    {
      // On degenerate and non-manifold meshes the textbook decides less carefully.
      std::vector<MeshRecipe> sound;
      for (const MeshRecipe& recipe : MeshRecipes())
      {
        const std::string name = recipe.Name;
        if (!recipe.NeedsRepair && name != "Degenerate" && name != "NonManifold")
        {
          sound.push_back(recipe);
        }
      }
      return sound;
    }()),
  [](const auto& info) { return std::string(info.param.Name); });
