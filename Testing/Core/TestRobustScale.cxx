// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RandomMeshes.h"
#include "RobustScale.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace SurfaceDenoising;

namespace
{

Buffer<double> Values(std::initializer_list<double> values)
{
  return Buffer<double>(values.begin(), values.end());
}

double MedianOf(std::initializer_list<double> list)
{
  Buffer<double> values = Values(list);
  return Median(values);
}

double ScaleOf(Buffer<double> values, ScaleEstimator estimator)
{
  return RobustScale(values, estimator);
}

}

TEST(RobustScale, Median)
{
  EXPECT_EQ(MedianOf({}), 0.0);
  EXPECT_EQ(MedianOf({ 3.0 }), 3.0);
  EXPECT_EQ(MedianOf({ 3.0, 1.0 }), 2.0);
  EXPECT_EQ(MedianOf({ 9.0, 1.0, 2.0 }), 2.0);
  EXPECT_EQ(MedianOf({ 4.0, 1.0, 100.0, 2.0 }), 3.0);
  EXPECT_EQ(MedianOf({ 1.0, 1.0, 1.0, 7.0 }), 1.0);
}

TEST(RobustScale, WorkedExample)
{
  const Buffer<double> x = Values({ 0.1, 0.2, 0.3, 0.4, 1.4 });
  const double sigma = ScaleOf(x, ScaleEstimator::MedianAbsoluteDeviation);
  EXPECT_NEAR(sigma, 0.148260, 1e-6);
  EXPECT_NEAR(ScaleForOutlierBoundary(NormId::Tukey, sigma), 0.331519, 1e-6);
  EXPECT_NEAR(ScaleForOutlierBoundary(NormId::Lorentzian, sigma), 0.104836, 1e-6);
  EXPECT_NEAR(ScaleForOutlierBoundary(NormId::Centin, sigma), 0.104836, 1e-6);
  EXPECT_NEAR(ScaleForOutlierBoundary(NormId::Gaussian, sigma) * std::sqrt(2.0), 0.209671, 1e-6);
  const double truncation = ScaleForOutlierBoundary(NormId::TruncatedL2, sigma);
  EXPECT_NEAR(truncation * truncation, 0.021981, 1e-6);
  EXPECT_NEAR(ScaleOf(x, ScaleEstimator::Rayleigh), 0.3 / 1.177410, 1e-6);
  EXPECT_NEAR(ScaleOf(x, ScaleEstimator::HalfNormal), 0.3 * 1.482602, 1e-6);
}

TEST(RobustScale, NothingAndNoNoise)
{
  for (const ScaleEstimator estimator : { ScaleEstimator::MedianAbsoluteDeviation,
         ScaleEstimator::Rayleigh, ScaleEstimator::HalfNormal })
  {
    EXPECT_EQ(ScaleOf({}, estimator), 0.0);
    EXPECT_EQ(ScaleOf(Values({ 0.0, 0.0, 0.0, 5.0 }), estimator), 0.0);
  }
}

TEST(RobustScale, EstimatesTheStandardDeviationOfItsData)
{
  constexpr std::size_t count = 100000;
  PortableRandom random(1);
  Buffer<double> normal;
  Buffer<double> half;
  Buffer<double> lengths;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = 2.0 * random.Gaussian();
    const double y = 2.0 * random.Gaussian();
    normal.push_back(x);
    half.push_back(std::abs(x));
    lengths.push_back(std::hypot(x, y));
  }
  const double error = 5.0 * 2.0 * 1.17 / std::sqrt(double(count)); // five standard errors
  EXPECT_NEAR(ScaleOf(normal, ScaleEstimator::MedianAbsoluteDeviation), 2.0, error);
  EXPECT_NEAR(ScaleOf(half, ScaleEstimator::HalfNormal), 2.0, error);
  EXPECT_NEAR(ScaleOf(lengths, ScaleEstimator::Rayleigh), 2.0, error);
  EXPECT_NEAR(ScaleOf(lengths, ScaleEstimator::MedianAbsoluteDeviation), 2.0 * 0.664877, error);
}

// A norm scaled to the outlier boundary has its largest influence there.
TEST(RobustScale, InfluenceIsLargestAtTheBoundary)
{
  constexpr double sigma = 0.2;
  for (int id = 0; id < NumberOfNorms; ++id)
  {
    const NormId norm = static_cast<NormId>(id);
    const ErrorNorm scaled = MakeErrorNorm(norm, ScaleForOutlierBoundary(norm, sigma));
    if (!PropertiesOf(scaled).Redescending || norm == NormId::TruncatedL1)
    {
      continue; // there is no peak
    }
    EXPECT_GT(Psi(scaled, sigma), Psi(scaled, 0.99 * sigma)) << NameOf(scaled);
    EXPECT_GT(Psi(scaled, sigma), Psi(scaled, 1.01 * sigma)) << NameOf(scaled);
  }
}

// The efficiency of an M-estimate of location is E[psi']^2 / E[psi^2] under the normal
// distribution.
TEST(RobustScale, EfficiencyConstantsGive95Percent)
{
  for (int id = 0; id < NumberOfNorms; ++id)
  {
    const NormId norm = static_cast<NormId>(id);
    const double constant = EfficiencyConstant(norm);
    if (!std::isfinite(constant))
    {
      continue;
    }
    const ErrorNorm scaled = MakeErrorNorm(norm, constant);
    // E[psi'] = E[x psi] by partial integration, which also holds where psi jumps.
    double slope = 0.0;
    double square = 0.0;
    constexpr double dx = 1e-3;
    for (double x = 0.5 * dx; x < 9.0; x += dx)
    {
      const double density = 2.0 * std::exp(-0.5 * x * x) / std::sqrt(2.0 * 3.14159265358979) * dx;
      slope += density * x * Psi(scaled, x);
      square += density * Psi(scaled, x) * Psi(scaled, x);
    }
    EXPECT_NEAR(slope * slope / square, 0.95, 5e-4) << NameOf(scaled);
  }
  EXPECT_TRUE(std::isinf(EfficiencyConstant(NormId::L2)));
  EXPECT_TRUE(std::isnan(EfficiencyConstant(NormId::L1)));
  EXPECT_TRUE(std::isnan(EfficiencyConstant(NormId::TruncatedL1)));
}
