// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ErrorNorm.h"

#include <gtest/gtest.h>

using namespace SurfaceDenoising;

namespace
{

constexpr double Scale = 0.5;
constexpr double Step = 1e-3;

class ErrorNorms : public testing::TestWithParam<int>
{
protected:
  /// Where the norm changes its formula; derivatives from two sides differ there.
  bool IsKink(double x) const
  {
    return std::abs(x - Scale) < 2 * Step || std::abs(x - 0.05) < 2 * Step;
  }

  ErrorNorm Norm = MakeErrorNorm(static_cast<NormId>(GetParam()), Scale);
  NormProperties Properties = PropertiesOf(this->Norm);
};

}

TEST_P(ErrorNorms, InfluenceIsTheDerivativeOfRho)
{
  for (double x = Step; x < 3.0; x += Step)
  {
    if (!this->IsKink(x))
    {
      constexpr double h = 1e-5;
      const double derivative = (Rho(this->Norm, x + h) - Rho(this->Norm, x - h)) / (2.0 * h);
      EXPECT_NEAR(Psi(this->Norm, x), derivative, 1e-8) << x;
    }
  }
  EXPECT_EQ(Rho(this->Norm, 0.0), 0.0);
}

TEST_P(ErrorNorms, WeightIsInfluenceOverX)
{
  for (double x = Step; x < 3.0; x += Step)
  {
    if (!this->IsKink(x))
    {
      EXPECT_NEAR(Weight(this->Norm, x) * x, Psi(this->Norm, x), 1e-14) << x;
    }
  }
}

TEST_P(ErrorNorms, WeightNeverGrowsAndBeginsWithOne)
{
  double before = Weight(this->Norm, 0.0);
  const NormId id = static_cast<NormId>(GetParam());
  EXPECT_EQ(before, id == NormId::L1 ? 2.0 : (id == NormId::TruncatedL1 ? 20.0 : 1.0));
  for (double x = 0.0; x < 10.0; x += Step)
  {
    const double weight = Weight(this->Norm, x);
    EXPECT_GE(weight, 0.0);
    EXPECT_LE(weight, before);
    before = weight;
  }
}

TEST_P(ErrorNorms, RhoIsContinuousAndNeverFalls)
{
  for (double x = 0.0; x < 3.0; x += Step)
  {
    const double growth = Rho(this->Norm, x + Step) - Rho(this->Norm, x);
    EXPECT_GE(growth, -1e-15) << x;
    EXPECT_LE(growth, 4.0 * Step) << x;
  }
}

TEST_P(ErrorNorms, PropertiesAreThoseOfTheFunctions)
{
  constexpr double far = 1e8;
  bool monotone = true;
  double largest = 0.0;
  for (double x = 0.0; x < 3.0; x += Step)
  {
    monotone = monotone && Psi(this->Norm, x + Step) >= Psi(this->Norm, x) - 1e-15;
    largest = std::max(largest, Psi(this->Norm, x));
  }
  EXPECT_EQ(this->Properties.Monotone, monotone);
  EXPECT_EQ(this->Properties.BoundedInfluence, Psi(this->Norm, far) <= largest + 1e-12);
  EXPECT_EQ(this->Properties.Redescending, Psi(this->Norm, far) < 1e-6);
  EXPECT_EQ(this->Properties.BoundedNorm, Rho(this->Norm, far * far) < 1.0);
}

TEST_P(ErrorNorms, CutOffIsWhereTheWeightEnds)
{
  const double cutOff = CutOff(this->Norm);
  if (std::isinf(cutOff))
  {
    EXPECT_GT(Weight(this->Norm, 3.0), 0.0);
  }
  else
  {
    EXPECT_GT(Weight(this->Norm, 0.999 * cutOff), 0.0);
    EXPECT_EQ(Weight(this->Norm, 1.001 * cutOff), 0.0);
    EXPECT_EQ(Psi(this->Norm, 1.001 * cutOff), 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(All, ErrorNorms, testing::Range(0, NumberOfNorms),
  [](const auto& info)
  {
    std::string name = NameOf(MakeErrorNorm(static_cast<NormId>(info.param), Scale));
    name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
    return name;
  });

// The largest influence in units of the scale, and where it is.
TEST(ErrorNorm, PeaksOfInfluence)
{
  const struct
  {
    NormId Id;
    double Height;
    double Place;
  } peaks[] = {
    { NormId::TruncatedL2, 1.0, 1.0 },
    { NormId::Lorentzian, 0.707107, std::sqrt(2.0) },
    { NormId::Gaussian, 0.606531, 1.0 },
    { NormId::Tukey, 0.286217, 1.0 / std::sqrt(5.0) },
    { NormId::Centin, 1.207107, std::sqrt(2.0) },
  };
  for (const auto& peak : peaks)
  {
    const ErrorNorm norm = MakeErrorNorm(peak.Id, Scale);
    double place = 0.0;
    for (double x = 0.0; x < 2.0; x += 1e-5)
    {
      place = Psi(norm, x) > Psi(norm, place) ? x : place;
    }
    EXPECT_NEAR(Psi(norm, place), peak.Height * Scale, 2e-5 * Scale) << NameOf(norm);
    EXPECT_NEAR(place, peak.Place * Scale, 2e-3 * Scale) << NameOf(norm);
  }
}

TEST(ErrorNorm, UnknownIdIsL2)
{
  EXPECT_STREQ(NameOf(MakeErrorNorm(static_cast<NormId>(99), 1.0)), "L2");
  EXPECT_STREQ(NameOf(MakeErrorNorm(static_cast<NormId>(-1), 1.0)), "L2");
}

TEST(ExpOfNegative, AgreesWithTheStandardLibrary)
{
  for (double x = -700.0; x <= 0.0; x += 0.00317)
  {
    const double expected = std::exp(x);
    ASSERT_NEAR(ExpOfNegative(x), expected, 1e-15 * expected) << x;
  }
  EXPECT_EQ(ExpOfNegative(0.0), 1.0);
  for (const double x : { -701.0, -1e10, -std::numeric_limits<double>::infinity() })
  {
    EXPECT_GE(ExpOfNegative(x), 0.0);
    EXPECT_LT(ExpOfNegative(x), 1e-300);
  }
}
