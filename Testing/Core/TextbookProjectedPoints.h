// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file TextbookProjectedPoints.h
 * @brief Moving least squares and its robust implicit form as a textbook would print them.
 *
 * Shares no code with the core: all points are looked at for every point, distances are sorted,
 * least squares are solved by a decomposition with pivots.
 */

#ifndef TextbookProjectedPoints_h
#define TextbookProjectedPoints_h

#include <Eigen/Core>

#include <vector>

namespace Textbook
{

using Point = Eigen::Vector3d;

struct Cloud
{
  std::vector<Point> Points;
  std::vector<Point> Normals; ///< unit vectors
};

/// One projection of all points with their nearest neighbours; h = 0: half the distance of the
/// last neighbour.
Cloud MovingLeastSquares(const Cloud& cloud, int neighbors, double h, int degree, int planeRounds);

struct ImplicitParameters
{
  double FilterScale = 3.0;
  double SigmaN = 0.75;
  double SigmaR = 0.5; ///< 0: residuals do not count
  int Fits = 3;
  int Projections = 15;
  bool Unoriented = false;
};

/// One projection of all points. rho_j is 2 r_16(j) / sqrt(16) of the cloud given as spacings.
Cloud RobustImplicit(const Cloud& cloud, const std::vector<Point>& spacings,
  const ImplicitParameters& parameters);

}

#endif
