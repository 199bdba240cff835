// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// The engine against the textbook, in every combination of settings.

#include "Methods.h"
#include "RandomMeshes.h"
#include "TextbookOfMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bitset>
#include <sstream>

using namespace SurfaceDenoising;

namespace
{

constexpr double Tolerance = 1e-9;

/// The same settings for the textbook; both list their choices in the same order.
Textbook::Settings ToTextbook(const MeshDenoisingSettings& settings)
{
  Textbook::Settings same;
  same.Faces = static_cast<Textbook::Neighborhood>(settings.Neighborhood);
  same.Radius = settings.Radius;
  same.RenewNeighborhood = settings.RenewNeighborhood;
  same.WeightNorm = static_cast<Textbook::Norm>(settings.Norm);
  same.Scale = settings.NormScale;
  same.Compared = static_cast<Textbook::Argument>(settings.Argument);
  same.ScaleUnit = static_cast<Textbook::CurvatureUnit>(settings.Unit);
  same.SpatialScale = settings.SpatialScale;
  same.Width =
    settings.LocalSpatialScale ? Textbook::SpatialWidth::PerFace : Textbook::SpatialWidth::Global;
  same.Weighting = static_cast<Textbook::FaceWeight>(settings.Weighting);
  same.IncludeOwn = settings.IncludeOwn;
  same.Averaged = static_cast<Textbook::Data>(settings.Data);
  same.Guide = static_cast<Textbook::Guidance>(settings.Guidance);
  same.Step = static_cast<Textbook::Operator>(settings.Operator);
  same.StepLength = settings.StepLength;
  same.TangentialFlux = settings.TangentialFlux;
  same.Fidelity = settings.Global.Fidelity;
  same.AreaEnergy = settings.Global.AreaEnergy;
  same.Selection = static_cast<Textbook::MedianKind>(settings.Median);
  same.EdgeRepetitions = settings.Repetitions.EdgeAdjacent;
  same.VertexRepetitions = settings.Repetitions.Other;
  same.TensorThreshold = settings.Tensor.Threshold;
  same.Damping = settings.Tensor.Damping;
  same.RotateVotes = settings.Tensor.RotateVotes;
  same.OuterIterations = settings.OuterIterations;
  same.NormalIterations = settings.NormalIterations;
  same.VertexIterations = settings.VertexIterations;
  same.VertexUpdate = static_cast<Textbook::Update>(settings.Vertices.Scheme);
  same.FreeBoundary = settings.Vertices.Boundary == BoundaryHandling::Free;
  same.Relaxation = settings.Vertices.Relaxation;
  same.InputPull = settings.Vertices.InputPull;
  same.MaximumDisplacement = settings.Vertices.MaximumDisplacement;
  return same;
}

/// True if a difference of one bit can decide what is averaged.
bool Jumps(const MeshDenoisingSettings& s)
{
  return s.Norm == NormId::TruncatedL2 || s.Norm == NormId::TruncatedL1 || s.Norm == NormId::Box ||
    s.Guidance != NormalGuidance::None || s.Operator == NormalOperator::Median ||
    s.Operator == NormalOperator::VotingTensor;
}

/// How far engine and textbook are apart at most.
struct Deviation
{
  double Normals = 0.0;
  double Points = 0.0;    ///< relative to the size of the mesh
  bool Undecided = false; ///< rounding may decide somewhere, so that the two may go separate ways
};

Deviation Compare(const TriangleMesh& mesh, const MeshDenoisingSettings& settings)
{
  Textbook::Mesh printed = ::ToTextbook(mesh);
  std::vector<double> margins;
  const std::vector<Textbook::Vector> expected =
    Textbook::Denoise(printed, ToTextbook(settings), &margins);

  TriangleMesh moved = mesh;
  Buffer<Vec3> normals;
  MeshDenoisingReport report;
  Execution serial;
  EXPECT_TRUE(DenoiseMesh(moved, normals, settings, report, serial));
  EXPECT_EQ(report.TurnedFaces + report.SeamVertices, 0u) << "the textbook cannot repair meshes";

  Deviation deviation;
  deviation.Undecided = Jumps(settings) && *std::min_element(margins.begin(), margins.end()) < 1e-9;
  for (std::size_t f = 0; f < expected.size(); ++f)
  {
    deviation.Normals = std::max(deviation.Normals, Distance(normals[f], expected[f]));
  }
  for (std::size_t v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    const double distance = Distance(moved.Positions[v], printed.Points[v]) / SizeOf(mesh);
    deviation.Points = std::max(deviation.Points, distance);
  }
  return deviation;
}

std::string Describe(const MeshDenoisingSettings& s)
{
  std::ostringstream text;
  text << "norm " << int(s.Norm) << ", argument " << int(s.Argument) << ", unit " << int(s.Unit)
       << ", faces " << int(s.Neighborhood) << ", spatial " << s.SpatialScale << ", local "
       << s.LocalSpatialScale << ", weighting " << int(s.Weighting) << ", own " << s.IncludeOwn
       << ", data " << int(s.Data) << ", guidance " << int(s.Guidance) << ", operator "
       << int(s.Operator) << ", outer " << s.OuterIterations << ", update "
       << int(s.Vertices.Scheme) << ", boundary " << int(s.Vertices.Boundary);
  return text.str();
}

class Oracle : public testing::TestWithParam<MeshRecipe>
{
protected:
  /// Compares on the mesh of the parameter.
  void Check(const MeshDenoisingSettings& settings)
  {
    const Deviation deviation = Compare(this->Mesh, settings);
    ++this->Runs;
    this->Undecided += deviation.Undecided;
    if (!deviation.Undecided)
    {
      // Slivers that are just not degenerate amplify rounding.
      const double tolerance = this->HasTies() ? 10.0 * Tolerance : Tolerance;
      EXPECT_LT(deviation.Normals, tolerance) << Describe(settings);
      EXPECT_LT(deviation.Points, tolerance) << Describe(settings);
    }
  }

