// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// The engine on a noisy cube, against the figures of an independent program.

#include "NoisyCube.h"

TEST_F(NoisyCube, TheModelItself)
{
  EXPECT_EQ(this->Clean.NumberOfVertices(), 386u);
  EXPECT_EQ(this->Clean.NumberOfFaces(), 768u);
  Execution serial;
  const CompressedRows stars = VertexStars(this->Clean);
  EXPECT_NEAR(TakeEdgeCensus(this->Clean, stars, serial).MeanEdgeLength, 0.142258898, 1e-9);
  EXPECT_LT((this->Noisy.Positions[0] - Vec3::Constant(-0.045583060)).norm(), 1e-8);
  EXPECT_LT((this->Noisy.Positions[200] - Vec3(0.5, 1.006373094, -0.006373094)).norm(), 1e-8);

  const Figures noisy = Measure(this->Noisy, this->Clean);
  EXPECT_NEAR(noisy.MeanAngle, 17.849, 1e-3);
  EXPECT_NEAR(noisy.Volume, 0.99481, 1e-5);
  EXPECT_EQ(noisy.FeatureEdges, 80u);
  EXPECT_EQ(Measure(this->Clean, this->Clean).FeatureEdges, 96u);
}

TEST_F(NoisyCube, VertexSchemes)
{
  MeshDenoisingSettings settings;
  settings.Vertices.Scheme = VertexScheme::AreaWeighted;
  EXPECT_NEAR(this->Denoise(this->Noisy, settings).MeanAngle, 1.830, 5e-4);
  settings.Vertices.Scheme = VertexScheme::ConstantStep;
  EXPECT_NEAR(this->Denoise(this->Noisy, settings).MeanAngle, 2.026, 5e-4);
}

// One engine, eleven estimators: an exact cut-off preserves edges, a monotone influence rounds
// them.
TEST_F(NoisyCube, EveryNorm)
{
  const struct
  {
    NormId Norm;
    double Scale;
    double MeanAngle;
    std::size_t FeatureEdges;
    double Volume;
    double CleanAngle; ///< what is left of the clean cube
  } rows[] = {
    { NormId::L2, 1.0, 29.678, 0, 1.05824, 29.811 },
    { NormId::TruncatedL2, 0.7, 1.887, 97, 0.99243, 0.0 },
    { NormId::L1, 0.05, 8.577, 9, 1.01654, 5.137 },
    { NormId::TruncatedL1, 0.7, 2.284, 97, 0.99332, 0.0 },
    { NormId::Huber, 0.2, 24.684, 3, 1.03971, 24.532 },
    { NormId::Lorentzian, 0.2, 7.577, 32, 1.01634, 6.330 },
    { NormId::Gaussian, 0.35, 1.943, 97, 0.99276, 0.036 },
    { NormId::Tukey, 0.8, 1.969, 98, 0.99231, 0.0 },
    { NormId::Tukey, 0.5, 5.086, 91, 0.99406, 0.0 },
    { NormId::Box, 0.7, 13.234, 0, 1.02685, 11.928 },
    { NormId::Centin, 0.2, 4.886, 92, 1.00897, 3.993 },
  };
  for (const auto& row : rows)
  {
    MeshDenoisingSettings settings;
    settings.Norm = row.Norm;
    settings.NormScale = row.Scale;
    settings.IncludeOwn = true;
    settings.VertexIterations = 20;
    const Figures figures = this->Denoise(this->Noisy, settings);
    const char* name = NameOf(MakeErrorNorm(row.Norm, row.Scale));
    EXPECT_NEAR(figures.MeanAngle, row.MeanAngle, 6e-4) << name;
    EXPECT_NEAR(figures.Volume, row.Volume, 6e-6) << name;
    EXPECT_EQ(figures.FeatureEdges, row.FeatureEdges) << name;
    const double rounding = row.CleanAngle > 0.0 ? 6e-4 : 1e-12;
    EXPECT_NEAR(this->Denoise(this->Clean, settings).MeanAngle, row.CleanAngle, rounding) << name;
  }
}

TEST_F(NoisyCube, ScaleFromTheData)
{
  const std::pair<ScaleEstimator, double> rows[] = {
    { ScaleEstimator::MedianAbsoluteDeviation, 0.2825 }, { ScaleEstimator::Rayleigh, 0.2532 }
  };
  for (const auto& row : rows)
  {
    MeshDenoisingSettings settings;
    settings.NormScale = 0.0;
    settings.Estimator = row.first;
    TriangleMesh mesh = this->Noisy;
    Buffer<Vec3> normals;
    MeshDenoisingReport report;
    Execution serial;
    DenoiseMesh(mesh, normals, settings, report, serial);
    // The other program takes the upper one of two middle values for the median.
    EXPECT_NEAR(report.NormScale, row.second, 5e-4);
  }
}
