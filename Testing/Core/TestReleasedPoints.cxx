// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// The released program of Yadav et al. 2018 for points against the textbook, and against its own
// results, if these are at hand: set SURFACE_DENOISING_DATA to a folder with
// reference/cube_noisy_0-3l.obj, vnvt_cube_initial_normals.obj and
// vnvt_cube_mesh_default_p<iterations>.obj.

#include "OddThreads.h"
#include "Points/ReleasedVotingTensor.h"
#include "TextbookVotingPoints.h"
#include "VotingClouds.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

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

TEST(ReleasedPoints, AgreesWithTheTextbook)
{
  for (const SurfaceCloud& cloud : { Noisy(SphereCloud(500), 0.1),
         Noisy(Blended(CubeCloud(8)), 0.1), Noisy(Blended(WedgeCloud(20, 8)), 0.2) })
  {
    const std::size_t count = cloud.Positions.size();
    Execution serial;
    const NeighborGraph nearest = NearestPoints(cloud.Positions, 12, serial);
    double h = 0.0;
    for (std::size_t i = 0; i < count; ++i)
    {
      for (const Index j : nearest.Row(i))
      {
        h += (cloud.Positions[j] - cloud.Positions[i]).norm() / 12.0 / static_cast<double>(count);
      }
    }
    const NeighborGraph ball = PointsWithinRadius(cloud.Positions, 5.0 * h, NoIndex, serial);
    VotingTextbook::Cloud printed;
    printed.Points.assign(cloud.Positions.begin(), cloud.Positions.end());
    printed.Normals.assign(cloud.Normals.begin(), cloud.Normals.end());
    printed.Start = printed.Points;
    printed.Spacings.assign(count, h);
    std::vector<std::vector<int>> rows(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      rows[i].assign(ball.Row(i).begin(), ball.Row(i).end());
    }
    VotingTextbook::Parameters parameters;
    parameters.SigmaN = h / std::sqrt(2.0); // 8 / r^2 with r = 2 h
    parameters.SigmaD = 1.0;
    parameters.SigmaP = 0.0;
    parameters.Cut = 0.0;
    parameters.Limit = 2.0 * h;
    parameters.InPlace = true;
    std::vector<int> classes;
    for (int iteration = 0; iteration < 4; ++iteration)
    {
      classes = VotingTextbook::Iterate(printed, rows, parameters);
    }

    Buffer<Vec3> positions = cloud.Positions;
    Buffer<Vec3> normals = cloud.Normals;
    ReleasedVotingTensorSettings settings;
    settings.Iterations = 4;
    ReleasedVotingTensorReport report;
    OddThreads threads(3);
    EXPECT_TRUE(DenoiseAsReleased(positions, normals, settings, report, threads));
    EXPECT_NEAR(report.Spacing, h, 1e-12);
    EXPECT_LT(LargestDifference(positions, { printed.Points.begin(), printed.Points.end() }), 1e-9);
    EXPECT_LT(LargestDifference(normals, { printed.Normals.begin(), printed.Normals.end() }), 1e-9);
    for (std::size_t i = 0; i < count; ++i)
    {
      EXPECT_EQ(static_cast<int>(report.Classes[i]), classes[i]);
    }
  }
}

TEST(ReleasedPoints, StartsWithNormalsOfPlanes)
{
  SurfaceCloud cloud = SphereCloud(500);
  AddNoise(cloud.Positions, 0.1 * cloud.Spacing, 5);
  Execution serial;
  const NeighborGraph nearest = NearestPoints(cloud.Positions, 12, serial);
  Buffer<Vec3> normals;
  ASSERT_TRUE(ReleasedStartNormals(cloud.Positions, nearest, normals, serial, 0.0, 1.0));
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    EXPECT_GT(normals[i].dot(cloud.Normals[i]), 0.9) << "point " << i;
  }
}

TEST(ReleasedPoints, PointsWithoutASimilarNormalLoseTheirs)
{
  SurfaceCloud cloud = WedgeCloud(10, 5);
  cloud.Normals[7] = Vec3(0.0, -1.0, 0.0);
  Buffer<Vec3> positions = cloud.Positions;
  Buffer<Vec3> normals = cloud.Normals;
  ReleasedVotingTensorReport report;
  Execution serial;
  EXPECT_TRUE(DenoiseAsReleased(positions, normals, {}, report, serial));
  EXPECT_EQ(normals[7], Vec3(0.0, 0.0, 0.0));
  EXPECT_EQ(positions[7], cloud.Positions[7]);
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
