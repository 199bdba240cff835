// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OddThreads.h"
#include "ProjectedClouds.h"

#include <limits>

namespace
{

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

}

TEST(ProjectedClouds, SignsOfNormalsDoNotMoveAnything)
{
  for (const SurfaceCloud& cloud : Clouds())
  {
    const Buffer<Vec3> flipped = Flipped(cloud.Normals);
    for (const PointOperatorSettings& method : Methods())
    {
      const PointCloud one = Denoise(cloud.Positions, cloud.Normals, Settings(method));
      const PointCloud other = Denoise(cloud.Positions, flipped, Settings(method));
      const auto* implicit = std::get_if<RobustImplicitMLSSettings>(&method);
      if (implicit && !implicit->Unoriented)
      {
        EXPECT_NE(std::memcmp(one.Positions.data(), other.Positions.data(),
                    one.Positions.size() * sizeof(Vec3)),
          0);
        continue;
      }
      ExpectIdentical(one.Positions, other.Positions);
      for (std::size_t i = 0; i < flipped.size(); ++i)
      {
        EXPECT_EQ(std::abs(one.Normals[i].dot(other.Normals[i])), one.Normals[i].squaredNorm());
      }
    }
  }
}

TEST(ProjectedClouds, ThreadsDoNotMatter)
{
  OddThreads threads(5);
  for (const SurfaceCloud& cloud : Clouds())
  {
    for (const PointOperatorSettings& method : Methods())
    {
      const PointCloud one = Denoise(cloud.Positions, cloud.Normals, Settings(method));
      const PointCloud other = Denoise(cloud.Positions, cloud.Normals, Settings(method), threads);
      ExpectIdentical(one.Positions, other.Positions);
      ExpectIdentical(one.Normals, other.Normals);
    }
  }
}

