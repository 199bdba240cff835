// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceTriangulation.h"

#include "ArrayDispatch.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"

#include <atomic>

namespace SurfaceDenoising
{

namespace
{

std::string BadPoint(vtkIdType cell, vtkIdType points)
{
  return "Cell " + std::to_string(cell) + " refers to a point that does not exist: there are " +
    std::to_string(points) + " points.";
}

/// Copies the corners of triangles; good becomes false if one is no point.
struct CopyTriangles
{
  template <typename Array>
  void operator()(Array* connectivity, vtkIdType points, Buffer<Triangle>& triangles,
    std::atomic<bool>& good, Execution& execution) const
  {
    const auto ids = vtk::DataArrayValueRange<1>(connectivity);
    execution.For(triangles.size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t f = begin; f < end; ++f)
        {
          for (std::size_t corner = 0; corner < 3; ++corner)
          {
            const auto id = static_cast<vtkIdType>(ids[static_cast<vtkIdType>(3 * f + corner)]);
            if (id < 0 || id >= points)
            {
              good = false;
            }
            triangles[f][corner] = static_cast<Index>(id);
          }
        }
      });
  }
};

/// Cuts polygons one by one.
class PolygonCutter
{
public:
  PolygonCutter(vtkPoints* points, MeshView& view)
    : Points(points)
    , View(view)
  {
  }

  void Cut(vtkIdType cell, vtkIdType count, const vtkIdType* ids)
  {
    if (count < 3)
    {
      return;
    }
    if (count == 3)
    {
      this->Add(cell, ids[0], ids[1], ids[2]);
      return;
    }
    this->Polygon->Initialize(static_cast<int>(count), ids, this->Points);
    // Triangulate answers with point ids, three per triangle.
    if (this->Polygon->Triangulate(0, this->Corners, this->Ignored) != 0 &&
      this->Corners->GetNumberOfIds() == 3 * (count - 2))
    {
      const vtkIdType* corners = this->Corners->GetPointer(0);
      for (vtkIdType t = 0; t < count - 2; ++t)
      {
        this->Add(cell, corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]);
      }
      return;
    }
    for (vtkIdType t = 1; t + 1 < count; ++t)
    {
      this->Add(cell, ids[0], ids[t], ids[t + 1]);
    }
  }

  /// Every second triangle of a strip runs the other way round.
  void CutStrip(vtkIdType cell, vtkIdType count, const vtkIdType* ids)
  {
    for (vtkIdType t = 0; t + 2 < count; ++t)
    {
      const vtkIdType odd = t % 2;
      this->Add(cell, ids[t], ids[t + 1 + odd], ids[t + 2 - odd]);
    }
  }

private:
  void Add(vtkIdType cell, vtkIdType a, vtkIdType b, vtkIdType c)
  {
    this->View.Mesh.Triangles.push_back(
      { static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(c) });
    this->View.FaceCell.push_back(cell);
  }

  vtkPoints* Points;
  MeshView& View;
  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkIdList> Corners;
  vtkNew<vtkPoints> Ignored;
};

/// Calls cut(cell, count, ids) for every cell; false with a message if one has a bad point.
template <typename Function>
bool ForCells(vtkCellArray* cells, vtkIdType firstCell, vtkIdType points, std::string& error,
  Function cut)
{
  auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  vtkIdType cell = firstCell;
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(count, ids);
    if (std::any_of(ids, ids + count, [points](vtkIdType id) { return id < 0 || id >= points; }))
    {
      error = BadPoint(cell, points);
      return false;
    }
    cut(cell, count, ids);
    ++cell;
  }
  return true;
}

}

bool ReadTriangles(vtkPolyData* surface, MeshView& view, std::string& error, Execution& execution)
{
  const vtkIdType points = surface->GetNumberOfPoints();
  vtkCellArray* polygons = surface->GetPolys();
  vtkCellArray* strips = surface->GetStrips();
  Buffer<Triangle>& triangles = view.Mesh.Triangles;
  view.FirstCell = surface->GetNumberOfVerts() + surface->GetNumberOfLines();

  if (surface->GetNumberOfStrips() == 0 && polygons->IsHomogeneous() == 3)
  {
    triangles.resize(static_cast<std::size_t>(polygons->GetNumberOfCells()));
    std::atomic<bool> good{ true };
    // In VTK later than 9.1, ids may be in an array of any type.
    OnArray<vtkArrayDispatch::Integrals>(polygons->GetConnectivityArray(), CopyTriangles{}, points,
      triangles, good, execution);
    // The slow way names the cell.
    return good ||
      ForCells(polygons, view.FirstCell, points, error, [](vtkIdType, vtkIdType, auto) {});
  }

  PolygonCutter cutter(surface->GetPoints(), view);
  const vtkIdType firstStrip = view.FirstCell + surface->GetNumberOfPolys();
  return ForCells(polygons, view.FirstCell, points, error,
           [&cutter](vtkIdType cell, vtkIdType count, const vtkIdType* ids)
           { cutter.Cut(cell, count, ids); }) &&
    ForCells(strips, firstStrip, points, error,
      [&cutter](vtkIdType cell, vtkIdType count, const vtkIdType* ids)
      { cutter.CutStrip(cell, count, ids); });
}

}
