// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Spikes.h"

#include "../OneStage/VertexRings.h"
#include "SpikeScores.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

constexpr int Rounds = 5;
/// What is far, in what is usual around a vertex: large spikes are found first.
constexpr double Far[Rounds] = { 4.0, 3.0, 3.0, 2.5, 2.5 };
constexpr double VeryFar = 8.0;
/// Whatever is usual, in mean edge lengths.
constexpr double LeastHeight = 0.05;
/// Of impulsive noise: spikes among the vertices, and those very far off among the spikes.
constexpr double LeastShare = 0.01;
constexpr double LeastVeryFar = 0.15;
/// Rows of features are clustered by more than that, impulses hardly: those that are missed are in
/// rough places, and an impulse may let its neighbour look like one.
constexpr double MostClustered = 1.4;

class SpikeSearch
{
public:
  SpikeSearch(const TriangleMesh& mesh, const CompressedRows& stars, Execution& execution)
    : Mesh(mesh)
    , Stars(stars)
    , Host(execution)
    , Edges(TakeEdgeCensus(mesh, stars, execution))
    , Rings(VertexRings(mesh, stars, execution))
    , Nearby(VerticesNearby(Rings, execution))
    , Marks(mesh.NumberOfVertices(), 0)
  {
  }

  /// Marks anew what is far without the marks so far. What has no score keeps its mark.
  void Run(int round)
  {
    const SpikeScores scores = ScoreSpikes(this->Mesh, this->Stars, this->Rings, this->Nearby,
      this->Edges, this->Marks, this->Host);
    this->Inside = this->Spikes = this->VeryFarSpikes = 0;
    for (std::size_t v = 0; v < this->Marks.size(); ++v)
    {
      if (!this->IsInside(v))
      {
        continue;
      }
      const double ratio = scores.Ratios[v];
      if (std::isfinite(ratio))
      {
        const bool high = scores.Heights[v] > LeastHeight * this->Edges.MeanEdgeLength;
        this->Marks[v] = high && ratio > Far[round] ? 1 : 0;
      }
      ++this->Inside;
      this->Spikes += this->Marks[v];
      this->VeryFarSpikes += this->Marks[v] && ratio > VeryFar ? 1 : 0;
    }
  }

  bool HasHeavyTails() const
  {
    return this->Spikes > 0 && double(this->Spikes) >= LeastShare * double(this->Inside) &&
      double(this->VeryFarSpikes) >= LeastVeryFar * double(this->Spikes);
  }

  /// Whether spikes say nothing about the vertices one and two rings away.
  bool IsScattered() const
  {
    const double share = double(this->Spikes) / double(std::max<std::size_t>(this->Inside, 1));
    std::size_t vertices[2] = { 0, 0 };
    std::size_t spikes[2] = { 0, 0 };
    for (std::size_t v = 0; v < this->Marks.size(); ++v)
    {
      for (const Index w : this->Marks[v] ? this->Nearby.Row(v) : Span<Index>())
      {
        if (this->IsInside(w))
        {
          const Span<Index> ring = this->Rings.Row(v);
          const int apart = std::find(ring.begin(), ring.end(), w) == ring.end() ? 1 : 0;
          ++vertices[apart];
          spikes[apart] += this->Marks[w];
        }
      }
    }
    for (const int apart : { 0, 1 })
    {
      const double expected = share * double(vertices[apart]);
      // Pairs are counted from both ends: the variance of the count is twice its expectation.
      if (double(spikes[apart]) > MostClustered * expected + std::sqrt(2.0 * expected))
      {
        return false;
      }
    }
    return true;
  }

  Buffer<unsigned char>& Found() { return this->Marks; }

private:
  bool IsInside(std::size_t v) const
  {
    return this->Stars.Row(v).size() > 0 && !this->Edges.BoundaryVertex[v];
  }

  const TriangleMesh& Mesh;
  const CompressedRows& Stars;
  Execution& Host;
  const EdgeCensus Edges;
  const CompressedRows Rings;
  const CompressedRows Nearby;
  Buffer<unsigned char> Marks;
  std::size_t Inside = 0;
  std::size_t Spikes = 0;
  std::size_t VeryFarSpikes = 0;
};

}

Buffer<unsigned char> FindSpikes(const TriangleMesh& mesh, const CompressedRows& stars,
  Execution& execution)
{
  SpikeSearch search(mesh, stars, execution);
  search.Run(0);
  return std::move(search.Found());
}

bool FindImpulses(const TriangleMesh& mesh, const CompressedRows& stars,
  Buffer<unsigned char>& marks, Execution& execution)
{
  SpikeSearch search(mesh, stars, execution);
  search.Run(0);
  if (!search.HasHeavyTails())
  {
    return false;
  }
  search.Run(1);
  if (!search.IsScattered())
  {
    return false;
  }
  for (int round = 2; round < Rounds; ++round)
  {
    search.Run(round);
  }
  marks = std::move(search.Found());
  return true;
}

}
