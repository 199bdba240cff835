// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file RobustQuadric.h
 * @brief How far a place is off the quadric through the points around it.
 */

#ifndef SurfaceDenoising_RobustQuadric_h
#define SurfaceDenoising_RobustQuadric_h

#include "../Types.h"

#include <array>
#include <vector>

namespace SurfaceDenoising
{

/**
 * Polynomials of degree 2 over the plane with a normal, with the sum of the absolute residuals as
 * the error (iteratively reweighted), so that some points that are far off do not matter. Holds
 * memory to work in: use one for many places.
 */
class RobustQuadric
{
public:
  /// Fewer points do not determine it.
  static constexpr std::size_t LeastPoints = 8;

  /// Forgets the points. up is a unit vector; lengths are divided by scale.
  void Start(const Vec3& up, double scale);

  /// A point relative to the place.
  void Add(const Vec3& offset);

  /// The polynomial at the place: how far it is away along up, a length with a sign; NaN with fewer
  /// points.
  double Height();

private:
  /// 1, x, y, x^2, x y, y^2
  using Row = std::array<double, 6>;

  Vec3 Up;
  Vec3 X;
  Vec3 Y;
  double Scale = 1.0;
  std::vector<Row> Rows;
  Buffer<double> Values;
  Buffer<double> Weights;
};

}

#endif
