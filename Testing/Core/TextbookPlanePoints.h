// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file TextbookPlanePoints.h
 * @brief Moving robust PCA, Park's regions and Li's likelihoods in plain loops.
 *
 * No code is shared with the core: angles by atan2, eigenvectors by Eigen's iteration, neighbours
 * by sorting all distances, sums in the order of the formulas. Each function is one outer
 * iteration.
 */

#ifndef TextbookPlanePoints_h
#define TextbookPlanePoints_h

#include <Eigen/Core>

#include <vector>

namespace PlaneTextbook
{

using Vector = Eigen::Vector3d;
using Vectors = std::vector<Vector>;
using Rows = std::vector<std::vector<int>>;

struct Cloud
{
  Vectors Points;
  Vectors Normals;
  std::vector<double> Spacings; ///< what lengths are relative to at a point
};

/// The k nearest other points of each, nearest first, equally distant ones by number.
Rows Nearest(const Vectors& points, std::size_t k);

/// The points at most radius away, nearest first, at most limit.
Rows Ball(const Vectors& points, double radius, std::size_t limit);

struct Plane
{
  Vector Centre;
  Vector Normal;
};

Plane FitPlane(const Vectors& points, const std::vector<double>& weights);

Plane FitRobustPlane(const Vectors& points, const std::vector<double>& weights, double epsilon,
  int rounds);

struct RobustPCA
{
  double Sigma;
  int Rounds;
  double Epsilon; ///< in spacings
  double Lambda;
};

void MovingRobustPCA(Cloud& cloud, const Rows& rows, const RobustPCA& settings);

/// exp(-(s^2 + c kappa^2) / sigma^2) between points at the distance d with normals n and m.
double ArcWeight(double d, const Vector& n, const Vector& m, double c, double sigma);

struct Park
{
  double Sigma; ///< in spacings
  double C;     ///< over the fourth power of the spacing
  double FeatureThreshold;
  double FeatureContrast;
  double RegionThreshold;
  std::size_t LeastMembers;
  bool Quadric;
};

/// Returns the classes: 0 flat, 1 edge, 2 corner.
std::vector<int> TensorRegions(Cloud& cloud, const Rows& rows, const Park& settings);

struct Li
{
  double Beta;
  double LeastAngle;
  bool LikelihoodInNormals;
  double OwnShare;     ///< of own heights: 1 own, 0 those of neighbours, 0.5 balanced
  double Radius = 0.0; ///< in spacings; 0: the distance of the last neighbour
};

void Likelihoods(Cloud& cloud, const Rows& rows, const Li& settings);

}

#endif