TEST(ProjectedClouds, PlanesStay)
{
  SurfaceCloud cloud = WedgeCloud(30, 20);
  cloud.Positions.resize(600); // one face
  cloud.Normals.resize(600);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Vec3(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
  for (std::size_t i = 0; i < 600; ++i)
  {
    cloud.Positions[i] = turn * cloud.Positions[i] + Vec3(10.0, -20.0, 5.0);
    cloud.Normals[i] = turn * cloud.Normals[i];
  }
  for (const PointOperatorSettings& method : Methods())
  {
    const PointCloud result = Denoise(cloud.Positions, cloud.Normals, Settings(method));
    for (std::size_t i = 0; i < 600; ++i)
    {
      EXPECT_LT((result.Positions[i] - cloud.Positions[i]).norm(), 1e-12);
      EXPECT_LT((result.Normals[i] - cloud.Normals[i]).norm(), 1e-12);
      EXPECT_EQ(result.Status[i], PointStatus::Filtered);
    }
  }
}

TEST(ProjectedClouds, NothingBreaksThem)
{
  const Vec3 up(0.0, 0.0, 1.0);
  Buffer<Vec3> line;
  Buffer<Vec3> heap(200, Vec3(1.0, 2.0, 3.0)); // with a plane around it
  Buffer<Vec3> pairs;
  for (int k = 0; k < 40; ++k)
  {
    line.push_back(Vec3(0.5 * k, 0.25 * k, k));
    heap.push_back(Vec3(k % 8, k / 8, 3.0));
    pairs.push_back(Vec3(k % 8, k / 8, 0.1 * (k % 3)));
    pairs.push_back(pairs.back());
  }
  Buffer<Vec3> broken = pairs;
  broken[7][1] = NotANumber;
  broken[9] = Vec3::Constant(std::numeric_limits<double>::infinity());
  Buffer<Vec3> outlier = pairs;
  outlier.push_back(Vec3(1e6, -1e6, 1e6));
  for (const Buffer<Vec3>& positions : { Buffer<Vec3>(), Buffer<Vec3>(1, up),
         Buffer<Vec3>{ up, -up }, Buffer<Vec3>(50, up), line, heap, pairs, broken, outlier })
  {
    for (const PointOperatorSettings& method : Methods())
    {
      for (const Vec3& normal : { up, Vec3(0.0, 0.0, 0.0) })
      {
        for (const int neighbors : { 1, 5, 30, 31 })
        {
          PointDenoisingSettings settings = Settings(method, neighbors);
          settings.OuterIterations = neighbors == 31 ? 3 : 1;
          const Buffer<Vec3> normals(positions.size(), normal);
          const PointCloud result = Denoise(positions, normals, settings);
          for (std::size_t i = 0; i < positions.size(); ++i)
          {
            EXPECT_EQ(result.Positions[i].allFinite(), positions[i].allFinite());
            EXPECT_TRUE(result.Normals[i].allFinite());
            const double length = result.Normals[i].norm();
            EXPECT_TRUE(length == 0.0 || std::abs(length - 1.0) < 1e-12);
            if (result.Status[i] == PointStatus::Kept && settings.OuterIterations == 1)
            {
              EXPECT_EQ(result.Positions[i], positions[i]);
            }
          }
        }
      }
    }
  }
}

TEST(ProjectedClouds, PointsWithoutANormalAreNoSamplesAndStay)
{
  const SurfaceCloud cloud = Noisy(SphereCloud(500), 0.2);
  Execution serial;
  PointSet points;
  points.Positions = points.Start = cloud.Positions;
  points.Normals = cloud.Normals;
  points.Neighbors = NearestPoints(points.Positions, 16, serial);
  points.Spacings = PointSpacings(points.Positions, points.Neighbors, serial);
  points.Spacing = cloud.Spacing;
  points.Status.assign(500, PointStatus::Filtered);
  PointSet fewer = points;
  const auto filter = MakeRobustImplicitMLS(RobustImplicitMLSSettings());
  for (std::size_t i = 0; i < 500; i += 2)
  {
    points.Normals[i].setZero();
    fewer.Spacings[i] = 0.0; // a ball without content
  }
  ASSERT_TRUE(filter->Run(points, serial, 0.0, 1.0));
  ASSERT_TRUE(filter->Run(fewer, serial, 0.0, 1.0));
  for (std::size_t i = 0; i < 500; ++i)
  {
    EXPECT_EQ(points.Status[i], i % 2 == 0 ? PointStatus::Kept : PointStatus::Filtered);
    EXPECT_EQ(points.Positions[i], i % 2 == 0 ? cloud.Positions[i] : fewer.Positions[i]);
  }
}

/// Ten thousand points at one place, with normals, take no longer than others.
TEST(ProjectedClouds, HeapsOfPointsAtOnePlaceAreNoSamples)
{
  constexpr Index count = 10000;
  PointSet points;
  points.Positions = points.Start = Buffer<Vec3>(count, Vec3(1.0, 2.0, 3.0));
  points.Normals.assign(count, Vec3(0.0, 0.0, 1.0));
  points.Spacings.assign(count, 1.0);
  points.Spacing = 1.0;
  points.Status.assign(count, PointStatus::Filtered);
  points.Neighbors.Offsets.push_back(0);
  for (Index i = 0; i < count; ++i)
  {
    for (Index k = 1; k <= 20; ++k)
    {
      points.Neighbors.Ids.push_back((i + k) % count);
    }
    points.Neighbors.Offsets.push_back(points.Neighbors.Ids.size());
  }
  Execution serial;
  ASSERT_TRUE(MakeRobustImplicitMLS(Unoriented())->Run(points, serial, 0.0, 1.0));
  EXPECT_EQ(std::count(points.Status.begin(), points.Status.end(), PointStatus::Kept), count);
}

TEST(ProjectedClouds, TheLimitOfDisplacementsKeepsPointsWithTheirNormals)
{
  const SurfaceCloud cloud = Noisy(SphereCloud(500), 0.4);
  for (const PointOperatorSettings& method : Methods())
  {
    PointDenoisingSettings settings = Settings(method);
    settings.MaximumDisplacement = 0.3;
    PointCloud result{ cloud.Positions, cloud.Normals, {}, {} };
    PointDenoisingReport report;
    Execution serial;
    ASSERT_TRUE(DenoisePoints(result, settings, report, serial));
    EXPECT_GT(report.Kept, 10u);
    EXPECT_LT(report.Kept, 490u);
    for (std::size_t i = 0; i < 500; ++i)
    {
      EXPECT_LE((result.Positions[i] - cloud.Positions[i]).norm(), 0.3 * report.Spacing);
      const bool kept = result.Status[i] == PointStatus::Kept;
      EXPECT_EQ(kept, result.Positions[i] == cloud.Positions[i]);
      EXPECT_EQ(kept, result.Normals[i] == cloud.Normals[i]);
    }
  }
}

namespace
{

class StopsAfter : public Execution
{
public:
  explicit StopsAfter(int questions)
    : Left(questions)
  {
  }

  bool Proceed(double fraction) override
  {
    if (fraction > 0.3) // neighbours and normals are done
    {
      ++this->Projections;
      EXPECT_GE(fraction, this->Done);
      EXPECT_LE(fraction, 1.0);
      this->Done = fraction;
    }
    return --this->Left >= 0;
  }

  int Left;
  int Projections = 0; ///< questions in between
  double Done = 0.0;
};

}

TEST(ProjectedClouds, TheyStopWhenAsked)
{
  const SurfaceCloud cloud = Noisy(SphereCloud(5000), 0.2);
  for (const PointOperatorSettings& method : Methods())
  {
    StopsAfter never(1000000);
    Denoise(cloud.Positions, cloud.Normals, Settings(method), never);
    const int questions = 1000000 - never.Left;
    StopsAfter early(questions - 5); // in the middle of the projections
    PointCloud result{ cloud.Positions, cloud.Normals, {}, {} };
    PointDenoisingReport report;
    EXPECT_FALSE(DenoisePoints(result, Settings(method), report, early));
    EXPECT_GT(early.Projections, 3);
    EXPECT_EQ(early.Left, -1);
    ExpectIdentical(result.Positions, cloud.Positions);
  }
}
