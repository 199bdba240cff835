// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file SurfaceStep.h
 * @brief The way of a place to the surface of the points around it.
 */

#ifndef SurfaceDenoising_SurfaceStep_h
#define SurfaceDenoising_SurfaceStep_h

#include "RobustQuadric.h"

namespace SurfaceDenoising
{

/**
 * The shorter of two ways: to the plane of the 12 nearest points and to the robust quadric through
 * the 20 nearest. Holds memory to work in.
 */
class SurfaceStep
{
public:
  static constexpr std::size_t PlaneNeighbors = 12;
  static constexpr std::size_t QuadricNeighbors = 20;

  /// Forgets the points.
  void Start() { this->Offsets.clear(); }

  /// A point relative to the place, the nearest first.
  void Add(const Vec3& offset) { this->Offsets.push_back(offset); }

  bool IsFull() const { return this->Offsets.size() >= QuadricNeighbors; }

  /// The step along the normal of the surface, which is zero without a surface (fewer than three
  /// points, or all on a line).
  Vec3 Step(Vec3& normal);

private:
  std::vector<Vec3> Offsets;
  RobustQuadric Quadric;
};

}

#endif
