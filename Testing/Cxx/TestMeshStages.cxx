// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// The two stages as steps of their own, and normals of the user's own to start from, with every
// filter of two stages.

#include "FilterTester.h"

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFaceNormalFilter.h"
#include "vtkNormalVertexUpdate.h"
#include "vtkPointData.h"

#include <cstdlib>

namespace
{

using namespace MeshTest;

/// The normals of a surface of triangles, length times as long as unit normals, turned by an angle
/// (in degrees) that differs from cell to cell.
vtkSmartPointer<vtkDoubleArray> Normals(vtkPolyData* surface, double length, double angle)
{
  auto normals = vtkSmartPointer<vtkDoubleArray>::New();
  normals->SetName("Mine");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkIdList> ids;
  vtkNew<vtkTransform> turn;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetCellPoints(cell, ids);
    double p[3][3];
    for (int i = 0; i < 3; ++i)
    {
      surface->GetPoint(ids->GetId(i), p[i]);
    }
    double u[3];
    double v[3];
    double n[3];
    vtkMath::Subtract(p[1], p[0], u);
    vtkMath::Subtract(p[2], p[0], v);
    vtkMath::Cross(u, v, n);
    vtkMath::Normalize(n);
    vtkMath::MultiplyScalar(n, length);
    turn->Identity();
    turn->RotateWXYZ(angle * Wobble(cell), u);
    turn->TransformVector(n, n);
    normals->InsertNextTuple(n);
  }
  return normals;
}

/// As many points as triangles, with normals of the triangles that are said to be of the points.
vtkSmartPointer<vtkPolyData> WithPointArray(vtkPolyData* surface, vtkDataArray* normals)
{
  auto equal = Copy(surface);
  equal->GetPointData()->Initialize();
  while (equal->GetNumberOfPoints() < equal->GetNumberOfCells())
  {
    equal->GetPoints()->InsertNextPoint(0.0, 0.0, 0.0);
  }
  equal->GetPointData()->AddArray(normals);
  return equal;
}

void StartFromPoints(vtkAlgorithm* filter, const char* name)
{
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
}

void StartFrom(vtkAlgorithm* filter, const char* name)
{
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, name);
}

vtkSmartPointer<vtkPolyData> Sphere()
{
  vtkNew<vtkTransform> identity;
  return Moved(NoisySphere(20, 0.01), identity);
}

void TestStartNormals(const MeshFilter& about, int& failures)
{
  if (!about.IsTwoStage())
  {
    return;
  }
  auto surface = Sphere();
  FilterTester byDefault(about);
  vtkPolyData* expected = byDefault.Denoise(surface);

  surface->GetCellData()->AddArray(Normals(surface, 7.0, 0.0));
  FilterTester test(about);
  CHECK(
    PointDistance(expected, test.Denoise(surface)) == 0.0); // it is there, but was not asked for
  StartFrom(test.Filter, "None");
  CHECK(PointDistance(expected, test.Denoise(surface)) == 0.0);
  StartFrom(test.Filter, "Mine");
  vtkPolyData* output = test.Denoise(surface);
  CHECK(test.Seen->Errors.empty() && test.Seen->Warnings.empty());
  CHECK(PointDistance(expected, output) < 1e-9 && NormalDistance(expected, output) < 1e-8);

  // Others lead elsewhere, or are those that come out if nothing is done to them.
  surface->GetCellData()->AddArray(Normals(surface, 0.01, 10.0));
  output = test.Denoise(surface);
  CHECK(test.Seen->Errors.empty());
  CHECK((NormalDistance(expected, output) > 1e-5) == !about.Is(AS_RELEASED));
  if (!about.Is(AS_RELEASED) && !about.Is(OWN_ITERATIONS))
  {
    auto* filter = vtkFaceNormalFilter::SafeDownCast(test.Filter);
    filter->SetNumberOfOuterIterations(1);
    filter->SetNumberOfNormalIterations(-1);
    surface->GetCellData()->GetArray("Mine")->SetName("FilteredNormals");
    StartFrom(filter, "FilteredNormals");
    output = test.Denoise(surface);
    auto mine = Normals(surface, 1.0, 10.0);
    auto* result = output->GetCellData()->GetArray("FilteredNormals");
    for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
    {
      CHECK(std::abs(result->GetComponent(cell, 2) - mine->GetComponent(cell, 2)) < 1e-12);
    }
  }
}

