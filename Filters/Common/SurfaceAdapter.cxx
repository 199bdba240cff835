// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceAdapter.h"

#include "ArrayDispatch.h"
#include "SurfaceTriangulation.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>
#include <limits>

namespace SurfaceDenoising
{

namespace
{

/// Adds displacements to input points.
struct AddDisplacements
{
  template <typename Array, typename Value>
  void operator()(Array* array, const Vec3& centre, const Buffer<Vec3>& positions, Value* moved,
    Execution& execution) const
  {
    const auto points = vtk::DataArrayTupleRange<3>(array);
    execution.For(positions.size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          const auto p = points[static_cast<vtkIdType>(i)];
          for (int c = 0; c < 3; ++c)
          {
            const double before = static_cast<double>(p[c]);
            const double displacement = positions[i][c] - (before - centre[c]);
            // Points that are not finite stay.
            moved[3 * i + c] = static_cast<Value>(
              displacement == 0.0 || std::isnan(displacement) ? before : before + displacement);
          }
        }
      });
  }
};

/// Lowest and highest coordinates, and the first point that has none.
struct Extent
{
  Vec3 Low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 High = Vec3::Constant(-std::numeric_limits<double>::infinity());
  Index FirstBad = NoIndex;

  Extent& operator+=(const Extent& other)
  {
    this->Low = this->Low.cwiseMin(other.Low);
    this->High = this->High.cwiseMax(other.High);
    this->FirstBad = std::min(this->FirstBad, other.FirstBad);
    return *this;
  }
};

/// False with a message if there are too many of them for an Index.
bool CanBeNumbered(std::size_t count, const char* what, std::string& error)
{
  if (count < NoIndex)
  {
    return true;
  }
  error = "The surface has " + std::to_string(count) + " " + what + "; at most " +
    std::to_string(NoIndex - 1) + " can be handled.";
  return false;
}

/// Of the points in use.
Extent FindExtent(const TriangleMesh& mesh, Execution& execution)
{
  return OrderedSum(execution, mesh.NumberOfFaces(), Extent(),
    [&mesh](std::size_t f)
    {
      Extent extent;
      for (const Index v : mesh.Triangles[f])
      {
        const Vec3& p = mesh.Positions[v];
        if (p.allFinite())
        {
          extent.Low = extent.Low.cwiseMin(p);
          extent.High = extent.High.cwiseMax(p);
        }
        else
        {
          extent.FirstBad = std::min(extent.FirstBad, v);
        }
      }
      return extent;
    });
}

}

bool HasPolygons(vtkPolyData* data)
{
  return data->GetNumberOfPolys() + data->GetNumberOfStrips() > 0;
}

bool ReadSurface(vtkPolyData* surface, MeshView& view, std::string& error, Execution& execution)
{
  view = MeshView();
  const vtkIdType points = surface->GetNumberOfPoints();
  if (!CanBeNumbered(static_cast<std::size_t>(points), "points", error) ||
    !ReadTriangles(surface, view, error, execution) ||
    !CanBeNumbered(view.Mesh.NumberOfFaces(), "triangles", error))
  {
    return false;
  }
  if (points == 0)
  {
    return true;
  }

  Buffer<Vec3>& positions = view.Mesh.Positions;
  positions.resize(static_cast<std::size_t>(points));
  OnArray(surface->GetPoints()->GetData(), CopyVectors{}, positions, execution);
  if (view.Mesh.NumberOfFaces() == 0)
  {
    return true;
  }

  const Extent extent = FindExtent(view.Mesh, execution);
  if (extent.FirstBad != NoIndex)
  {
    error = "Point " + std::to_string(extent.FirstBad) +
      " of a polygon has a coordinate that is not a finite number.";
    return false;
  }
  if ((extent.High - extent.Low).maxCoeff() > 1e100)
  {
    error = "The surface is too large: its squared extent is beyond double precision.";
    return false;
  }
  view.Centre = 0.5 * extent.Low + 0.5 * extent.High;
  execution.For(positions.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        positions[i] -= view.Centre;
      }
    });
  return true;
}

