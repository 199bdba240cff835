// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file NormalFilterStages.h
 * @brief The loops of the normal filter over a block of rows, stage by stage: differences, what the
 * norm is applied to, weights, new normals. For NormalFilter.cxx alone.
 */

#ifndef SurfaceDenoising_NormalFilterStages_h
#define SurfaceDenoising_NormalFilterStages_h

#include "NormalFilter.h"

namespace SurfaceDenoising
{

namespace
{

/// Loops over weights run to a multiple of the widest vector, so that no remainder loop rounds
/// differently.
constexpr std::size_t Lanes = 8;

constexpr std::size_t RoundUp(std::size_t count) { return (count + Lanes - 1) / Lanes * Lanes; }

/// Entries handled together: their weights stay in the first-level cache between the stages.
constexpr std::size_t EntriesPerBlock = 512;

/// Rows [First, Last) of a graph, each with an entry for the site itself in front if Own.
struct Rows
{
  const CompressedRows& Graph;
  bool Own;
  std::size_t First;
  std::size_t Last;
};

/// What the vectors of stage 1 are.
enum class VectorKind
{
  Positions,
  Normals, ///< a zero centre is no normal and differs from nothing
  Axes     ///< normals without orientation: the smaller of the differences from n and -n
};

/// Stage 1: |centre_i - compared_j|^2 for the entries of a block.
template <VectorKind Kind>
SURFACEDENOISING_VECTORIZED void SquaredDistances(const Rows& rows, const Vec3* centre,
  const Vec3* compared, double* squares)
{
  const std::uint64_t* offsets = rows.Graph.Offsets.data();
  const Index* ids = rows.Graph.Ids.data();
  const bool own = rows.Own;
  std::size_t k = 0;
  for (std::size_t i = rows.First; i < rows.Last; ++i)
  {
    const double cx = centre[i][0];
    const double cy = centre[i][1];
    const double cz = centre[i][2];
    const bool differs = Kind == VectorKind::Positions || cx * cx + cy * cy + cz * cz > 0.0;
    const double factor = differs ? 1.0 : 0.0;
    auto square = [=](const Vec3& n)
    {
      const double dx = n[0] - cx;
      const double dy = n[1] - cy;
      const double dz = n[2] - cz;
      const double square = dx * dx + dy * dy + dz * dz;
      if constexpr (Kind == VectorKind::Axes)
      {
        const double sx = n[0] + cx;
        const double sy = n[1] + cy;
        const double sz = n[2] + cz;
        return factor * std::min(square, sx * sx + sy * sy + sz * sz);
      }
      return factor * square;
    };
    if (own)
    {
      squares[k++] = square(compared[i]);
    }
    for (std::uint64_t p = offsets[i]; p < offsets[i + 1]; ++p)
    {
      squares[k++] = square(compared[ids[p]]);
    }
  }
  for (const std::size_t end = RoundUp(k); k < end; ++k)
  {
    squares[k] = 0.0;
  }
}

/// Instead of stages 1 and 2, if heights are compared: (n . (p_j - c_i))^2 with the normal n of the
/// site or that of the neighbour.
template <bool OfNeighbor>
SURFACEDENOISING_VECTORIZED void SquaredHeights(const Rows& rows, const Vec3* normals,
  const Vec3* centres, const Vec3* positions, double* squares)
{
  const std::uint64_t* offsets = rows.Graph.Offsets.data();
  const Index* ids = rows.Graph.Ids.data();
  std::size_t k = 0;
  for (std::size_t i = rows.First; i < rows.Last; ++i)
  {
    const Vec3& c = centres[i];
    auto square = [&](std::size_t j)
    {
      const Vec3& n = normals[OfNeighbor ? j : i];
      const Vec3& p = positions[j];
      const double height = n[0] * (p[0] - c[0]) + n[1] * (p[1] - c[1]) + n[2] * (p[2] - c[2]);
      return height * height;
    };
    if (rows.Own)
    {
      squares[k++] = square(i);
    }
    for (std::uint64_t p = offsets[i]; p < offsets[i + 1]; ++p)
    {
      squares[k++] = square(ids[p]);
    }
  }
  for (const std::size_t end = RoundUp(k); k < end; ++k)
  {
    squares[k] = 0.0;
  }
}

/// Stage 2, if bent arcs are compared: from the square of a chord to s^2 + C kappa^2.
SURFACEDENOISING_VECTORIZED
void ChordsToBentArcs(const double* inverseSquaredDistances, std::size_t count, double bendFactor,
  double* squares)
{
  for (std::size_t k = 0; k < count; ++k)
  {
    const double chord = squares[k];
    const double angle = AngleOfSquaredChord(chord);
    const double ratio = chord > 1e-20 ? angle * angle / std::max(chord, 1e-20) : 1.0;
    squares[k] =
      ratio / inverseSquaredDistances[k] + bendFactor * chord * inverseSquaredDistances[k];
  }
}

/// Stage 2, if every site has a scale of its own: squares of row i over the square of its factor.
void DivideBySquares(const Rows& rows, const double* factors, double* squares)
{
  std::size_t k = 0;
  for (std::size_t i = rows.First; i < rows.Last; ++i)
  {
    const double inverse = 1.0 / (factors[i] * factors[i]);
    const std::size_t entries =
      rows.Graph.Offsets[i + 1] - rows.Graph.Offsets[i] + (rows.Own ? 1 : 0);
    for (const std::size_t end = k + entries; k < end; ++k)
    {
      squares[k] *= inverse;
    }
  }
}

/// Stage 2, if angles are compared: from the square of a chord to that of the angle.
SURFACEDENOISING_VECTORIZED void ChordsToAngles(double* squares, std::size_t count)
{
  for (std::size_t k = 0, end = RoundUp(count); k < end; ++k)
  {
    const double angle = AngleOfSquaredChord(squares[k]);
    squares[k] = angle * angle;
  }
}

/// Instead of stages 1 to 3, if x belongs to the sites: weights from g of both sites.
void WeighBySites(const Rows& rows, const double* factors, const double* fixed, double* weights)
{
  std::size_t k = 0;
  for (std::size_t i = rows.First; i < rows.Last; ++i)
  {
    if (rows.Own)
    {
      weights[k] = factors[i] * fixed[k];
      ++k;
    }
    for (const Index j : rows.Graph.Row(i))
    {
      weights[k] = 0.5 * (factors[i] + factors[j]) * fixed[k];
      ++k;
    }
  }
}

/// values *= factors.
void Multiply(const double* factors, std::size_t count, double* values)
{
  for (std::size_t k = 0; k < count; ++k)
  {
    values[k] *= factors[k];
  }
}

/// 1 / squares, held at 1 / smallest.
void InvertSquares(const double* squares, std::size_t count, double smallest, double* inverse)
{
  for (std::size_t k = 0; k < count; ++k)
  {
    inverse[k] = 1.0 / std::max(squares[k], smallest);
  }
}

/// values *= f(d), the spatial kernel.
SURFACEDENOISING_VECTORIZED
void Attenuate(const GaussianNorm kernel, const double* squares, std::size_t count, double* values)
{
  for (std::size_t k = 0; k < count; ++k)
  {
    values[k] *= kernel.WeightOfSquare(squares[k]);
  }
}

/// Stage 3: the weights of the norm times what is fixed.
template <typename Norm>
SURFACEDENOISING_VECTORIZED void Weigh(const Norm norm, const double* fixed, double* squares,
  std::size_t count)
{
  for (std::size_t k = 0, end = RoundUp(count); k < end; ++k)
  {
    squares[k] = norm.WeightOfSquare(squares[k]) * fixed[k];
  }
}

/// Stage 4, average: weighted sums of the data, normalised. Without orientation, the data of a
/// neighbour get the sign that agrees with those of the site. Returns the number of sites that kept
/// their normal.
template <bool Unoriented>
SURFACEDENOISING_VECTORIZED std::size_t Average(const Rows& rows, const double* weights,
  const Vec3* data, const Vec3* current, Vec3* filtered)
{
  const std::uint64_t* offsets = rows.Graph.Offsets.data();
  const Index* ids = rows.Graph.Ids.data();
  const bool own = rows.Own;
  std::size_t kept = 0;
  std::size_t k = 0;
  for (std::size_t i = rows.First; i < rows.Last; ++i)
  {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    double total = 0.0;
    const Vec3& reference = data[i];
    auto add = [&](const Vec3& n)
    {
      double w = weights[k++];
      if constexpr (Unoriented)
      {
        const double dot = reference[0] * n[0] + reference[1] * n[1] + reference[2] * n[2];
        total += w;
        w = dot < 0.0 ? -w : w;
      }
      else
      {
        total += w;
      }
      x += w * n[0];
      y += w * n[1];
      z += w * n[2];
    };
    if (own)
    {
      add(data[i]);
    }
    for (std::uint64_t p = offsets[i]; p < offsets[i + 1]; ++p)
    {
      add(data[ids[p]]);
    }
    const double length = std::sqrt(x * x + y * y + z * z);
    if (length > std::max(1e-12 * total, NormalFilter::NoWeight))
    {
      const double scale = 1.0 / length;
      filtered[i] = Vec3(x * scale, y * scale, z * scale);
    }
    else
    {
      filtered[i] = current[i];
      ++kept;
    }
  }
  return kept;
}

/// Stage 4, diffusion: a step along the weighted sum of differences.
std::size_t Diffuse(const Rows& rows, const NormalFilterSettings& settings, const double* weights,
  const double* fixed, const Vec3* data, const Vec3* current, Vec3* filtered)
{
  std::size_t kept = 0;
  std::size_t k = 0;
  for (std::size_t i = rows.First; i < rows.Last; ++i)
  {
    const Vec3 n = current[i];
    Vec3 flux(0.0, 0.0, 0.0);
    double capacity = 0.0;
    auto add = [&](const Vec3& other)
    {
      const double sign = settings.Unoriented && other.dot(n) < 0.0 ? -1.0 : 1.0;
      flux += weights[k] * (sign * other - n);
      capacity += fixed[k];
      ++k;
    };
    if (rows.Own)
    {
      add(data[i]);
    }
    for (const Index j : rows.Graph.Row(i))
    {
      add(data[j]);
    }
    filtered[i] = n;
    ++kept;
    if (capacity > NormalFilter::NoWeight)
    {
      if (settings.TangentialFlux)
      {
        flux -= flux.dot(n) * n;
      }
      const Vec3 moved = n + (settings.StepLength / capacity) * flux;
      const double length = moved.norm();
      if (length > 1e-12)
      {
        filtered[i] = moved / length;
        --kept;
      }
    }
  }
  return kept;
}

}

}

#endif
