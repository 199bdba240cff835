// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// The search for the values of open settings, and iterations that end by themselves.

#include "Automatic/CloudTuning.h"
#include "Automatic/MeshTuning.h"
#include "AutomaticShapes.h"
#include "CompareMeshes.h"
#include "Methods.h"
#include "NoisyClouds.h"
#include "NoisyCube.h"
#include "OddThreads.h"
#include "Points/PointMethods.h"

#include <cmath>
#include <functional>

namespace
{

/// Judges by a cost.
class Judge : public OpenSettings::Judge
{
public:
  explicit Judge(std::function<double()> cost)
    : Cost(std::move(cost))
  {
  }

  bool Try(Execution& execution) override
  {
    this->Known.push_back(this->Cost());
    return execution.Proceed(1.0);
  }

  std::vector<double> Costs() const override { return this->Known; }

  std::function<double()> Cost;
  std::vector<double> Known;
};

/// Settings with a best value, known to those who judge.
class Toy : public Judge
{
public:
  Toy()
    : Judge([this] { return this->Distance(); })
  {
  }

  double Scale = 1.0;
  int Count = 10;
  double Follower = 0.0;
  double BestScale = 2.0;
  int BestCount = 23;
  std::vector<double> Scales;
  std::vector<int> Counts;

private:
  double Distance()
  {
    EXPECT_EQ(this->Follower, this->Scale);
    this->Counts.push_back(this->Count);
    this->Scales.push_back(this->Scale);
    const double scale = std::log(this->Scale / this->BestScale);
    const double count = std::log(double(this->Count) / this->BestCount);
    return scale * scale + count * count + scale * count;
  }
};

OpenSettings Open(Toy& toy)
{
  OpenSettings open;
  open.Take("Scale", 0.0, toy.Scale, 2.0);
  open.Tie(toy.Scale, toy.Follower);
  open.Take("Count", 0, toy.Count);
  return open;
}

TriangleMesh Noisy(const TriangleMesh& clean, double level)
{
  TriangleMesh mesh = clean;
  AddNormalNoise(mesh, level, 12345);
  return mesh;
}

/// Chooses scale and iterations of a method for a mesh. Returns the report.
MeshTuningReport Tune(const TriangleMesh& mesh, MeshDenoisingSettings& settings, OpenSettings& open,
  Execution& execution)
{
  open.Clear();
  open.Take("RangeScale", 0.0, settings.NormScale);
  open.Take("NumberOfNormalIterations", 0, settings.NormalIterations);
  MeshTuningReport report;
  EXPECT_TRUE(TuneForMesh(
    mesh, open,
    [&](TriangleMesh& trial, Execution& share)
    {
      Buffer<Vec3> normals;
      MeshDenoisingReport done;
      return DenoiseMesh(trial, normals, settings, done, share);
    },
    report, execution));
  return report;
}

double AngleAfter(const TriangleMesh& mesh, const TriangleMesh& clean,
  const MeshDenoisingSettings& settings, MeshDenoisingReport& report)
{
  report = MeshDenoisingReport();
  TriangleMesh result = mesh;
  Buffer<Vec3> normals;
  Execution serial;
  EXPECT_TRUE(DenoiseMesh(result, normals, settings, report, serial));
  return Measure(result, clean).MeanAngle;
}

}

TEST(OpenSettings, GivenValuesAreTaken)
{
  double scale = 3.0;
  double spatial = 1.0;
  int count = 7;
  OpenSettings open;
  open.Take("Scale", 4.0, scale, 0.5);
  open.Take("Count", 9, count);
  open.TakeSpatial("Spatial", 2.5, spatial);
  EXPECT_FALSE(open.Any());
  EXPECT_EQ(scale, 2.0);
  EXPECT_EQ(count, 9);
  EXPECT_EQ(spatial, 2.5);
  open.Take("Scale", 0.01, scale, 1.0, 0.1);
  EXPECT_EQ(scale, 0.1);
  open.Take("Count", -1, count);
  EXPECT_EQ(count, 0);
  open.TakeSpatial("Spatial", -1.0, spatial);
  EXPECT_EQ(spatial, 0.0);
  EXPECT_EQ(OpenSettings::SpatialProperty(0.0), -1.0);
  EXPECT_EQ(OpenSettings::SpatialProperty(1.5), 1.5);
  EXPECT_TRUE(std::isnan(open.Chosen("Scale")));
}

