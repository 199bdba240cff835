// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PointAdapter.h"

#include "ArrayDispatch.h"
#include "Bounds.h"
#include "SurfaceAdapter.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace SurfaceDenoising
{

namespace
{

/// The direction of a vector of any length; zero if it has none. (The bits of Eigen's stable norms
/// depend on where in memory the vector is, and so on the order of points.)
Vec3 UnitOrZero(const Vec3& v)
{
  const double largest = v.cwiseAbs().maxCoeff();
  if (!v.allFinite() || !(largest > 0.0))
  {
    return Vec3(0.0, 0.0, 0.0);
  }
  const bool squaresAreNumbers = largest > 1e-100 && largest < 1e100;
  const Vec3 n = squaresAreNumbers ? v : Vec3(v / largest);
  return n / n.norm();
}

/// The data with one of the finite points in place of each that is not; the data themselves if all
/// points are finite, or none.
vtkSmartPointer<vtkPolyData> WithFinitePoints(vtkPolyData* data, Buffer<unsigned char>& isFinite,
  Execution& execution)
{
  Buffer<Vec3> positions(static_cast<std::size_t>(data->GetNumberOfPoints()));
  OnArray(data->GetPoints()->GetData(), CopyVectors{}, positions, execution);
  isFinite.resize(positions.size());
  std::transform(positions.begin(), positions.end(), isFinite.begin(),
    [](const Vec3& p) { return p.allFinite(); });
  const auto place = std::find(isFinite.begin(), isFinite.end(), 1);
  if (place == isFinite.end() || std::count(isFinite.begin(), isFinite.end(), 0) == 0)
  {
    return data;
  }
  vtkNew<vtkPoints> points;
  points->DeepCopy(data->GetPoints());
  const vtkIdType somewhere = place - isFinite.begin();
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    if (!isFinite[i])
    {
      points->SetPoint(static_cast<vtkIdType>(i), points->GetPoint(somewhere));
    }
  }
  auto finite = vtkSmartPointer<vtkPolyData>::New();
  finite->ShallowCopy(data);
  finite->SetPoints(points);
  return finite;
}

/// From where points were to where they are; zero for those that are not finite.
struct WriteDisplacements
{
  double* Displacements;
  Execution& Loops;

  template <typename Before, typename After>
  void operator()(Before* before, After* after) const
  {
    const auto from = vtk::DataArrayTupleRange<3>(before);
    const auto to = vtk::DataArrayTupleRange<3>(after);
    this->Loops.For(static_cast<std::size_t>(from.size()),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          const auto p = from[static_cast<vtkIdType>(i)];
          const auto q = to[static_cast<vtkIdType>(i)];
          const Vec3 place(p[0], p[1], p[2]);
          const Vec3 displacement =
            place.allFinite() ? Vec3(Vec3(q[0], q[1], q[2]) - place) : Vec3(0.0, 0.0, 0.0);
          std::copy_n(displacement.data(), 3, this->Displacements + 3 * i);
        }
      });
  }
};

/// A byte per point.
template <typename Value>
void AddBytes(const char* name, const Buffer<Value>& values, vtkPolyData* output)
{
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), static_cast<unsigned char>(values[i]));
  }
  output->GetPointData()->AddArray(array);
}

}

bool ReadNormals(vtkDataArray* array, vtkPolyData* data, Buffer<Vec3>& normals, std::string& error,
  Execution& execution)
{
  if (array->GetNumberOfComponents() != 3 ||
    array->GetNumberOfTuples() != data->GetNumberOfPoints())
  {
    error = std::string("Array ") + (array->GetName() ? array->GetName() : "(no name)") +
      " is no field of point normals: it has " + std::to_string(array->GetNumberOfTuples()) +
      " tuples of " + std::to_string(array->GetNumberOfComponents()) + " components for " +
      std::to_string(data->GetNumberOfPoints()) + " points.";
    return false;
  }
  normals.resize(static_cast<std::size_t>(data->GetNumberOfPoints()));
  OnArray(array, CopyVectors{}, normals, execution);
  execution.For(normals.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        normals[i] = UnitOrZero(normals[i]);
      }
    });
  return true;
}

