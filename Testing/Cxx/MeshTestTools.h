// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file MeshTestTools.h
 * @brief Surfaces with noise, comparisons and a check macro for the tests of the VTK classes.
 */

#ifndef MeshTestTools_h
#define MeshTestTools_h

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

/// Counts what went wrong and prints where.
#define CHECK(condition)                                                                           \
  do                                                                                               \
  {                                                                                                \
    if (!(condition))                                                                              \
    {                                                                                              \
      std::cerr << __FILE__ << ":" << __LINE__ << ": " << #condition << "\n";                      \
      ++failures;                                                                                  \
    }                                                                                              \
  } while (false)

namespace MeshTest
{

/// Keeps the errors and warnings of an algorithm instead of printing them.
class Messages : public vtkCommand
{
public:
  vtkTypeMacro(Messages, vtkCommand);
  static Messages* New() { return new Messages; }

  void Watch(vtkAlgorithm* algorithm)
  {
    algorithm->AddObserver(vtkCommand::ErrorEvent, this);
    algorithm->AddObserver(vtkCommand::WarningEvent, this);
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this);
  }

  void Execute(vtkObject* caller, unsigned long event, void* text) override
  {
    // The executive only repeats that the algorithm failed.
    if (vtkAlgorithm::SafeDownCast(caller) != nullptr)
    {
      (event == vtkCommand::ErrorEvent ? this->Errors : this->Warnings) +=
        static_cast<const char*>(text);
    }
  }

  std::string Errors;
  std::string Warnings;
};

/// Runs the filter on a surface; messages collects what it says.
inline vtkPolyData* Run(vtkAlgorithm* filter, vtkPolyData* input, Messages* messages)
{
  messages->Errors.clear();
  messages->Warnings.clear();
  filter->SetInputDataObject(input);
  filter->Update();
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
}

/// A repeatable number in [-1, 1).
inline double Wobble(vtkIdType i)
{
  const double x = std::sin(12.9898 * static_cast<double>(i + 1)) * 43758.5453;
  return 2.0 * (x - std::floor(x)) - 1.0;
}

/// Shifts every point by up to size in each direction.
inline void Shake(vtkPolyData* surface, double size)
{
  vtkPoints* points = surface->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    for (int c = 0; c < 3; ++c)
    {
      p[c] += size * Wobble(3 * i + c);
    }
    points->SetPoint(i, p);
  }
  points->Modified();
}

/// A sphere of radius 0.5 with noise; about 2 * resolution^2 triangles.
inline vtkSmartPointer<vtkPolyData> NoisySphere(int resolution = 48, double noise = 0.01)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution);
  sphere->Update();
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->DeepCopy(sphere->GetOutput());
  Shake(surface, noise);
  return surface;
}

/// A surface from a list of points and cells.
inline vtkSmartPointer<vtkPolyData> MakeSurface(const std::vector<std::array<double, 3>>& points,
  const std::vector<std::vector<vtkIdType>>& polygons)
{
  vtkNew<vtkPoints> vtkpoints;
  vtkpoints->SetDataTypeToDouble();
  for (const auto& p : points)
  {
    vtkpoints->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> cells;
  for (const auto& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(vtkpoints);
  surface->SetPolys(cells);
  return surface;
}

/// A wavy n x n grid of quads.
inline vtkSmartPointer<vtkPolyData> QuadGrid(int n, double noise)
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<vtkIdType>> quads;
  for (vtkIdType j = 0; j <= n; ++j)
  {
    for (vtkIdType i = 0; i <= n; ++i)
    {
      const double z = std::sin(0.3 * static_cast<double>(i)) + noise * Wobble(i + (n + 1) * j);
      points.push_back({ static_cast<double>(i), static_cast<double>(j), z });
      if (i < n && j < n)
      {
        const vtkIdType a = i + (n + 1) * j;
        quads.push_back({ a, a + 1, a + n + 2, a + n + 1 });
      }
    }
  }
  return MakeSurface(points, quads);
}

/// Largest distance between points with the same number; infinite if their numbers differ or one is
/// not finite.
inline double PointDistance(vtkPolyData* a, vtkPolyData* b)
{
  if (!a || !b || a->GetNumberOfPoints() != b->GetNumberOfPoints())
  {
    return vtkMath::Inf();
  }
  double largest = 0.0;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double q[3];
    a->GetPoint(i, p);
    b->GetPoint(i, q);
    const double d = std::sqrt(vtkMath::Distance2BetweenPoints(p, q));
    if (!std::isfinite(d))
    {
      return vtkMath::Inf();
    }
    largest = std::max(largest, d);
  }
  return largest;
}

/// How much distances to the origin spread around their mean: the roughness of a sphere.
inline double Roughness(vtkPolyData* surface)
{
  double sum = 0.0;
  double sumOfSquares = 0.0;
  const auto n = static_cast<double>(surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    const double r = vtkMath::Norm(p);
    sum += r;
    sumOfSquares += r * r;
  }
  return std::sqrt(std::max(0.0, sumOfSquares / n - (sum / n) * (sum / n)));
}

}

#endif
