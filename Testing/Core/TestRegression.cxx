// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Whole methods on a noisy cube, against the figures of an independent program.

#include "MeshDenoising.h"
#include "Metrics.h"
#include "RandomMeshes.h"

#include <gtest/gtest.h>

using namespace SurfaceDenoising;

namespace
{

struct Figures
{
  double MeanAngle = 0.0; ///< between the normals of the faces and those of the clean cube, degrees
  double Volume = 0.0;
  std::size_t FeatureEdges = 0; ///< sharper than 70 degrees
};

Figures Measure(const TriangleMesh& mesh, const TriangleMesh& reference)
{
  Execution serial;
  FaceGeometry geometry;
  FaceGeometry clean;
  ComputeFaceGeometry(mesh, 1.0, geometry, serial);
  ComputeFaceGeometry(reference, 1.0, clean, serial);
  Figures figures;
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    figures.MeanAngle +=
      AngleBetween(geometry.Normals[f], clean.Normals[f]) / double(mesh.NumberOfFaces());
  }
  figures.Volume = SignedVolume(mesh, serial);
  const NeighborGraph edges = EdgeAdjacentFaces(mesh, VertexStars(mesh), serial);
  figures.FeatureEdges =
    CompareFeatureEdges(edges, geometry.Normals, geometry.Normals, 70.0, serial).Reference;
  return figures;
}

class NoisyCube : public testing::Test
{
protected:
  NoisyCube() { AddNormalNoise(this->Noisy, 0.2, 12345); }

  Figures Denoise(const TriangleMesh& mesh, const MeshDenoisingSettings& settings) const
  {
    TriangleMesh result = mesh;
    Buffer<Vec3> normals;
    MeshDenoisingReport report;
    Execution serial;
    EXPECT_TRUE(DenoiseMesh(result, normals, settings, report, serial));
    return Measure(result, this->Clean);
  }

  TriangleMesh Clean = Cube(8);
  TriangleMesh Noisy = this->Clean;
};

}

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

TEST_F(NoisyCube, BilateralFilter)
{
  const MeshDenoisingSettings settings; // Zheng et al. is the default
  const Figures figures = this->Denoise(this->Noisy, settings);
  EXPECT_NEAR(figures.MeanAngle, 2.017, 5e-4);
  EXPECT_NEAR(figures.Volume, 0.99375, 5e-6);
  EXPECT_EQ(figures.FeatureEdges, 97u);

  TriangleMesh random = this->Clean;
  AddDirectionNoise(random, 0.3, 12345);
  EXPECT_NEAR(Measure(random, this->Clean).MeanAngle, 20.089, 5e-4);
  EXPECT_NEAR(this->Denoise(random, settings).MeanAngle, 2.991, 5e-4);
}

TEST_F(NoisyCube, VertexSchemes)
{
  MeshDenoisingSettings settings;
  settings.Vertices.Scheme = VertexScheme::AreaWeighted;
  EXPECT_NEAR(this->Denoise(this->Noisy, settings).MeanAngle, 1.830, 5e-4);
  settings.Vertices.Scheme = VertexScheme::ConstantStep;
  EXPECT_NEAR(this->Denoise(this->Noisy, settings).MeanAngle, 2.026, 5e-4);
}

// Sun et al., but with areas.
TEST_F(NoisyCube, ThresholdedCosine)
{
  MeshDenoisingSettings settings;
  settings.Norm = NormId::Tukey;
  settings.NormScale = 1.0; // T = 0.5
  settings.SpatialScale = 0.0;
  settings.IncludeOwn = true;
  settings.VertexIterations = 50;
  const Figures figures = this->Denoise(this->Noisy, settings);
  EXPECT_NEAR(figures.MeanAngle, 1.411, 5e-4);
  EXPECT_NEAR(figures.Volume, 0.99032, 5e-6);
  EXPECT_EQ(figures.FeatureEdges, 97u);
}

TEST_F(NoisyCube, MeanFilter)
{
  MeshDenoisingSettings settings;
  settings.Norm = NormId::L2;
  settings.SpatialScale = 0.0;
  settings.IncludeOwn = true;
  settings.OuterIterations = 10;
  settings.NormalIterations = 1;
  settings.VertexIterations = 1;
  settings.Vertices.Scheme = VertexScheme::AreaWeighted;
  const Figures figures = this->Denoise(this->Noisy, settings);
  EXPECT_NEAR(figures.MeanAngle, 14.013, 5e-4);
  EXPECT_NEAR(figures.Volume, 1.00424, 5e-6);
  EXPECT_EQ(figures.FeatureEdges, 2u);
}

TEST_F(NoisyCube, HuberFilter)
{
  MeshDenoisingSettings settings;
  settings.Norm = NormId::Huber;
  settings.NormScale = 0.1;
  settings.SpatialScale = 0.0;
  settings.IncludeOwn = true;
  settings.NormalIterations = 5;
  settings.VertexIterations = 20;
  const Figures figures = this->Denoise(this->Noisy, settings);
  EXPECT_NEAR(figures.MeanAngle, 5.840, 5e-4);
  EXPECT_NEAR(figures.Volume, 1.00969, 5e-6);
  EXPECT_EQ(figures.FeatureEdges, 62u);
}

TEST_F(NoisyCube, BelyaevOhtake)
{
  MeshDenoisingSettings settings;
  settings.Neighborhood = FaceNeighborhood::EdgeAdjacent;
  settings.NormScale = 0.6 / std::sqrt(2.0);
  settings.Argument = NormalArgument::DirectionalCurvature;
  settings.SpatialScale = 0.0;
  settings.IncludeOwn = true;
  settings.OuterIterations = 10;
  settings.NormalIterations = 1;
  settings.VertexIterations = 20;
  settings.Vertices.Scheme = VertexScheme::IntegralFit;
  const Figures figures = this->Denoise(this->Noisy, settings);
  EXPECT_NEAR(figures.MeanAngle, 3.609, 0.02 * 3.609);
  EXPECT_NEAR(figures.Volume, 0.99175, 1e-3);
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
