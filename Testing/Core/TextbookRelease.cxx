// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Robust and high fidelity denoising as its authors released it, with what the program does
// otherwise than the paper.

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

struct Geometry
{
  std::vector<Vector> Centroids;
  std::vector<Vector> Normals;
  std::vector<double> Areas;
  std::vector<double> Distances; // per face, mean to the adjacent ones
  double Radius = 0.0;
};

Geometry Measure(const Mesh& mesh, const Neighbors& adjacent)
{
  Geometry here;
  for (const Face& face : mesh.Faces)
  {
    const Vector s = AreaVector(mesh, face);
    here.Centroids.push_back(Centroid(mesh, face));
    here.Normals.push_back(Unit(s));
    here.Areas.push_back(Length(s));
  }
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    double sum = 0.0;
    for (const int g : adjacent[f])
    {
      sum += Length(here.Centroids[f] - here.Centroids[g]);
    }
    here.Distances.push_back(sum / 3.0); // also if there are fewer
    here.Radius += 2.0 * sum / 3.0 / double(mesh.Faces.size());
  }
  return here;
}

Vector FilteredNormal(const Geometry& here, const std::vector<Vector>& normals,
  const Neighbors& adjacent, int f, double sigma, double& margin)
{
  Vector sum = { 0.0, 0.0, 0.0 };
  std::set<int> visited = { f };
  std::vector<int> grown = { f };
  for (std::size_t next = 0; next < grown.size(); ++next)
  {
    for (const int g : adjacent[grown[next]])
    {
      const double distance = Length(here.Centroids[f] - here.Centroids[g]);
      if (visited.count(g) > 0 || !(distance < here.Radius))
      {
        continue;
      }
      visited.insert(g);
      grown.push_back(g);
      const double x = Length(normals[f] - normals[g]);
      margin = std::min(margin, std::abs(x - sigma) / sigma);
      if (x <= sigma)
      {
        // The scale has dropped out of Tukey's weight and is a mere limit.
        const double tukey = (1.0 - x * x) * (1.0 - x * x);
        const double width = here.Distances[f];
        const double spatial = std::exp(-distance * distance / (2.0 * width * width));
        sum = sum + here.Areas[g] * spatial * tukey * normals[g];
      }
    }
  }
  // Not the normal of the face, as one should think.
  return Length(sum) < 1e-10 ? Vector{ 0.0, 0.0, 1.0 } : Unit(sum);
}

/// Mean target of the star of the last point, which all points use; not of length 1.
Vector MeanTarget(const Geometry& here, const std::vector<std::vector<int>>& stars,
  const std::vector<Vector>& targets)
{
  Vector sum = { 0.0, 0.0, 0.0 };
  double area = 0.0;
  for (const int f : stars.back())
  {
    sum = sum + here.Areas[f] * targets[f];
    area += here.Areas[f];
  }
  return area > 0.0 ? (1.0 / area) * sum : sum;
}

/// Where a point goes; it has faces.
Vector Moved(const Mesh& mesh, const std::vector<int>& star, const std::vector<int>& ring, int v,
  const std::vector<Vector>& targets, const Vector& mean, double lambda)
{
  const Vector p = mesh.Points[v];
  Vector force = { 0.0, 0.0, 0.0 };
  for (const int f : star)
  {
    for (const int q : mesh.Faces[f])
    {
      force = force + Dot(targets[f], mesh.Points[q] - p) * targets[f];
    }
  }
  Vector sum = { 0.0, 0.0, 0.0 };
  double length = 0.0;
  for (const int q : ring)
  {
    sum = sum + Length(mesh.Points[q] - p) * mesh.Points[q];
    length += Length(mesh.Points[q] - p);
  }
  const Vector smooth = length > 0.0 ? (1.0 / length) * sum - p : Vector{ 0.0, 0.0, 0.0 };
  const Vector tangential = smooth - Dot(smooth, mean) * mean;
  return p + (1.0 / (3.0 * double(star.size()))) * force + lambda * (smooth + tangential);
}

}

std::vector<Vector> DenoiseAsReleased(Mesh& mesh, double sigma, double lambda, int iterations,
  std::vector<double>* margins)
{
  const Neighbors adjacent = FacesAtEdges(mesh);
  const std::vector<std::vector<int>> stars = FacesOfPoints(mesh);
  const std::vector<std::vector<int>> rings = Rings(mesh);
  const std::size_t faces = mesh.Faces.size();
  std::vector<double> nearest(faces, std::numeric_limits<double>::infinity());
  std::vector<Vector> normals = Measure(mesh, adjacent).Normals;
  std::vector<Vector> filtered(faces, Vector{ 0.0, 0.0, 0.0 });
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    const Geometry here = Measure(mesh, adjacent);
    for (std::size_t f = 0; f < faces; ++f)
    {
      filtered[f] = FilteredNormal(here, normals, adjacent, int(f), sigma, nearest[f]);
    }
    normals = here.Normals; // those before the points move are what the next iteration filters
    const Vector mean = MeanTarget(here, stars, filtered);
    std::vector<Vector> moved = mesh.Points;
    for (std::size_t v = 0; v < moved.size(); ++v)
    {
      if (!stars[v].empty())
      {
        moved[v] = Moved(mesh, stars[v], rings[v], int(v), filtered, mean, lambda);
      }
    }
    mesh.Points = moved;
    lambda *= 0.7;
  }
  if (margins)
  {
    *margins = nearest;
  }
  return filtered;
}

}
