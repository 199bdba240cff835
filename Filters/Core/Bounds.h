// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file Bounds.h
 * @brief The box around points.
 */

#ifndef SurfaceDenoising_Bounds_h
#define SurfaceDenoising_Bounds_h

#include "Execution.h"

#include <limits>

namespace SurfaceDenoising
{

/// The box of the finite ones of some points; without any, Low is infinite and High its negative.
struct Bounds
{
  Vec3 Low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 High = Vec3::Constant(-std::numeric_limits<double>::infinity());
  std::size_t Finite = 0; ///< how many

  Bounds& operator+=(const Vec3& p)
  {
    if (p.allFinite())
    {
      *this += Bounds{ p, p, 1 };
    }
    return *this;
  }

  Bounds& operator+=(const Bounds& other)
  {
    this->Low = this->Low.cwiseMin(other.Low);
    this->High = this->High.cwiseMax(other.High);
    this->Finite += other.Finite;
    return *this;
  }
};

inline Bounds BoundsOf(const Buffer<Vec3>& points, Execution& execution)
{
  return OrderedSum(execution, points.size(), Bounds(),
    [&points](std::size_t i) { return points[i]; });
}

}

#endif
