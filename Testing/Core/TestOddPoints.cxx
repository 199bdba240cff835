// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
// What every method for point sets makes of points that are not what one hopes for.

#include "EveryPointMethod.h"

#include <limits>

namespace
{

class OddPointsTest : public PointMethodTest
{
};

}

TEST_P(OddPointsTest, NothingToDo)
{
  PointCloud cloud;
  EXPECT_TRUE(this->Denoise(cloud).Positions.empty());
  for (const int count : { 1, 2, 3, 4, 7 })
  {
    cloud = PointCloud();
    for (int i = 0; i < count; ++i)
    {
      cloud.Positions.push_back(Vec3(std::cos(i), std::sin(3 * i), 0.1 * i * i));
    }
    ExpectFinite(this->Denoise(cloud));
  }
}

TEST_P(OddPointsTest, PointsAtOnePlaceOrOnALineStay)
{
  PointCloud equal;
  equal.Positions.assign(50, Vec3(1.0, 2.0, 3.0));
  PointCloud found = this->Denoise(equal);
  EXPECT_EQ(found.Positions, equal.Positions);
  EXPECT_EQ(found.Status, Buffer<PointStatus>(50, PointStatus::Kept));

  PointCloud line;
  for (int i = 0; i < 60; ++i)
  {
    line.Positions.push_back(Vec3(i, 2.0 * i, -i));
  }
  found = this->Denoise(line);
  ExpectFinite(found);
  for (std::size_t i = 0; i < line.Positions.size(); ++i)
  {
    const Vec3 away = found.Positions[i].cross(Vec3(1.0, 2.0, -1.0).normalized());
    EXPECT_LT(away.norm(), 1e-6);
  }
}

TEST_P(OddPointsTest, DoublePointsAreTwoPoints)
{
  PointCloud cloud = NoisyCube();
  const std::size_t count = cloud.Positions.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    cloud.Positions.push_back(cloud.Positions[i]);
  }
  const PointCloud found = this->Denoise(cloud);
  ExpectFinite(found);
  EXPECT_LT(MeanDistance(found.Positions, DistanceToCube),
    MeanDistance(cloud.Positions, DistanceToCube));
}

TEST_P(OddPointsTest, PointsThatAreNotFiniteAreLeftOut)
{
  const PointCloud clean = NoisyCube();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  PointCloud cloud = clean;
  cloud.Positions.insert(cloud.Positions.begin() + 10, Vec3(nan, 0.0, 0.0));
  cloud.Positions.push_back(Vec3(0.0, infinity, 0.0));
  const PointCloud expected = this->Denoise(clean);
  const PointCloud found = this->Denoise(cloud);
  EXPECT_TRUE(std::isnan(found.Positions[10][0]));
  EXPECT_EQ(found.Status[10], PointStatus::NotFinite);
  EXPECT_EQ(found.Positions.back()[1], infinity);
  for (std::size_t i = 0; i < clean.Positions.size(); ++i)
  {
    ASSERT_EQ(found.Positions[i < 10 ? i : i + 1], expected.Positions[i]);
  }
}

TEST_P(OddPointsTest, OutliersFarAwayDoNotDisturb)
{
  PointCloud cloud = NoisyCube();
  const std::size_t count = cloud.Positions.size();
  cloud.Positions.push_back(Vec3(1e6, 0.0, 0.0));
  cloud.Positions.push_back(Vec3(0.0, -3e6, 2.0));
  cloud.Positions.push_back(Vec3(30.0, 30.0, 30.0));
  PointCloud found = this->Denoise(cloud);
  ExpectFinite(found);
  found.Positions.resize(count);
  cloud.Positions.resize(count);
  EXPECT_LT(MeanDistance(found.Positions, DistanceToCube),
    0.9 * MeanDistance(cloud.Positions, DistanceToCube));
}

TEST_P(OddPointsTest, UnevenDensity)
{
  PointCloud cloud;
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> even(0.0, 1.0);
  std::normal_distribution<double> noise(0.0, 0.002);
  for (int i = 0; i < 2000; ++i)
  {
    // Thirty times denser at one side than at the other.
    const double x = std::pow(even(random), 3.0);
    cloud.Positions.push_back(Vec3(x, even(random), noise(random)));
  }
  const PointCloud found = this->Denoise(cloud);
  ExpectFinite(found);
  EXPECT_LT(MeanDistance(found.Positions, [](const Vec3& p) { return std::abs(p[2]); }),
    MeanDistance(cloud.Positions, [](const Vec3& p) { return std::abs(p[2]); }));
}

TEST_P(OddPointsTest, SheetsCloserThanTheNeighborhoodStayApart)
{
  PointCloud cloud;
  for (int i = 0; i < 20; ++i)
  {
    for (int j = 0; j < 20; ++j)
    {
      for (const double side : { -1.0, 1.0 })
      {
        cloud.Positions.push_back(Vec3(i, j, 0.75 * side));
        cloud.Normals.push_back(Vec3(0.0, 0.0, side));
      }
    }
  }
  AddNoise(cloud.Positions, 0.02, 4);
  const PointCloud found = this->Denoise(cloud);
  ExpectFinite(found);
}

TEST_P(OddPointsTest, MissingNormalsAreFitted)
{
  PointCloud cloud = NoisySphere();
  for (const Vec3& p : cloud.Positions)
  {
    cloud.Normals.push_back(p.normalized());
  }
  for (std::size_t i = 0; i < cloud.Normals.size(); i += 3)
  {
    cloud.Normals[i].setZero();
  }
  const PointCloud found = this->Denoise(cloud);
  ExpectFinite(found);
  for (std::size_t i = 0; i < cloud.Positions.size(); ++i)
  {
    EXPECT_GT(found.Normals[i].dot(cloud.Positions[i]), 0.7) << "point " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(All, OddPointsTest, testing::ValuesIn(EveryPointMethod()),
  NameOfPointMethod);
