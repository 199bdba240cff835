// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// What a pipeline relies on: the input stays, data pass through, stages can be separate, progress
// and abort work.

#include "MeshTestTools.h"

#include "vtkBilateralNormalFilter.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNormalVertexUpdate.h"
#include "vtkPointData.h"
#include "vtkRobustNormalFilter.h"
#include "vtkStringArray.h"

#include <cstdlib>

namespace
{

using MeshTest::NoisySphere;
using MeshTest::PointDistance;

vtkSmartPointer<vtkIntArray> Numbers(const char* name, vtkIdType count)
{
  auto numbers = vtkSmartPointer<vtkIntArray>::New();
  numbers->SetName(name);
  for (vtkIdType i = 0; i < count; ++i)
  {
    numbers->InsertNextValue(static_cast<int>(i));
  }
  return numbers;
}

void TestDataPassThrough(int& failures)
{
  auto surface = NoisySphere();
  // A vertex and a line in front of the triangles shift their cell ids.
  vtkNew<vtkCellArray> verts;
  const vtkIdType line[2] = { 3, 4 };
  verts->InsertNextCell(1, line);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(2, line);
  surface->SetVerts(verts);
  surface->SetLines(lines);
  surface->GetPointData()->AddArray(Numbers("PointNumber", surface->GetNumberOfPoints()));
  surface->GetCellData()->AddArray(Numbers("CellNumber", surface->GetNumberOfCells()));
  vtkNew<vtkStringArray> text;
  text->SetName("Origin");
  text->InsertNextValue("scan 7");
  surface->GetFieldData()->AddArray(text);
  CHECK(surface->GetPointData()->GetNormals() != nullptr);

  vtkNew<vtkPolyData> before;
  before->DeepCopy(surface);
  const vtkMTimeType stamp = surface->GetMTime();
  vtkNew<vtkBilateralNormalFilter> filter;
  filter->SetInputData(surface);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();

  CHECK(surface->GetMTime() == stamp && PointDistance(surface, before) == 0.0);
  CHECK(surface->GetCellData()->GetNumberOfArrays() == 1);
  CHECK(surface->GetFieldData()->GetNumberOfArrays() == 1);
  CHECK(surface->GetPointData()->GetNormals() != nullptr);

  CHECK(PointDistance(surface, output) > 1e-4);
  CHECK(output->GetPolys() == surface->GetPolys());
  CHECK(output->GetNumberOfVerts() == 1 && output->GetNumberOfLines() == 1);
  CHECK(output->GetPointData()->GetArray("PointNumber") ==
    surface->GetPointData()->GetArray("PointNumber"));
  CHECK(output->GetCellData()->GetArray("CellNumber") ==
    surface->GetCellData()->GetArray("CellNumber"));
  CHECK(output->GetFieldData()->GetAbstractArray("Origin") == text);

  // Normals of the noisy surface stay as an array, but nobody shades with them.
  CHECK(output->GetPointData()->GetArray("Normals") != nullptr);
  CHECK(output->GetPointData()->GetNormals() == nullptr);

  vtkDataArray* normals = output->GetCellData()->GetArray("FilteredNormals");
  CHECK(normals->GetNumberOfTuples() == surface->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    double n[3];
    normals->GetTuple(cell, n);
    CHECK(std::abs(vtkMath::Norm(n) - (cell < 2 ? 0.0 : 1.0)) < 1e-12);
  }

  vtkDataArray* report = output->GetFieldData()->GetArray("DenoisingReport");
  CHECK(report != nullptr && report->GetNumberOfTuples() == 1);
  CHECK(std::string(report->GetComponentName(0)) == "Mean Edge Length");
  CHECK(
    report->GetComponent(0, 0) == filter->GetMeanEdgeLength() && filter->GetMeanEdgeLength() > 0);
}

void TestSeparateStages(int& failures)
{
  auto surface = NoisySphere();
  vtkNew<vtkBilateralNormalFilter> whole;
  whole->SetInputData(surface);
  whole->Update();

  vtkNew<vtkBilateralNormalFilter> normals;
  normals->SetInputData(surface);
  normals->UpdateVerticesOff();
  normals->Update();
  CHECK(PointDistance(surface, normals->GetOutput()) == 0.0);
  vtkNew<vtkNormalVertexUpdate> points;
  points->SetInputConnection(normals->GetOutputPort());
  points->Update();
  CHECK(PointDistance(whole->GetOutput(), points->GetOutput()) == 0.0);

  // Normals of the user's own, of any length: all of them up flatten a bumpy grid.
  auto grid = MeshTest::QuadGrid(10, 0.3);
  vtkNew<vtkDoubleArray> up;
  up->SetName("Predicted");
  up->SetNumberOfComponents(3);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    up->InsertNextTuple3(0.0, 0.0, 7.0);
  }
  grid->GetCellData()->AddArray(up);
  vtkNew<MeshTest::Messages> seen;
  vtkNew<vtkNormalVertexUpdate> flatten;
  seen->Watch(flatten);
  flatten->SetNumberOfVertexIterations(3000);
  flatten->SetBoundaryHandlingToFree();
  flatten->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Predicted");
  vtkPolyData* flat = MeshTest::Run(flatten, grid, seen);
  CHECK(seen->Errors.empty());
  double bounds[6];
  flat->GetBounds(bounds);
  CHECK(bounds[5] - bounds[4] < 1e-3);
  CHECK(bounds[1] - bounds[0] == 10.0);