TEST(OpenSettings, SearchComesNearTheBest)
{
  Toy toy;
  OpenSettings open = Open(toy);
  ASSERT_TRUE(open.Any());
  Execution serial;
  ASSERT_TRUE(open.Search(toy, serial));
  open.Keep();
  EXPECT_NEAR(std::log(toy.Scale / toy.BestScale), 0.0, std::log(1.25));
  EXPECT_NEAR(std::log(toy.Count / double(toy.BestCount)), 0.0, std::log(1.4));
  EXPECT_EQ(toy.Follower, toy.Scale);
  EXPECT_EQ(open.Chosen("Scale"), toy.Scale / 2.0);
  EXPECT_EQ(open.Chosen("Count"), toy.Count);
  EXPECT_LE(toy.Known.size(), 6u + 4u * 2u);

  // A judge who prefers small values has the last word, among the best and the start.
  Judge strict([&] { return toy.Scale + toy.Count; });
  ASSERT_TRUE(open.Confirm(toy, strict, serial));
  EXPECT_LE(strict.Known.size(), 5u);
  EXPECT_EQ(toy.Scale, 1.0);
  EXPECT_EQ(toy.Count, 10);
  EXPECT_EQ(toy.Follower, 1.0);
  open.Close("Scale");
  EXPECT_TRUE(std::isnan(open.Chosen("Scale")));
  EXPECT_FALSE(std::isnan(open.Chosen("Count")));
}

TEST(OpenSettings, SearchStaysWithinBounds)
{
  for (const double best : { 1e-6, 1e6 })
  {
    Toy toy;
    toy.BestScale = best;
    toy.BestCount = best > 1.0 ? 1000000 : 1;
    OpenSettings open = Open(toy);
    Execution serial;
    ASSERT_TRUE(open.Search(toy, serial));
    for (std::size_t k = 0; k < toy.Known.size(); ++k)
    {
      EXPECT_GE(toy.Scales[k], 1.0 / 8.0);
      EXPECT_LE(toy.Scales[k], 8.0);
      EXPECT_GE(toy.Counts[k], 1);
      EXPECT_LE(toy.Counts[k], 40);
    }
  }
}

// Risks are estimates: on meshes as small as these the best of them is not always the best.
TEST(MeshTuning, NearTheBestOnSmoothAndSharpShapes)
{
  for (const AutomaticShape& shape : AutomaticShapes())
  {
    const TriangleMesh clean = shape.Make();
    const TriangleMesh mesh = Noisy(clean, 0.3);
    MeshDenoisingSettings settings = SettingsOf(Method::BilateralNormal);
    double best = 180.0;
    MeshDenoisingReport report;
    for (const double scale : { 0.2, 0.35, 0.5, 0.7 })
    {
      for (const int iterations : { 5, 10, 20, 40 })
      {
        settings.NormScale = scale;
        settings.NormalIterations = iterations;
        best = std::min(best, AngleAfter(mesh, clean, settings, report));
      }
    }
    settings = SettingsOf(Method::BilateralNormal);
    OpenSettings open;
    Execution serial;
    const MeshTuningReport found = Tune(mesh, settings, open, serial);
    EXPECT_FALSE(found.NoNoiseFound);
    EXPECT_NEAR(found.Noise.Level, 0.3, 0.06);
    EXPECT_EQ(open.Chosen("RangeScale"), settings.NormScale);
    EXPECT_LT(AngleAfter(mesh, clean, settings, report), 2.1 * best) << shape.Name;
  }
}

// A scale that keeps noise for features, and one that rounds all edges.
TEST(MeshTuning, FindsItsWayFromBadStarts)
{
  const TriangleMesh clean = Cube(14);
  const TriangleMesh mesh = Noisy(clean, 0.2);
  for (const double start : { 0.05, 1.5 })
  {
    MeshDenoisingSettings settings = SettingsOf(Method::BilateralNormal);
    settings.NormScale = start;
    MeshDenoisingReport report;
    const double before = AngleAfter(mesh, clean, settings, report);
    OpenSettings open;
    Execution serial;
    Tune(mesh, settings, open, serial);
    EXPECT_LT(AngleAfter(mesh, clean, settings, report), 0.5 * before) << start;
  }
}

TEST(MeshTuning, SameForAnyOrderPlaceSizeAndThreads)
{
  const TriangleMesh mesh = Noisy(Torus(20), 0.25);
  MeshDenoisingSettings settings = SettingsOf(Method::BilateralNormal);
  OpenSettings open;
  Execution serial;
  Tune(mesh, settings, open, serial);
  OddThreads threads(3);
  MeshDenoisingSettings again = SettingsOf(Method::BilateralNormal);
  Tune(mesh, again, open, threads);
  EXPECT_EQ(settings.NormScale, again.NormScale);
  EXPECT_EQ(settings.NormalIterations, again.NormalIterations);

  TriangleMesh moved = mesh;
  std::reverse(moved.Triangles.begin(), moved.Triangles.end());
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  for (Vec3& p : moved.Positions)
  {
    p = 40.0 * (turn * p) + Vec3(3.0, -5.0, 2.0);
  }
  again = SettingsOf(Method::BilateralNormal);
  Tune(moved, again, open, serial);
  EXPECT_EQ(settings.NormScale, again.NormScale);
  EXPECT_EQ(settings.NormalIterations, again.NormalIterations);
}

