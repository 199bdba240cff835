// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// The released program of Yadav, Reitebuch, Polthier 2018, against the textbook, and against its
// own results if these are at hand: set SURFACE_DENOISING_DATA to a folder with
// fandisk/noisy-0.3.obj and reference/rofi_fandisk_s0.35_l0.2_p<iterations>.obj.

#include "RandomMeshes.h"
#include "ReleasedTukeyBilateral.h"
#include "TextbookOfMesh.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

using namespace SurfaceDenoising;

namespace
{

TriangleMesh ReadObj(const std::string& name)
{
  TriangleMesh mesh;
  std::ifstream file(name);
  for (std::string line; std::getline(file, line);)
  {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v")
    {
      Vec3 p;
      words >> p[0] >> p[1] >> p[2];
      mesh.Positions.push_back(p);
    }
    else if (kind == "f")
    {
      Triangle t;
      for (Index& v : t)
      {
        std::string corner;
        words >> corner;
        v = static_cast<Index>(std::stoul(corner) - 1);
      }
      mesh.Triangles.push_back(t);
    }
  }
  return mesh;
}

void Denoise(TriangleMesh& mesh, int iterations)
{
  Execution serial;
  Buffer<Vec3> normals;
  MeshFacts facts;
  EXPECT_TRUE(DenoiseAsReleased(mesh, normals, { 0.35, 0.2, iterations }, facts, serial));
}

}

TEST(ReleasedProgram, AgreesWithTheTextbook)
{
  for (const MeshRecipe& recipe : MeshRecipes())
  {
    const std::string name = recipe.Name;
    if (recipe.NeedsRepair || name == "Degenerate")
    {
      continue;
    }
    TriangleMesh mesh = recipe.Make(1);
    Textbook::Mesh printed = ToTextbook(mesh);
    Textbook::DenoiseAsReleased(printed, 0.35, 0.2, 4);
    Denoise(mesh, 4);
    double distance = 0.0;
    for (std::size_t v = 0; v < mesh.NumberOfVertices(); ++v)
    {
      distance = std::max(distance, Distance(mesh.Positions[v], printed.Points[v]));
    }
    EXPECT_LT(distance, 1e-9) << name;
  }
}

TEST(ReleasedProgram, ReproducesItsResults)
{
  const char* data = std::getenv("SURFACE_DENOISING_DATA");
  if (!data)
  {
    GTEST_SKIP() << "SURFACE_DENOISING_DATA is not set";
  }
  const TriangleMesh noisy = ReadObj(std::string(data) + "/fandisk/noisy-0.3.obj");
  ASSERT_GT(noisy.NumberOfFaces(), 0u);
  for (const int iterations : { 1, 2, 5 })
  {
    const TriangleMesh expected = ReadObj(std::string(data) +
      "/reference/rofi_fandisk_s0.35_l0.2_p" + std::to_string(iterations) + ".obj");
    ASSERT_EQ(expected.NumberOfVertices(), noisy.NumberOfVertices());
    TriangleMesh mesh = noisy;
    Denoise(mesh, iterations);
    double distance = 0.0;
    for (std::size_t v = 0; v < mesh.NumberOfVertices(); ++v)
    {
      distance = std::max(distance, (mesh.Positions[v] - expected.Positions[v]).norm());
    }
    EXPECT_LT(distance, 1e-9) << iterations;
  }
}
