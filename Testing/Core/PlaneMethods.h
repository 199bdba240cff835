// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PlaneMethods.h
 * @brief Moving robust PCA, tensor regions and likelihoods with several settings, each with its
 * textbook version, and clouds to run them on.
 */

#ifndef PlaneMethods_h
#define PlaneMethods_h

#include "NoisyClouds.h"
#include "Points/PointDenoising.h"
#include "TextbookPlanePoints.h"

#include <functional>
#include <string>

using namespace SurfaceDenoising;

/// A method, and the same by the textbook.
struct PlaneMethod
{
  std::string Name;
  std::function<std::unique_ptr<PointOperator>()> Make;
  std::function<std::vector<int>(PlaneTextbook::Cloud&, const PlaneTextbook::Rows&)> Textbook;
  double Radius; ///< of the neighbourhood, in spacings; 0: the nearest points
  int Count;
};

inline PlaneMethod PCA(const std::string& name, const MovingRobustPCASettings& s)
{
  return { name, [s] { return MakeMovingRobustPCA(s); },
    [s](PlaneTextbook::Cloud& cloud, const PlaneTextbook::Rows& rows)
    {
      PlaneTextbook::MovingRobustPCA(cloud, rows,
        { s.NormalAngle, s.Rounds, s.Regularization, s.Fidelity });
      return std::vector<int>();
    },
    0.0, 20 };
}

inline PlaneMethod Regions(const std::string& name, const TensorRegionsSettings& s)
{
  return { name, [s] { return MakeTensorRegions(s); },
    [s](PlaneTextbook::Cloud& cloud, const PlaneTextbook::Rows& rows)
    {
      return PlaneTextbook::TensorRegions(cloud, rows,
        { s.Range, s.BendFactor, s.FeatureThreshold, s.FeatureContrast, s.RegionThreshold,
          static_cast<std::size_t>(s.LeastMembers), s.QuadricAtFeatures });
    },
    3.5, 25 };
}

inline PlaneMethod Likelihood(const std::string& name, const LikelihoodPointsSettings& s)
{
  const double share = s.Scheme == PointScheme::OwnHeight ? 1.0
    : s.Scheme == PointScheme::NeighborHeight             ? 0.0
                                                          : 0.5;
  return { name, [s] { return MakeLikelihoodPoints(s); },
    [s, share](PlaneTextbook::Cloud& cloud, const PlaneTextbook::Rows& rows)
    {
      PlaneTextbook::Likelihoods(cloud, rows,
        { s.FeatureSharpening, s.LeastAngle, s.LikelihoodInNormals, share, s.Radius });
      return std::vector<int>();
    },
    s.Radius, 16 };
}

inline std::vector<PlaneMethod> PlaneMethods()
{
  LikelihoodPointsSettings ball;
  ball.Radius = 3.0;
  ball.Scheme = PointScheme::OwnHeight;
  ball.LikelihoodInNormals = true;
  LikelihoodPointsSettings sharp;
  sharp.FeatureSharpening = 0.9;
  sharp.LeastAngle = 0.3;
  sharp.Scheme = PointScheme::NeighborHeight;
  TensorRegionsSettings other;
  other.Range = 3.0;
  other.BendFactor = 5.0;
  other.FeatureThreshold = 0.05;
  other.FeatureContrast = 0.0;
  other.RegionThreshold = 0.8;
  other.LeastMembers = 7;
  other.QuadricAtFeatures = true;
  return { PCA("PCA", MovingRobustPCASettings()),
    PCA("NarrowPCA", { 0.1, 4, 0.05, 0.5 }), // many uniform patches
    Regions("Regions", TensorRegionsSettings()), Regions("OtherRegions", other),
    Likelihood("Likelihood", LikelihoodPointsSettings()), Likelihood("BallLikelihood", ball),
    Likelihood("SharpLikelihood", sharp) };
}

inline NeighborGraph Neighbors(const PlaneMethod& method, const PointSet& points)
{
  Execution serial;
  return method.Radius > 0.0
    ? PointsWithinRadius(points.Positions, method.Radius * points.Spacing, method.Count, serial)
    : NearestPoints(points.Positions, method.Count, serial);
}

inline void RenewNeighbors(const PlaneMethod& method, PointSet& points, PointOperator& filter)
{
  Execution serial;
  points.Neighbors = Neighbors(method, points);
  filter.Renew(points, serial);
}

/// A cloud with normals of plane fits and random signs, ready for an operator.
inline PointSet Prepare(Buffer<Vec3> positions, double spacing, bool localScale = false)
{
  Execution serial;
  std::mt19937 random(9);
  PointSet points;
  const NeighborGraph nearest = NearestPoints(positions, 16, serial);
  points.Normals = PlaneFitNormals(positions, nearest, 16, serial);
  for (Vec3& n : points.Normals)
  {
    n = random() % 2 == 0 ? n : Vec3(-n);
  }
  points.Spacing = spacing;
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    points.Spacings.push_back(
      localScale ? spacing * (0.8 + 0.4 * static_cast<double>(random() % 1000) / 1000.0) : spacing);
  }
  points.LocalScale = localScale;
  points.Start = points.Positions = std::move(positions);
  points.Status.assign(points.Size(), PointStatus::Filtered);
  return points;
}

struct Shape
{
  std::string Name;
  Buffer<Vec3> Positions;
  double Spacing;
};

inline std::vector<Shape> Shapes()
{
  std::vector<Shape> shapes = { { "Sphere", SphereCloud(500).Positions, 0.16 },
    { "Cube", CubeCloud(9).Positions, 2.0 / 9.0 }, { "Wedge", WedgeCloud(20, 12).Positions, 1.0 } };
  unsigned seed = 1;
  for (Shape& shape : shapes)
  {
    AddNoise(shape.Positions, 0.2 * shape.Spacing, seed++);
  }
  return shapes;
}

#endif
