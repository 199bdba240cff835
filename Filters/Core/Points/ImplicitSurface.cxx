// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ImplicitSurface.h"

#include "NormalFilter.h"
#include "Vectorize.h"

#include <algorithm>
#include <cmath>

namespace SurfaceDenoising
{

namespace
{

constexpr std::size_t Lanes = ImplicitSurface::Lanes;
using Tile = ImplicitSurface::Tile;

/// What depends on the place alone.
SURFACEDENOISING_VECTORIZED
void Measure(Tile* tiles, std::size_t count, double x, double y, double z)
{
  for (Tile* tile = tiles; tile != tiles + count; ++tile)
  {
    for (std::size_t l = 0; l < Lanes; ++l)
    {
      const double dx = x - tile->Position[0][l];
      const double dy = y - tile->Position[1][l];
      const double dz = z - tile->Position[2][l];
      const double left = 1.0 - (dx * dx + dy * dy + dz * dz) * tile->InverseSquare[l];
      const double t = left > 0.0 ? left : 0.0;
      const double square = t * t;
      tile->Offset[0][l] = dx;
      tile->Offset[1][l] = dy;
      tile->Offset[2][l] = dz;
      tile->Height[l] = tile->Normal[0][l] * dx + tile->Normal[1][l] * dy + tile->Normal[2][l] * dz;
      tile->Phi[l] = square * square;
      tile->Slope[l] = -8.0 * tile->InverseSquare[l] * (square * t);
    }
  }
}

/// What alpha looks at: the fit before, and 1 / sigma^2 of both parts.
struct Weighting
{
  double Value;
  double Gradient[3];
  double OfResiduals;
  double OfNormals;
};

/// The sums of a fit: with w = alpha phi and s = alpha slope, of w, w f_j, w n_j, s (x - p_j) and
/// s f_j (x - p_j).
struct Sums
{
  double Weight[Lanes];
  double Value[Lanes];
  double Normal[3][Lanes];
  double Slope[3][Lanes];
  double SlopeHeight[3][Lanes];
};

/// Robust: with the weights alpha, else alpha = 1. Products and sums in loops of their own are what
/// compilers turn into vectors.
template <bool Robust>
SURFACEDENOISING_VECTORIZED void AddUp(const Tile* tiles, std::size_t count,
  const Weighting& weighting, Sums& result)
{
  const double f = weighting.Value;
  const double gx = weighting.Gradient[0];
  const double gy = weighting.Gradient[1];
  const double gz = weighting.Gradient[2];
  const double ofResiduals = weighting.OfResiduals;
  const double ofNormals = weighting.OfNormals;
  Sums sums = {};
  for (const Tile* tile = tiles; tile != tiles + count; ++tile)
  {
    double w[Lanes];
    double s[Lanes];
    for (std::size_t l = 0; l < Lanes; ++l)
    {
      double alpha = 1.0;
      if constexpr (Robust)
      {
        const double r = tile->Height[l] - f;
        const double dx = tile->Normal[0][l] - gx;
        const double dy = tile->Normal[1][l] - gy;
        const double dz = tile->Normal[2][l] - gz;
        alpha = ExpOfNegative(-(r * r * tile->InverseSquare[l] * ofResiduals +
          (dx * dx + dy * dy + dz * dz) * ofNormals));
      }
      w[l] = alpha * tile->Phi[l];
      s[l] = alpha * tile->Slope[l];
    }
    for (std::size_t l = 0; l < Lanes; ++l)
    {
      sums.Weight[l] += w[l];
      sums.Value[l] += w[l] * tile->Height[l];
    }
    for (int k = 0; k < 3; ++k)
    {
      for (std::size_t l = 0; l < Lanes; ++l)
      {
        const double along = s[l] * tile->Offset[k][l];
        sums.Normal[k][l] += w[l] * tile->Normal[k][l];
        sums.Slope[k][l] += along;
        sums.SlopeHeight[k][l] += along * tile->Height[l];
      }
    }
  }
  result = sums;
}

double Total(const double (&lanes)[Lanes])
{
  double total = 0.0;
  for (const double lane : lanes)
  {
    total += lane;
  }
  return total;
}

Vec3 Total(const double (&lanes)[3][Lanes])
{
  return Vec3(Total(lanes[0]), Total(lanes[1]), Total(lanes[2]));
}

}

void ImplicitSurface::Add(const Vec3& position, const Vec3& normal, double radius)
{
  const std::size_t lane = this->Count % Lanes;
  if (this->Count / Lanes == this->Tiles.size())
  {
    this->Tiles.emplace_back();
  }
  Tile& tile = this->Tiles[this->Count / Lanes];
  if (lane == 0)
  {
    tile = Tile(); // the rest of the tile
  }
  for (int k = 0; k < 3; ++k)
  {
    tile.Position[k][lane] = position[k];
    tile.Normal[k][lane] = normal[k];
  }
  tile.InverseSquare[lane] = 1.0 / (radius * radius);
  ++this->Count;
}

ImplicitValue ImplicitSurface::Evaluate(const Vec3& x, const RobustImplicitMLSSettings& settings)
{
  const std::size_t tiles = (this->Count + Lanes - 1) / Lanes;
  Measure(this->Tiles.data(), tiles, x[0], x[1], x[2]);
  for (std::size_t l = this->Count; l < tiles * Lanes; ++l)
  {
    this->Tiles[tiles - 1].Phi[l % Lanes] = 0.0;
  }
  auto inverseSquare = [](double scale) { return scale > 0.0 ? 1.0 / (scale * scale) : 0.0; };
  ImplicitValue value;
  for (int fit = 0; fit < std::max(1, settings.MaximumFits); ++fit)
  {
    const Vec3& g = value.Gradient;
    const Weighting weighting{ value.Value, { g[0], g[1], g[2] },
      inverseSquare(settings.ResidualScale), inverseSquare(settings.NormalScale) };
    Sums sums = {};
    (fit == 0 ? AddUp<false> : AddUp<true>)(this->Tiles.data(), tiles, weighting, sums);
    ImplicitValue next;
    next.Weight = Total(sums.Weight);
    if (!(next.Weight > NormalFilter::NoWeight))
    {
      break; // outside all balls, or weights that leave nothing: the fit before
    }
    next.Value = Total(sums.Value) / next.Weight;
    next.Gradient =
      (Total(sums.SlopeHeight) - next.Value * Total(sums.Slope) + Total(sums.Normal)) / next.Weight;
    const double change = (next.Gradient - value.Gradient).squaredNorm();
    value = next;
    if (fit > 0 && change < 1e-3)
    {
      break;
    }
  }
  return value;
}

}
