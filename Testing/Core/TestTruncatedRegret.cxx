// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// The best of several choices after rounds that do not agree.

#include "Automatic/TruncatedRegret.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace SurfaceDenoising;

/// The first choice is far better in one round, the second a little in two.
TEST(TruncatedRegret, NoRoundDecidesAlone)
{
  TruncatedRegret regret(3, 3.0);
  regret.AddRound(1.0, { 0.0, 2.0, 1.0 });
  EXPECT_TRUE(regret.IsOpen(1));
  EXPECT_EQ(regret.Best(), 0u);
  regret.AddRound(1.0, { 0.2, 0.0, 0.5 });
  EXPECT_TRUE(regret.IsOpen(0));
  EXPECT_FALSE(regret.IsOpen(2)); // 0.6 behind by now, and 0.3 to be won
  regret.AddRound(1.0, { 0.2, 0.0, -5.0 });
  EXPECT_EQ(regret.Best(), 1u);
}

/// Whatever the rounds to come say, the best of all rounds is none of those given up first.
TEST(TruncatedRegret, GivesUpOnlyWhatIsLost)
{
  std::mt19937 random(1);
  std::normal_distribution<double> loss(0.0, 0.3);
  constexpr std::size_t choices = 5;
  const double weights[] = { 0.9, 0.4, 0.25, 0.1 };
  int givenUp = 0;
  for (int repetition = 0; repetition < 2000; ++repetition)
  {
    TruncatedRegret regret(choices, 1.65);
    std::vector<double> all(choices, 0.0);
    std::vector<bool> lost(choices, false);
    for (const double weight : weights)
    {
      std::vector<double> losses(choices);
      std::generate(losses.begin(), losses.end(), [&] { return loss(random); });
      const double least = *std::min_element(losses.begin(), losses.end());
      for (std::size_t k = 0; k < choices; ++k)
      {
        all[k] += weight * std::min(0.3, losses[k] - least);
      }
      regret.AddRound(weight, losses);
      if (weight > 0.1 && std::count(lost.begin(), lost.end(), true) == 0)
      {
        for (std::size_t k = 0; k < choices; ++k)
        {
          lost[k] = !regret.IsOpen(k);
        }
      }
    }
    givenUp += int(std::count(lost.begin(), lost.end(), true));
    const auto best = std::min_element(all.begin(), all.end());
    EXPECT_FALSE(lost[std::size_t(best - all.begin())]) << repetition;
  }
  EXPECT_GT(givenUp, 1000);
}

/// Ten times 0.1 is not 1, nor is 1 less that ten times 0.
TEST(TruncatedRegret, RoundingLeavesTheBest)
{
  for (const double weight : { 0.1, 1.0 / 3.0, 0.7 })
  {
    TruncatedRegret regret(2, 10.0 * weight);
    for (int t = 0; t < 10; ++t)
    {
      regret.AddRound(weight, { 0.1, 0.1 });
    }
    EXPECT_TRUE(regret.IsOpen(regret.Best()));
  }
}

TEST(TruncatedRegret, ExcludedChoicesHaveNoSay)
{
  TruncatedRegret regret(3, 1.0);
  regret.Exclude(0);
  regret.AddRound(1.0, { -9.0, 0.2, 0.1 });
  EXPECT_FALSE(regret.IsOpen(0));
  EXPECT_EQ(regret.Best(), 2u);
}
