// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file LineAngles.h
 * @brief How far the normals of points are from those of a reference.
 *
 * Normals of point clouds are often known up to their sign only: the angle here is that between the
 * lines along two normals, from 0 to 90 degrees, and how many point the other way is counted.
 */

#ifndef SurfaceDenoising_LineAngles_h
#define SurfaceDenoising_LineAngles_h

#include "SurfaceSides.h"

namespace SurfaceDenoising
{

/// A normal against the one that is expected.
struct LineAngle
{
  double Degrees; ///< atan2(|a x b|, |a.b|), from 0 to 90; NaN if a or b is zero
  bool Flipped;   ///< a.b < 0
};

LineAngle AngleBetweenLines(const Vec3& a, const Vec3& b);

/// Of each point.
struct LineAngles
{
  Buffer<double> Degrees; ///< NaN if there is nothing to compare
  Buffer<unsigned char> Flipped;
};

/**
 * Against the normal of the nearest face. If several are equally near, as they are outside an edge
 * or a corner, the one that fits best counts: on an edge the normal of either side is right.
 * nearest has one nearest face of each point or NoIndex.
 */
LineAngles CompareWithFaces(const Buffer<Vec3>& normals, const Buffer<Vec3>& positions,
  const Buffer<Index>& nearest, const SurfaceSides& sides, const Buffer<Vec3>& faceNormals,
  Execution& execution);

/// Against the normal of the nearest point of a reference.
LineAngles CompareWithPoints(const Buffer<Vec3>& normals, const Buffer<Index>& nearest,
  const Buffer<Vec3>& referenceNormals, Execution& execution);

/// Of all points whose angle is a number; NaN without any.
struct LineAngleSummary
{
  double Mean;
  double RootMeanSquare;
  double ShareWithin10; ///< share of angles below 10 degrees, from 0 to 1
  double Flipped;       ///< number of normals that point the other way
};

LineAngleSummary Summarize(const LineAngles& angles, Execution& execution);

}

#endif