  void ExpectMostDecided() const { EXPECT_LE(5 * this->Undecided, this->Runs); }

  /// Faces at the same place, or a few that all share vertices, have ties everywhere.
  bool HasTies() const
  {
    const std::string name = GetParam().Name;
    return name == "Degenerate" || name == "SingleTriangle" || name == "Components";
  }

  TriangleMesh Mesh = GetParam().Make(1);
  std::size_t Runs = 0;
  std::size_t Undecided = 0;
};

/// Scales that cut through the differences of the meshes, so that both sides of every norm matter.
constexpr double Scales[] = { 1.0, 0.61, 0.053, 0.67, 0.23, 0.31, 0.37, 0.83, 0.59, 0.29 };

}

TEST_P(Oracle, EveryCombinationOfWeights)
{
  for (int norm = 0; norm < NumberOfNorms; ++norm)
  {
    for (int argument = 0; argument < 5; ++argument)
    {
      for (int faces = 0; faces < 4; ++faces)
      {
        for (int choice = 0; choice < 32; ++choice)
        {
          // A quarter of the combinations will do: in it, any three of the five choices meet in
          // every way.
          const int code = int(std::bitset<5>(choice).count()) + 2 * (choice >> 4);
          if ((code + norm + argument + faces) % 4)
          {
            continue;
          }
          MeshDenoisingSettings settings;
          settings.Norm = static_cast<NormId>(norm);
          settings.NormScale = Scales[norm];
          settings.Argument = static_cast<NormalArgument>(argument);
          settings.Unit = norm % 2 ? CurvatureUnit::EdgeLength : CurvatureUnit::CentroidDistance;
          settings.Neighborhood = static_cast<FaceNeighborhood>(faces);
          settings.Radius = 1.9;
          settings.SpatialScale = choice & 1 ? 1.1 : 0.0;
          settings.LocalSpatialScale = (choice + norm) % 2;
          settings.Weighting = static_cast<SiteWeight>((choice >> 1) % 3);
          settings.IncludeOwn = choice & 4;
          settings.Data = choice & 8 ? NormalData::Original : NormalData::Previous;
          const bool alternate = choice & 16;
          settings.OuterIterations = alternate ? 2 : 1;
          settings.NormalIterations = alternate ? 1 : 2;
          settings.VertexIterations = alternate ? 1 : 2;
          settings.RenewNeighborhood = argument % 2;
          this->Check(settings);
        }
      }
    }
  }
  this->ExpectMostDecided();
}

