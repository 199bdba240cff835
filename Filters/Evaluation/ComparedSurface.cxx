// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ComparedSurface.h"

#include "PointAdapter.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <limits>

namespace SurfaceDenoising
{

namespace
{

constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();

bool AreSame(vtkCellArray* a, vtkCellArray* b)
{
  if (a->GetNumberOfCells() != b->GetNumberOfCells())
  {
    return false;
  }
  for (vtkIdType cell = 0; cell < a->GetNumberOfCells(); ++cell)
  {
    vtkIdType sizeA = 0;
    vtkIdType sizeB = 0;
    const vtkIdType* idsA = nullptr;
    const vtkIdType* idsB = nullptr;
    a->GetCellAtId(cell, sizeA, idsA);
    b->GetCellAtId(cell, sizeB, idsB);
    if (!std::equal(idsA, idsA + sizeA, idsB, idsB + sizeB))
    {
      return false;
    }
  }
  return true;
}

}

void ComparedSurface::Shift(const Vec3& shift)
{
  for (Vec3& position : this->View.Mesh.Positions)
  {
    position += shift;
  }
}

void ComparedSurface::Analyze(Execution& execution)
{
  this->Stars = VertexStars(this->View.Mesh);
  this->Census = TakeEdgeCensus(this->View.Mesh, this->Stars, execution);
  ComputeFaceGeometry(this->View.Mesh, this->Census.MeanEdgeLength, this->Geometry, execution);
  this->Points = this->View.Mesh.Positions;
  for (std::size_t v = 0; v < this->Points.size(); ++v)
  {
    if (!IsPlace(this->Points[v]) || (!this->IsCloud() && this->Stars.Row(v).size() == 0))
    {
      this->Points[v] = Vec3::Constant(Undefined);
    }
  }
}

void ComparedSurface::BecomeCloud(Execution& execution)
{
  this->View.Mesh.Triangles.clear();
  this->Analyze(execution);
}

bool ComparedSurface::HasArea() const
{
  return std::any_of(this->Geometry.Areas.begin(), this->Geometry.Areas.end(),
    [](double area) { return area > 0.0; });
}

bool ComparedSurface::HasPoints() const
{
  return std::any_of(this->Points.begin(), this->Points.end(), IsPlace);
}

double ComparedSurface::Diagonal() const
{
  Eigen::AlignedBox3d box;
  for (const Vec3& p : this->Points)
  {
    if (IsPlace(p))
    {
      box.extend(p);
    }
  }
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

double ComparedSurface::EnclosedVolume(Execution& execution) const
{
  return IsClosed(this->Census) ? SignedVolume(this->View.Mesh, execution) : Undefined;
}

void ComparedSurface::LeaveOutUnused(Buffer<double>& values) const
{
  for (std::size_t v = 0; v < values.size() && !this->IsCloud(); ++v)
  {
    if (this->Stars.Row(v).size() == 0)
    {
      values[v] = Undefined;
    }
  }
}

Statistics ComparedSurface::SummarizeVertices(Buffer<double> values, Execution& execution) const
{
  this->LeaveOutUnused(values);
  return Summarize(values, {}, execution);
}

bool ComparedSurface::ReadPointNormals(Buffer<Vec3>& normals, Execution& execution) const
{
  vtkDataArray* array = GivenNormals(this->Data, this->IsCloud());
  std::string ignored;
  return array && ReadNormals(array, this->Data, normals, ignored, execution);
}

vtkSmartPointer<vtkDoubleArray> ComparedSurface::CellMeans(const Buffer<double>& values,
  const char* name) const
{
  auto means = MakeUndefinedArray(name, this->Data->GetNumberOfCells());
  for (std::size_t f = 0; f < values.size();)
  {
    const vtkIdType cell = this->View.CellOfFace(f);
    double sum = 0.0;
    double weight = 0.0;
    for (; f < values.size() && this->View.CellOfFace(f) == cell; ++f)
    {
      if (!std::isnan(values[f]))
      {
        sum += this->Geometry.Areas[f] * values[f];
        weight += this->Geometry.Areas[f];
      }
    }
    means->SetValue(cell, weight > 0.0 ? sum / weight : Undefined);
  }
  return means;
}

bool HaveSameFaces(vtkPolyData* a, vtkPolyData* b)
{
  return a->GetNumberOfPoints() == b->GetNumberOfPoints() &&
    AreSame(a->GetPolys(), b->GetPolys()) && AreSame(a->GetStrips(), b->GetStrips());
}

void TriangulateAlike(const MeshView& reference, MeshView& result)
{
  result.Mesh.Triangles = reference.Mesh.Triangles;
  result.FaceCell = reference.FaceCell;
  for (vtkIdType& cell : result.FaceCell)
  {
    cell += result.FirstCell - reference.FirstCell; // vertices and lines come first
  }
}

NearestElements FindNearest(const TriangleTree& tree, const Buffer<Vec3>& positions,
  Execution& execution)
{
  NearestElements nearest;
  nearest.Distances.resize(positions.size());
  nearest.Numbers.resize(positions.size());
  execution.For(
    positions.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const TriangleTree::Hit hit = tree.Nearest(positions[i]);
        nearest.Distances[i] = hit.Distance;
        nearest.Numbers[i] = hit.Face;
      }
    },
    1024);
  return nearest;
}

vtkSmartPointer<vtkDoubleArray> MakeUndefinedArray(const char* name, vtkIdType size)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfTuples(size);
  array->FillValue(Undefined);
  return array;
}

}
