// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file TextbookTwoStagePoints.h
 * @brief Filters of point normals and point updates as a textbook would print them.
 *
 * Shares no code with the core: all points are looked at for every point, and distances are sorted.
 */

#ifndef TextbookTwoStagePoints_h
#define TextbookTwoStagePoints_h

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace TextbookPoints
{

using Vector = Eigen::Vector3d;

struct Cloud
{
  std::vector<Vector> Points;
  std::vector<Vector> Normals;
};

/// The numbers of the nearest other points.
std::vector<std::vector<int>> Nearest(const std::vector<Vector>& points, int count);

/// Median over the points of r sqrt(pi / 16) with the distance r of the 16th nearest.
double Spacing(const std::vector<Vector>& points);

enum class Measure
{
  Chord,
  Angle,
  Curvature,
  Gradient,
  Height
};

enum class Step
{
  Own,
  Neighbor,
  Balanced,
  Gradient,
  Quadric
};

struct Stage
{
  std::function<double(double)> Weight; ///< g(x)
  Measure Argument = Measure::Chord;
  double SpatialSigma = 0.0; ///< of exp(-d^2 / (2 sigma^2)), a length
  bool Own = true;
};

/// x_ij of the points at p and q with the normals m and n; curvatures are per distance.
double Difference(Measure measure, double distance, const Vector& p, const Vector& m,
  const Vector& q, Vector n, bool unoriented);

/// Averages the normals iterations times; with rolling guidance, the data are those at the start.
void FilterNormals(Cloud& cloud, const std::vector<std::vector<int>>& neighbors, const Stage& stage,
  int iterations, bool rolling, bool original, bool unoriented);

/// The normals of planes fitted to the weighted points.
void FitNormals(Cloud& cloud, const std::vector<std::vector<int>>& neighbors, const Stage& stage);

/// Moves the points iterations times, with the distances of the start.
void MovePoints(Cloud& cloud, const std::vector<std::vector<int>>& neighbors, const Stage& stage,
  Step step, double length, double cut, int iterations, bool unoriented);

}

#endif