vtkSmartPointer<vtkPoints> MovedPoints(vtkPolyData* surface, const Vec3& centre,
  const Buffer<Vec3>& positions, Execution& execution)
{
  vtkDataArray* before = surface->GetPoints()->GetData();
  const bool isFloat = before->GetDataType() == VTK_FLOAT;
  auto moved = vtk::TakeSmartPointer(vtkPoints::New(isFloat ? VTK_FLOAT : VTK_DOUBLE));
  moved->SetNumberOfPoints(surface->GetNumberOfPoints());
  moved->GetData()->SetName(before->GetName());
  if (isFloat)
  {
    float* values = static_cast<float*>(moved->GetVoidPointer(0));
    OnArray(before, AddDisplacements{}, centre, positions, values, execution);
  }
  else
  {
    double* values = static_cast<double*>(moved->GetVoidPointer(0));
    OnArray(before, AddDisplacements{}, centre, positions, values, execution);
  }
  return moved;
}

vtkSmartPointer<vtkDataArray> CellVectors(vtkPolyData* surface, const MeshView& view,
  const Buffer<Vec3>& faceVectors, const char* name, Execution& execution)
{
  const vtkIdType cells = surface->GetNumberOfCells();
  auto vectors = vtkSmartPointer<vtkDoubleArray>::New();
  vectors->SetName(name);
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(cells);
  double* values = vectors->GetPointer(0);
  const std::size_t faces = faceVectors.size();
  if (view.FaceCell.empty() && faces == static_cast<std::size_t>(cells))
  {
    execution.For(faces,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t f = begin; f < end; ++f)
        {
          std::copy_n(faceVectors[f].data(), 3, values + 3 * f);
        }
      });
    return vectors;
  }

  std::fill_n(values, 3 * cells, 0.0);
  for (std::size_t f = 0; f < faces;)
  {
    const vtkIdType cell = view.CellOfFace(f);
    const std::size_t first = f;
    Vec3 sum(0.0, 0.0, 0.0);
    for (; f < faces && view.CellOfFace(f) == cell; ++f)
    {
      sum += view.Mesh.DoubleAreaVector(f).norm() * faceVectors[f];
    }
    const double length = sum.norm();
    const Vec3 mean = f - first == 1 || !(length > 0.0) ? faceVectors[first] : Vec3(sum / length);
    std::copy_n(mean.data(), 3, values + 3 * cell);
  }
  return vectors;
}

bool ReadCellVectors(vtkDataArray* array, vtkPolyData* surface, const MeshView& view,
  Buffer<Vec3>& faceVectors, std::string& error)
{
  const std::string name = array->GetName() ? array->GetName() : "(no name)";
  if (array->GetNumberOfComponents() != 3 ||
    array->GetNumberOfTuples() != surface->GetNumberOfCells())
  {
    error = "Array " + name + " is no field of cell normals: it has " +
      std::to_string(array->GetNumberOfTuples()) + " tuples of " +
      std::to_string(array->GetNumberOfComponents()) + " components, the surface " +
      std::to_string(surface->GetNumberOfCells()) + " cells.";
    return false;
  }
  faceVectors.resize(view.Mesh.NumberOfFaces());
  for (std::size_t f = 0; f < faceVectors.size(); ++f)
  {
    Vec3& n = faceVectors[f];
    array->GetTuple(view.CellOfFace(f), n.data());
    const double length = n.stableNorm();
    if (!std::isfinite(length))
    {
      error = "Array " + name + " has a normal that is not finite, for cell " +
        std::to_string(view.CellOfFace(f)) + ".";
      return false;
    }
    if (length > 0.0)
    {
      n /= length;
    }
  }
  return true;
}

void PassUnchanged(vtkPolyData* input, const AddedArrays& added, vtkPolyData* output)
{
  output->ShallowCopy(input);
  auto remove = [](vtkFieldData* data, const std::vector<const char*>& names)
  {
    for (const char* name : names)
    {
      data->RemoveArray(name);
    }
  };
  remove(output->GetPointData(), added.OfPoints);
  remove(output->GetCellData(), added.OfCells);
  remove(output->GetFieldData(), added.OfAll);
}

void PassSurface(vtkPolyData* input, vtkPoints* points, vtkPolyData* output)
{
  output->ShallowCopy(input);
  output->SetPoints(points);
  output->GetPointData()->SetActiveNormals(nullptr);
  output->GetCellData()->SetActiveNormals(nullptr);
}

}
