// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Spikes.h"

#include "../OneStage/VertexRings.h"
#include "SpikeScores.h"

namespace SurfaceDenoising
{

namespace
{

/// Details of a coarse mesh hide many impulses, so that fewer than usual are very far off.
/// RepairSpikes sorts out Gaussian noise that comes as far.
constexpr double LeastVeryFar = 0.11;
/// The same details let what is left of the impulses look clustered.
constexpr double MostClustered = 1.6;

/// Returns false if the execution asked to stop. The mesh and the stars must outlive the sites.
bool FindSites(const TriangleMesh& mesh, const CompressedRows& stars, const EdgeCensus& edges,
  SpikeSites& sites, Execution& execution)
{
  sites.Unit = edges.MeanEdgeLength;
  sites.LeastVeryFar = LeastVeryFar;
  sites.MostClustered = MostClustered;
  sites.Counted.resize(mesh.NumberOfVertices());
  for (std::size_t v = 0; v < sites.Counted.size(); ++v)
  {
    sites.Counted[v] = stars.Row(v).size() > 0 && !edges.BoundaryVertex[v] ? 1 : 0;
  }
  sites.Beside = VertexRings(mesh, stars, execution);
  if (!execution.Proceed(0.0))
  {
    return false;
  }
  sites.Nearby = VerticesNearby(sites.Beside, execution);
  sites.Score = [&](const Buffer<unsigned char>& marks, Execution& host)
  { return ScoreSpikes(mesh, stars, sites.Beside, sites.Nearby, edges, marks, host); };
  return execution.Proceed(0.0);
}

}

Buffer<unsigned char> FindSpikes(const TriangleMesh& mesh, const CompressedRows& stars,
  Execution& execution)
{
  const EdgeCensus edges = TakeEdgeCensus(mesh, stars, execution);
  SpikeSites sites;
  return execution.Proceed(0.0) && FindSites(mesh, stars, edges, sites, execution)
    ? FindSpikes(sites, execution)
    : Buffer<unsigned char>(mesh.NumberOfVertices(), 0);
}

bool FindImpulses(const TriangleMesh& mesh, const CompressedRows& stars,
  Buffer<unsigned char>& marks, Execution& execution)
{
  const EdgeCensus edges = TakeEdgeCensus(mesh, stars, execution);
  SpikeSites sites;
  return execution.Proceed(0.0) && FindSites(mesh, stars, edges, sites, execution) &&
    FindImpulses(sites, marks, execution);
}

}
