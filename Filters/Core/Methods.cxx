// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Methods.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// The Gaussian exp(-x^2 / s^2) of some papers is exp(-x^2 / (2 sigma^2)) with this sigma.
double SigmaOf(double s) { return s / std::sqrt(2.0); }

double Radians(double degrees) { return degrees * (3.14159265358979323846 / 180.0); }

void Schedule(MeshDenoisingSettings& s, int outer, int normal, int vertex)
{
  s.OuterIterations = outer;
  s.NormalIterations = normal;
  s.VertexIterations = vertex;
}

/// What most methods before the bilateral filter have in common: all faces around, the face itself
/// among them, no spatial kernel.
MeshDenoisingSettings Plain()
{
  MeshDenoisingSettings s;
  s.SpatialScale = 0.0;
  s.IncludeOwn = true;
  return s;
}

MeshDenoisingSettings NormalDiffusion()
{
  MeshDenoisingSettings s = Plain();
  s.Neighborhood = FaceNeighborhood::EdgeAdjacent;
  s.Argument = NormalArgument::DirectionalCurvature;
  s.NormScale = SigmaOf(Radians(35.0));
  s.Vertices.Scheme = VertexScheme::IntegralFit;
  Schedule(s, 10, 1, 20);
  return s;
}

MeshDenoisingSettings MeanNormal()
{
  MeshDenoisingSettings s = Plain();
  s.Norm = NormId::L2;
  s.Vertices.Scheme = VertexScheme::AreaWeighted;
  Schedule(s, 10, 1, 1);
  return s;
}

MeshDenoisingSettings MedianNormal(int edgeRepetitions)
{
  MeshDenoisingSettings s = MeanNormal();
  s.Operator = NormalOperator::Median;
  s.Repetitions.EdgeAdjacent = edgeRepetitions;
  return s;
}

MeshDenoisingSettings HuberNormal()
{
  MeshDenoisingSettings s = Plain();
  s.Norm = NormId::Huber;
  s.NormScale = 0.1;
  Schedule(s, 1, 5, 20);
  return s;
}

MeshDenoisingSettings NormalVotingTensor()
{
  MeshDenoisingSettings s = Plain();
  s.Neighborhood = FaceNeighborhood::Radius;
  s.Norm = NormId::Box;
  s.Argument = NormalArgument::Angle;
  s.NormScale = Radians(46.0);
  s.Operator = NormalOperator::VotingTensor;
  Schedule(s, 60, 1, 1);
  return s;
}

MeshDenoisingSettings FuzzyVectorMedian()
{
  MeshDenoisingSettings s = Plain();
  s.Guidance = NormalGuidance::Median;
  s.NormScale = SigmaOf(0.35);
  s.Weighting = SiteWeight::Uniform;
  Schedule(s, 10, 1, 10);
  return s;
}

MeshDenoisingSettings CurvatureNormalDiffusion()
{
  MeshDenoisingSettings s = Plain();
  s.Neighborhood = FaceNeighborhood::EdgeAdjacent;
  s.Argument = NormalArgument::NormalGradient;
  s.NormScale = SigmaOf(0.5);
  s.Weighting = SiteWeight::Coupling;
  s.IncludeOwn = false;
  s.Operator = NormalOperator::Diffusion;
  s.TangentialFlux = true;
  s.Vertices.Scheme = VertexScheme::IntegralFit;
  Schedule(s, 8, 25, 20);
  return s;
}

MeshDenoisingSettings GeometricFidelity()
{
  MeshDenoisingSettings s = Plain();
  s.Norm = NormId::Centin;
  s.Argument = NormalArgument::SiteCurvature;
  s.Unit = CurvatureUnit::EdgeLength;
  s.NormScale = 0.1;
  s.IncludeOwn = false;
  s.Operator = NormalOperator::Diffusion;
  s.Vertices.MaximumDisplacement = 1.0;
  Schedule(s, 20, 1, 5);
  return s;
}

MeshDenoisingSettings GlobalBilateralNormal()
{
  MeshDenoisingSettings s;
  s.Operator = NormalOperator::GlobalSolve;
  Schedule(s, 1, 1, 10);
  return s;
}

MeshDenoisingSettings GuidedNormal()
{
  MeshDenoisingSettings s;
  s.Neighborhood = FaceNeighborhood::Radius;
  s.RenewNeighborhood = false;
  s.IncludeOwn = true;
  s.Guidance = NormalGuidance::Patch;
  Schedule(s, 20, 1, 10);
  return s;
}