bool ReadPoints(vtkPolyData* data, vtkDataArray* normals, PointView& view, std::string& error,
  Execution& execution)
{
  view = PointView();
  const vtkIdType count = data->GetNumberOfPoints();
  if (count >= static_cast<vtkIdType>(NoIndex))
  {
    error = "The input has " + std::to_string(count) + " points; at most " +
      std::to_string(NoIndex - 1) + " can be handled.";
    return false;
  }
  if (count == 0)
  {
    return true;
  }
  Buffer<Vec3>& positions = view.Cloud.Positions;
  positions.resize(static_cast<std::size_t>(count));
  OnArray(data->GetPoints()->GetData(), CopyVectors{}, positions, execution);
  if (normals && !ReadNormals(normals, data, view.Cloud.Normals, error, execution))
  {
    return false;
  }

  const Bounds box = BoundsOf(positions, execution);
  if (box.Finite == 0)
  {
    return true;
  }
  if (!((box.High - box.Low).maxCoeff() <= 1e100))
  {
    error = "The input is too large: its squared extent is beyond double precision.";
    return false;
  }
  view.Centre = 0.5 * box.Low + 0.5 * box.High;
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

vtkDataArray* GivenNormals(vtkPolyData* data, bool isCloud)
{
  vtkDataArray* active = data->GetPointData()->GetNormals();
  if (active || !isCloud)
  {
    return active;
  }
  vtkDataArray* named = data->GetPointData()->GetArray("Normals");
  return named && named->GetNumberOfComponents() == 3 ? named : nullptr;
}

Buffer<Vec3> NormalsOfFaces(vtkPolyData* data, Execution& execution)
{
  if (!HasPolygons(data))
  {
    return {};
  }
  MeshView view;
  std::string error;
  Buffer<unsigned char> isFinite;
  if (!ReadSurface(WithFinitePoints(data, isFinite, execution), view, error, execution) ||
    view.Mesh.NumberOfFaces() == 0)
  {
    return {};
  }
  Buffer<Vec3> normals(view.Mesh.NumberOfVertices(), Vec3(0.0, 0.0, 0.0));
  for (std::size_t f = 0; f < view.Mesh.NumberOfFaces(); ++f)
  {
    const auto& triangle = view.Mesh.Triangles[f];
    if (std::all_of(triangle.begin(), triangle.end(), [&](Index v) { return isFinite[v] != 0; }))
    {
      for (const Index v : triangle)
      {
        normals[v] += view.Mesh.DoubleAreaVector(f);
      }
    }
  }
  for (Vec3& n : normals)
  {
    n = UnitOrZero(n);
  }
  return normals;
}

void PassPoints(vtkPolyData* input, const PointView& view, vtkPolyData* output,
  Execution& execution)
{
  const PointCloud& cloud = view.Cloud;
  const auto moved = MovedPoints(input, view.Centre, cloud.Positions, execution);
  PassSurface(input, moved, output);
  const std::size_t count = cloud.Positions.size();

  vtkNew<vtkDoubleArray> normals;
  vtkNew<vtkDoubleArray> displacements;
  normals->SetName("Normals");
  displacements->SetName("Displacement");
  for (vtkDoubleArray* array : { normals.Get(), displacements.Get() })
  {
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  }
  double* normal = normals->GetPointer(0);
  execution.For(count,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        std::copy_n(cloud.Normals[i].data(), 3, normal + 3 * i);
      }
    });
  using SameReals = vtkArrayDispatch::Dispatch2BySameValueType<vtkArrayDispatch::Reals>;
  vtkDataArray* before = input->GetPoints()->GetData();
  vtkDataArray* after = moved->GetData();
  WriteDisplacements write{ displacements->GetPointer(0), execution };
  if (!SameReals::Execute(before, after, write))
  {
    write(before, after);
  }
  output->GetPointData()->SetNormals(normals);
  output->GetPointData()->AddArray(displacements);
  AddBytes("Status", cloud.Status, output);
  if (!cloud.Classes.empty())
  {
    AddBytes("FeatureClass", cloud.Classes, output);
  }
}

}
