// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SpikeRepair.h"

#include "../Methods.h"
#include "../OneStage/VertexRings.h"
#include "Spikes.h"

namespace SurfaceDenoising
{

namespace
{

constexpr int Rounds = 3;
/// What counts as a spike in each round, in mean edge lengths: large ones hide small ones.
constexpr double Least[Rounds] = { 0.1, 0.07, 0.05 };
/// Steps towards the middle of the neighbours: spikes side by side wait for one another.
constexpr int FillSteps = 20;
constexpr int OuterIterations = 15;

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

}

bool RepairSpikes(TriangleMesh& mesh, const CompressedRows& stars, const EdgeCensus& edges,
  std::size_t& repaired, Execution& execution)
{
  repaired = 0;
  const CompressedRows rings = VertexRings(mesh, stars, execution);
  const FaceFilterSettings settings = WideSettings();
  Buffer<unsigned char> fixed(mesh.NumberOfVertices(), 1);
  for (int round = 0; round < Rounds; ++round)
  {
    const Buffer<unsigned char> spikes = FindSpikes(mesh, stars, execution, Least[round]);
    if (round == 0 && !AreImpulses(mesh, stars, spikes, execution))
    {
      return execution.Proceed(1.0);
    }
    std::size_t found = 0;
    for (std::size_t v = 0; v < spikes.size(); ++v)
    {
      if (spikes[v] && fixed[v] && !edges.BoundaryVertex[v])
      {
        fixed[v] = 0;
        ++found;
      }
    }
    if (found == 0)
    {
      break;
    }
    repaired += found;
    FillIn(mesh.Positions, rings, fixed, execution);
    FaceFilterReport report;
    FaceFilter filter(mesh, stars, edges.BoundaryVertex, edges.MeanEdgeLength, settings, report);
    // Vertices at boundaries stay where they are; here all that are no spikes do.
    const VertexUpdateSettings vertices;
    VertexUpdate update(mesh, stars, fixed, edges.MeanEdgeLength, vertices);
    Buffer<Vec3> normals;
    for (int outer = 0; outer < OuterIterations; ++outer)
    {
      const double done = (round + double(outer) / OuterIterations) / Rounds;
      const double next = (round + double(outer + 1) / OuterIterations) / Rounds;
      normals.clear();
      filter.Renew(normals, execution);
      if (!filter.Run(normals, {}, execution, done, next) ||
        !update.Run(mesh.Positions, normals, 2, execution, next, next))
      {
        return false;
      }
    }
  }
  return execution.Proceed(1.0);
}

}
