// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PointFixtures.h
 * @brief The few points of which worked numbers are known.
 */

#ifndef PointFixtures_h
#define PointFixtures_h

#include "Points/PointSet.h"

/// F1: five points with normals, each the neighbour of all others.
static inline SurfaceDenoising::PointSet FivePoints()
{
  using SurfaceDenoising::Vec3;
  SurfaceDenoising::PointSet points;
  points.Positions = { Vec3(0.0, 0.0, 0.2), Vec3(1.0, 0.0, 0.1), Vec3(-1.0, 0.0, 0.0),
    Vec3(0.0, 1.0, 0.0), Vec3(0.0, -1.0, -0.1) };
  points.Normals = { Vec3(0.0, 0.0, 1.0), Vec3(0.2, 0.0, 1.0), Vec3(-0.1, 0.1, 1.0),
    Vec3(0.0, -0.2, 1.0), Vec3(1.0, 0.0, 0.2) };
  for (Vec3& normal : points.Normals)
  {
    normal.normalize();
  }
  SurfaceDenoising::Execution serial;
  points.Neighbors = SurfaceDenoising::NearestPoints(points.Positions, 4, serial);
  points.Start = points.Positions;
  points.Spacings.assign(5, 1.0);
  points.Spacing = 1.0;
  points.Status.assign(5, SurfaceDenoising::PointStatus::Filtered);
  return points;
}

#endif
