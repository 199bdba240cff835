// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

using namespace SurfaceDenoising;

namespace
{

constexpr std::size_t Many = 100000;

NoiseSource MakeSource(NoiseKind kind, double deviation = 1.0, std::uint64_t seed = 1)
{
  NoiseParameters parameters;
  parameters.Kind = kind;
  parameters.Deviation = deviation;
  parameters.Fraction = 0.25;
  parameters.Seed = seed;
  return NoiseSource(parameters, Many);
}

/// Mean of the k-th power of the amplitudes.
double Moment(const NoiseSource& source, int k)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < Many; ++i)
  {
    sum += std::pow(source.Amplitude(i), k);
  }
  return sum / Many;
}

}

// Five standard errors in all statistics: a correct generator fails once in two million draws, and
// as the numbers are fixed it either fails always or never.

TEST(Noise, GaussianHasTheMomentsOfTheNormalDistribution)
{
  const NoiseSource source = MakeSource(NoiseKind::Gaussian, 2.0);
  const double error = 5.0 / std::sqrt(double(Many));
  EXPECT_NEAR(Moment(source, 1), 0.0, 2.0 * error);
  EXPECT_NEAR(Moment(source, 2), 4.0, 4.0 * std::sqrt(2.0) * error);
  EXPECT_NEAR(Moment(source, 3), 0.0, 8.0 * std::sqrt(15.0) * error);
  EXPECT_NEAR(Moment(source, 4), 48.0, 16.0 * std::sqrt(96.0) * error);
}

TEST(Noise, UniformIsBoundedAndHasTheGivenDeviation)
{
  const NoiseSource source = MakeSource(NoiseKind::Uniform, 2.0);
  const double bound = 2.0 * std::sqrt(3.0);
  double largest = 0.0;
  for (std::size_t i = 0; i < Many; ++i)
  {
    largest = std::max(largest, std::abs(source.Amplitude(i)));
  }
  EXPECT_LT(largest, bound);
  EXPECT_GT(largest, 0.999 * bound);
  const double error = 5.0 / std::sqrt(double(Many));
  EXPECT_NEAR(Moment(source, 1), 0.0, 2.0 * error);
  EXPECT_NEAR(Moment(source, 2), 4.0, 4.0 * std::sqrt(0.8) * error);
}

TEST(Noise, ImpulsesHitExactlyTheFraction)
{
  const NoiseSource impulses = MakeSource(NoiseKind::Impulsive);
  const NoiseSource gaussian = MakeSource(NoiseKind::Gaussian);
  std::size_t hit = 0;
  for (std::size_t i = 0; i < Many; ++i)
  {
    const double amplitude = impulses.Amplitude(i);
    hit += amplitude != 0.0;
    EXPECT_TRUE(amplitude == 0.0 || amplitude == gaussian.Amplitude(i)) << i;
  }
  EXPECT_EQ(hit, Many / 4);
}

TEST(Noise, ChooseFraction)
{
  auto chosen = [](double fraction, std::size_t count)
  {
    const Buffer<unsigned char> marks = ChooseFraction(fraction, count, 3);
    EXPECT_EQ(marks.size(), count);
    return std::accumulate(marks.begin(), marks.end(), 0);
  };
  EXPECT_EQ(chosen(0.29, 100), 29); // 0.29 * 100 is 28.999999999999996
  EXPECT_EQ(chosen(0.299, 100), 29);
  EXPECT_EQ(chosen(0.0, 100), 0);
  EXPECT_EQ(chosen(1.0, 100), 100);
  EXPECT_EQ(chosen(-1.0, 100), 0);
  EXPECT_EQ(chosen(7.0, 100), 100);
  EXPECT_EQ(chosen(std::numeric_limits<double>::quiet_NaN(), 100), 0);
  EXPECT_EQ(chosen(0.5, 0), 0);
  EXPECT_EQ(chosen(0.5, 1), 0);
}

