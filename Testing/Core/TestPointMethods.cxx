// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
// What every method for point sets must do, whatever it computes.

#include "NoisyClouds.h"
#include "OddThreads.h"
#include "Points/PointMethods.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

using namespace SurfaceDenoising;

namespace
{

class PointMethodTest : public testing::TestWithParam<PointMethod>
{
protected:
  /// The settings of the method, with fewer iterations if it makes many.
  PointDenoisingSettings Settings() const
  {
    PointDenoisingSettings settings = SettingsOf(this->GetParam());
    settings.OuterIterations = std::min(settings.OuterIterations, 5);
    return settings;
  }

  PointCloud Denoise(PointCloud cloud, Execution& execution) const
  {
    PointDenoisingReport report;
    EXPECT_TRUE(DenoisePoints(cloud, this->Settings(), report, execution));
    return cloud;
  }

  PointCloud Denoise(const PointCloud& cloud) const
  {
    Execution serial;
    return this->Denoise(cloud, serial);
  }
};

PointCloud NoisyCube(double noise = 0.04)
{
  PointCloud cloud;
  cloud.Positions = CubeCloud(16).Positions;
  AddNoise(cloud.Positions, noise, 7);
  return cloud;
}

PointCloud NoisySphere()
{
  PointCloud cloud;
  cloud.Positions = SphereCloud(900).Positions;
  AddNoise(cloud.Positions, 0.03, 8);
  return cloud;
}

double DistanceToCube(const Vec3& p)
{
  static const SurfaceCloud cube = CubeCloud(1);
  return std::abs(cube.DistanceOf(p));
}

void ExpectFinite(const PointCloud& cloud)
{
  for (std::size_t i = 0; i < cloud.Positions.size(); ++i)
  {
    if (cloud.Status[i] != PointStatus::NotFinite)
    {
      ASSERT_TRUE(cloud.Positions[i].allFinite()) << "point " << i;
      const double length = cloud.Normals[i].norm();
      ASSERT_TRUE(length == 0.0 || std::abs(length - 1.0) < 1e-12) << "point " << i;
    }
  }
}

double MeanDistance(const Buffer<Vec3>& points, double (*distance)(const Vec3&))
{
  double sum = 0.0;
  for (const Vec3& p : points)
  {
    sum += distance(p);
  }
  return sum / static_cast<double>(points.size());
}

double DistanceToSphere(const Vec3& p) { return std::abs(p.norm() - 1.0); }

}

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

TEST_P(PointMethodTest, NothingToDo)
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

TEST_P(PointMethodTest, PointsAtOnePlaceOrOnALineStay)
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

TEST_P(PointMethodTest, DoublePointsAreTwoPoints)
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

TEST_P(PointMethodTest, PointsThatAreNotFiniteAreLeftOut)
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

TEST_P(PointMethodTest, OutliersFarAwayDoNotDisturb)
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

TEST_P(PointMethodTest, UnevenDensity)
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

TEST_P(PointMethodTest, SheetsCloserThanTheNeighborhoodStayApart)
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

TEST_P(PointMethodTest, MissingNormalsAreFitted)
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

INSTANTIATE_TEST_SUITE_P(All, PointMethodTest,
  testing::ValuesIn(
    []
    {
      std::vector<PointMethod> methods;
      for (const PointMethodRow& row : PointMethods())
      {
        methods.push_back(row.Id);
      }
      return methods;
    }()),
  [](const testing::TestParamInfo<PointMethod>& info)
  {
    std::string name = PointMethods()[static_cast<std::size_t>(info.param)].Name;
    name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
    return name;
  });

TEST(PointMethods, RowsAreInTheOrderOfTheirNumbers)
{
  for (std::size_t i = 0; i < PointMethods().size(); ++i)
  {
    EXPECT_EQ(static_cast<std::size_t>(PointMethods()[i].Id), i);
  }
}
