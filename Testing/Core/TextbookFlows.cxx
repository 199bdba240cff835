// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextbookFlows.h"

#include "TextbookInternals.h"
#include "TextbookVectors.h"

#include <algorithm>
#include <cmath>

namespace Textbook
{

namespace
{

double StarArea(const Mesh& mesh, const std::vector<int>& star)
{
  double area = 0.0;
  for (const int f : star)
  {
    area += Length(AreaVector(mesh, mesh.Faces[f]));
  }
  return area;
}

/// The unit normal, zero for a degenerate face.
Vector NormalOf(const Mesh& mesh, const Face& face, double smallestArea)
{
  const Vector s = AreaVector(mesh, face);
  return Length(s) > smallestArea ? Unit(s) : Vector{ 0.0, 0.0, 0.0 };
}

/// Cotangent of the angle at a.
double Cotangent(const Vector& a, const Vector& b, const Vector& c)
{
  const double dot = Dot(b - a, c - a);
  const double cross = Length(Cross(b - a, c - a));
  return dot == 0.0 ? 0.0 : std::max(-1e6, std::min(1e6, dot / cross));
}

void FlowImplicitly(Mesh& mesh, double time, const std::vector<bool>& moves,
  const std::vector<std::vector<int>>& stars)
{
  const std::size_t n = mesh.Points.size();
  std::vector<std::vector<double>> matrix(n, std::vector<double>(n, 0.0));
  std::vector<Vector> right = mesh.Points;
  for (const Face& face : mesh.Faces)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const int i = face[(corner + 1) % 3];
      const int j = face[(corner + 2) % 3];
      const double weight =
        0.5 * Cotangent(mesh.Points[face[corner]], mesh.Points[i], mesh.Points[j]);
      matrix[i][i] += time * weight;
      matrix[j][j] += time * weight;
      matrix[i][j] -= time * weight;
      matrix[j][i] -= time * weight;
    }
  }
  for (std::size_t v = 0; v < n; ++v)
  {
    const double mass = StarArea(mesh, stars[v]) / 3.0;
    if (moves[v] && mass > 0.0)
    {
      matrix[v][v] += mass;
      right[v] = mass * mesh.Points[v];
    }
    else
    {
      matrix[v].assign(n, 0.0);
      matrix[v][v] = 1.0;
    }
  }
  const std::vector<Vector> solution = Solve(matrix, right);
  for (std::size_t v = 0; v < n; ++v)
  {
    mesh.Points[v] = moves[v] ? solution[v] : mesh.Points[v]; // not even by rounding
  }
}

double Volume(const Mesh& mesh)
{
  double volume = 0.0;
  for (const Face& face : mesh.Faces)
  {
    volume += Dot(mesh.Points[face[0]], Cross(mesh.Points[face[1]], mesh.Points[face[2]])) / 6.0;
  }
  return volume;
}

/// Scales the points that have faces.
void ScaleTo(Mesh& mesh, double volume, const std::vector<bool>& moves)
{
  Vector sum = { 0.0, 0.0, 0.0 };
  double count = 0.0;
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    sum = moves[v] ? sum + mesh.Points[v] : sum;
    count += moves[v] ? 1.0 : 0.0;
  }
  const double ratio = volume / Volume(mesh);
  if (!(ratio > 0.0) || std::isinf(ratio))
  {
    return; // no factor brings that volume back
  }
  const Vector centre = (1.0 / count) * sum;
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    if (moves[v])
    {
      mesh.Points[v] = centre + std::cbrt(ratio) * (mesh.Points[v] - centre);
    }
  }
}

/// The corner that is not on the edge.
int OppositeCorner(const Face& face, const Edge& edge)
{
  for (const int v : face)
  {
    if (v != edge.first && v != edge.second)
    {
      return v;
    }
  }
  return edge.first;
}

/// The curvature of an edge times its normal, times its weight.
Vector WeightedCurvature(const Mesh& mesh, const Edge& edge, const std::vector<int>& faces,
  double threshold, double sharpness, double smallestArea)
{
  const Vector none = { 0.0, 0.0, 0.0 };
  if (faces.size() != 2)
  {
    return none;
  }
  const Vector n1 = NormalOf(mesh, mesh.Faces[faces[0]], smallestArea);
  const Vector n2 = NormalOf(mesh, mesh.Faces[faces[1]], smallestArea);
  if (Length(n1) == 0.0 || Length(n2) == 0.0 || Length(n1 + n2) <= 1e-12)
  {
    return none;
  }
  const Vector& p = mesh.Points[edge.first];
  const double length = Length(mesh.Points[edge.second] - p);
  const Vector& opposite = mesh.Points[OppositeCorner(mesh.Faces[faces[1]], edge)];
  const bool convex = Dot(n1, opposite - p) < 0.0;
  const double size = 2.0 * length * std::sin(0.5 * AngleBetween(n1, n2));
  const double excess = threshold - size;
  const double weight = size <= threshold
    ? 1.0
    : threshold * threshold / (sharpness * excess * excess + threshold * threshold);
  return weight * (convex ? size : -size) * Unit(n1 + n2);
}

}

void MeanCurvatureFlow(Mesh& mesh, double timeStep, int steps, bool restoreVolume)
{
  const double edge = MeanEdgeLength(mesh);
  const double volume = Volume(mesh);
  const std::vector<std::vector<int>> stars = FacesOfPoints(mesh);
  const std::vector<bool> moves = MovingPoints(mesh);
  const std::vector<bool> boundary = BoundaryPoints(mesh);
  const bool closed = std::count(boundary.begin(), boundary.end(), true) == 0;
  for (int step = 0; step < steps; ++step)
  {
    FlowImplicitly(mesh, timeStep * edge * edge, moves, stars);
    if (restoreVolume && closed)
    {
      ScaleTo(mesh, volume, moves);
    }
  }
}

void AnisotropicMeanCurvature(Mesh& mesh, double threshold, double timeStep, double sharpness,
  int steps)
{
  const double edge = MeanEdgeLength(mesh);
  const std::vector<std::vector<int>> stars = FacesOfPoints(mesh);
  const std::vector<bool> moves = MovingPoints(mesh);
  const std::map<Edge, std::vector<int>> edges = FacesOfEdges(mesh);
  for (int step = 0; step < steps; ++step)
  {
    std::vector<Vector> curvatures(mesh.Points.size(), Vector{ 0.0, 0.0, 0.0 });
    for (const auto& entry : edges)
    {
      const Vector half = 0.5 *
        WeightedCurvature(mesh, entry.first, entry.second, threshold * edge, sharpness,
          1e-12 * edge * edge);
      curvatures[entry.first.first] = curvatures[entry.first.first] + half;
      curvatures[entry.first.second] = curvatures[entry.first.second] + half;
    }
    std::vector<Vector> moved = mesh.Points;
    for (std::size_t v = 0; v < moved.size(); ++v)
    {
      const double area = StarArea(mesh, stars[v]);
      if (moves[v] && area > 0.0)
      {
        moved[v] = moved[v] - (3.0 * timeStep * edge * edge / area) * curvatures[v];
      }
    }
    mesh.Points = moved;
  }
}

}
