// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VertexFilling.h"

#include "../Methods.h"

namespace SurfaceDenoising
{

namespace
{

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

bool FillVertices(TriangleMesh& mesh, const CompressedRows& stars, const CompressedRows& rings,
  const EdgeCensus& edges, const Buffer<unsigned char>& fixed, Execution& execution)
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
    const double done = double(outer) / OuterIterations;
    const double next = double(outer + 1) / OuterIterations;
    normals.clear();
    if (!filter.Renew(normals, execution, done) ||
      !filter.Run(normals, {}, execution, done, next) ||
      !update.Run(mesh.Positions, normals, 2, execution, next, next))
    {
      return false;
    }
  }
  return true;
}

}
