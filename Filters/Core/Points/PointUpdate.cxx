// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PointUpdate.h"

#include "SymmetricEigen.h"

#include <atomic>

namespace SurfaceDenoising
{

namespace
{

/// The sums of a row, from which schemes take their step.
struct RowSums
{
  double Weight = 0.0;
  double OwnHeight = 0.0;
  double NeighborHeight = 0.0;
  Vec3 Pull = Vec3(0.0, 0.0, 0.0); ///< sum w n_j (n_j . e): b of the quadric
  Mat3 Quadric = Mat3::Zero();
};

/// Those of the sums that the scheme needs. They take most of the time of a step.
template <PointScheme Scheme>
RowSums SumRow(const NormalFilter& weights, const Buffer<Vec3>& normals,
  const Buffer<Vec3>& positions, const PointUpdateSettings& settings, std::size_t i,
  const double* w)
{
  constexpr bool quadric = Scheme == PointScheme::QuadricFit;
  constexpr bool pull = quadric || Scheme == PointScheme::Gradient;
  constexpr bool neighbor =
    Scheme == PointScheme::NeighborHeight || Scheme == PointScheme::BalancedHeight;
  constexpr bool own = Scheme == PointScheme::OwnHeight || Scheme == PointScheme::BalancedHeight ||
    Scheme == PointScheme::Gradient;
  const Vec3 n = normals[i];
  const Vec3 p = positions[i];
  const Vec3 line = quadric && settings.Lines ? (*settings.Lines)[i] : Vec3(0.0, 0.0, 0.0);
  RowSums sums;
  if (weights.IncludesOwn())
  {
    // No height, no way to oneself; but the own plane holds back.
    if constexpr (quadric)
    {
      const Vec3 m = n - line.dot(n) * line;
      sums.Quadric += *w * m * m.transpose();
    }
    sums.Weight += *w++;
  }
  for (const Index j : weights.Neighbors().Row(i))
  {
    const Vec3 e = positions[j] - p;
    sums.Weight += *w;
    if constexpr (own)
    {
      sums.OwnHeight += *w * n.dot(e);
    }
    if constexpr (neighbor || pull)
    {
      Vec3 m = normals[j];
      if constexpr (quadric)
      {
        m -= line.dot(m) * line;
        sums.Quadric += *w * m * m.transpose();
      }
      const double height = m.dot(e);
      if constexpr (neighbor)
      {
        sums.NeighborHeight += *w * (settings.Unoriented && n.dot(m) < 0.0 ? -height : height);
      }
      if constexpr (pull)
      {
        sums.Pull += (*w * height) * m;
      }
    }
    ++w;
  }
  return sums;
}

using SumRows = RowSums (*)(const NormalFilter&, const Buffer<Vec3>&, const Buffer<Vec3>&,
  const PointUpdateSettings&, std::size_t, const double*);

SumRows SumsOf(PointScheme scheme)
{
  switch (scheme)
  {
    case PointScheme::OwnHeight:
      return SumRow<PointScheme::OwnHeight>;
    case PointScheme::NeighborHeight:
      return SumRow<PointScheme::NeighborHeight>;
    case PointScheme::BalancedHeight:
      return SumRow<PointScheme::BalancedHeight>;
    case PointScheme::Gradient:
      return SumRow<PointScheme::Gradient>;
    case PointScheme::QuadricFit:
      break;
  }
  return SumRow<PointScheme::QuadricFit>;
}

}

TruncatedSolution SolveWithRank(const Mat3& a, const Vec3& b, double cut)
{
  const Eigensystem system = Decompose(a);
  const double limit = std::max(cut, 1e-12) * system.Values[2];
  TruncatedSolution solution;
  for (int k = 0; k < 3; ++k)
  {
    if (system.Values[k] > 0.0 && system.Values[k] >= limit)
    {
      const Vec3 e = system.Vectors.col(k);
      solution.X += e.dot(b) / system.Values[k] * e;
      ++solution.Rank;
    }
  }
  return solution;
}

std::size_t ComputeDisplacements(const NormalFilter& weights, const NormalFilter::Fields& fields,
  const Buffer<Vec3>& positions, const PointUpdateSettings& settings, Buffer<Vec3>& displacements,
  Execution& execution, Buffer<unsigned char>* ranks)
{
  const std::size_t count = weights.Neighbors().NumberOfRows();
  const Buffer<Vec3>& normals = fields.Data;
  const SumRows sum = SumsOf(settings.Scheme);
  displacements.resize(count);
  if (ranks)
  {
    ranks->assign(count, 0);
  }
  std::atomic<std::size_t> kept{ 0 };
  weights.VisitWeights(fields, execution,
    [&](std::size_t i, const double* w)
    {
      const Vec3& n = normals[i];
      const RowSums sums = sum(weights, normals, positions, settings, i, w);
      Vec3& d = displacements[i];
      d.setZero();
      const bool needsNormal = settings.Scheme != PointScheme::QuadricFit;
      if (!(sums.Weight > NormalFilter::NoWeight) || (needsNormal && n.isZero(0.0)))
      {
        ++kept;
        return;
      }
      const double step = settings.Step / sums.Weight;
      switch (settings.Scheme)
      {
        case PointScheme::OwnHeight:
          d = step * sums.OwnHeight * n;
          break;
        case PointScheme::NeighborHeight:
          d = step * sums.NeighborHeight * n;
          break;
        case PointScheme::BalancedHeight:
          d = step * 0.5 * (sums.OwnHeight + sums.NeighborHeight) * n;
          break;
        case PointScheme::Gradient:
          d = step / 3.0 * (sums.OwnHeight * n + sums.Pull);
          break;
        case PointScheme::QuadricFit:
        {
          const TruncatedSolution solution =
            SolveWithRank(sums.Quadric, sums.Pull, settings.EigenvalueCut);
          d = settings.Step * solution.X;
          if (ranks)
          {
            (*ranks)[i] = static_cast<unsigned char>(solution.Rank);
          }
          break;
        }
      }
    });
  return kept;
}

void MoveTo(const Buffer<Vec3>& places, PointSet& points, Execution& execution)
{
  const double limit = points.MaximumDisplacement;
  execution.For(points.Size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Vec3& place = places[i];
        if (place.allFinite() && (!(limit > 0.0) || (place - points.Start[i]).norm() <= limit))
        {
          points.Positions[i] = place;
        }
        else
        {
          points.Status[i] = PointStatus::Kept;
        }
      }
    });
}

void MoveBy(Buffer<Vec3>& displacements, PointSet& points, Execution& execution)
{
  execution.For(points.Size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        displacements[i] += points.Positions[i];
      }
    });
  MoveTo(displacements, points, execution);
}

void TurnTo(const Buffer<Vec3>& normals, PointSet& points, Execution& execution)
{
  execution.For(points.Size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        if (points.Status[i] != PointStatus::Kept)
        {
          points.Normals[i] = normals[i];
        }
      }
    });
}

}
