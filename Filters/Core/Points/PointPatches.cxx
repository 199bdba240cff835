// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PointPatches.h"

namespace SurfaceDenoising
{

PointPatch JudgePatch(const std::vector<Vec3>& members)
{
  PointPatch patch;
  double largest = 0.0;
  double sum = 0.0;
  Vec3 mean(0.0, 0.0, 0.0);
  for (std::size_t a = 0; a < members.size(); ++a)
  {
    mean += members[a];
    for (std::size_t b = a + 1; b < members.size(); ++b)
    {
      const double difference = (members[a] - members[b]).norm();
      largest = std::max(largest, difference);
      sum += difference;
    }
  }
  const double length = mean.norm();
  if (length > 1e-12)
  {
    patch.Mean = mean / length;
    patch.Inconsistency = largest * largest / (1e-9 + sum);
  }
  return patch;
}

namespace
{

/// Rounding must not take opposite normals below -1, which stands for all.
bool Agree(double cosine, double least) { return std::max(cosine, -1.0) >= least; }

/// The normals of the patch of site j; none if that has no normal.
void CollectMembers(const NeighborGraph& graph, const Buffer<Vec3>& normals, std::size_t j,
  const PointPatchSettings& settings, std::vector<Vec3>& members)
{
  members.clear();
  const Vec3& centre = normals[j];
  if (centre.isZero(0.0))
  {
    return;
  }
  members.push_back(centre);
  const Span<Index> row = graph.Row(j);
  for (std::size_t k = 0; k < std::min(settings.Neighbors, row.size()); ++k)
  {
    const Vec3& n = normals[row[k]];
    const double cosine = n.dot(centre);
    const bool turned = settings.Unoriented && cosine < 0.0;
    if (!n.isZero(0.0) && Agree(turned ? -cosine : cosine, settings.MemberAgreement))
    {
      members.push_back(turned ? Vec3(-n) : n);
    }
  }
}

}

void ComputePointPatches(const NeighborGraph& graph, const Buffer<Vec3>& normals,
  const PointPatchSettings& settings, Buffer<Vec3>& guidance, Execution& execution)
{
  const std::size_t count = graph.NumberOfRows();
  Buffer<PointPatch> patches(count);
  execution.For(count,
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Vec3> members;
      for (std::size_t j = begin; j < end; ++j)
      {
        CollectMembers(graph, normals, j, settings, members);
        patches[j] = JudgePatch(members);
      }
    });
  guidance.resize(count);
  execution.For(count,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Vec3& n = normals[i];
        const PointPatch* best = &patches[i];
        double sign = 1.0;
        const Span<Index> row = graph.Row(i);
        for (std::size_t k = 0; k < std::min(settings.Neighbors, row.size()); ++k)
        {
          const double cosine = n.dot(normals[row[k]]);
          const bool agrees =
            Agree(settings.Unoriented ? std::abs(cosine) : cosine, settings.Agreement);
          if (agrees && patches[row[k]].Inconsistency < best->Inconsistency)
          {
            best = &patches[row[k]];
            sign = cosine < 0.0 ? -1.0 : 1.0;
          }
        }
        guidance[i] = best->Mean.isZero(0.0) ? n : Vec3(sign * best->Mean);
      }
    });
}

}
