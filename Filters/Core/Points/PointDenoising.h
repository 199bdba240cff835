// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PointDenoising.h
 * @brief The way of a point set through a method: neighbours, normals, signs, outer iterations.
 *
 * Lengths are relative to the cloud, in mean spacings (PointSet.h), so that the same settings serve
 * a ring and a cathedral.
 */

#ifndef SurfaceDenoising_PointDenoising_h
#define SurfaceDenoising_PointDenoising_h

#include "LikelihoodPoints.h"
#include "MovingLeastSquares.h"
#include "MovingRobustPCA.h"
#include "NormalBundles.h"
#include "PointNeighbors.h"
#include "PointNormals.h"
#include "RobustImplicitMLS.h"
#include "TensorRegions.h"
#include "TwoStagePoints.h"
#include "VotingTensorPoints.h"

#include <variant>

namespace SurfaceDenoising
{

/// What is done in an outer iteration. The bilateral filter and rolling normals are two-stage.
using PointOperatorSettings = std::variant<TwoStageSettings, MovingLeastSquaresSettings,
  RobustImplicitMLSSettings, MovingRobustPCASettings, LikelihoodPointsSettings,
  NormalBundlesSettings, TensorRegionsSettings, VotingTensorPointsSettings>;

struct PointDenoisingSettings
{
  PointNeighborSettings Neighborhood;
  bool RenewNeighborhood = true; ///< look for neighbours again before every outer iteration
  PointNormalSettings Normals;
  bool LocalScale = false;          ///< lengths are relative to the spacing around each point
  double MaximumDisplacement = 0.0; ///< from the start, in mean spacings; 0: as far as it goes
  int OuterIterations = 1;
  /// Iterations end once the points moved that far along their normals: standard deviation, told
  /// from the median, a length; 0: never.
  double Residual = 0.0;
  PointOperatorSettings Operator;
};

/// What was found and done.
struct PointDenoisingReport : PointOperatorReport
{
  double Spacing = 0.0;             ///< s
  std::size_t NotFinite = 0;        ///< points with a coordinate that is not a number
  std::size_t EstimatedNormals = 0; ///< by plane fits
  bool Oriented = false;            ///< along a spanning tree
  std::size_t Parts = 0;            ///< connected parts of the spanning tree
  int OuterIterations = 0;          ///< done
  std::size_t Kept = 0;             ///< points that the last iteration could not filter
  double SetupSeconds = 0.0;        ///< neighbours, normals, signs
  double FilterSeconds = 0.0;
};

/// A cloud as it comes and goes.
struct PointCloud
{
  Buffer<Vec3> Positions;
  Buffer<Vec3> Normals; ///< one per point (unit or zero), or none at all
  Buffer<FeatureClass> Classes;
  Buffer<PointStatus> Status;
};

/**
 * Denoises the cloud in place: new positions and normals, and classes if the method tells. Points
 * that are not finite stay as they are. Where normals are given, those of the result are on the
 * same side. Returns false if the execution asked to stop; the cloud is unchanged then.
 */
bool DenoisePoints(PointCloud& cloud, const PointDenoisingSettings& settings,
  PointDenoisingReport& report, Execution& execution);

}

#endif
