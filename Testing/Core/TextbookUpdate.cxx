// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextbookInternals.h"
#include "TextbookVectors.h"

#include <cmath>

namespace Textbook
{

namespace
{

/// The corners after corner v, in the order of the face.
std::array<int, 2> OtherCorners(const Face& face, int v)
{
  const int corner = face[0] == v ? 0 : (face[1] == v ? 1 : 2);
  return { face[(corner + 1) % 3], face[(corner + 2) % 3] };
}

/// The unit vector of the targets weighted by area; zero if they cancel out.
Vector MeanTarget(const Mesh& mesh, const std::vector<int>& faces,
  const std::vector<Vector>& targets)
{
  Vector sum = { 0.0, 0.0, 0.0 };
  double total = 0.0;
  for (const int f : faces)
  {
    const double area = Length(AreaVector(mesh, mesh.Faces[f]));
    sum = sum + area * targets[f];
    total += area;
  }
  return Length(sum) > 1e-12 * total ? Unit(sum) : Vector{ 0.0, 0.0, 0.0 };
}

/// The way to the mean of the ring weighted by edge length, its tangential part twice.
Vector WayToRing(const Mesh& mesh, const std::vector<int>& faces, int v,
  const std::vector<Vector>& targets)
{
  const Vector p = mesh.Points[v];
  Vector sum = { 0.0, 0.0, 0.0 };
  double total = 0.0;
  for (const int f : faces)
  {
    for (const int q : OtherCorners(mesh.Faces[f], v))
    {
      const double length = Length(mesh.Points[q] - p);
      sum = sum + length * mesh.Points[q];
      total += length;
    }
  }
  if (total == 0.0)
  {
    return { 0.0, 0.0, 0.0 };
  }
  const Vector way = (1.0 / total) * sum - p;
  const Vector normal = MeanTarget(mesh, faces, targets);
  return way + (way - Dot(way, normal) * normal);
}

/// Where point v goes, all other points as they are, by the targets alone.
Vector Moved(const Mesh& mesh, const std::vector<int>& faces, int v,
  const std::vector<Vector>& targets, Update update, double smallestArea)
{
  const Vector p = mesh.Points[v];
  Vector sum = { 0.0, 0.0, 0.0 };
  double count = 0.0;
  double area = 0.0;
  for (const int f : faces)
  {
    const Vector& m = targets[f];
    if (Length(m) == 0.0)
    {
      continue;
    }
    const std::array<int, 2> others = OtherCorners(mesh.Faces[f], v);
    const Vector& q = mesh.Points[others[0]];
    const Vector& r = mesh.Points[others[1]];
    const Vector s = AreaVector(mesh, mesh.Faces[f]);
    count += 1.0;
    area += Length(s);
    switch (update)
    {
      case Update::FaceMean:
      case Update::ConstantStep:
      case Update::EdgeWeighted:
        sum = sum + (Dot(m, q - p) + Dot(m, r - p)) * m;
        break;
      case Update::AreaWeighted:
        sum = sum + (Length(s) * Dot(m, Centroid(mesh, mesh.Faces[f]) - p)) * m;
        break;
      case Update::IntegralFit:
        if (Length(s) > smallestArea)
        {
          sum = sum + Cross((1.0 / Length(s)) * s - m, r - q);
        }
        break;
    }
  }
  switch (update)
  {
    case Update::FaceMean:
    case Update::EdgeWeighted:
      return count > 0.0 ? p + (1.0 / (3.0 * count)) * sum : p;
    case Update::ConstantStep:
      return p + (1.0 / 18.0) * sum;
    case Update::AreaWeighted:
      return area > 0.0 ? p + (1.0 / area) * sum : p;
    case Update::IntegralFit:
      return p - 0.05 * sum;
  }
  return p;
}

}

void UpdatePoints(Mesh& mesh, const std::vector<Vector>& targets, Update update, bool freeBoundary,
  int count, double relaxation, const std::vector<Vector>& input, double longest)
{
  const std::vector<bool> boundary = BoundaryPoints(mesh);
  const double edge = MeanEdgeLength(mesh);
  const std::vector<std::vector<int>> facesOfPoint = FacesOfPoints(mesh);
  for (int step = 0; step < count; ++step)
  {
    std::vector<Vector> moved = mesh.Points;
    for (int v = 0; v < int(moved.size()); ++v)
    {
      const std::vector<int>& faces = facesOfPoint[v];
      if (freeBoundary || !boundary[v])
      {
        moved[v] = Moved(mesh, faces, v, targets, update, 1e-12 * edge * edge);
      }
      if (update == Update::EdgeWeighted && !boundary[v])
      {
        moved[v] = moved[v] + relaxation * WayToRing(mesh, faces, v, targets);
      }
      if (longest > 0.0 && Length(moved[v] - input[v]) > longest)
      {
        moved[v] = input[v] + longest * Unit(moved[v] - input[v]);
      }
    }
    mesh.Points = moved;
    relaxation *= 0.7;
  }
}

void PullToInput(Mesh& mesh, const std::vector<Vector>& targets, bool freeBoundary,
  const std::vector<Vector>& input, double part)
{
  const std::vector<bool> boundary = BoundaryPoints(mesh);
  const std::vector<std::vector<int>> facesOfPoint = FacesOfPoints(mesh);
  std::vector<Vector> pulled = mesh.Points;
  for (std::size_t v = 0; v < pulled.size(); ++v)
  {
    if (freeBoundary || !boundary[v])
    {
      const Vector normal = MeanTarget(mesh, facesOfPoint[v], targets);
      pulled[v] = pulled[v] + part * Dot(input[v] - mesh.Points[v], normal) * normal;
    }
  }
  mesh.Points = pulled;
}

}
