// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// What trials on surfaces that methods made say of these methods.

#include "Automatic/TrialVerdict.h"

#include <gtest/gtest.h>

using namespace SurfaceDenoising;

namespace
{

/// Methods 0 and 1 are of one kind, 2 and 3 of another.
const std::vector<std::size_t> Kinds = { 7, 7, 5, 5 };

/// Of so many points, gains above 0.022 are no chance.
constexpr std::size_t Judged = 10000;

}

TEST(TrialVerdict, SurfacesAreNotHeardOnTheirMakersAndTheirKind)
{
  const TrialVerdict verdict(Kinds, 0, Judged);
  EXPECT_FALSE(verdict.IsHeard(1, 1));
  EXPECT_FALSE(verdict.IsHeard(2, 2));
  EXPECT_FALSE(verdict.IsHeard(2, 3));
  EXPECT_TRUE(verdict.IsHeard(1, 2));
}

TEST(TrialVerdict, SurfacesTellMethodsOfTheKindOfTheFavouriteApart)
{
  const TrialVerdict verdict(Kinds, 0, Judged);
  EXPECT_TRUE(verdict.IsHeard(2, 1));
  EXPECT_TRUE(verdict.IsHeard(0, 1));
}

TEST(TrialVerdict, TheSurfaceOfTheFavouriteIsHeardOnAllOthers)
{
  const TrialVerdict verdict(Kinds, 2, Judged);
  for (const std::size_t method : { 0, 1, 3 })
  {
    EXPECT_TRUE(verdict.IsHeard(2, method)) << method;
  }
}

TEST(TrialVerdict, WhatMayBeChanceDoesNotCount)
{
  TrialVerdict verdict(Kinds, 0, Judged);
  EXPECT_EQ(verdict.Chosen(), 0u);
  verdict.AddGain(3, 0.02);
  EXPECT_EQ(verdict.Chosen(), 0u);
  verdict.AddGain(1, 0.024);
  EXPECT_EQ(verdict.Chosen(), 1u);

  TrialVerdict ofFewer(Kinds, 0, Judged / 4);
  ofFewer.AddGain(1, 0.024);
  EXPECT_EQ(ofFewer.Chosen(), 0u);
}

TEST(TrialVerdict, GainsCountOnAverage)
{
  TrialVerdict verdict(Kinds, 0, Judged);
  verdict.AddGain(2, 0.3);
  verdict.AddGain(2, -0.2); // 0.05
  verdict.AddGain(3, 0.1);
  verdict.AddGain(3, 0.04); // 0.07
  verdict.AddGain(1, 0.06);
  EXPECT_EQ(verdict.Chosen(), 3u);

  TrialVerdict once(Kinds, 0, Judged);
  once.AddGain(3, 0.1);
  once.AddGain(3, 0.04); // 0.14 together
  once.AddGain(1, 0.08);
  EXPECT_EQ(once.Chosen(), 1u);
}
