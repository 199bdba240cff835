// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// The normal filter on four faces, worked out by hand.

#include "FourFaces.h"

TEST_F(FourFaces, EveryNorm)
{
  const double s = 0.35;
  const struct
  {
    ErrorNorm Norm;
    Vec3 With;    ///< the own face
    Vec3 Without; ///< it
  } rows[] = {
    { L2Norm{ s }, Vec3(0.286534, 0.167001, 0.943403), Vec3(0.370235, 0.215785, 0.903528) },
    { TruncatedL2Norm{ s }, Vec3(0.044207, 0.174140, 0.983728),
      Vec3(0.058867, 0.231889, 0.970959) },
    { L1Norm{ 0.001 }, Vec3(0.001685, 0.001948, 0.999997), Vec3(0.149892, 0.173328, 0.973391) },
    { TruncatedL1Norm{ s, 0.001 }, Vec3(0.000985, 0.001948, 0.999998),
      Vec3(0.088321, 0.174623, 0.980666) },
    { HuberNorm{ s }, Vec3(0.106703, 0.173315, 0.979069), Vec3(0.141572, 0.229952, 0.962850) },
    { LorentzianNorm{ s }, Vec3(0.082904, 0.144153, 0.986076), Vec3(0.119826, 0.208351, 0.970686) },
    { GaussianNorm{ s / std::sqrt(2.0) }, Vec3(0.054475, 0.102734, 0.993216),
      Vec3(0.090410, 0.170505, 0.981200) },
    { GaussianNorm{ s }, Vec3(0.050365, 0.137020, 0.989287), Vec3(0.074341, 0.202251, 0.976508) },
    { TukeyNorm{ s }, Vec3(0.062926, 0.000104, 0.998018), Vec3(0.173514, 0.000286, 0.984831) },
    { BoxNorm{ s }, Vec3(0.069563, 0.173888, 0.982305), Vec3(0.092529, 0.231295, 0.968473) },
    { CentinNorm{ s }, Vec3(0.068958, 0.173895, 0.982347), Vec3(0.091726, 0.231313, 0.968546) },
  };
  for (const auto& row : rows)
  {
    this->Settings.Norm = row.Norm;
    this->Settings.IncludeOwn = true;
    this->ExpectNormal(this->Settings, row.With);
    this->Settings.IncludeOwn = false;
    this->ExpectNormal(this->Settings, row.Without);
  }
}

TEST_F(FourFaces, BilateralWithSpatialKernel)
{
  this->Settings.SpatialSigma = 1.0;
  this->ExpectNormal(this->Settings, Vec3(0.074380, 0.202250, 0.976505));
  this->Settings.IncludeOwn = true;
  this->ExpectNormal(this->Settings, Vec3(0.041621, 0.113172, 0.992703));
}

TEST_F(FourFaces, DirectionalCurvature)
{
  this->Settings.Norm = GaussianNorm{ 0.3 / std::sqrt(2.0) };
  this->Settings.Argument = NormalArgument::DirectionalCurvature;
  this->ExpectNormal(this->Settings, Vec3(0.102575, 0.146377, 0.983896));
  this->Settings.IncludeOwn = true;
  this->ExpectNormal(this->Settings, Vec3(0.056319, 0.080368, 0.995173));
}

TEST_F(FourFaces, MEstimateByReweighting)
{
  this->Settings.Norm = HuberNorm{ 0.35 };
  this->Settings.IncludeOwn = true;
  this->ExpectNormal(this->Settings, Vec3(0.110436, 0.173244, 0.978668), 40);
  this->Settings.Weighting = SiteWeight::Uniform;
  this->ExpectNormal(this->Settings, Vec3(0.148396, 0.114872, 0.982234), 40);
}