/// Arrays that cannot be normals are errors.
void TestBadStartNormals(const MeshFilter& about, int& failures)
{
  if (!about.IsTwoStage() || about.Is(AS_RELEASED)) // which does not look at the array
  {
    return;
  }
  auto surface = Sphere();
  FilterTester test(about);
  StartFrom(test.Filter, "Mine");
  CHECK(test.Refuses(surface, "no cell array"));

  surface->GetPointData()->AddArray(Normals(surface, 1.0, 0.0)); // of points
  CHECK(test.Refuses(surface, "no cell array"));

  StartFromPoints(test.Filter, "Mine");
  CHECK(test.Refuses(WithPointArray(surface, Normals(surface, 1.0, 0.0)), "no cell array Mine"));
  StartFrom(test.Filter, "Mine");

  auto normals = Normals(surface, 1.0, 0.0);
  normals->SetNumberOfTuples(surface->GetNumberOfCells() - 1);
  surface->GetCellData()->AddArray(normals);
  CHECK(test.Refuses(surface, "Array Mine is no field of cell normals"));

  for (const int components : { 1, 2, 4 })
  {
    vtkNew<vtkDoubleArray> flat;
    flat->SetName("Mine");
    flat->SetNumberOfComponents(components);
    flat->SetNumberOfTuples(surface->GetNumberOfCells());
    flat->FillValue(1.0);
    surface->GetCellData()->AddArray(flat);
    CHECK(test.Refuses(surface, "Array Mine is no field of cell normals"));
  }

  for (const double bad : { vtkMath::Nan(), vtkMath::Inf() })
  {
    normals = Normals(surface, 1.0, 0.0);
    normals->SetComponent(3, 1, bad);
    surface->GetCellData()->AddArray(normals);
    CHECK(test.Refuses(surface, "not finite, for cell 3"));
  }

  // Zero vectors say nothing about their face; the filter can still be used.
  normals = Normals(surface, 1.0, 0.0);
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); cell += 5)
  {
    normals->SetTuple3(cell, 0.0, 0.0, 0.0);
  }
  surface->GetCellData()->AddArray(normals);
  CHECK(test.Quiet(surface) && PointDistance(surface, test.Denoise(surface)) > 1e-4);
  normals->FillValue(0.0);
  normals->Modified();
  surface->Modified();
  CHECK(test.Quiet(surface));
}

void TestSeparateStages(const MeshFilter& about, int& failures)
{
  if (!about.IsTwoStage())
  {
    return;
  }
  auto surface = Sphere();
  FilterTester whole(about);
  FilterTester first(about);
  auto* filter = vtkFaceNormalFilter::SafeDownCast(whole.Filter);
  auto* normals = vtkFaceNormalFilter::SafeDownCast(first.Filter);
  normals->UpdateVerticesOff();
  if (about.Is(AS_RELEASED))
  {
    // Its documentation says that this does not matter.
    CHECK(PointDistance(whole.Denoise(surface), first.Denoise(surface)) == 0.0);
    return;
  }
  vtkPolyData* output = first.Denoise(surface);
  CHECK(first.Seen->Errors.empty() && first.Seen->Warnings.empty());
  CHECK(PointDistance(surface, output) == 0.0);
  surface->GetCellData()->AddArray(Normals(surface, 1.0, 0.0));
  surface->GetCellData()->GetArray("Mine")->SetName("FilteredNormals");
  CHECK(NormalDistance(surface, output) > 0.01);
  surface->GetCellData()->Initialize();

  if (about.Is(OWN_ITERATIONS))
  {
    return;
  }
  filter->SetNumberOfOuterIterations(1);
  normals->SetNumberOfOuterIterations(1);
  vtkPolyData* expected = whole.Denoise(surface);
  first.Denoise(surface);
  vtkNew<vtkNormalVertexUpdate> second;
  second->SetInputConnection(normals->GetOutputPort());
  second->SetNumberOfVertexIterations(filter->GetNumberOfVertexIterations());
  second->SetVertexScheme(filter->GetVertexScheme());
  second->SetRelaxation(filter->GetRelaxation());
  second->SetMaximumDisplacement(filter->GetMaximumDisplacement());
  second->Update();
  CHECK(PointDistance(expected, second->GetOutput()) < 1e-14);
  CHECK(PointDistance(surface, expected) > 1e-4);
}

/// Normals of any length: all of them up flatten a bumpy grid.
void TestVertexUpdate(int& failures)
{
  auto grid = QuadGrid(10, 0.3);
  vtkNew<vtkDoubleArray> up;
  up->SetName("Predicted");
  up->SetNumberOfComponents(3);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    up->InsertNextTuple3(0.0, 0.0, 7.0);
  }
  grid->GetCellData()->AddArray(up);
  vtkNew<Messages> seen;
  vtkNew<vtkNormalVertexUpdate> flatten;
  seen->Watch(flatten);
  flatten->SetNumberOfVertexIterations(3000);
  flatten->SetBoundaryHandlingToFree();
  StartFrom(flatten, "Predicted");
  vtkPolyData* flat = Run(flatten, grid, seen);
  CHECK(seen->Errors.empty());
  double bounds[6];
  flat->GetBounds(bounds);
  CHECK(bounds[5] - bounds[4] < 1e-3);
  CHECK(bounds[1] - bounds[0] == 10.0);

  Run(flatten, Sphere(), seen);
  CHECK(seen->Errors.find("no cell array Predicted") != std::string::npos);
  StartFromPoints(flatten, "Mine");
  Run(flatten, WithPointArray(Sphere(), Normals(Sphere(), 1.0, 0.0)), seen);
  CHECK(seen->Errors.find("no cell array Mine") != std::string::npos);
  StartFrom(flatten, "Predicted");
  up->SetComponent(3, 1, vtkMath::Nan());
  up->Modified();
  Run(flatten, grid, seen);
  CHECK(seen->Errors.find("for cell 3") != std::string::npos);
}

}

int TestMeshStages(int, char*[])
{
  int failures = 0;
  TestAllMeshFilters(TestStartNormals, failures);
  TestAllMeshFilters(TestBadStartNormals, failures);
  TestAllMeshFilters(TestSeparateStages, failures);
  TestVertexUpdate(failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
