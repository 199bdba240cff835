// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file Methods.h
 * @brief The table of methods: a row per published method. A new method is added here.
 *
 * A two-stage method is a row of settings: which neighbours, which norm of what, which operator,
 * which vertex update, in which order. The filters take their defaults from here; the presets of
 * the composer, the tests, the comparison script and the table in the readme follow the rows.
 */

#ifndef SurfaceDenoising_Methods_h
#define SurfaceDenoising_Methods_h

#include "MeshDenoising.h"

namespace SurfaceDenoising
{

/// In the order of the table. It is part of the saved state of user interfaces: add new ones at the
/// end.
enum class Method : int
{
  NormalDiffusion,
  MeanNormal,
  MedianNormal,
  WeightedMedianNormal,
  HuberNormal,
  NormalVotingTensor,
  FuzzyVectorMedian,
  CurvatureNormalDiffusion,
  GeometricFidelity,
  BilateralNormal,
  GlobalBilateralNormal,
  GuidedNormal,
  TukeyBilateralNormal,
  ThresholdedCosine,
  MeanCurvatureFlow,
  AnisotropicMeanCurvature,
  BilateralVertex,
  NonIterativeBilateral
};

struct MethodRow
{
  Method Id;
  const char* Name;
  const char* Paper;  ///< authors and year
  const char* Filter; ///< the class that does it by default, without the prefix vtk
  bool TwoStage; ///< filters normals first; the others move points at once and have no settings
  bool Composed; ///< a composition of the parts that the composer offers
  MeshDenoisingSettings Settings;
};

/// All rows, in the order of Method.
const std::vector<MethodRow>& Methods();

inline const MeshDenoisingSettings& SettingsOf(Method method)
{
  return Methods()[static_cast<std::size_t>(method)].Settings;
}

}

#endif
