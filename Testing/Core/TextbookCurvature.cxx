// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextbookInternals.h"
#include "TextbookVectors.h"

namespace Textbook
{

namespace
{

/// From the gradient of the area, which is 2 H times a third of the area of the star.
double MeanCurvature(const Mesh& mesh, const std::vector<Vector>& normals,
  const std::vector<int>& star, int v)
{
  Vector gradient = { 0.0, 0.0, 0.0 };
  double area = 0.0;
  for (const int f : star)
  {
    const Face& face = mesh.Faces[f];
    if (Length(normals[f]) == 0.0)
    {
      continue;
    }
    const int corner = face[0] == v ? 0 : (face[1] == v ? 1 : 2);
    const Vector& q = mesh.Points[face[(corner + 1) % 3]];
    const Vector& r = mesh.Points[face[(corner + 2) % 3]];
    gradient = gradient + 0.5 * Cross(normals[f], r - q);
    area += Length(AreaVector(mesh, face));
  }
  return area > 0.0 ? Length(gradient) / (2.0 * area / 3.0) : 0.0;
}

}

std::vector<double> FaceCurvatures(const Mesh& mesh, const std::vector<Vector>& normals)
{
  const std::vector<std::vector<int>> stars = FacesOfPoints(mesh);
  const std::vector<std::vector<int>> rings = Rings(mesh);
  const std::vector<bool> boundary = BoundaryPoints(mesh);
  const std::size_t points = mesh.Points.size();
  std::vector<double> atPoints(points, 0.0);
  for (std::size_t v = 0; v < points; ++v)
  {
    if (!boundary[v])
    {
      atPoints[v] = MeanCurvature(mesh, normals, stars[v], int(v));
    }
  }
  // The gradient of an open star says nothing about curvature.
  for (std::size_t v = 0; v < points; ++v)
  {
    if (boundary[v])
    {
      double sum = 0.0;
      int count = 0;
      for (const int q : rings[v])
      {
        if (!boundary[q])
        {
          sum += atPoints[q];
          ++count;
        }
      }
      atPoints[v] = count > 0 ? sum / count : 0.0;
    }
  }
  std::vector<double> curvatures;
  for (const Face& face : mesh.Faces)
  {
    curvatures.push_back((atPoints[face[0]] + atPoints[face[1]] + atPoints[face[2]]) / 3.0);
  }
  return curvatures;
}

}
