// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NoisyCloud.h"

#include "Noise.h"
#include "NoisySurface.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <cmath>
#include <random>

using namespace SurfaceDenoising;

namespace
{

/// Of the distance sqrt(area / count).
constexpr double NoiseInSpacings = 0.3;

/// Even in the triangle for even a and b in [0, 1).
Vec3 PointInTriangle(const TriangleMesh& mesh, std::size_t f, double a, double b)
{
  const Triangle& t = mesh.Triangles[f];
  const Vec3& p = mesh.Positions[t[0]];
  const double root = std::sqrt(a);
  return p + root * (1.0 - b) * (mesh.Positions[t[1]] - p) + root * b * (mesh.Positions[t[2]] - p);
}

}

vtkSmartPointer<vtkPolyData> NoisyCloud(vtkIdType count)
{
  const TriangleMesh mesh = CleanMesh();
  double area = 0.0;
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    area += 0.5 * mesh.DoubleAreaVector(f).norm();
  }
  if (!(area > 0.0))
  {
    return nullptr;
  }
  NoiseParameters parameters;
  parameters.Deviation = NoiseInSpacings * std::sqrt(area / double(count));
  const NoiseSource noise(parameters, std::size_t(count));

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> even(0.0, 1.0);
  std::size_t f = 0;
  double until = 0.5 * mesh.DoubleAreaVector(0).norm();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double at = (double(i) + 0.5) / double(count) * area;
    while (until < at && f + 1 < mesh.NumberOfFaces())
    {
      until += 0.5 * mesh.DoubleAreaVector(++f).norm();
    }
    const double a = even(random);
    const double b = even(random);
    const std::size_t k = std::size_t(i);
    const Vec3 p = PointInTriangle(mesh, f, a, b) + noise.Amplitude(k) * noise.Direction(k);
    const Vec3 n = mesh.DoubleAreaVector(f).normalized();
    points->SetPoint(i, p.data());
    normals->SetTuple(i, n.data());
  }
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(points);
  cloud->GetPointData()->SetNormals(normals);
  return cloud;
}

vtkSmartPointer<vtkPolyData> WithoutNormals(vtkPolyData* cloud)
{
  auto bare = vtkSmartPointer<vtkPolyData>::New();
  bare->SetPoints(cloud->GetPoints());
  return bare;
}
