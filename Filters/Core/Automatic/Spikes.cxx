// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Spikes.h"

#include "../Metrics.h"
#include "../OneStage/VertexRings.h"
#include "../RobustScale.h"

#include <cmath>
#include <limits>

namespace SurfaceDenoising
{

namespace
{

constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();

/// Around a vertex of more faces than that, everything looks like a spike.
constexpr std::size_t MostFaces = 400;

}

Buffer<unsigned char> FindSpikes(const TriangleMesh& mesh, const CompressedRows& stars,
  Execution& execution, double least, double medians)
{
  const std::size_t count = mesh.NumberOfVertices();
  const EdgeCensus census = TakeEdgeCensus(mesh, stars, execution);
  FaceGeometry geometry;
  ComputeFaceGeometry(mesh, census.MeanEdgeLength, geometry, execution);
  Buffer<double> distances(count);
  execution.For(
    count,
    [&](std::size_t begin, std::size_t end)
    {
      Buffer<double> heights;
      std::vector<Index> faces;
      for (std::size_t i = begin; i < end; ++i)
      {
        const Index v = static_cast<Index>(i);
        faces.clear();
        distances[v] = Unknown;
        if (stars.Row(v).size() > MostFaces)
        {
          continue;
        }
        for (const Index f : stars.Row(v))
        {
          for (const Index w : mesh.Triangles[f])
          {
            const Span<Index> star = stars.Row(w);
            faces.insert(faces.end(), star.begin(), star.end());
          }
        }
        std::sort(faces.begin(), faces.end());
        faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
        heights.clear();
        for (const Index f : faces)
        {
          if (!HasCorner(mesh.Triangles[f], v) && geometry.Areas[f] > 0.0)
          {
            heights.push_back(
              std::abs(geometry.Normals[f].dot(mesh.Positions[v] - geometry.Centroids[f])));
          }
        }
        if (heights.size() >= 4)
        {
          distances[v] = Percentile(heights, 0.15);
        }
      }
    },
    256);
  Buffer<double> values;
  std::copy_if(distances.begin(), distances.end(), std::back_inserter(values),
    [](double value) { return std::isfinite(value); });
  const double limit = std::max(medians * Median(values), least * census.MeanEdgeLength);
  Buffer<unsigned char> spikes(count);
  for (std::size_t v = 0; v < count; ++v)
  {
    spikes[v] = distances[v] > limit ? 1 : 0;
  }
  return spikes;
}

bool AreImpulses(const TriangleMesh& mesh, const CompressedRows& stars,
  const Buffer<unsigned char>& spikes, Execution& execution)
{
  const CompressedRows rings = VertexRings(mesh, stars, execution);
  std::size_t used = 0;
  std::size_t count = 0;
  std::size_t neighbors = 0;
  std::size_t both = 0;
  for (std::size_t v = 0; v < spikes.size(); ++v)
  {
    used += stars.Row(v).size() > 0 ? 1 : 0;
    if (spikes[v])
    {
      ++count;
      neighbors += rings.Row(v).size();
      for (const Index w : rings.Row(v))
      {
        both += spikes[w];
      }
    }
  }
  if (used == 0 || neighbors == 0)
  {
    return false;
  }
  const Buffer<unsigned char> large = FindSpikes(mesh, stars, execution, 0.1, 8.0);
  if (double(std::count(large.begin(), large.end(), 1)) < 0.1 * double(count))
  {
    return false;
  }
  const double share = double(count) / double(used);
  return share > 0.022 && double(both) / double(neighbors) < 0.03 + 2.0 * share;
}

}