TEST(MeshTuning, NothingIsChosenWithoutNoise)
{
  MeshDenoisingSettings settings = SettingsOf(Method::BilateralNormal);
  OpenSettings open;
  Execution serial;
  EXPECT_TRUE(Tune(Torus(20), settings, open, serial).NoNoiseFound);
  EXPECT_EQ(settings.NormScale, SettingsOf(Method::BilateralNormal).NormScale);
}

// Neither stage goes on once the normals are as far from the input as the noise turned them.
TEST(Residual, EndsIterationsOfBothSchedules)
{
  const TriangleMesh clean = Cube(14);
  const TriangleMesh mesh = Noisy(clean, 0.2);
  Execution serial;
  SurfaceNoise noise;
  ASSERT_TRUE(MeasureNoise(mesh, noise, serial));
  const double angle = noise.NormalAngle * 3.14159265358979323846 / 180.0;
  for (const bool alternate : { false, true })
  {
    MeshDenoisingSettings settings = SettingsOf(Method::BilateralNormal);
    settings.OuterIterations = alternate ? 60 : 1;
    settings.NormalIterations = alternate ? 1 : 60;
    settings.VertexIterations = alternate ? 2 : 10;
    settings.NormScale = 0.6;
    MeshDenoisingReport all;
    const double tooFar = AngleAfter(mesh, clean, settings, all);
    EXPECT_EQ(all.NormalIterations, 60);
    EXPECT_EQ(all.VertexIterations, alternate ? 120 : 10);
    settings.Residual = 0.9 * angle;
    MeshDenoisingReport some;
    const double ended = AngleAfter(mesh, clean, settings, some);
    EXPECT_GT(some.NormalIterations, 1);
    EXPECT_LT(some.NormalIterations, 60);
    EXPECT_EQ(some.VertexIterations, alternate ? 2 * some.OuterIterations : 10);
    EXPECT_LT(ended, tooFar) << alternate;

    // As many iterations as these are the same, and one less is not enough.
    settings.Residual = 0.0;
    (alternate ? settings.OuterIterations : settings.NormalIterations) = some.NormalIterations;
    MeshDenoisingReport again;
    EXPECT_EQ(AngleAfter(mesh, clean, settings, again), ended);
    (alternate ? settings.OuterIterations : settings.NormalIterations) = some.NormalIterations - 1;
    settings.Residual = 0.9 * angle;
    AngleAfter(mesh, clean, settings, again);
    EXPECT_EQ(again.NormalIterations, some.NormalIterations - 1);
  }
}

TEST(CloudTuning, BeatsTheDefaultsAndStopsAtNoise)
{
  const SurfaceCloud clean = SphereCloud(2000);
  PointCloud cloud;
  cloud.Positions = clean.Positions;
  AddNoise(cloud.Positions, 0.5 * clean.Spacing, 9);
  auto errorAfter = [&](const PointDenoisingSettings& settings, PointDenoisingReport& report)
  {
    PointCloud result = cloud;
    Execution serial;
    report = PointDenoisingReport();
    EXPECT_TRUE(DenoisePoints(result, settings, report, serial));
    double sum = 0.0;
    for (const Vec3& p : result.Positions)
    {
      sum += std::abs(clean.DistanceOf(p));
    }
    return sum;
  };
  PointDenoisingSettings settings = ComposedPoints();
  PointDenoisingReport report;
  const double standard = errorAfter(settings, report);
  OpenSettings open;
  auto& stages = std::get<TwoStageSettings>(settings.Operator);
  open.Take("NumberOfNeighbors", 0, settings.Neighborhood.Count, 6);
  open.Take("RangeScale", 0.0, stages.Normals.NormScale);
  open.Tie(stages.Normals.NormScale, stages.Points.NormScale);
  CloudTuningReport found;
  OddThreads threads(3);
  ASSERT_TRUE(TuneForCloud(cloud, open, settings, found, threads));
  EXPECT_FALSE(found.NoNoiseFound);
  EXPECT_NEAR(found.Deviation / found.Spacing, 0.5, 0.07);
  EXPECT_LT(errorAfter(settings, report), 0.8 * standard);
  EXPECT_EQ(open.Chosen("NumberOfNeighbors"), settings.Neighborhood.Count);

  // Points that move on and on are stopped where the noise ends.
  settings = SettingsOf(PointMethod::BilateralPoint);
  settings.OuterIterations = 30;
  const double tooFar = errorAfter(settings, report);
  EXPECT_EQ(report.OuterIterations, 30);
  settings.Residual = found.Deviation;
  EXPECT_LT(errorAfter(settings, report), tooFar);
  EXPECT_LT(report.OuterIterations, 15);

  cloud.Positions = clean.Positions;
  ASSERT_TRUE(TuneForCloud(cloud, open, settings, found, threads));
  EXPECT_TRUE(found.NoNoiseFound || found.Deviation < 0.02 * found.Spacing);
}
