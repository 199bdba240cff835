// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PointMethods.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// The Gaussian exp(-x^2 / s^2) of some papers is exp(-x^2 / (2 sigma^2)) with this sigma.
double SigmaOf(double s) { return s / std::sqrt(2.0); }

PointDenoisingSettings Nearest(int count, int outerIterations)
{
  PointDenoisingSettings s;
  s.Neighborhood.Count = count;
  s.OuterIterations = outerIterations;
  return s;
}

PointDenoisingSettings Ball(double radius, int outerIterations)
{
  PointDenoisingSettings s;
  s.Neighborhood.Kind = PointNeighborhood::Radius;
  s.Neighborhood.Radius = radius;
  s.OuterIterations = outerIterations;
  return s;
}

/// Normals to start with from 24 instead of 16.
/// With noise of half a spacing, fits of 16 points lose edges, and what follows cannot find them.
PointDenoisingSettings WithSteadyNormals(PointDenoisingSettings s)
{
  s.Normals.NumberOfNeighbors = 24;
  return s;
}

PointDenoisingSettings RobustImplicitMLS()
{
  PointDenoisingSettings s;
  s.Operator = RobustImplicitMLSSettings();
  return s;
}

PointDenoisingSettings MovingRobustPCA()
{
  PointDenoisingSettings s = Nearest(30, 5);
  s.Operator = MovingRobustPCASettings();
  return s;
}

PointDenoisingSettings FeatureAwarePoint()
{
  PointDenoisingSettings s = Nearest(20, 3);
  s.Operator = LikelihoodPointsSettings();
  return s;
}

PointDenoisingSettings GuidedPointNormal()
{
  PointDenoisingSettings s = WithSteadyNormals(Nearest(30, 1));
  s.MaximumDisplacement = 2.0;
  s.Operator = NormalBundlesSettings();
  return s;
}

PointDenoisingSettings TensorPoint()
{
  PointDenoisingSettings s = Ball(4.0, 3);
  s.Neighborhood.MaximumCount = 40;
  s.Operator = TensorRegionsSettings();
  return s;
}

/// The radius holds about 30 points of a surface.
PointDenoisingSettings BilateralPoint()
{
  PointDenoisingSettings s = Ball(3.0, 1);
  TwoStageSettings t;
  t.Operator = PointNormalOperator::PlaneFit;
  t.Normals.Norm = NormId::L2;
  t.Normals.SpatialScale = 1.0;
  t.NormalIterations = 1;
  t.Points.Argument = NormalArgument::Height;
  t.Points.NormScale = 1.0;
  t.Points.SpatialScale = 1.0;
  t.Update.Scheme = PointScheme::OwnHeight;
  t.PointIterations = 1;
  s.Operator = t;
  return s;
}

PointDenoisingSettings RollingPointNormal()
{
  PointDenoisingSettings s = WithSteadyNormals(Nearest(30, 1));
  TwoStageSettings t;
  t.Guidance = PointGuidance::Rolling;
  t.Data = PointNormalData::Original;
  t.Normals.NormScale = t.Points.NormScale = SigmaOf(0.35);
  t.Normals.SpatialScale = t.Points.SpatialScale = SigmaOf(1.55); // half the distance of the 30th
  t.Points.IncludeOwn = false;
  t.NormalIterations = 4;
  s.Operator = t;
  return s;
}

/// Smaller balls than in the paper, which make facets of curved surfaces, fewer but longer steps,
/// balanced heights, which do not shrink them, and a wider angle for noisy normals.
PointDenoisingSettings VotingTensorPoint()
{
  PointDenoisingSettings s = WithSteadyNormals(Ball(3.0, 8));
  s.RenewNeighborhood = false;
  s.MaximumDisplacement = 1.5;
  VotingTensorPointsSettings v;
  v.AngleThreshold = std::acos(0.8);
  v.Step = 0.3;
  v.FlatScheme = PointScheme::BalancedHeight;
  s.Operator = v;
  return s;
}

PointDenoisingSettings MovingLeastSquares()
{
  PointDenoisingSettings s = Nearest(30, 1);
  MovingLeastSquaresSettings m;
  m.PlaneRounds = 1; // five take twice as long and round edges a little more
  s.Operator = m;
  return s;
}

}

const std::vector<PointMethodRow>& PointMethods()
{
  static const std::vector<PointMethodRow> rows = {
    { PointMethod::RobustImplicitMLS, "Robust Implicit MLS", "Oztireli, Guennebaud, Gross 2009",
      "RobustImplicitMLSFilter", false, RobustImplicitMLS() },
    { PointMethod::MovingRobustPCA, "Moving Robust PCA", "Mattei, Castrodad 2017",
      "MovingRobustPCAFilter", false, MovingRobustPCA() },
    { PointMethod::FeatureAwarePoint, "Feature Aware Point", "Li 2009", "FeatureAwarePointFilter",
      false, FeatureAwarePoint() },
    { PointMethod::GuidedPointNormal, "Guided Point Normal", "Zheng, Li, Wu, Liu, Gao 2017",
      "GuidedPointNormalFilter", false, GuidedPointNormal() },
    { PointMethod::TensorPoint, "Tensor Point", "Park, Lee, Jang, Lee, Lee 2013",
      "TensorPointFilter", false, TensorPoint() },
    { PointMethod::BilateralPoint, "Bilateral Point", "Digne, de Franchis 2017",
      "BilateralPointFilter", true, BilateralPoint() },
    { PointMethod::RollingPointNormal, "Rolling Point Normal", "Zheng, Li, Xu, Wu, Nie 2018",
      "RollingPointNormalFilter", true, RollingPointNormal() },
    { PointMethod::VotingTensorPoint, "Voting Tensor Point",
      "Yadav, Reitebuch, Skrodzki, Zimmermann, Polthier 2018", "VotingTensorPointFilter", false,
      VotingTensorPoint() },
    { PointMethod::MovingLeastSquares, "Moving Least Squares",
      "Alexa, Behr, Cohen-Or, Fleishman, Levin, Silva 2003", "MovingLeastSquaresFilter", false,
      MovingLeastSquares() },
  };
  return rows;
}

const PointDenoisingSettings& ComposedPoints()
{
  static const PointDenoisingSettings settings = []
  {
    PointDenoisingSettings s = WithSteadyNormals(Nearest(16, 1));
    TwoStageSettings t;
    t.Normals.NormScale = t.Points.NormScale = 0.2;
    t.Points.IncludeOwn = false;
    t.NormalIterations = 2;
    t.PointIterations = 5;
    s.Operator = t;
    return s;
  }();
  return settings;
}

}
