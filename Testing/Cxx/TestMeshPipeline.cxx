// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// What a pipeline relies on, of every filter: the input stays, data pass through, noise gets less,
// progress and abort work.

#include "FilterTester.h"
#include "PointClouds.h"

#include "vtkFaceNormalFilter.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <cstdlib>

namespace
{

using namespace MeshTest;
using PointTest::SameArrays;

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

/// A sphere with point, cell and field data, a vertex and a line.
vtkSmartPointer<vtkPolyData> SphereWithData()
{
  auto surface = NoisySphere(24);
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
  return surface;
}

void TestDataPassThrough(const MeshFilter& about, int& failures)
{
  auto surface = SphereWithData();
  CHECK(surface->GetPointData()->GetNormals() != nullptr);
  auto before = Copy(surface);
  const vtkMTimeType stamp = surface->GetMTime();
  FilterTester test(about);
  vtkPolyData* output = test.Denoise(surface);
  CHECK(test.Seen->Errors.empty() && test.Seen->Warnings.empty());

  CHECK(surface->GetMTime() == stamp && PointDistance(surface, before) == 0.0);
  CHECK(surface->GetCellData()->GetNumberOfArrays() == 1);
  CHECK(surface->GetFieldData()->GetNumberOfArrays() == 1);
  CHECK(surface->GetPointData()->GetNormals() != nullptr);

  CHECK(PointDistance(surface, output) > 1e-4);
  CHECK(output->GetPoints() != surface->GetPoints());
  CHECK(output->GetPolys() == surface->GetPolys());
  CHECK(output->GetNumberOfVerts() == 1 && output->GetNumberOfLines() == 1);
  CHECK(output->GetPointData()->GetArray("PointNumber") ==
    surface->GetPointData()->GetArray("PointNumber"));
  CHECK(output->GetCellData()->GetArray("CellNumber") ==
    surface->GetCellData()->GetArray("CellNumber"));
  CHECK(output->GetFieldData()->GetAbstractArray("Origin") ==
    surface->GetFieldData()->GetAbstractArray("Origin"));

  // Normals of the noisy surface stay as an array, but nobody shades with them.
  CHECK(output->GetPointData()->GetArray("Normals") != nullptr);
  CHECK(output->GetPointData()->GetNormals() == nullptr);
}

void TestWhatIsAdded(const MeshFilter& about, int& failures)
{
  auto surface = SphereWithData();
  FilterTester test(about);
  vtkPolyData* output = test.Denoise(surface);
  vtkDataArray* normals = output->GetCellData()->GetArray("FilteredNormals");
  CHECK((normals != nullptr) == about.IsTwoStage());
  for (vtkIdType cell = 0; normals && cell < surface->GetNumberOfCells(); ++cell)
  {
    double n[3];
    normals->GetTuple(cell, n);
    CHECK(std::abs(vtkMath::Norm(n) - (cell < 2 ? 0.0 : 1.0)) < 1e-12);
  }

  vtkDataArray* report = output->GetFieldData()->GetArray("DenoisingReport");
  CHECK(report != nullptr && report->GetNumberOfTuples() == 1);
  CHECK(std::string(report->GetComponentName(0)) == "Mean Edge Length");
  CHECK(report->GetComponent(0, 0) == test.Filter->GetMeanEdgeLength());
  CHECK(test.Filter->GetMeanEdgeLength() > 0.0);
  for (int i = 0; i < report->GetNumberOfComponents(); ++i)
  {
    CHECK(report->GetComponentName(i) && std::isfinite(report->GetComponent(0, i)));
  }

  // What was found on one surface is not said of the next.
  vtkNew<vtkPolyData> empty;
  test.Denoise(empty);
  CHECK(test.Filter->GetMeanEdgeLength() == 0.0);
}

/// On a sphere fine enough that facets, which some methods make of it, are less than the noise.
void TestNoiseGetsLess(const MeshFilter& about, int& failures)
{
  auto surface = NoisySphere(40);
  FilterTester test(about);
  const double share = Roughness(test.Denoise(surface)) / Roughness(surface);
  std::cout << about.Name << ": " << share << " of the roughness stays\n";
  CHECK(share < 0.9);
}

/// With nothing to do, the points keep their bits.
void TestNoIterations(const MeshFilter& about, int& failures)
{
  if (about.Is(OWN_ITERATIONS) || about.Is(ONE_PASS))
  {
    return;
  }
  auto surface = NoisySphere(12);
  FilterTester test(about);
  LimitIterations(test.Filter, -1);
  CHECK(PointDistance(surface, test.Denoise(surface)) == 0.0);
  CHECK(test.SaidNothing());
  CHECK(NormalDistance(test.Filter->GetOutput(), test.Filter->GetOutput()) == 0.0 ||
    !about.IsTwoStage());

  auto* normals = vtkFaceNormalFilter::SafeDownCast(test.Filter);
  if (normals && !about.Is(AS_RELEASED))
  {
    normals->SetNumberOfOuterIterations(3);
    CHECK(PointDistance(surface, test.Denoise(surface)) == 0.0);
    normals->SetNumberOfNormalIterations(2);
    CHECK(PointDistance(surface, test.Denoise(surface)) == 0.0);
  }
}

/// Who asks to stop at the noise of a surface that has none is told.
void TestStopWithoutNoise(const MeshFilter& about, int& failures)
{
  FilterTester test(about);
  auto* normals = vtkFaceNormalFilter::SafeDownCast(test.Filter);
  if (!normals || about.Is(AS_RELEASED))
  {
    return;
  }
  auto flat = Roof(16, 0.0);
  normals->StopAtNoiseOn();
  CHECK(PointDistance(flat, test.Denoise(flat)) == 0.0 && test.Seen->Errors.empty());
  CHECK(test.Seen->Warnings.find("no noise to stop at") != std::string::npos);
  const std::size_t first = test.Seen->Warnings.find("Warning:");
  CHECK(test.Seen->Warnings.find("Warning:", first + 1) == std::string::npos);
  auto noisy = NoisySphere(24);
  CHECK(PointDistance(noisy, test.Denoise(noisy)) > 1e-4 && test.Seen->Warnings.empty());
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
    this->Monotone = this->Monotone && progress >= this->Last && progress <= 1.0;
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

/// Where a filter adds nothing, what the same filter before it added is not taken for its own; all
/// else stays.
void TestNothingAdded(const MeshFilter& about, int& failures)
{
  FilterTester test(about);
  auto surface = Copy(test.Denoise(SphereWithData()));
  surface->GetCellData()->AddArray(Numbers("Other", surface->GetNumberOfCells()));
  auto isBare = [&](vtkPolyData* output)
  {
    const int normals = about.IsTwoStage() ? 1 : 0;
    return output->GetFieldData()->GetAbstractArray("Origin") != nullptr &&
      output->GetFieldData()->GetAbstractArray("DenoisingReport") == nullptr &&
      output->GetCellData()->GetArray("Other") != nullptr &&
      output->GetCellData()->GetNumberOfArrays() ==
      surface->GetCellData()->GetNumberOfArrays() - normals &&
      SameArrays(output->GetPointData(), surface->GetPointData());
  };
  vtkNew<Aborter> aborter;
  aborter->AbortAt = 0.02;
  test.Filter->AddObserver(vtkCommand::ProgressEvent, aborter);
  test.Filter->Modified();
  vtkPolyData* output = test.Denoise(surface);
  CHECK(output->GetNumberOfPoints() == 0 || isBare(output));
  test.Filter->RemoveObservers(vtkCommand::ProgressEvent);
  test.Filter->SetAbortExecute(0);

  surface->SetPolys(nullptr);
  CHECK(isBare(test.Denoise(surface)));
  CHECK(surface->GetFieldData()->GetAbstractArray("DenoisingReport") != nullptr);
  vtkNew<vtkPolyData> empty;
  empty->SetFieldData(surface->GetFieldData());
  output = test.Denoise(empty);
  CHECK(output->GetFieldData()->GetNumberOfArrays() == 1);
}

void TestProgressAndAbort(const MeshFilter& about, int& failures)
{
  auto surface = NoisySphere(24);
  FilterTester test(about);
  vtkNew<Aborter> progress;
  test.Filter->AddObserver(vtkCommand::ProgressEvent, progress);
  auto whole = Copy(test.Denoise(surface));
  CHECK(progress->Monotone && progress->Last == 1.0);
  CHECK(progress->Events >= (about.Is(ONE_PASS) ? 4 : 5));
  CHECK(PointDistance(surface, whole) > 1e-4);
  test.Filter->RemoveObservers(vtkCommand::ProgressEvent);

  for (const double at : { 0.0, 0.02, 0.3, 0.6, 0.9 })
  {
    vtkNew<Aborter> aborter;
    aborter->AbortAt = at;
    test.Filter->AddObserver(vtkCommand::ProgressEvent, aborter);
    test.Filter->SetAbortExecute(0);
    test.Filter->Modified();
    vtkPolyData* output = test.Denoise(surface);
    // The sweep that runs is finished, then nothing more happens. The executive reports progress 0
    // before the filter begins to look, and may report the end. Who asks for less than what is
    // there already gets all.
    CHECK(aborter->Aborted && aborter->EventsAfterAbort <= (at == 0.0 ? 2 : 1));
    CHECK(output->GetNumberOfPoints() == 0 || PointDistance(surface, output) == 0.0 ||
      (at > 0.5 && PointDistance(whole, output) == 0.0));
    CHECK(test.Seen->Errors.empty() && test.Seen->Warnings.empty());

    // The next execution is whole again.
    test.Filter->RemoveObservers(vtkCommand::ProgressEvent);
    test.Filter->SetAbortExecute(0);
    test.Filter->Modified();
    CHECK(PointDistance(whole, test.Denoise(surface)) == 0.0);
  }
}

}

int TestMeshPipeline(int, char*[])
{
  int failures = 0;
  TestAllMeshFilters(TestDataPassThrough, failures);
  TestAllMeshFilters(TestWhatIsAdded, failures);
  TestAllMeshFilters(TestNoiseGetsLess, failures);
  TestAllMeshFilters(TestNoIterations, failures);
  TestAllMeshFilters(TestStopWithoutNoise, failures);
  TestAllMeshFilters(TestNothingAdded, failures);
  TestAllMeshFilters(TestProgressAndAbort, failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
