// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file TextbookVotingPoints.h
 * @brief Voting tensors on point sets in plain loops.
 *
 * No code is shared with the core: cosines are compared instead of angles, covariances are summed
 * about their centre, cross-sections of edges have two coordinates.
 */

#ifndef TextbookVotingPoints_h
#define TextbookVotingPoints_h

#include <Eigen/Core>

#include <vector>

namespace VotingTextbook
{

using Vector = Eigen::Vector3d;
using Vectors = std::vector<Vector>;

struct Cloud
{
  Vectors Points;
  Vectors Normals;
  Vectors Start;                ///< what displacements are limited from
  std::vector<double> Spacings; ///< what lengths are relative to at a point
};

struct Parameters
{
  double Cosine = 0.9;
  double Tau = 0.25;
  double Damping = 3.0;
  double Alpha = 0.1;
  double SigmaN = 0.35;
  double SigmaD = 1.5; ///< in spacings
  bool Balanced = false;
  double Cut = 0.05;
  double SigmaP = 0.7; ///< of the distance from planes, in spacings; 0: every plane counts alike
  bool Unoriented = false;
  double Limit = 0.0;   ///< a length
  bool InPlace = false; ///< points move one after the other
};

/// One iteration. Returns the classes: 0 flat, 1 edge, 2 corner, -1 similar to no other.
std::vector<int> Iterate(Cloud& cloud, const std::vector<std::vector<int>>& rows,
  const Parameters& parameters);

}

#endif
