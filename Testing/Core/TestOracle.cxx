// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// The engine against the textbook, in every combination of settings.

#include "MeshDenoising.h"
#include "RandomMeshes.h"
#include "Textbook.h"

#include <gtest/gtest.h>

#include <bitset>
#include <sstream>

using namespace SurfaceDenoising;

namespace
{

constexpr double Tolerance = 1e-9;

Textbook::Mesh ToTextbook(const TriangleMesh& mesh)
{
  Textbook::Mesh copy;
  for (const Vec3& p : mesh.Positions)
  {
    copy.Points.push_back({ p[0], p[1], p[2] });
  }
  for (const Triangle& t : mesh.Triangles)
  {
    copy.Faces.push_back({ int(t[0]), int(t[1]), int(t[2]) });
  }
  return copy;
}

/// The same settings for the engine; both list their choices in the same order.
MeshDenoisingSettings ToEngine(const Textbook::Settings& settings)
{
  MeshDenoisingSettings same;
  same.Neighborhood = static_cast<FaceNeighborhood>(settings.Faces);
  same.Radius = settings.Radius;
  same.Norm = static_cast<NormId>(settings.WeightNorm);
  same.NormScale = settings.Scale;
  same.Argument = static_cast<NormalArgument>(settings.Compared);
  same.SpatialScale = settings.SpatialScale;
  same.Weighting = settings.AreaWeighted ? SiteWeight::Area : SiteWeight::Uniform;
  same.IncludeOwn = settings.IncludeOwn;
  same.Data = static_cast<NormalData>(settings.Averaged);
  same.OuterIterations = settings.OuterIterations;
  same.NormalIterations = settings.NormalIterations;
  same.VertexIterations = settings.VertexIterations;
  same.Vertices.Scheme = static_cast<VertexScheme>(settings.VertexUpdate);
  same.Vertices.Boundary = settings.FreeBoundary ? BoundaryHandling::Free : BoundaryHandling::Fixed;
  return same;
}

double Distance(const Vec3& a, const Textbook::Vector& b)
{
  return (a - Vec3(b[0], b[1], b[2])).norm();
}

double SizeOf(const TriangleMesh& mesh)
{
  double size = 0.0;
  for (const Vec3& p : mesh.Positions)
  {
    size = std::max(size, p.norm());
  }
  return size;
}

bool JumpsAtScale(Textbook::Norm norm)
{
  return norm == Textbook::Norm::TruncatedL2 || norm == Textbook::Norm::TruncatedL1 ||
    norm == Textbook::Norm::Box;
}

/// How far engine and textbook are apart at most.
struct Deviation
{
  double Normals = 0.0;
  double Points = 0.0;     ///< relative to the size of the mesh
  std::size_t Skipped = 0; ///< faces where rounding may decide whether a neighbour counts
};

Deviation Compare(const TriangleMesh& mesh, const Textbook::Settings& settings)
{
  Textbook::Mesh printed = ToTextbook(mesh);
  std::vector<double> margins;
  const std::vector<Textbook::Vector> expected = Textbook::Denoise(printed, settings, &margins);

  TriangleMesh moved = mesh;
  Buffer<Vec3> normals;
  MeshDenoisingReport report;
  Execution serial;
  EXPECT_TRUE(DenoiseMesh(moved, normals, ToEngine(settings), report, serial));
  EXPECT_EQ(report.TurnedFaces + report.SeamVertices, 0u) << "the textbook cannot repair meshes";

  Deviation deviation;
  std::vector<bool> skipped(mesh.NumberOfVertices(), false);
  for (std::size_t f = 0; f < expected.size(); ++f)
  {
    if (JumpsAtScale(settings.WeightNorm) && margins[f] < 1e-7)
    {
      ++deviation.Skipped;
      for (const Index v : mesh.Triangles[f])
      {
        skipped[v] = true;
      }
      continue;
    }
    deviation.Normals = std::max(deviation.Normals, Distance(normals[f], expected[f]));
  }
  for (std::size_t v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    const double distance = Distance(moved.Positions[v], printed.Points[v]) / SizeOf(mesh);
    deviation.Points = std::max(deviation.Points, skipped[v] ? 0.0 : distance);
  }
  return deviation;
}

std::string Describe(const Textbook::Settings& s)
{
  std::ostringstream text;
  text << "norm " << int(s.WeightNorm) << ", argument " << int(s.Compared) << ", faces "
       << int(s.Faces) << ", spatial " << s.SpatialScale << ", area " << s.AreaWeighted << ", own "
       << s.IncludeOwn << ", data " << int(s.Averaged) << ", outer " << s.OuterIterations
       << ", update " << int(s.VertexUpdate) << ", free boundary " << s.FreeBoundary;
  return text.str();
}

class Oracle : public testing::TestWithParam<MeshRecipe>
{
protected:
  /// Compares on the mesh of the parameter.
  void Check(const Textbook::Settings& settings)
  {
    const Deviation deviation = Compare(this->Mesh, settings);
    EXPECT_LT(deviation.Normals, Tolerance) << Describe(settings);
    EXPECT_LT(deviation.Points, Tolerance) << Describe(settings);
    this->Faces += this->Mesh.NumberOfFaces();
    this->Skipped += deviation.Skipped;
  }

  TriangleMesh Mesh = GetParam().Make(1);
  std::size_t Faces = 0;
  std::size_t Skipped = 0;
};

}

TEST_P(Oracle, EveryCombinationOfTheNormalFilter)
{
  // Scales that cut through the differences of the meshes, so that both sides of every norm matter.
  const double scales[] = { 1.0, 0.61, 0.053, 0.67, 0.23, 0.31, 0.37, 0.83, 0.59, 0.29 };
  for (int norm = 0; norm < NumberOfNorms; ++norm)
  {
    for (int argument = 0; argument < 3; ++argument)
    {
      for (int faces = 0; faces < 3; ++faces)
      {
        for (int choice = 0; choice < 32; ++choice)
        {
          // Half of the combinations will do: in it, any four of the five choices meet in every
          // way.
          if ((std::bitset<5>(choice).count() + norm + argument + faces) % 2)
          {
            continue;
          }
          Textbook::Settings settings;
          settings.WeightNorm = static_cast<Textbook::Norm>(norm);
          settings.Scale = scales[norm];
          settings.Compared = static_cast<Textbook::Argument>(argument);
          settings.Faces = static_cast<Textbook::Neighborhood>(faces);
          settings.Radius = 1.9;
          settings.SpatialScale = choice & 1 ? 1.1 : 0.0;
          settings.AreaWeighted = choice & 2;
          settings.IncludeOwn = choice & 4;
          settings.Averaged = choice & 8 ? Textbook::Data::Original : Textbook::Data::Previous;
          const bool alternate = choice & 16;
          settings.OuterIterations = alternate ? 2 : 1;
          settings.NormalIterations = alternate ? 1 : 2;
          settings.VertexIterations = alternate ? 1 : 2;
          this->Check(settings);
        }
      }
    }
  }
  EXPECT_LE(100 * this->Skipped, this->Faces);
}

TEST_P(Oracle, EveryVertexUpdate)
{
  for (int update = 0; update < 4; ++update)
  {
    for (const bool freeBoundary : { false, true })
    {
      Textbook::Settings settings;
      settings.NormalIterations = 3;
      settings.VertexIterations = 5;
      settings.VertexUpdate = static_cast<Textbook::Update>(update);
      settings.FreeBoundary = freeBoundary;
      this->Check(settings);
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
