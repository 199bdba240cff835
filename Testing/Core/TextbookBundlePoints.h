// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file TextbookBundlePoints.h
 * @brief Bundles of normals at features, in plain loops from their formulas.
 */

#ifndef TextbookBundlePoints_h
#define TextbookBundlePoints_h

#include <Eigen/Core>

#include <vector>

namespace TextbookBundles
{

using Point = Eigen::Vector3d;

/// Lengths are absolute. Gaussians are exp(-(x / sigma)^2).
struct Parameters
{
  double CandidateScale = 0.3;
  double CandidateThreshold = 0.6;
  double SkeletonRadius = 0.0; ///< 0: none
  double BundleAngle = 0.4363323129985824;
  double BundleSeparation = 4.0; ///< 0: any
  int MaximumBundles = 3;
  double BundleReach = 0.75; ///< 0: any
  double RangeScale = 0.35;
  double SpatialScale = 1.5;
  int PatchNeighbors = 6;
  double PatchAgreement = 0.9;
  double PatchMemberAgreement = 0.9;
  int NormalIterations = 5;
  int PointIterations = 10;
  double FeaturePull = 0.1;
  bool Unoriented = false;
  double MaximumDisplacement = 0.0;
};

struct Cloud
{
  std::vector<Point> Start;
  std::vector<Point> Positions;
  std::vector<Point> Normals; ///< that an iteration starts from
  std::vector<std::vector<int>> Neighbors;
  std::vector<std::vector<Point>> Bundles;
  std::vector<Point> Means; ///< of bundles
};

double Score(const Cloud& cloud, int i, double sigma);

/// The clusters of unit vectors, as lists of their numbers.
std::vector<std::vector<int>> Clusters(const std::vector<Point>& normals, const Point& side,
  const Parameters& parameters);

/// Last places of the skeleton of a cloud after 30 steps.
std::vector<Point> Skeleton(const std::vector<Point>& cloud, double h);

/// One iteration of the whole method: new positions, bundles, means, and normals to start the next
/// one from.
void Denoise(Cloud& cloud, const Parameters& parameters);

}

#endif
