// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextbookVectors.h"

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

/// Where point v goes, all other points as they are.
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
  int count)
{
  const std::vector<bool> boundary = BoundaryPoints(mesh);
  const double edge = MeanEdgeLength(mesh);
  std::vector<std::vector<int>> facesOfPoint(mesh.Points.size());
  for (int f = 0; f < int(mesh.Faces.size()); ++f)
  {
    for (const int v : mesh.Faces[f])
    {
      // A face that repeats a point is one face all the same.
      if (facesOfPoint[v].empty() || facesOfPoint[v].back() != f)
      {
        facesOfPoint[v].push_back(f);
      }
    }
  }
  for (int step = 0; step < count; ++step)
  {
    std::vector<Vector> moved = mesh.Points;
    for (int v = 0; v < int(moved.size()); ++v)
    {
      if (freeBoundary || !boundary[v])
      {
        moved[v] = Moved(mesh, facesOfPoint[v], v, targets, update, 1e-12 * edge * edge);
      }
    }
    mesh.Points = moved;
  }
}

}