TEST(Noise, EveryPointIsChosenEquallyOften)
{
  std::vector<int> times(10, 0);
  constexpr int rounds = 10000;
  for (std::uint64_t seed = 0; seed < rounds; ++seed)
  {
    const Buffer<unsigned char> marks = ChooseFraction(0.3, times.size(), seed);
    for (std::size_t i = 0; i < times.size(); ++i)
    {
      times[i] += marks[i];
    }
  }
  for (const int count : times)
  {
    EXPECT_NEAR(count, 0.3 * rounds, 5.0 * std::sqrt(0.3 * 0.7 * rounds));
  }
}

TEST(Noise, DirectionsAreUnitVectorsEvenlyOnTheSphere)
{
  const NoiseSource source = MakeSource(NoiseKind::Gaussian);
  Vec3 mean(0.0, 0.0, 0.0);
  Mat3 second = Mat3::Zero();
  double alongAmplitude = 0.0;
  for (std::size_t i = 0; i < Many; ++i)
  {
    const Vec3 d = source.Direction(i);
    ASSERT_NEAR(d.norm(), 1.0, 1e-15);
    mean += d / Many;
    second += d * d.transpose() / Many;
    alongAmplitude += source.Amplitude(i) * d.z() / Many;
  }
  const double error = 5.0 / std::sqrt(double(Many));
  EXPECT_LT(mean.cwiseAbs().maxCoeff(), error / std::sqrt(3.0));
  EXPECT_LT((second - Mat3::Identity() / 3.0).cwiseAbs().maxCoeff(), 0.3 * error);
  EXPECT_NEAR(alongAmplitude, 0.0, error / std::sqrt(3.0)) << "length and direction depend";
}

TEST(Noise, NeighbouringPointsAndSeedsAreIndependent)
{
  const NoiseSource source = MakeSource(NoiseKind::Gaussian, 1.0, 1);
  const NoiseSource other = MakeSource(NoiseKind::Gaussian, 1.0, 2);
  double points = 0.0;
  double seeds = 0.0;
  double shifted = 0.0;
  for (std::size_t i = 0; i + 1 < Many; ++i)
  {
    points += source.Amplitude(i) * source.Amplitude(i + 1) / Many;
    seeds += source.Amplitude(i) * other.Amplitude(i) / Many;
    shifted += source.Amplitude(i + 1) * other.Amplitude(i) / Many;
  }
  const double error = 5.0 / std::sqrt(double(Many));
  EXPECT_NEAR(points, 0.0, error);
  EXPECT_NEAR(seeds, 0.0, error);
  EXPECT_NEAR(shifted, 0.0, error);
}
// Results that users keep must not change with the platform or the version. Computed by another
// program from the definition in Noise.cxx.
TEST(Noise, GoldenValues)
{
  const std::size_t points[] = { 0, 1, 2 };
  const double gaussian[] = { 0.5172087406435447, -0.885772838126675, 0.28247053588209314 };
  const double uniform[] = { 0.0032749832715242657, 0.49308981230471255, 1.4869897745642147 };
  const Vec3 directions[] = { Vec3(0.7609891141188105, 0.5020335642923492, 0.41092319053150006),
    Vec3(0.512261580251774, -0.05992080769154542, 0.8567365815719252),
    Vec3(0.7164028990322234, 0.15083164502489074, 0.6811877135689628) };
  const NoiseSource normal = MakeSource(NoiseKind::Gaussian, 1.0, 12345);
  const NoiseSource even = MakeSource(NoiseKind::Uniform, 1.0, 12345);
  for (const std::size_t i : points)
  {
    EXPECT_NEAR(normal.Amplitude(i), gaussian[i], 1e-14);
    EXPECT_NEAR(even.Amplitude(i), uniform[i], 1e-14);
    EXPECT_LT((normal.Direction(i) - directions[i]).norm(), 1e-14);
  }

  const Buffer<unsigned char> marks = ChooseFraction(0.25, 20, 12345);
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < marks.size(); ++i)
  {
    if (marks[i])
    {
      chosen.push_back(i);
    }
  }
  EXPECT_EQ(chosen, (std::vector<std::size_t>{ 0, 3, 4, 13, 15 }));
}
