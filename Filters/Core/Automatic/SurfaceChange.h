// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file SurfaceChange.h
 * @brief What a filter did to a surface: measures that need no ground truth.
 */

#ifndef SurfaceDenoising_SurfaceChange_h
#define SurfaceDenoising_SurfaceChange_h

#include "../TriangleMesh.h"

namespace SurfaceDenoising
{

/// Lengths are in a unit of the caller, such as the mean edge length. What is not defined is NaN.
struct SurfaceChange
{
  double MeanDisplacement = 0.0; ///< of the vertices that have faces, or of all finite points
  double RootMeanSquareDisplacement = 0.0;
  double MaximumDisplacement = 0.0;
  double VolumeChange; ///< (after - before) / |before| of closed surfaces; NaN for others
  std::size_t FeatureEdgesBefore = 0; ///< edges whose faces make more than the feature angle
  std::size_t FeatureEdgesAfter = 0;
  std::size_t FeatureEdgesKept = 0; ///< edges that are features before and after
  std::size_t FlippedFaces = 0;     ///< faces whose normals turned by more than 90 degrees
};

/// The change of a mesh whose vertices were at other places before. angle is the feature angle in
/// degrees, 0 for flat, as in vtkFeatureEdges; unit must be above 0.
SurfaceChange MeasureChange(const TriangleMesh& after, const Buffer<Vec3>& before, double unit,
  double angle, Execution& execution);

/// The change of a cloud: displacements alone.
SurfaceChange MeasureChange(const Buffer<Vec3>& after, const Buffer<Vec3>& before, double unit,
  Execution& execution);

}

#endif
