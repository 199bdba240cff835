// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SpikeRepair.h"

#include "../InterruptedExecution.h"
#include "../Metrics.h"
#include "../OneStage/VertexRings.h"
#include "MeshSample.h"
#include "ProgressShare.h"
#include "SpikeScores.h"
#include "Spikes.h"
#include "VertexFilling.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// What this share of the others around a vertex misses less than, is usual.
constexpr double UsualMiss = 0.75;
/// How much farther vertices that were out of place must have moved than others would.
constexpr double LeastFarther = 3.0;
/// How much more faces of vertices that were out of place must have turned than others would.
/// Errors are less from sqrt(2) on, if what is made up is wrong by as much as the trial says.
constexpr double LeastGain = 2.0;
/// Enough for the fraction of a length to have nothing to do with that of the next, few enough for
/// rounding errors not to matter.
constexpr double Digits = 1e4;

/// Numbers at random, in [0, 1), that belong to the places: they stay the same if the mesh is
/// turned, moved, scaled or numbered anew.
Buffer<double> Lots(const TriangleMesh& mesh, const CompressedRows& rings, const EdgeCensus& edges,
  Execution& execution)
{
  const std::size_t count = mesh.NumberOfVertices();
  const Vec3 middle = MiddleOf(mesh, execution);
  Buffer<double> lots(count);
  execution.For(count,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t v = begin; v < end; ++v)
      {
        double length = (mesh.Positions[v] - middle).norm();
        for (const Index w : rings.Row(v))
        {
          length += (mesh.Positions[w] - mesh.Positions[v]).norm();
        }
        const double digits = Digits * length / edges.MeanEdgeLength;
        lots[v] = digits - std::floor(digits);
      }
    });
  return lots;
}

/// Marks fixed vertices within two rings of those that are not, no two beside one another, with 0
/// and all others with 1.
Buffer<unsigned char> ChooseControls(const TriangleMesh& mesh, const CompressedRows& rings,
  const EdgeCensus& edges, const Buffer<unsigned char>& fixed, Execution& execution)
{
  const std::size_t count = mesh.NumberOfVertices();
  Buffer<unsigned char> beside(count);
  Buffer<unsigned char> others(count);
  const Buffer<double> lots = Lots(mesh, rings, edges, execution);
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
        const bool near = std::any_of(ring.begin(), ring.end(), [&](Index w) { return beside[w]; });
        const bool lost = std::any_of(ring.begin(), ring.end(),
          [&](Index w) { return fixed[w] && lots[w] >= lots[v]; });
        others[v] = fixed[v] && !edges.BoundaryVertex[v] && near && !lost ? 0 : 1;
      }
    });
  return others;
}

/// How far the vertices that are not fixed have moved along their normals; 0 for the others.
Buffer<double> Moved(const TriangleMesh& mesh, const CompressedRows& stars,
  const Buffer<Vec3>& before, const Buffer<unsigned char>& fixed, Execution& execution)
{
  const Buffer<Vec3> normals = VertexAreaVectors(mesh, stars, execution);
  Buffer<double> heights(fixed.size(), 0.0);
  for (std::size_t v = 0; v < fixed.size(); ++v)
  {
    if (!fixed[v])
    {
      heights[v] = std::abs(normals[v].stableNormalized().dot(mesh.Positions[v] - before[v]));
    }
  }
  return heights;
}

/// Mean angle by which the faces of vertices that are not fixed have turned, 0 without any.
double Turned(const TriangleMesh& mesh, const Buffer<Vec3>& before,
  const Buffer<unsigned char>& fixed)
{
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    const Triangle& t = mesh.Triangles[f];
    if (!fixed[t[0]] || !fixed[t[1]] || !fixed[t[2]])
    {
      const Vec3 old = (before[t[1]] - before[t[0]]).cross(before[t[2]] - before[t[0]]);
      const double angle = AngleBetween(mesh.DoubleAreaVector(f), old);
      if (std::isfinite(angle))
      {
        sum += angle;
        ++count;
      }
    }
  }
  return count > 0 ? sum / double(count) : 0.0;
}

/// What 90% of the heights of vertices that are not fixed stay below, 0 without any.
double LargeHeight(const Buffer<double>& heights, const Buffer<unsigned char>& fixed)
{
  Buffer<double> values;
  for (std::size_t v = 0; v < fixed.size(); ++v)
  {
    if (!fixed[v])
    {
      values.push_back(heights[v]);
    }
  }
  return values.empty() ? 0.0 : Percentile(values, 0.9);
}

/// What is made up for a vertex is better than where it is only if the vertex moves farther than
/// others around it would, although these are in place. Fixes those that do not, returns the rest.
std::size_t KeepOutstanding(Buffer<unsigned char>& fixed, const Buffer<double>& moved,
  const Buffer<unsigned char>& others, const Buffer<double>& missed, const CompressedRows& rings,
  const CompressedRows& nearby, Execution& execution)
{
  execution.For(
    fixed.size(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Index> around;
      Buffer<double> heights;
      for (std::size_t v = begin; v < end; ++v)
      {
        if (fixed[v])
        {
          continue;
        }
        around.clear();
        for (const Index w : nearby.Row(v))
        {
          const Span<Index> ring = rings.Row(w);
          std::copy_if(ring.begin(), ring.end(), std::back_inserter(around),
            [&](Index u) { return !others[u]; });
        }
        std::sort(around.begin(), around.end());
        around.erase(std::unique(around.begin(), around.end()), around.end());
        heights.clear();
        std::transform(around.begin(), around.end(), std::back_inserter(heights),
          [&](Index u) { return missed[u]; });
        const bool far = !heights.empty() && moved[v] > Percentile(heights, UsualMiss);
        fixed[v] = far ? 0 : 1;
      }
    },
    256);
  return std::size_t(std::count(fixed.begin(), fixed.end(), 0));
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
  for (unsigned char& mark : fixed)
  {
    mark = mark ? 0 : 1;
  }
  const CompressedRows rings = VertexRings(mesh, stars, execution);
  const CompressedRows nearby = VerticesNearby(rings, execution);
  const Buffer<Vec3> input = mesh.Positions;
  std::size_t spikes = 0;
  bool far = false;
  bool turned = false;
  for (const double done : { 0.0, 0.5 })
  {
    mesh.Positions = input;
    ProgressShare first(execution, done, done + 0.25);
    if (!FillVertices(mesh, stars, rings, edges, fixed, first))
    {
      return false;
    }
    TriangleMesh trial = mesh;
    const Buffer<unsigned char> others = ChooseControls(mesh, rings, edges, fixed, execution);
    ProgressShare second(execution, done + 0.25, done + 0.5);
    if (!FillVertices(trial, stars, rings, edges, others, second))
    {
      return false;
    }
    const Buffer<double> moved = Moved(mesh, stars, input, fixed, execution);
    const Buffer<double> missed = Moved(trial, stars, mesh.Positions, others, execution);
    far = far || LargeHeight(moved, fixed) > LeastFarther * LargeHeight(missed, others);
    turned = Turned(mesh, input, fixed) > LeastGain * Turned(trial, mesh.Positions, others);
    if (done == 0.0)
    {
      spikes = KeepOutstanding(fixed, moved, others, missed, rings, nearby, execution);
    }
  }
  if (far && turned)
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
