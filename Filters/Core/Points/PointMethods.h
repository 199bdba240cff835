// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PointMethods.h
 * @brief The table of methods for point sets: a row per published method. A new method is added
 * here.
 *
 * As Methods.h for meshes: the filters take their defaults from here; the presets of the composer,
 * the tests, the comparison script and the table in the readme follow the rows.
 */

#ifndef SurfaceDenoising_PointMethods_h
#define SurfaceDenoising_PointMethods_h

#include "PointDenoising.h"

namespace SurfaceDenoising
{

/// In the order of the table. It is part of the saved state of user interfaces: add new ones at the
/// end.
enum class PointMethod : int
{
  RobustImplicitMLS,
  MovingRobustPCA,
  FeatureAwarePoint,
  GuidedPointNormal,
  TensorPoint,
  BilateralPoint,
  RollingPointNormal,
  VotingTensorPoint,
  MovingLeastSquares
};

struct PointMethodRow
{
  PointMethod Id;
  const char* Name;
  const char* Paper;  ///< authors and year
  const char* Filter; ///< the class that does it by default, without the prefix vtk
  bool Composed;      ///< a composition of the parts that the composer offers
  PointDenoisingSettings Settings;
};

/// All rows, in the order of PointMethod.
const std::vector<PointMethodRow>& PointMethods();

/// What the composer does before anybody composes: a bilateral filter of the normals and a gradient
/// fit of the points, from normals of robust plane fits.
const PointDenoisingSettings& ComposedPoints();

inline const PointDenoisingSettings& SettingsOf(PointMethod method)
{
  return PointMethods()[static_cast<std::size_t>(method)].Settings;
}

}

#endif
