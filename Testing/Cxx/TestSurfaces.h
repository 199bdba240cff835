// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file TestSurfaces.h
 * @brief Surfaces to denoise, and the same surface told in another way.
 */

#ifndef TestSurfaces_h
#define TestSurfaces_h

#include "MeshTestTools.h"

#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace MeshTest
{

using Ids = std::vector<vtkIdType>;

/// An open surface of quads with noise and an edge, so that borders and scales matter.
inline vtkSmartPointer<vtkPolyData> Roof(int n = 24, double noise = 0.25)
{
  auto grid = QuadGrid(n, noise);
  vtkPoints* points = grid->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    p[0] += 0.6 * noise * Wobble(7 * i);
    p[1] += 0.6 * noise * Wobble(9 * i);
    p[2] += 3.0 - 0.8 * std::abs(p[1] - 0.5 * n);
    points->SetPoint(i, p);
  }
  return grid;
}

/// A cube of n x n cells of size 1 on each of five sides, two triangles each; the top is open.
inline vtkSmartPointer<vtkPolyData> NoisyBox(int n, double noise)
{
  std::vector<std::array<double, 3>> points;
  std::vector<Ids> triangles;
  Ids ids(static_cast<std::size_t>((n + 1) * (n + 1) * (n + 1)), -1);
  auto id = [&](int x, int y, int z)
  {
    vtkIdType& place = ids[static_cast<std::size_t>(x + (n + 1) * (y + (n + 1) * z))];
    if (place < 0)
    {
      place = static_cast<vtkIdType>(points.size());
      points.push_back({ double(x), double(y), double(z) });
    }
    return place;
  };
  auto quad = [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d)
  {
    triangles.push_back({ a, b, c });
    triangles.push_back({ a, c, d });
  };
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      quad(id(i, j, 0), id(i, j + 1, 0), id(i + 1, j + 1, 0), id(i + 1, j, 0));
      quad(id(0, i, j), id(0, i, j + 1), id(0, i + 1, j + 1), id(0, i + 1, j));
      quad(id(n, i, j), id(n, i + 1, j), id(n, i + 1, j + 1), id(n, i, j + 1));
      quad(id(i, 0, j), id(i + 1, 0, j), id(i + 1, 0, j + 1), id(i, 0, j + 1));
      quad(id(i, n, j), id(i, n, j + 1), id(i + 1, n, j + 1), id(i + 1, n, j));
    }
  }
  auto box = MakeSurface(points, triangles);
  Shake(box, noise);
  return box;
}

inline vtkSmartPointer<vtkPolyData> Copy(vtkPolyData* surface)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(surface);
  return copy;
}

/// Every triangle has points of its own, as in an STL file.
inline vtkSmartPointer<vtkPolyData> Soup(vtkPolyData* surface)
{
  std::vector<std::array<double, 3>> points;
  std::vector<Ids> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetCellPoints(cell, ids);
    Ids triangle;
    for (vtkIdType i = 0; i < 3; ++i)
    {
      double p[3];
      surface->GetPoint(ids->GetId(i), p);
      triangle.push_back(static_cast<vtkIdType>(points.size()));
      points.push_back({ p[0], p[1], p[2] });
    }
    triangles.push_back(triangle);
  }
  return MakeSurface(points, triangles);
}

/// Every third face runs the other way round.
inline vtkSmartPointer<vtkPolyData> Turned(vtkPolyData* surface)
{
  auto turned = Copy(surface);
  turned->BuildCells();
  for (vtkIdType cell = 0; cell < turned->GetNumberOfCells(); cell += 3)
  {
    turned->ReverseCell(cell);
  }
  return turned;
}

/// The surface with transformed points in double precision.
inline vtkSmartPointer<vtkPolyData> Moved(vtkPolyData* surface, vtkTransform* transform)
{
  auto moved = Copy(surface);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  transform->TransformPoints(surface->GetPoints(), points);
  moved->SetPoints(points);
  return moved;
}

/// The numbers below count, in an order without any pattern that repeats for the same seed.
inline Ids Shuffled(vtkIdType count, std::uint32_t seed)
{
  Ids order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), vtkIdType(0));
  for (std::size_t i = order.size(); i > 1; --i)
  {
    seed = seed * 1664525u + 1013904223u;
    std::swap(order[i - 1], order[(seed >> 8) % i]);
  }
  return order;
}

/// Point i becomes point points[i] and cell i becomes cell cells[i], which starts at another
/// corner.
inline vtkSmartPointer<vtkPolyData> Permuted(vtkPolyData* surface, const Ids& points,
  const Ids& cells)
{
  std::vector<std::array<double, 3>> positions(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    surface->GetPoint(static_cast<vtkIdType>(i),
      positions[static_cast<std::size_t>(points[i])].data());
  }
  std::vector<Ids> polygons(cells.size());
  vtkNew<vtkIdList> ids;
  for (std::size_t cell = 0; cell < cells.size(); ++cell)
  {
    surface->GetCellPoints(static_cast<vtkIdType>(cell), ids);
    Ids& polygon = polygons[static_cast<std::size_t>(cells[cell])];
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      polygon.push_back(points[static_cast<std::size_t>(ids->GetId(i))]);
    }
    std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
  }
  return MakeSurface(positions, polygons);
}

/// Largest difference of the filtered normals of cells with the same number, or of cell i and
/// cell cells[i] of the second surface.
inline double NormalDistance(vtkPolyData* a, vtkPolyData* b, const Ids& cells = {})
{
  vtkDataArray* first = a->GetCellData()->GetArray("FilteredNormals");
  vtkDataArray* second = b->GetCellData()->GetArray("FilteredNormals");
  if (!first || !second || first->GetNumberOfTuples() != second->GetNumberOfTuples())
  {
    return vtkMath::Inf();
  }
  double largest = 0.0;
  for (vtkIdType i = 0; i < first->GetNumberOfTuples(); ++i)
  {
    double m[3];
    double n[3];
    first->GetTuple(i, m);
    second->GetTuple(cells.empty() ? i : cells[static_cast<std::size_t>(i)], n);
    const double d = std::sqrt(vtkMath::Distance2BetweenPoints(m, n));
    largest = std::isfinite(d) ? std::max(largest, d) : vtkMath::Inf();
  }
  return largest;
}

}

#endif