MeshDenoisingSettings TukeyBilateralNormal()
{
  MeshDenoisingSettings s;
  s.Neighborhood = FaceNeighborhood::EdgeRadius;
  s.Norm = NormId::Tukey;
  s.LocalSpatialScale = true;
  s.Vertices.Scheme = VertexScheme::EdgeWeighted;
  Schedule(s, 100, 1, 1);
  return s;
}

MeshDenoisingSettings ThresholdedCosine()
{
  MeshDenoisingSettings s = Plain();
  s.Norm = NormId::Tukey;
  s.NormScale = 1.0; // sqrt(2 (1 - T)) with T = 0.5
  s.Weighting = SiteWeight::Uniform;
  Schedule(s, 1, 20, 50);
  return s;
}

}

const std::vector<MethodRow>& Methods()
{
  static const std::vector<MethodRow> rows = {
    { Method::NormalDiffusion, "Normal Diffusion", "Belyaev, Ohtake 2001", "NormalDiffusionFilter",
      true, true, NormalDiffusion() },
    { Method::MeanNormal, "Mean Normal", "Yagou, Ohtake, Belyaev 2002", "MeanNormalFilter", true,
      true, MeanNormal() },
    { Method::MedianNormal, "Median Normal", "Yagou, Ohtake, Belyaev 2002", "MedianNormalFilter",
      true, false, MedianNormal(1) },
    { Method::WeightedMedianNormal, "Weighted Median Normal", "Yagou, Belyaev, Wei 2002",
      "MedianNormalFilter", true, false, MedianNormal(2) },
    { Method::HuberNormal, "Huber Normal", "Huber 1981", "HuberNormalFilter", true, true,
      HuberNormal() },
    { Method::NormalVotingTensor, "Normal Voting Tensor", "Yadav, Reitebuch, Polthier 2017",
      "NormalVotingTensorFilter", true, false, NormalVotingTensor() },
    { Method::FuzzyVectorMedian, "Fuzzy Vector Median", "Shen, Barner 2004",
      "FuzzyVectorMedianNormalFilter", true, true, FuzzyVectorMedian() },
    { Method::CurvatureNormalDiffusion, "Curvature Normal Diffusion",
      "Tasdizen, Whitaker, Burchard, Osher 2002", "CurvatureNormalDiffusionFilter", true, true,
      CurvatureNormalDiffusion() },
    { Method::GeometricFidelity, "Geometric Fidelity", "Centin, Signoroni 2018",
      "GeometricFidelityNormalFilter", true, true, GeometricFidelity() },
    { Method::BilateralNormal, "Bilateral Normal", "Zheng, Fu, Au, Tai 2011",
      "BilateralNormalFilter", true, true, MeshDenoisingSettings() },
    { Method::GlobalBilateralNormal, "Global Bilateral Normal", "Zheng, Fu, Au, Tai 2011",
      "BilateralNormalFilter", true, true, GlobalBilateralNormal() },
    { Method::GuidedNormal, "Guided Normal", "Zhang, Deng, Zhang, Bouaziz, Liu 2015",
      "GuidedNormalFilter", true, true, GuidedNormal() },
    { Method::TukeyBilateralNormal, "Tukey Bilateral Normal", "Yadav, Reitebuch, Polthier 2018",
      "TukeyBilateralNormalFilter", true, true, TukeyBilateralNormal() },
    { Method::ThresholdedCosine, "Thresholded Cosine", "Sun, Rosin, Martin, Langbein 2007",
      "RobustNormalFilter", true, true, ThresholdedCosine() },
    { Method::MeanCurvatureFlow, "Mean Curvature Flow", "Desbrun, Meyer, Schroeder, Barr 1999",
      "MeanCurvatureFlowFilter", false, false, MeshDenoisingSettings() },
    { Method::AnisotropicMeanCurvature, "Anisotropic Mean Curvature", "Hildebrandt, Polthier 2004",
      "AnisotropicMeanCurvatureFilter", false, false, MeshDenoisingSettings() },
    { Method::BilateralVertex, "Bilateral Vertex", "Fleishman, Drori, Cohen-Or 2003",
      "BilateralVertexFilter", false, false, MeshDenoisingSettings() },
    { Method::NonIterativeBilateral, "Non Iterative Bilateral", "Jones, Durand, Desbrun 2003",
      "NonIterativeBilateralFilter", false, false, MeshDenoisingSettings() },
  };
  return rows;
}

}
