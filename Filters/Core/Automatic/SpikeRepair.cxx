// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SpikeRepair.h"

#include "../Methods.h"
#include "../Metrics.h"
#include "../OneStage/VertexRings.h"
#include "Spikes.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// Steps towards the middle of the neighbours: spikes side by side wait for one another.
constexpr int FillSteps = 20;
constexpr int OuterIterations = 15;
/// How much of the roughness at spikes, above that beside them, may be left.
constexpr double MostLeft = 0.5;

/// Vertices that do not move are marked with 1, the others become the means of their neighbours.
void FillIn(Buffer<Vec3>& positions, const CompressedRows& rings,
  const Buffer<unsigned char>& fixed, Execution& execution)
{
  Buffer<Vec3> moved = positions;
  for (int step = 0; step < FillSteps; ++step)
  {
    execution.For(positions.size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t v = begin; v < end; ++v)
        {
          if (!fixed[v] && rings.Row(v).size() > 0)
          {
            Vec3 sum(0.0, 0.0, 0.0);
            for (const Index w : rings.Row(v))
            {
              sum += positions[w];
            }
            moved[v] = sum / double(rings.Row(v).size());
          }
        }
      });
    positions.swap(moved);
  }
}

/// The settings that sort faces into sides, see CandidateChains.
FaceFilterSettings WideSettings()
{
  FaceFilterSettings settings = SettingsOf(Method::TukeyBilateralNormal);
  settings.NormScale = 1.0;
  return settings;
}

/// Mean angles between faces, in degrees.
struct Roughness
{
  double Repaired = 0.0; ///< over the edges of the faces that move
  double Beside = 0.0;   ///< over the other edges of faces next to these
};

Roughness RoughnessOf(const TriangleMesh& mesh, const NeighborGraph& edgeAdjacent,
  const CompressedRows& rings, const Buffer<unsigned char>& fixed, Execution& execution)
{
  // 2 for faces that move, 1 for those next to them, else 0.
  Buffer<unsigned char> kinds(mesh.NumberOfFaces(), 0);
  execution.For(kinds.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t f = begin; f < end; ++f)
      {
        for (const Index v : mesh.Triangles[f])
        {
          const Span<Index> ring = rings.Row(v);
          const bool beside =
            std::any_of(ring.begin(), ring.end(), [&](Index w) { return !fixed[w]; });
          kinds[f] = std::max<unsigned char>(kinds[f], !fixed[v] ? 2 : beside ? 1 : 0);
        }
      }
    });
  using Sums = Eigen::Array4d;
  const Sums sums = OrderedSum(execution, kinds.size(), Sums(Sums::Zero()),
    [&](std::size_t f)
    {
      Sums sum = Sums::Zero();
      for (const Index g : edgeAdjacent.Row(f))
      {
        const unsigned char kind = std::max(kinds[f], kinds[g]);
        const double angle = AngleBetween(mesh.DoubleAreaVector(f), mesh.DoubleAreaVector(g));
        if (kind > 0 && std::isfinite(angle))
        {
          sum[2 * (kind - 1)] += angle;
          sum[2 * (kind - 1) + 1] += 1.0;
        }
      }
      return sum;
    });
  return { sums[2] / std::max(1.0, sums[3]), sums[0] / std::max(1.0, sums[1]) };
}

}

bool RepairSpikes(TriangleMesh& mesh, const CompressedRows& stars, const EdgeCensus& edges,
  std::size_t& repaired, Execution& execution)
{
  repaired = 0;
  Buffer<unsigned char> fixed;
  if (!FindImpulses(mesh, stars, fixed, execution))
  {
    return execution.Proceed(1.0);
  }
  std::size_t moved = 0;
  for (unsigned char& mark : fixed)
  {
    moved += mark;
    mark = mark ? 0 : 1;
  }
  const CompressedRows rings = VertexRings(mesh, stars, execution);
  const NeighborGraph edgeAdjacent = EdgeAdjacentFaces(mesh, stars, execution);
  const Roughness before = RoughnessOf(mesh, edgeAdjacent, rings, fixed, execution);
  const Buffer<Vec3> input = mesh.Positions;
  FillIn(mesh.Positions, rings, fixed, execution);
  const FaceFilterSettings settings = WideSettings();
  FaceFilterReport report;
  FaceFilter filter(mesh, stars, edges.BoundaryVertex, edges.MeanEdgeLength, settings, report);
  // Vertices at boundaries stay where they are; here all that are no spikes do.
  const VertexUpdateSettings vertices;
  VertexUpdate update(mesh, stars, fixed, edges.MeanEdgeLength, vertices);
  Buffer<Vec3> normals;
  for (int outer = 0; outer < OuterIterations; ++outer)
  {
    const double done = double(outer) / OuterIterations;
    const double next = double(outer + 1) / OuterIterations;
    normals.clear();
    filter.Renew(normals, execution);
    if (!filter.Run(normals, {}, execution, done, next) ||
      !update.Run(mesh.Positions, normals, 2, execution, next, next))
    {
      return false;
    }
  }
  const Roughness after = RoughnessOf(mesh, edgeAdjacent, rings, fixed, execution);
  if (after.Repaired - before.Beside < MostLeft * (before.Repaired - before.Beside))
  {
    repaired = moved;
  }
  else
  {
    mesh.Positions = input;
  }
  return execution.Proceed(1.0);
}

}
