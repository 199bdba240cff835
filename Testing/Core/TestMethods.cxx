// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// The table of methods, and whole methods on a noisy cube against the figures of an independent
// program.

#include "Methods.h"
#include "NoisyCube.h"

#include <set>

namespace
{

/// A row of the table in the terms of the paper, where the program that made the figures used other
/// numbers.
MeshDenoisingSettings With(Method method, double normScale, int outer, int normal, int vertex)
{
  MeshDenoisingSettings settings = SettingsOf(method);
  settings.NormScale = normScale;
  settings.OuterIterations = outer;
  settings.NormalIterations = normal;
  settings.VertexIterations = vertex;
  settings.Vertices.MaximumDisplacement = 0.0;
  return settings;
}

}

TEST(Methods, RowsAreInTheOrderOfTheEnumeration)
{
  std::set<std::string> names;
  for (std::size_t i = 0; i < Methods().size(); ++i)
  {
    const MethodRow& row = Methods()[i];
    EXPECT_EQ(static_cast<std::size_t>(row.Id), i);
    EXPECT_TRUE(names.insert(row.Name).second) << row.Name;
    EXPECT_TRUE(row.TwoStage || !row.Composed) << row.Name;
  }
  EXPECT_EQ(Methods().back().Id, Method::NonIterativeBilateral);
}

TEST_F(NoisyCube, EveryMethod)
{
  const double root2 = std::sqrt(2.0);
  MeshDenoisingSettings edgeCurvature = With(Method::GeometricFidelity, 0.2, 30, 1, 5);
  edgeCurvature.Argument = NormalArgument::DirectionalCurvature;
  MeshDenoisingSettings global = With(Method::GlobalBilateralNormal, 0.35, 1, 1, 20);
  global.Global.AreaEnergy = false;
  MeshDenoisingSettings smoother = global;
  smoother.Global.Fidelity = 0.001;
  MeshDenoisingSettings mEstimate = With(Method::HuberNormal, 0.2, 1, 20, 20);
  mEstimate.Data = NormalData::Original;
  mEstimate.SpatialScale = 1.0;
  MeshDenoisingSettings cosine = With(Method::ThresholdedCosine, 1.0, 1, 20, 50);
  cosine.Weighting = SiteWeight::Area; // as the other program, unlike the paper

  const struct
  {
    const char* Name;
    MeshDenoisingSettings Settings;
    Figures AlongNormals; ///< noise of 0.2
    Figures AnyDirection; ///< noise of 0.3; a mean angle of 0: not known
  } rows[] = {
    { "mean", SettingsOf(Method::MeanNormal), { 14.013, 1.00424, 2 }, { 15.968, 1.00748, 26 } },
    { "median", SettingsOf(Method::MedianNormal), { 4.132, 0.98881, 84 }, { 6.055, 0.98733, 91 } },
    { "weighted median", SettingsOf(Method::WeightedMedianNormal), { 4.231, 0.98852, 85 },
      { 5.782, 0.98660, 94 } },
    { "normal diffusion", With(Method::NormalDiffusion, 0.6 / root2, 10, 1, 20),
      { 3.609, 0.99175, 98 }, { 4.292, 0.99585, 103 } },
    { "voting tensor", With(Method::NormalVotingTensor, 0.8, 60, 1, 1), { 3.226, 0.99627, 94 },
      { 4.325, 0.99832, 106 } },
    { "fuzzy median", SettingsOf(Method::FuzzyVectorMedian), { 3.136, 0.99311, 92 },
      { 3.658, 0.99373, 104 } },
    { "curvature diffusion", SettingsOf(Method::CurvatureNormalDiffusion), { 1.210, 0.99290, 98 },
      { 2.517, 0.99676, 106 } },
    { "face curvature", With(Method::GeometricFidelity, 0.1, 30, 1, 5), { 5.807, 1.01057, 53 },
      {} },
    { "edge curvature", edgeCurvature, { 1.972, 0.99882, 95 }, {} },
    { "bilateral", SettingsOf(Method::BilateralNormal), { 2.017, 0.99375, 97 },
      { 2.991, 0.99644, 104 } },
    { "global", global, { 3.584, 0.99503, 95 }, {} },
    { "smoother global", smoother, { 2.558, 0.0, 0 }, {} },
    { "guided", SettingsOf(Method::GuidedNormal), { 2.372, 0.99262, 88 }, { 3.075, 0.99440, 91 } },
    { "Tukey", With(Method::TukeyBilateralNormal, 0.35, 60, 1, 1), { 3.463, 0.94831, 94 },
      { 2.980, 0.94996, 96 } },
    { "cosine", cosine, { 1.411, 0.99032, 97 }, { 2.752, 0.99093, 107 } },
    { "Huber", SettingsOf(Method::HuberNormal), { 5.840, 1.00969, 62 }, {} },
    { "Huber M-estimate", mEstimate, { 9.796, 0.99983, 0 }, {} },
  };
  for (const auto& row : rows)
  {
    for (const bool anyDirection : { false, true })
    {
      const Figures& expected = anyDirection ? row.AnyDirection : row.AlongNormals;
      if (expected.MeanAngle == 0.0)
      {
        continue;
      }
      SCOPED_TRACE(row.Name);
      const Figures figures =
        this->Denoise(anyDirection ? this->DirectionNoisy : this->Noisy, row.Settings);
      EXPECT_NEAR(figures.MeanAngle, expected.MeanAngle, 6e-4);
      if (expected.Volume > 0.0)
      {
        EXPECT_NEAR(figures.Volume, expected.Volume, 6e-6);
      }
      if (expected.FeatureEdges > 0)
      {
        EXPECT_EQ(figures.FeatureEdges, expected.FeatureEdges);
      }
    }
  }
}

// The released energies of the global scheme ignore areas, those of the paper do not.
TEST_F(NoisyCube, AreaFactorsOfTheGlobalSchemeMatterLittle)
{
  const MeshDenoisingSettings areas = With(Method::GlobalBilateralNormal, 0.35, 1, 1, 20);
  EXPECT_NEAR(this->Denoise(this->Noisy, areas).MeanAngle, 3.584, 0.1);
}

TEST_F(NoisyCube, CleanCubeStaysForMethodsWithACutOff)
{
  for (const Method method :
    { Method::ThresholdedCosine, Method::TukeyBilateralNormal, Method::NormalVotingTensor })
  {
    MeshDenoisingSettings settings = SettingsOf(method);
    settings.Vertices.Relaxation = 0.0; // evens out edges, on a cube too
    EXPECT_LT(this->Denoise(this->Clean, settings).MeanAngle, 1e-6) << int(method);
  }
}

// Averages over similar faces, so that a face that is cut finer weighs no more.
TEST_F(NoisyCube, MeanFiltersRoundEdgesAndRobustOnesDoNot)
{
  auto featureEdges = [this](Method method)
  { return this->Denoise(this->Noisy, SettingsOf(method)).FeatureEdges; };
  EXPECT_LT(featureEdges(Method::MeanNormal), 10u);
  EXPECT_GT(featureEdges(Method::BilateralNormal), 90u);
  EXPECT_GT(featureEdges(Method::ThresholdedCosine), 90u);
}