// L1 with the original data converges to the geometric median of the four normals.
TEST_F(FourFaces, GeometricMedian)
{
  this->Settings.Norm = L1Norm{ 1e-9 };
  this->Settings.Weighting = SiteWeight::Uniform;
  // A fifth site that sees all faces and starts anywhere.
  this->Graph.Offsets = { 0, 0, 0, 0, 0, 4 };
  this->Graph.Ids = { 0, 1, 2, 3 };
  this->Normals.push_back(Vec3(0.3, 0.2, 1.0).normalized());
  this->Areas.push_back(1.0);
  this->Centroids.push_back(Vec3(0, 0, 0));
  Execution serial;
  NormalFilter filter(this->Graph, this->Settings);
  filter.SetGeometry({ this->Centroids, this->Areas, 1e-12 }, serial);
  Buffer<Vec3> current = this->Normals;
  Buffer<Vec3> filtered;
  for (int sweep = 0; sweep < 250; ++sweep)
  {
    filter.Sweep({ current, current, this->Normals, this->Normals }, filtered, serial);
    current.swap(filtered);
  }
  EXPECT_LT((current[4] - Vec3(0.157575, 0.019648, 0.987312)).cwiseAbs().maxCoeff(), Digits);
}

// Sun et al. weigh by max(0, n_i . n_j - T)^2. That is Tukey's norm with scale sqrt(2 (1 - T)).
TEST_F(FourFaces, ThresholdedCosineIsTukey)
{
  this->Settings.Weighting = SiteWeight::Uniform;
  this->Settings.IncludeOwn = true;
  const std::pair<double, Vec3> rows[] = { { 0.5, Vec3(0.061129, 0.099034, 0.993205) },
    { 0.4, Vec3(0.060760, 0.101922, 0.992935) } };
  for (const auto& row : rows)
  {
    const double threshold = row.first;
    this->Settings.Norm = TukeyNorm{ std::sqrt(2.0 * (1.0 - threshold)) };
    this->ExpectNormal(this->Settings, row.second);
    Vec3 sum(0.0, 0.0, 0.0);
    for (const Vec3& n : this->Normals)
    {
      const double cosine = std::max(0.0, this->Normals[0].dot(n) - threshold);
      sum += cosine * cosine * n;
    }
    EXPECT_LT((this->Filter(this->Settings) - sum.normalized()).norm(), 1e-15);
  }
}

TEST_F(FourFaces, NothingToAverageKeepsTheNormal)
{
  Execution serial;
  Buffer<Vec3> filtered;
  auto kept = [&](const NormalFilterSettings& settings)
  {
    NormalFilter filter(this->Graph, settings);
    filter.SetGeometry({ this->Centroids, this->Areas, 1e-12 }, serial);
    return filter.Sweep(this->Normals, filtered, serial);
  };
  // No neighbour within the scale.
  this->Settings.Norm = TukeyNorm{ 0.1 };
  EXPECT_EQ(kept(this->Settings), 4u);
  EXPECT_EQ(filtered, this->Normals);
  // Weights so small that their squares underflow, on either side of the smallest number.
  for (double scale = 0.002; scale < 0.01; scale += 1e-5)
  {
    this->Settings.Norm = GaussianNorm{ scale };
    kept(this->Settings);
    ASSERT_NEAR(filtered[0].norm(), 1.0, 1e-15) << scale;
  }
  // Opposite normals of the same weight.
  this->Settings.Norm = L2Norm{ 1.0 };
  this->Areas = { 1.0, 1.0, 0.0, 1.0 };
  this->Normals[1] = Vec3(0.6, 0.8, 0.0);
  this->Normals[3] = -this->Normals[1];
  EXPECT_EQ(kept(this->Settings), 4u);
  EXPECT_EQ(filtered, this->Normals);
}

TEST_F(FourFaces, FaceWithoutNormalTakesThePlainMean)
{
  this->Normals[0] = Vec3(0.0, 0.0, 0.0);
  this->Areas[0] = 0.0;
  this->Settings.Norm = TukeyNorm{ 0.35 };
  const Vec3 mean = this->Normals[1] + 2.0 * this->Normals[2] + this->Normals[3];
  this->ExpectNormal(this->Settings, mean.normalized());
  this->Settings.IncludeOwn = true;
  this->ExpectNormal(this->Settings, mean.normalized());
  this->Areas[3] = 0.0; // a neighbour without area has no say, whether areas are weights or not
  this->Settings.Weighting = SiteWeight::Uniform;
  this->ExpectNormal(this->Settings, (this->Normals[1] + this->Normals[2]).normalized());
}
