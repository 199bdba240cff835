// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file ImplicitSurface.h
 * @brief The robust implicit function of RobustImplicitMLS.h at a place, and its gradient.
 */

#ifndef SurfaceDenoising_ImplicitSurface_h
#define SurfaceDenoising_ImplicitSurface_h

#include "RobustImplicitMLS.h"

#include <vector>

namespace SurfaceDenoising
{

/// The function at a place.
struct ImplicitValue
{
  double Weight = 0.0; ///< W; 0 outside all balls
  double Value = 0.0;  ///< f
  Vec3 Gradient = Vec3(0.0, 0.0, 0.0);
};

/// The samples around a place.
class ImplicitSurface
{
public:
  /// Sums run in so many lanes, which are added at the end: the same bits however wide vectors are.
  static constexpr std::size_t Lanes = 8;

  /// Takes all samples away, but keeps their memory.
  void Clear() { this->Count = 0; }

  /// A sample with the radius of its ball, which is above 0.
  void Add(const Vec3& position, const Vec3& normal, double radius);

  /// By at most settings.MaximumFits fits.
  ImplicitValue Evaluate(const Vec3& x, const RobustImplicitMLSSettings& settings);

  /// Samples side by side, with what depends on the place of the last evaluation.
  struct Tile
  {
    double Position[3][Lanes];
    double Normal[3][Lanes];
    double InverseSquare[Lanes]; ///< 1 / h_j^2
    double Offset[3][Lanes];     ///< x - p_j
    double Height[Lanes];        ///< f_j
    double Phi[Lanes];
    double Slope[Lanes]; ///< of grad phi_j = slope (x - p_j)
  };

private:
  std::size_t Count = 0;
  std::vector<Tile> Tiles;
};

}

#endif