  // A filter can start from them too; no normal iteration leaves them as they are.
  vtkNew<vtkBilateralNormalFilter> started;
  started->SetNumberOfNormalIterations(0);
  started->UpdateVerticesOff();
  started->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Predicted");
  started->SetInputData(grid);
  started->Update();
  CHECK(
    started->GetOutput()->GetCellData()->GetArray("FilteredNormals")->GetComponent(5, 2) == 1.0);

  // Arrays that cannot be normals are errors.
  MeshTest::Run(flatten, surface, seen);
  CHECK(seen->Errors.find("no cell array") != std::string::npos);
  surface->GetCellData()->AddArray(Numbers("Predicted", surface->GetNumberOfCells()));
  MeshTest::Run(flatten, surface, seen);
  CHECK(seen->Errors.find("no field of cell normals") != std::string::npos);
  up->SetComponent(3, 1, std::nan(""));
  up->Modified();
  MeshTest::Run(flatten, grid, seen);
  CHECK(seen->Errors.find("for cell 3") != std::string::npos);
}

/// Aborts an algorithm at a given progress and counts what comes after.
class Aborter : public vtkCommand
{
public:
  vtkTypeMacro(Aborter, vtkCommand);
  static Aborter* New() { return new Aborter; }

  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
    const double progress = algorithm->GetProgress();
    this->Monotone = this->Monotone && progress >= this->Last;
    this->Last = progress;
    ++this->Events;
    if (this->Aborted)
    {
      ++this->EventsAfterAbort;
    }
    else if (progress >= this->AbortAt)
    {
      this->Aborted = true;
      algorithm->SetAbortExecute(1);
    }
  }

  double AbortAt = 2.0;
  double Last = 0.0;
  bool Monotone = true;
  bool Aborted = false;
  int Events = 0;
  int EventsAfterAbort = 0;
};

void TestProgressAndAbort(int& failures)
{
  auto surface = NoisySphere(60);
  for (const double at : { 2.0, 0.001, 0.5, 0.9 })
  {
    vtkNew<vtkRobustNormalFilter> filter;
    filter->SetNumberOfOuterIterations(10);
    filter->SetNumberOfNormalIterations(3);
    filter->SetInputData(surface);
    vtkNew<Aborter> aborter;
    aborter->AbortAt = at;
    filter->AddObserver(vtkCommand::ProgressEvent, aborter);
    filter->Update();
    CHECK(aborter->Monotone);
    if (at > 1.0)
    {
      CHECK(aborter->Events > 100 && aborter->Last == 1.0);
      CHECK(PointDistance(surface, filter->GetOutput()) > 1e-4);
    }
    else
    {
      // The sweep that runs is finished, then nothing more happens (the executive may report the
      // end).
      CHECK(aborter->Aborted && aborter->EventsAfterAbort <= 1);
      CHECK(filter->GetOutput()->GetNumberOfPoints() == 0 ||
        PointDistance(surface, filter->GetOutput()) == 0.0);
      // The next execution is whole again.
      filter->RemoveObservers(vtkCommand::ProgressEvent);
      filter->SetAbortExecute(0);
      filter->Modified();
      filter->Update();
      CHECK(PointDistance(surface, filter->GetOutput()) > 1e-4);
    }
  }
}

void TestThreads(int& failures)
{
  auto surface = NoisySphere(100);
  vtkNew<vtkPolyData> first;
  for (const int threads : { 1, 2, 3, 0 })
  {
    vtkNew<vtkBilateralNormalFilter> filter;
    filter->SetNumberOfThreads(threads);
    filter->SetInputData(surface);
    filter->Update();
    if (threads == 1)
    {
      first->DeepCopy(filter->GetOutput());
    }
    CHECK(PointDistance(first, filter->GetOutput()) == 0.0);
  }
}

}

int TestMeshPipeline(int, char*[])
{
  int failures = 0;
  TestDataPassThrough(failures);
  TestSeparateStages(failures);
  TestProgressAndAbort(failures);
  TestThreads(failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
