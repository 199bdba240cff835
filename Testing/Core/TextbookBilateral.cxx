// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Bilateral filters of points: by the heights of points around and by the planes of faces around.

#include "TextbookFlows.h"
#include "TextbookInternals.h"
#include "TextbookVectors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace Textbook
{

namespace
{

double Gaussian(double x, double sigma) { return std::exp(-x * x / (2.0 * sigma * sigma)); }

/// The mean of the normals weighted by area; the area vectors are just that.
Vector NormalAt(const Mesh& mesh, const std::vector<int>& star)
{
  Vector sum = { 0.0, 0.0, 0.0 };
  for (const int f : star)
  {
    sum = sum + AreaVector(mesh, mesh.Faces[f]);
  }
  return Unit(sum);
}

/// Points reached along edges, none farther than the radius; the point itself comes first.
std::vector<int> PointsWithin(const Mesh& mesh, const std::vector<std::vector<int>>& rings, int v,
  double radius)
{
  std::vector<int> grown = { v };
  std::set<int> found = { v };
  for (std::size_t next = 0; next < grown.size(); ++next)
  {
    for (const int q : rings[grown[next]])
    {
      if (found.count(q) == 0 && Length(mesh.Points[q] - mesh.Points[v]) <= radius)
      {
        found.insert(q);
        grown.push_back(q);
      }
    }
  }
  return grown;
}

double StandardDeviationOfSizes(const std::vector<double>& heights)
{
  double mean = 0.0;
  for (const double h : heights)
  {
    mean += std::abs(h) / double(heights.size());
  }
  double variance = 0.0;
  for (const double h : heights)
  {
    variance += (std::abs(h) - mean) * (std::abs(h) - mean) / double(heights.size());
  }
  return std::sqrt(variance);
}

Vector BilateralPoint(const Mesh& mesh, const std::vector<std::vector<int>>& rings,
  const std::vector<int>& star, int v, double spatialFactor, double rangeFactor, double edge)
{
  const Vector p = mesh.Points[v];
  const Vector normal = NormalAt(mesh, star);
  double shortest = std::numeric_limits<double>::infinity();
  for (const int q : rings[v])
  {
    shortest = std::min(shortest, Length(mesh.Points[q] - p));
  }
  if (!(shortest > 0.0))
  {
    return p;
  }
  const double sigmaC = spatialFactor * shortest;
  const std::vector<int> around = PointsWithin(mesh, rings, v, 2.0 * sigmaC);
  std::vector<double> heights;
  for (const int q : around)
  {
    heights.push_back(Dot(normal, mesh.Points[q] - p));
  }
  const double sigmaS = std::max(1e-12 * edge, rangeFactor * StandardDeviationOfSizes(heights));
  double sum = 0.0;
  double total = 0.0;
  for (std::size_t k = 0; k < around.size(); ++k)
  {
    const double w =
      Gaussian(Length(mesh.Points[around[k]] - p), sigmaC) * Gaussian(heights[k], sigmaS);
    sum += w * heights[k];
    total += w;
  }
  return p + (sum / total) * normal; // its own weight is 1
}

/// Faces with centroids within the radius, reached from those of the point through such faces.
std::vector<int> FacesAround(const Mesh& mesh, const Neighbors& connected,
  const std::vector<int>& star, const Vector& p, double radius)
{
  std::vector<int> grown;
  std::set<int> found;
  const auto enter = [&](const std::vector<int>& faces)
  {
    for (const int f : faces)
    {
      if (Length(Centroid(mesh, mesh.Faces[f]) - p) <= radius && found.insert(f).second)
      {
        grown.push_back(f);
      }
    }
  };
  enter(star);
  for (std::size_t next = 0; next < grown.size(); ++next)
  {
    enter(connected[grown[next]]);
  }
  return grown;
}

}

void BilateralVertices(Mesh& mesh, int steps, double spatialFactor, double rangeFactor)
{
  const double edge = MeanEdgeLength(mesh);
  const std::vector<std::vector<int>> stars = FacesOfPoints(mesh);
  const std::vector<std::vector<int>> rings = Rings(mesh);
  const std::vector<bool> moves = MovingPoints(mesh);
  for (int step = 0; step < steps; ++step)
  {
    std::vector<Vector> moved = mesh.Points;
    for (int v = 0; v < int(moved.size()); ++v)
    {
      if (moves[v])
      {
        moved[v] = BilateralPoint(mesh, rings, stars[v], v, spatialFactor, rangeFactor, edge);
      }
    }
    mesh.Points = moved;
  }
}

void NonIterativeBilateral(Mesh& mesh, double spatialScale, double rangeScale)
{
  const double edge = MeanEdgeLength(mesh);
  const double sigmaF = spatialScale * edge;
  const double sigmaG = rangeScale * edge;
  const Neighbors connected = FacesAtPoints(mesh);
  const std::vector<std::vector<int>> stars = FacesOfPoints(mesh);
  const std::vector<bool> boundary = BoundaryPoints(mesh);
  std::vector<double> areas;
  std::vector<Vector> centroids;
  for (const Face& face : mesh.Faces)
  {
    areas.push_back(Length(AreaVector(mesh, face)));
    centroids.push_back(Centroid(mesh, face));
  }

  Mesh mollified = mesh; // for its normals only
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    const Vector p = mesh.Points[v];
    Vector sum = { 0.0, 0.0, 0.0 };
    double total = 0.0;
    for (const int f : FacesAround(mesh, connected, stars[v], p, 2.0 * sigmaF))
    {
      const double w = areas[f] * Gaussian(Length(centroids[f] - p), 0.5 * sigmaF);
      sum = sum + w * centroids[f];
      total += w;
    }
    mollified.Points[v] = total > 0.0 ? (1.0 / total) * sum : p;
  }

  std::vector<Vector> moved = mesh.Points;
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    const Vector p = mesh.Points[v];
    Vector sum = { 0.0, 0.0, 0.0 };
    double total = 0.0;
    for (const int f : FacesAround(mesh, connected, stars[v], p, 2.0 * sigmaF))
    {
      const Vector s = AreaVector(mollified, mesh.Faces[f]);
      if (Length(s) > 1e-12 * edge * edge)
      {
        const double height = Dot(Unit(s), p - centroids[f]);
        const double w =
          areas[f] * Gaussian(Length(centroids[f] - p), sigmaF) * Gaussian(height, sigmaG);
        sum = sum + w * (p - height * Unit(s));
        total += w;
      }
    }
    if (!boundary[v] && total > 1e-140)
    {
      moved[v] = (1.0 / total) * sum;
    }
  }
  mesh.Points = moved;
}

}