TEST_P(Oracle, EveryOperatorWithEveryGuidance)
{
  int number = 0;
  for (int guidance = 0; guidance < 3; ++guidance)
  {
    for (int op = 0; op < 5; ++op)
    {
      for (int faces = 0; faces < 4; ++faces)
      {
        for (const NormalData data : { NormalData::Previous, NormalData::Original })
        {
          ++number;
          MeshDenoisingSettings settings;
          settings.Guidance = static_cast<NormalGuidance>(guidance);
          settings.Operator = static_cast<NormalOperator>(op);
          settings.Neighborhood = static_cast<FaceNeighborhood>(faces);
          settings.Radius = 1.9;
          settings.Data = data;
          settings.Norm = number % 2 ? NormId::Gaussian : NormId::Lorentzian;
          settings.Argument = number % 3 ? NormalArgument::Chord : NormalArgument::Angle;
          settings.Weighting = number % 5 ? SiteWeight::Area : SiteWeight::Uniform;
          settings.IncludeOwn = number % 7 % 2;
          settings.StepLength = 0.7;
          settings.TangentialFlux = number % 2;
          settings.Global.Tolerance = 1e-14;
          settings.Global.Fidelity = 0.03;
          settings.Global.AreaEnergy = number % 3;
          settings.Median = number % 3 ? MedianKind::Angular : MedianKind::Directional;
          settings.Repetitions = { 1 + number % 3, number % 2 };
          settings.Tensor = { 0.13, 2.0, number % 3 == 0 };
          settings.OuterIterations = 2;
          settings.NormalIterations = 1 + number % 2;
          settings.VertexIterations = 1;
          this->Check(settings);
        }
      }
    }
  }
  if (!this->HasTies())
  {
    this->ExpectMostDecided();
  }
}

TEST_P(Oracle, EveryMethodOfTheTable)
{
  for (const MethodRow& row : Methods())
  {
    if (row.TwoStage)
    {
      MeshDenoisingSettings settings = row.Settings;
      settings.OuterIterations = std::min(3, settings.OuterIterations);
      settings.NormalIterations = std::min(4, settings.NormalIterations);
      settings.VertexIterations = std::min(4, settings.VertexIterations);
      settings.Global.Tolerance = 1e-14;
      SCOPED_TRACE(row.Name);
      this->Check(settings);
    }
  }
}

TEST_P(Oracle, EveryVertexUpdate)
{
  for (int update = 0; update < 5; ++update)
  {
    for (const bool freeBoundary : { false, true })
    {
      for (const bool hold : { false, true })
      {
        MeshDenoisingSettings settings;
        settings.OuterIterations = 2;
        settings.NormalIterations = 2;
        settings.VertexIterations = 3;
        settings.Vertices.Scheme = static_cast<VertexScheme>(update);
        settings.Vertices.Boundary =
          freeBoundary ? BoundaryHandling::Free : BoundaryHandling::Fixed;
        settings.Vertices.Relaxation = 0.3;
        settings.Vertices.InputPull = hold ? 0.2 : 0.0;
        settings.Vertices.MaximumDisplacement = hold ? 0.1 : 0.0;
        this->Check(settings);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, Oracle,
  testing::ValuesIn(
    []
    {
      std::vector<MeshRecipe> sound;
      for (const MeshRecipe& recipe : MeshRecipes())
      {
        if (!recipe.NeedsRepair)
        {
          sound.push_back(recipe);
        }
      }
      return sound;
    }()),
  [](const auto& info) { return std::string(info.param.Name); });
