// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Trials of methods on surfaces that methods made of a cloud.

#include "Automatic/CloudTrials.h"
#include "AutomaticClouds.h"
#include "Points/PointMethods.h"

#include <optional>

using namespace SurfaceDenoising;

namespace
{

PointDenoisingSettings Untouched()
{
  PointDenoisingSettings settings = ComposedPoints();
  settings.OuterIterations = 0;
  return settings;
}

PointDenoisingSettings LeastSquares(int neighbors)
{
  PointDenoisingSettings settings = SettingsOf(PointMethod::MovingLeastSquares);
  settings.Neighborhood.Count = neighbors;
  return settings;
}

/// On a wedge with noise of a fifth of a spacing. What made the surface comes first.
class CloudTrialsOnAWedge : public testing::Test
{
protected:
  void Start(const Buffer<Vec3>& points, const PointDenoisingSettings& maker)
  {
    CloudNoise noise;
    noise.Spacing = 1.0;
    this->Sample.emplace(points, Buffer<Vec3>(), noise, 0.2, 3, this->Serial);
    this->Trials.emplace(*this->Sample, 0.2);
    EXPECT_TRUE(this->Trials->AddSurface(maker, this->Serial));
  }

  double LogDistance(const PointDenoisingSettings& settings)
  {
    return this->Trials->LogDistance(0, settings, this->Serial);
  }

  Execution Serial;
  SurfaceCloud Wedge = WedgeCloud(60, 30);
  std::optional<CloudSample> Sample;
  std::optional<CloudTrials> Trials;
};

}

/// What is left by doing nothing is the noise: the mean of its absolute values, in deviations.
TEST_F(CloudTrialsOnAWedge, NoiseIsThatOfTheCloud)
{
  const PointDenoisingSettings maker = SettingsOf(PointMethod::MovingRobustPCA);
  Buffer<Vec3> points = this->Wedge.Positions;
  AddNoise(points, 0.2, 1);
  this->Start(points, maker);
  EXPECT_NEAR(std::exp(this->LogDistance(Untouched())), std::sqrt(2.0 / 3.14159265), 0.04);

  // A length with a normal distribution times a random direction: quiet places are frequent.
  points = this->Wedge.Positions;
  AddHeavyTailedNoise(points, 0.2, 1);
  this->Start(points, maker);
  EXPECT_NEAR(std::exp(this->LogDistance(Untouched())), std::sqrt(1.5 / 3.14159265), 0.04);
}

TEST_F(CloudTrialsOnAWedge, TellsWhatKeepsTheEdge)
{
  const PointDenoisingSettings sharp = SettingsOf(PointMethod::MovingRobustPCA);
  Buffer<Vec3> points = this->Wedge.Positions;
  AddNoise(points, 0.2, 1);
  this->Start(points, sharp);
  const double ofSharp = this->LogDistance(sharp);
  EXPECT_LT(ofSharp, this->LogDistance(LeastSquares(30)) - 0.2);
  EXPECT_LT(this->LogDistance(LeastSquares(30)), this->LogDistance(Untouched()) - 0.2);

  // A surface favours what it comes from.
  const PointDenoisingSettings smooth = LeastSquares(200);
  ASSERT_TRUE(this->Trials->AddSurface(smooth, this->Serial));
  const double behind = this->Trials->LogDistance(1, smooth, this->Serial) -
    this->Trials->LogDistance(1, sharp, this->Serial);
  EXPECT_LT(behind, this->LogDistance(smooth) - ofSharp - 0.05);
}

TEST_F(CloudTrialsOnAWedge, WhatLeavesPointsAloneMakesNoSurface)
{
  this->Start(this->Wedge.Positions, SettingsOf(PointMethod::MovingRobustPCA));
  EXPECT_FALSE(this->Trials->AddSurface(Untouched(), this->Serial));
  EXPECT_EQ(this->Trials->NumberOfSurfaces(), 1u);
}
