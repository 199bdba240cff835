// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
// The spanning tree of OrientNormals.

#include "InterruptedLoops.h"
#include "PointNormals.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// Sets of points that grow together, and whether the normal of a point agrees with that of the
/// first of its set.
class SignedSets
{
public:
  explicit SignedSets(std::size_t count)
    : Parents(count)
    , Opposed(count, 0)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Parents[i] = static_cast<Index>(i);
    }
  }

  /// The first of the set; opposed tells about the normal of i.
  Index Find(Index i, unsigned char& opposed)
  {
    Index root = i;
    opposed = 0;
    while (this->Parents[root] != root)
    {
      opposed ^= this->Opposed[root];
      root = this->Parents[root];
    }
    // Shorten the way for the next time.
    unsigned char sign = opposed;
    while (this->Parents[i] != root && i != root)
    {
      const Index next = this->Parents[i];
      const unsigned char step = this->Opposed[i];
      this->Parents[i] = root;
      this->Opposed[i] = sign;
      sign ^= step;
      i = next;
    }
    return root;
  }

  /// Unites the sets of i and j, if they are two, so that their normals are opposed or not.
  void Unite(Index i, Index j, unsigned char opposed)
  {
    unsigned char signI = 0;
    unsigned char signJ = 0;
    const Index a = this->Find(i, signI);
    const Index b = this->Find(j, signJ);
    if (a != b)
    {
      this->Parents[std::max(a, b)] = std::min(a, b);
      this->Opposed[std::max(a, b)] = signI ^ signJ ^ opposed;
    }
  }

private:
  Buffer<Index> Parents;
  Buffer<unsigned char> Opposed; ///< to the normal of the parent
};

/// Steps of sqrt(1 - |n_i . n_j|) that are told apart.
constexpr std::size_t Levels = 1 << 16;

std::size_t LevelOf(const Vec3& m, const Vec3& n)
{
  const double length = std::sqrt(std::max(0.0, 1.0 - std::abs(m.dot(n))));
  return std::min(static_cast<std::size_t>(length * static_cast<double>(Levels)), Levels - 1);
}

/// Positions of the entries of the graph, shortest edge first, equally short ones as they come.
/// Returns false if the execution asked to stop.
bool SortEdges(const NeighborGraph& graph, const Buffer<Vec3>& normals, const Buffer<Index>& rowOf,
  Buffer<std::uint64_t>& sorted, Execution& execution, double fraction)
{
  std::vector<std::uint64_t> starts(Levels + 1, 0);
  const std::size_t edges = graph.NumberOfIds();
  auto levelOf = [&](std::size_t e) { return LevelOf(normals[rowOf[e]], normals[graph.Ids[e]]); };
  if (!ForInOrder(
        edges, [&](std::size_t e) { ++starts[levelOf(e) + 1]; }, execution, fraction))
  {
    return false;
  }
  for (std::size_t level = 0; level < Levels; ++level)
  {
    starts[level + 1] += starts[level];
  }
  sorted.resize(edges);
  // The first edges go everywhere: without this they would wait for the pages of all the memory.
  InterruptedExecution interrupted(execution, fraction);
  interrupted.For(
    edges,
    [&](std::size_t begin, std::size_t end)
    { std::fill(sorted.begin() + begin, sorted.begin() + end, std::uint64_t(0)); },
    4096);
  return interrupted.Proceed(fraction) &&
    ForInOrder(
      edges, [&](std::size_t e) { sorted[starts[levelOf(e)]++] = e; }, execution, fraction);
}

/// What decides where a connected part points.
struct Part
{
  Vec3 Sum = Vec3(0.0, 0.0, 0.0);
  std::size_t Count = 0;
  double Outwards = 0.0; ///< sum n . (p - c)
  double Size = 0.0;     ///< sum |p - c|
  Index Highest = NoIndex;
};

}

std::size_t OrientNormals(const Buffer<Vec3>& points, const NeighborGraph& graph,
  Buffer<Vec3>& normals, Execution& execution, double fraction)
{
  const std::size_t count = points.size();
  Buffer<Index> rowOf(graph.NumberOfIds());
  auto numberRow = [&](std::size_t i)
  {
    std::fill(rowOf.begin() + graph.Offsets[i], rowOf.begin() + graph.Offsets[i + 1],
      static_cast<Index>(i));
  };
  SignedSets sets(count);
  Buffer<std::uint64_t> edges;
  auto unite = [&](std::size_t k)
  {
    const Index i = rowOf[edges[k]];
    const Index j = graph.Ids[edges[k]];
    if (!normals[i].isZero(0.0) && !normals[j].isZero(0.0))
    {
      sets.Unite(i, j, normals[i].dot(normals[j]) < 0.0);
    }
  };
  if (!ForInOrder(count, numberRow, execution, fraction) ||
    !SortEdges(graph, normals, rowOf, edges, execution, fraction) ||
    !ForInOrder(edges.size(), unite, execution, fraction))
  {
    return 0;
  }

  Buffer<Index> partOf(count);
  std::vector<Part> parts;
  Buffer<Index> numberOf(count, NoIndex);
  for (std::size_t i = 0; i < count; ++i)
  {
    unsigned char opposed = 0;
    const Index root = sets.Find(static_cast<Index>(i), opposed);
    if (opposed)
    {
      normals[i] = -normals[i];
    }
    if (numberOf[root] == NoIndex)
    {
      numberOf[root] = static_cast<Index>(parts.size());
      parts.emplace_back();
    }
    Part& part = parts[partOf[i] = numberOf[root]];
    part.Sum += points[i];
    ++part.Count;
    if (part.Highest == NoIndex || points[i][2] > points[part.Highest][2])
    {
      part.Highest = static_cast<Index>(i);
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    Part& part = parts[partOf[i]];
    const Vec3 arm = points[i] - part.Sum / static_cast<double>(part.Count);
    part.Outwards += normals[i].dot(arm);
    part.Size += arm.norm();
  }
  std::vector<bool> turned;
  for (const Part& part : parts)
  {
    const bool hasInside = std::abs(part.Outwards) > 0.05 * part.Size;
    turned.push_back(hasInside ? part.Outwards < 0.0 : normals[part.Highest][2] < 0.0);
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    if (turned[partOf[i]])
    {
      normals[i] = -normals[i];
    }
  }
  return parts.size();
}

}
