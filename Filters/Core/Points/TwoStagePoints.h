// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file TwoStagePoints.h
 * @brief Filter the normals, then move the points: every composition of the engine's parts.
 *
 * Lengths are in mean spacings s (PointSet.h), or those of the point if scales are local.
 */

#ifndef SurfaceDenoising_TwoStagePoints_h
#define SurfaceDenoising_TwoStagePoints_h

#include "NormalFilter.h"
#include "PointOperator.h"
#include "PointPatches.h"
#include "PointUpdate.h"
#include "RobustScale.h"
#include "VotingTensor.h"

namespace SurfaceDenoising
{

/// What the error norm compares.
enum class PointGuidance : int
{
  None,    ///< the normals of a point and its neighbour
  Patch,   ///< the mean normals of their most consistent patches, see PointPatches.h
  Median,  ///< the directional median around the point and the normal of the neighbour
  Rolling, ///< the filtered normals of the iteration before, first of one without norm
};

/// Which normals are averaged when iterations follow one another.
enum class PointNormalData : int
{
  Previous, ///< those of the iteration before
  Original  ///< those that the iterations started from
};

/// What is made of the weights.
enum class PointNormalOperator : int
{
  Average,      ///< their mean
  Diffusion,    ///< a step towards the neighbours, see NormalFilter.h
  VotingTensor, ///< the tensor of the normals, see VotingTensor.h
  PlaneFit      ///< the plane of the weighted positions, see PlaneFit.h
};

/// The weights f(d) g(x) of one stage.
struct PointWeights
{
  NormId Norm = NormId::Gaussian;
  /// In units of the argument: chord length, radians, curvatures times s, lengths over s; 0: from
  /// the data, in the normal stage.
  double NormScale = 0.35;
  NormalArgument Argument = NormalArgument::Chord; ///< all but SiteCurvature
  double SpatialScale = 1.5;                       ///< sigma of the spatial Gaussian; 0: none
  bool IncludeOwn = true;
};

struct TwoStageSettings
{
  PointWeights Normals;
  ScaleEstimator Estimator = ScaleEstimator::MedianAbsoluteDeviation;
  PointGuidance Guidance = PointGuidance::None;
  /// Of that guidance; patches end at edges, or the mean error near these is larger than without
  /// any guidance: on a wedge with noise of 0.15 spacings 0.06 spacings instead of 0.025.
  PointPatchSettings Patch = { 10, 0.7, false, 0.65 };
  PointNormalData Data = PointNormalData::Previous;
  PointNormalOperator Operator = PointNormalOperator::Average;
  double StepLength = 0.5; ///< of Diffusion
  VotingTensorSettings Tensor;
  int NormalIterations = 5; ///< per outer iteration

  PointWeights Points;
  PointUpdateSettings Update;
  int PointIterations = 10; ///< per outer iteration

  bool DensityWeights = false; ///< neighbours count by the area around them, s_j^2
  bool Unoriented = false;     ///< n and -n are the same normal, in both stages and in patches
};

std::unique_ptr<PointOperator> MakeTwoStagePoints(const TwoStageSettings& settings);

}

#endif
