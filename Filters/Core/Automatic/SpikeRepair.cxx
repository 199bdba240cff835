// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SpikeRepair.h"

#include "../InterruptedExecution.h"
#include "../Methods.h"
#include "../Metrics.h"
#include "../OneStage/VertexRings.h"
#include "Spikes.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace SurfaceDenoising
{

namespace
{

/// Steps towards the middle of the neighbours: spikes side by side wait for one another.
constexpr int FillSteps = 20;
constexpr int OuterIterations = 15;
/// How much farther vertices that were out of place must have moved than others would.
constexpr double LeastGain = 3.0;

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

/// Makes up positions for the vertices that are not fixed.
bool MakeUp(TriangleMesh& mesh, const CompressedRows& stars, const CompressedRows& rings,
  const EdgeCensus& edges, const Buffer<unsigned char>& fixed, Execution& execution, double first,
  double last)
{
  FillIn(mesh.Positions, rings, fixed, execution);
  const FaceFilterSettings settings = WideSettings();
  FaceFilterReport report;
  FaceFilter filter(mesh, stars, edges.BoundaryVertex, edges.MeanEdgeLength, settings, report);
  // Vertices at boundaries stay where they are; here all that are fixed do.
  const VertexUpdateSettings vertices;
  VertexUpdate update(mesh, stars, fixed, edges.MeanEdgeLength, vertices);
  Buffer<Vec3> normals;
  for (int outer = 0; outer < OuterIterations; ++outer)
  {
    const double done = first + (last - first) * outer / OuterIterations;
    const double next = first + (last - first) * (outer + 1) / OuterIterations;
    normals.clear();
    filter.Renew(normals, execution);
    if (!filter.Run(normals, {}, execution, done, next) ||
      !update.Run(mesh.Positions, normals, 2, execution, next, next))
    {
      return false;
    }
  }
  return true;
}

/// A number at random that belongs to the place and to nothing else.
std::uint64_t Lot(const Vec3& position)
{
  std::uint64_t lot = 0;
  for (int k = 0; k < 3; ++k)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &position[k], sizeof(bits));
    lot = (lot ^ bits) * 0x9E3779B97F4A7C15u;
    lot ^= lot >> 29;
  }
  return lot;
}

/// Marks fixed vertices within two rings of those that are not, no two beside one another, with 0
/// and all others with 1.
Buffer<unsigned char> ChooseControls(const TriangleMesh& mesh, const CompressedRows& rings,
  const EdgeCensus& edges, const Buffer<unsigned char>& fixed, Execution& execution)
{
  const std::size_t count = mesh.NumberOfVertices();
  Buffer<unsigned char> beside(count);
  Buffer<unsigned char> others(count);
  execution.For(count,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t v = begin; v < end; ++v)
      {
        const Span<Index> ring = rings.Row(v);
        beside[v] = std::any_of(ring.begin(), ring.end(), [&](Index w) { return !fixed[w]; });
      }
    });
  execution.For(count,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t v = begin; v < end; ++v)
      {
        const Span<Index> ring = rings.Row(v);
        const std::uint64_t lot = Lot(mesh.Positions[v]);
        const bool near = std::any_of(ring.begin(), ring.end(), [&](Index w) { return beside[w]; });
        const bool lost = std::any_of(ring.begin(), ring.end(),
          [&](Index w) { return fixed[w] && Lot(mesh.Positions[w]) >= lot; });
        others[v] = fixed[v] && !edges.BoundaryVertex[v] && near && !lost ? 0 : 1;
      }
    });
  return others;
}

/// How far the vertices that are not fixed have moved along their normals: what 90% stay below.
double Moved(const TriangleMesh& mesh, const CompressedRows& stars, const Buffer<Vec3>& before,
  const Buffer<unsigned char>& fixed)
{
  Buffer<double> heights;
  for (std::size_t v = 0; v < fixed.size(); ++v)
  {
    if (!fixed[v])
    {
      Vec3 normal(0.0, 0.0, 0.0);
      for (const Index f : stars.Row(v))
      {
        normal += mesh.DoubleAreaVector(f);
      }
      heights.push_back(std::abs(normal.stableNormalized().dot(mesh.Positions[v] - before[v])));
    }
  }
  return heights.empty() ? std::numeric_limits<double>::infinity() : Percentile(heights, 0.9);
}

}

bool RepairSpikes(TriangleMesh& mesh, const CompressedRows& stars, const EdgeCensus& edges,
  std::size_t& repaired, Execution& execution)
{
  repaired = 0;
  Buffer<unsigned char> fixed;
  InterruptedExecution searching(execution, 0.0);
  const bool found = FindImpulses(mesh, stars, fixed, searching);
  if (!searching.Proceed(0.0))
  {
    return false;
  }
  if (!found)
  {
    return execution.Proceed(1.0);
  }
  std::size_t spikes = 0;
  for (unsigned char& mark : fixed)
  {
    spikes += mark;
    mark = mark ? 0 : 1;
  }
  const CompressedRows rings = VertexRings(mesh, stars, execution);
  const Buffer<Vec3> input = mesh.Positions;
  if (!MakeUp(mesh, stars, rings, edges, fixed, execution, 0.0, 0.5))
  {
    return false;
  }
  TriangleMesh trial = mesh;
  const Buffer<unsigned char> others = ChooseControls(mesh, rings, edges, fixed, execution);
  if (!MakeUp(trial, stars, rings, edges, others, execution, 0.5, 1.0))
  {
    return false;
  }
  if (Moved(mesh, stars, input, fixed) > LeastGain * Moved(trial, stars, mesh.Positions, others))
  {
    repaired = spikes;
  }
  else
  {
    mesh.Positions = input;
  }
  return execution.Proceed(1.0);
}

}
