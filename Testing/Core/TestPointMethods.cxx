// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
// What every method for point sets must do, whatever it computes.

#include "EveryPointMethod.h"
#include "OddThreads.h"

#include <numeric>

TEST_P(PointMethodTest, RemovesNoise)
{
  const PointCloud cube = NoisyCube();
  EXPECT_LT(MeanDistance(this->Denoise(cube).Positions, DistanceToCube),
    0.9 * MeanDistance(cube.Positions, DistanceToCube));
  const PointCloud sphere = NoisySphere();
  EXPECT_LT(MeanDistance(this->Denoise(sphere).Positions, DistanceToSphere),
    0.8 * MeanDistance(sphere.Positions, DistanceToSphere));
}

TEST_P(PointMethodTest, DoesNotDependOnThreads)
{
  OddThreads threads(5);
  const PointCloud cloud = NoisyCube();
  const PointCloud one = this->Denoise(cloud);
  const PointCloud five = this->Denoise(cloud, threads);
  EXPECT_EQ(one.Positions, five.Positions);
  EXPECT_EQ(one.Normals, five.Normals);
  EXPECT_EQ(one.Classes, five.Classes);
  EXPECT_EQ(one.Status, five.Status);
}

TEST_P(PointMethodTest, DoesNotDependOnTheOrderOfPoints)
{
  const PointCloud cloud = NoisyCube();
  std::vector<std::size_t> order(cloud.Positions.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937_64(3));
  PointCloud shuffled;
  for (const std::size_t i : order)
  {
    shuffled.Positions.push_back(cloud.Positions[i]);
  }
  const PointCloud expected = this->Denoise(cloud);
  const PointCloud found = this->Denoise(shuffled);
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    ASSERT_EQ(found.Positions[k], expected.Positions[order[k]]);
    ASSERT_EQ(found.Normals[k], expected.Normals[order[k]]);
  }
}

TEST_P(PointMethodTest, FollowsMotionsAndScale)
{
  const PointCloud cloud = NoisyCube();
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.1, Vec3(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  const double scale = 40.0;
  const Vec3 shift(3.0, -7.0, 11.0);
  PointCloud moved = cloud;
  for (Vec3& p : moved.Positions)
  {
    p = scale * (turn * p) + shift;
  }
  const PointCloud expected = this->Denoise(cloud);
  const PointCloud found = this->Denoise(moved);
  for (std::size_t i = 0; i < cloud.Positions.size(); ++i)
  {
    const Vec3 place = scale * (turn * expected.Positions[i]) + shift;
    ASSERT_LT((found.Positions[i] - place).norm(), 1e-8 * scale) << "point " << i;
    ASSERT_LT((found.Normals[i] - turn * expected.Normals[i]).norm(), 1e-6) << "point " << i;
  }
}

TEST_P(PointMethodTest, LeavesAPlaneAlone)
{
  PointCloud cloud;
  const Vec3 normal = Vec3(1.0, 2.0, -2.0) / 3.0;
  const Vec3 u = Vec3(2.0, 1.0, 2.0) / 3.0;
  const Vec3 v = normal.cross(u);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> even(-5.0, 5.0);
  for (int i = 0; i < 400; ++i)
  {
    cloud.Positions.push_back(even(random) * u + even(random) * v);
    cloud.Normals.push_back(normal);
  }
  const PointCloud found = this->Denoise(cloud);
  for (std::size_t i = 0; i < cloud.Positions.size(); ++i)
  {
    ASSERT_LT(std::abs(normal.dot(found.Positions[i])), 1e-12);
    ASSERT_LT((found.Normals[i] - normal).norm(), 1e-7);
  }
}

TEST_P(PointMethodTest, HonoursTheDisplacementLimit)
{
  PointDenoisingSettings settings = this->Settings();
  settings.MaximumDisplacement = 0.1;
  PointCloud cloud = NoisyCube(0.06);
  const Buffer<Vec3> before = cloud.Positions;
  PointDenoisingReport report;
  Execution serial;
  ASSERT_TRUE(DenoisePoints(cloud, settings, report, serial));
  EXPECT_GT(report.Kept, 0u);
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    EXPECT_LE((cloud.Positions[i] - before[i]).norm(), 0.1 * report.Spacing * (1.0 + 1e-12));
  }
}

TEST_P(PointMethodTest, NoIterationsNoChange)
{
  PointDenoisingSettings settings = this->Settings();
  settings.OuterIterations = 0;
  PointCloud cloud = NoisyCube();
  const Buffer<Vec3> before = cloud.Positions;
  PointDenoisingReport report;
  Execution serial;
  ASSERT_TRUE(DenoisePoints(cloud, settings, report, serial));
  EXPECT_EQ(cloud.Positions, before);
}

TEST_P(PointMethodTest, StopsWhenAsked)
{
  class Impatient : public Execution
  {
  public:
    explicit Impatient(int patience)
      : Patience(patience)
    {
    }
    bool Proceed(double fraction) override
    {
      EXPECT_GE(fraction, this->Last - 1e-9) << "progress goes back";
      this->Last = fraction;
      return --this->Patience > 0;
    }
    int Patience;
    double Last = 0.0;
  };
  const PointCloud cloud = NoisyCube();
  int questions = 0;
  {
    Impatient all(1 << 30);
    this->Denoise(cloud, all);
    questions = (1 << 30) - all.Patience;
  }
  for (const int patience : { 1, questions / 2, questions - 1 })
  {
    Impatient some(patience);
    PointCloud work = cloud;
    PointDenoisingReport report;
    EXPECT_FALSE(DenoisePoints(work, this->Settings(), report, some));
    EXPECT_EQ(work.Positions, cloud.Positions);
  }
}

INSTANTIATE_TEST_SUITE_P(All, PointMethodTest, testing::ValuesIn(EveryPointMethod()),
  NameOfPointMethod);

TEST(PointMethods, RowsAreInTheOrderOfTheirNumbers)
{
  for (std::size_t i = 0; i < PointMethods().size(); ++i)
  {
    EXPECT_EQ(static_cast<std::size_t>(PointMethods()[i].Id), i);
  }
}
