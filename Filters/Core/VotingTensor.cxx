// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VotingTensor.h"

#include "SymmetricEigen.h"

#include <atomic>

namespace SurfaceDenoising
{

namespace
{

/// The normal at j as the site at the origin would have it on a common circular arc.
Vec3 RotatedVote(const Vec3& n, const Vec3& towards)
{
  const Vec3 u = towards.cross(n).cross(towards);
  const double length = u.norm();
  return length > 0.0 ? Vec3(2.0 * n.dot(u / length) * (u / length) - n) : n;
}

/// d n + sum_k b_k (e_k . n) e_k, not normalised.
Vec3 Project(const Mat3& tensor, const Vec3& n, const VotingTensorSettings& settings)
{
  const Eigensystem system = Decompose(tensor);
  const Vec3& values = system.Values;
  const Mat3& vectors = system.Vectors;
  const Vec3 first = vectors.col(2);
  const double threshold =
    settings.Threshold * (settings.Unit == EigenvalueUnit::Length ? values.norm() : values.sum());
  if (values[0] >= threshold)
  {
    return n; // a corner
  }
  Vec3 projected = first.dot(n) * first;
  if (values[1] >= threshold)
  {
    const Vec3 second = vectors.col(1);
    projected += second.dot(n) * second;
  }
  return settings.Damping * n + projected;
}

}

std::size_t VoteOnNormals(const NormalFilter& filter, const NormalFilter::Fields& fields,
  const Buffer<Vec3>& positions, const VotingTensorSettings& settings, Buffer<Vec3>& filtered,
  Execution& execution)
{
  const NeighborGraph& graph = filter.Neighbors();
  filtered.resize(graph.NumberOfRows());
  std::atomic<std::size_t> kept{ 0 };
  filter.VisitWeights(fields, execution,
    [&](std::size_t i, const double* weights)
    {
      double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;
      Vec3 mean(0.0, 0.0, 0.0);
      double total = 0.0;
      auto vote = [&](std::size_t j)
      {
        const double w = *weights++;
        const Vec3& data = fields.Data[j];
        const Vec3 n =
          settings.RotateVotes && j != i ? RotatedVote(data, positions[j] - positions[i]) : data;
        const Vec3 wn = w * n;
        xx += wn[0] * n[0];
        xy += wn[0] * n[1];
        xz += wn[0] * n[2];
        yy += wn[1] * n[1];
        yz += wn[1] * n[2];
        zz += wn[2] * n[2];
        mean += w * data;
        total += w;
      };
      if (filter.IncludesOwn())
      {
        vote(i);
      }
      for (const Index j : graph.Row(i))
      {
        vote(j);
      }
      const Vec3& own = fields.Current[i];
      filtered[i] = own;
      Vec3 voted(0.0, 0.0, 0.0);
      if (total > NormalFilter::NoWeight)
      {
        Mat3 tensor;
        tensor << xx, xy, xz, xy, yy, yz, xz, yz, zz;
        voted = own.isZero(0.0) ? Vec3(mean / total) : Project(tensor / total, own, settings);
      }
      const double length = voted.norm();
      if (length > 1e-12)
      {
        filtered[i] = voted / length;
      }
      else
      {
        ++kept;
      }
    });
  return kept;
}

}
