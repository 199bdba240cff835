// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReleasedTukeyBilateral.h"

#include "NeighborGraph.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// Sums are taken to be nothing below this, whatever the size of the model.
constexpr double Nothing = 1e-10;

/// Mean distance to three adjacent centroids; those that are missing count as 0.
Buffer<double> Spacings(const NeighborGraph& adjacent, const Buffer<Vec3>& centroids)
{
  Buffer<double> spacings(centroids.size());
  for (std::size_t f = 0; f < spacings.size(); ++f)
  {
    double sum = 0.0;
    for (const Index g : adjacent.Row(f))
    {
      sum += (centroids[f] - centroids[g]).norm();
    }
    spacings[f] = sum / 3.0;
  }
  return spacings;
}

double Mean(const Buffer<double>& values, Execution& execution)
{
  const double sum =
    OrderedSum(execution, values.size(), 0.0, [&values](std::size_t i) { return values[i]; });
  return sum / static_cast<double>(values.size());
}

void FilterNormals(const NeighborGraph& graph, const FaceGeometry& geometry,
  const Buffer<double>& spacings, double rangeScale, const Buffer<Vec3>& normals,
  Buffer<Vec3>& filtered, Execution& execution)
{
  filtered.resize(normals.size());
  execution.For(normals.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t f = begin; f < end; ++f)
      {
        Vec3 sum(0.0, 0.0, 0.0);
        for (const Index g : graph.Row(f))
        {
          const double chordSquare = (normals[f] - normals[g]).squaredNorm();
          if (std::sqrt(chordSquare) <= rangeScale)
          {
            const double distanceSquare =
              (geometry.Centroids[f] - geometry.Centroids[g]).squaredNorm();
            const double similar = (1.0 - chordSquare) * (1.0 - chordSquare);
            sum += geometry.Areas[g] *
              std::exp(-distanceSquare / (2.0 * spacings[f] * spacings[f])) * similar * normals[g];
          }
        }
        // Not a number around a face stored twice, which is at distance 0 from itself.
        const double length = sum.norm();
        filtered[f] = length >= Nothing ? Vec3(sum / length) : Vec3(0.0, 0.0, 1.0);
      }
    });
}

/// Where vertex v goes; common is the mean normal of the last vertex.
Vec3 Moved(const TriangleMesh& mesh, Span<Index> star, Index v, const Buffer<Vec3>& targets,
  const Vec3& common, double relaxation, std::vector<Spoke>& spokes)
{
  const Vec3& p = mesh.Positions[v];
  Vec3 force(0.0, 0.0, 0.0);
  for (const Index f : star)
  {
    // The corner at v adds nothing.
    Vec3 edges(0.0, 0.0, 0.0);
    for (const Index q : mesh.Triangles[f])
    {
      edges += mesh.Positions[q] - p;
    }
    force += targets[f].dot(edges) * targets[f];
  }
  CollectSpokes(mesh, star, v, spokes);
  Vec3 sum(0.0, 0.0, 0.0);
  double total = 0.0;
  for (const Spoke& spoke : spokes)
  {
    const double length = (mesh.Positions[spoke.Vertex] - p).norm();
    sum += length * mesh.Positions[spoke.Vertex];
    total += length;
  }
  const Vec3 difference = total > 0.0 ? Vec3(sum / total - p) : Vec3(0.0, 0.0, 0.0);
  return p + force / (3.0 * static_cast<double>(star.size())) +
    relaxation * (2.0 * difference - difference.dot(common) * common);
}

}

bool DenoiseAsReleased(TriangleMesh& mesh, Buffer<Vec3>& normals,
  const ReleasedTukeyBilateralSettings& settings, MeshFacts& facts, Execution& execution)
{
  const CompressedRows stars = VertexStars(mesh);
  facts = FactsOf(mesh, TakeEdgeCensus(mesh, stars, execution), execution);
  const double scale = facts.MeanEdgeLength;
  const NeighborGraph adjacent = EdgeAdjacentFaces(mesh, stars, execution);
  FaceGeometry geometry;
  ComputeFaceGeometry(mesh, scale, geometry, execution);
  normals = geometry.Normals;
  Buffer<Vec3> lagging = geometry.Normals;
  Buffer<Vec3> moved(mesh.Positions.size());
  double relaxation = settings.Relaxation;
  for (int iteration = 0; iteration < settings.Iterations; ++iteration)
  {
    if (!execution.Proceed(static_cast<double>(iteration) / settings.Iterations))
    {
      return false;
    }
    ComputeFaceGeometry(mesh, scale, geometry, execution);
    const Buffer<double> spacings = Spacings(adjacent, geometry.Centroids);
    // Centroids at exactly this distance are outside.
    const double radius = std::nextafter(2.0 * Mean(spacings, execution), 0.0);
    // The program's balls have no limit.
    FilterNormals(
      FacesWithinRadius(adjacent, geometry.Centroids, radius, mesh.NumberOfFaces(), execution),
      geometry, spacings, settings.RangeScale, lagging, normals, execution);
    lagging.swap(geometry.Normals);

    Vec3 common(0.0, 0.0, 0.0);
    double area = 0.0;
    for (const Index f : stars.Row(mesh.NumberOfVertices() - 1))
    {
      common += geometry.Areas[f] * normals[f];
      area += geometry.Areas[f];
    }
    common = area > 0.0 ? Vec3(common / area) : Vec3(0.0, 0.0, 0.0);
    execution.For(moved.size(),
      [&](std::size_t begin, std::size_t end)
      {
        std::vector<Spoke> spokes;
        for (std::size_t v = begin; v < end; ++v)
        {
          const Span<Index> star = stars.Row(v);
          moved[v] = star.size() == 0
            ? mesh.Positions[v]
            : Moved(mesh, star, static_cast<Index>(v), normals, common, relaxation, spokes);
        }
      });
    mesh.Positions.swap(moved);
    relaxation *= 0.7;
  }
  return true;
}

}
