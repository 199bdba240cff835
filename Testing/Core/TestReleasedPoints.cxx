// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// The released program of Yadav et al. 2018 for points against its own results, if these are at
// hand: set SURFACE_DENOISING_DATA to a folder with reference/cube_noisy_0-3l.obj,
// vnvt_cube_initial_normals.obj and vnvt_cube_mesh_default_p<iterations>.obj.

#include "OddThreads.h"
#include "Points/ReleasedVotingTensor.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

using namespace SurfaceDenoising;

namespace
{

struct Cloud
{
  Buffer<Vec3> Positions;
  Buffer<Vec3> Normals;
};

Cloud ReadObj(const std::string& name)
{
  Cloud cloud;
  std::ifstream file(name);
  for (std::string line; std::getline(file, line);)
  {
    std::istringstream words(line);
    std::string kind;
    Vec3 v;
    words >> kind >> v[0] >> v[1] >> v[2];
    if (kind == "v")
    {
      cloud.Positions.push_back(v);
    }
    else if (kind == "vn")
    {
      cloud.Normals.push_back(v);
    }
  }
  return cloud;
}

double LargestDifference(const Buffer<Vec3>& a, const Buffer<Vec3>& b)
{
  EXPECT_EQ(a.size(), b.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    largest = std::max(largest, (a[i] - b[i]).norm());
  }
  return largest;
}

}

TEST(ReleasedPoints, ReproducesItsResults)
{
  const char* data = std::getenv("SURFACE_DENOISING_DATA");
  if (!data)
  {
    GTEST_SKIP() << "SURFACE_DENOISING_DATA is not set";
  }
  const std::string folder = std::string(data) + "/reference/";
  const Cloud noisy = ReadObj(folder + "cube_noisy_0-3l.obj");
  const Buffer<Vec3> normals = ReadObj(folder + "vnvt_cube_initial_normals.obj").Normals;
  ASSERT_GT(noisy.Positions.size(), 0u);
  ASSERT_EQ(noisy.Positions.size(), normals.size());
  for (const int iterations : { 1, 5 })
  {
    const Cloud expected =
      ReadObj(folder + "vnvt_cube_mesh_default_p" + std::to_string(iterations) + ".obj");
    Cloud cloud{ noisy.Positions, normals };
    ReleasedVotingTensorSettings settings;
    settings.Iterations = iterations;
    ReleasedVotingTensorReport report;
    Execution serial;
    EXPECT_TRUE(DenoiseAsReleased(cloud.Positions, cloud.Normals, settings, report, serial));
    EXPECT_LT(LargestDifference(cloud.Positions, expected.Positions), 1e-9) << iterations;
    EXPECT_LT(LargestDifference(cloud.Normals, expected.Normals), 1e-9) << iterations;
  }
}
