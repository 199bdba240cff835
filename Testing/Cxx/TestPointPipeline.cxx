// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// What a pipeline relies on, of every filter for point sets: the input stays, data pass through,
// noise gets less, nothing runs twice, progress and abort work.

#include "PointFilterTester.h"

#include "vtkIntArray.h"
#include "vtkStringArray.h"
#include "vtkTrivialProducer.h"

#include <cstdlib>

namespace
{

using namespace PointTest;

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

/// Points with cells of all kinds, and with arrays of points, cells and the whole.
vtkSmartPointer<vtkPolyData> CloudWithData()
{
  auto cloud = SphereCloud();
  AddVertices(cloud);
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkCellArray> strips;
  const vtkIdType ids[5] = { 3, 4, 16, 12, 9 };
  lines->InsertNextCell(5, ids);
  polygons->InsertNextCell(4, ids);
  polygons->InsertNextCell(3, ids);
  strips->InsertNextCell(5, ids);
  cloud->SetLines(lines);
  cloud->SetPolys(polygons);
  cloud->SetStrips(strips);
  cloud->GetPointData()->SetScalars(Numbers("PointNumber", cloud->GetNumberOfPoints()));
  cloud->GetPointData()->SetNormals(SphereNormals(cloud, "Measured", 0.1));
  cloud->GetPointData()->AddArray(SphereNormals(cloud, "Normals", 0.3, 2.0));
  cloud->GetCellData()->AddArray(Numbers("CellNumber", cloud->GetNumberOfCells()));
  vtkNew<vtkStringArray> text;
  text->SetName("Origin");
  text->InsertNextValue("scan 7");
  cloud->GetFieldData()->AddArray(text);
  return cloud;
}

void TestDataPassThrough(const PointFilter& about, int& failures)
{
  auto cloud = CloudWithData();
  auto before = Copy(cloud);
  const vtkMTimeType stamp = cloud->GetMTime();
  PointFilterTester test(about);
  CHECK(test.Quiet(cloud));
  vtkPolyData* output = test.Denoise(cloud);
  CHECK(cloud->GetMTime() == stamp && SameData(cloud, before));

  CHECK(PointDistance(cloud, output) > 1e-4);
  CHECK(output->GetPoints() != cloud->GetPoints() && SameCells(cloud, output));
  CHECK(SameArrays(cloud->GetCellData(), output->GetCellData()));
  for (const char* name : { "PointNumber", "Measured" })
  {
    CHECK(output->GetPointData()->GetArray(name) == cloud->GetPointData()->GetArray(name));
  }
  CHECK(output->GetPointData()->GetScalars() == cloud->GetPointData()->GetScalars());
  CHECK(output->GetFieldData()->GetAbstractArray("Origin") ==
    cloud->GetFieldData()->GetAbstractArray("Origin"));
  // What is added, and nothing more.
  const int added = about.Is(TELLS_CLASSES) ? 3 : 2;
  CHECK(output->GetPointData()->GetNumberOfArrays() == 3 + added);
  CHECK((output->GetPointData()->GetArray("FeatureClass") != nullptr) == about.Is(TELLS_CLASSES));
  CHECK(output->GetFieldData()->GetNumberOfArrays() == 2);
  CHECK(output->GetPointData()->GetNormals() == output->GetPointData()->GetArray("Normals"));
}

void TestReport(const PointFilter& about, int& failures)
{
  if (about.Is(AS_RELEASED))
  {
    return;
  }
  auto cloud = SphereCloud();
  cloud->GetPoints()->InsertNextPoint(vtkMath::Nan(), 0.0, 0.0);
  PointFilterTester test(about);
  vtkPolyData* output = test.Denoise(cloud);
  vtkDataArray* report = output->GetFieldData()->GetArray("DenoisingReport");
  CHECK(report != nullptr && report->GetNumberOfTuples() == 1);
  auto value = [output](const std::string& name) { return Figure(output, name); };
  vtkPointDenoisingFilter* filter = test.Filter;
  CHECK(std::abs(value("Mean Spacing") - 3.54 / std::sqrt(600.0)) < 0.02);
  CHECK(value("Mean Spacing") == filter->GetMeanSpacing());
  CHECK(value("Kept Points") == filter->GetNumberOfKeptPoints());
  CHECK(value("Points Not Finite") == 1 && filter->GetNumberOfPointsNotFinite() == 1);
  CHECK(value("Fitted Normals") == 600 && filter->GetNumberOfFittedNormals() == 600);
  CHECK(value("Parts") == 1 && filter->GetNumberOfParts() == 1);
  CHECK(value("Seconds Of Setup") > 0.0 && value("Seconds Of Filtering") > 0.0);
  CHECK(value("Kept Points") == CountStatus(output, vtkPointDenoisingFilter::KEPT));

  // What was found on one cloud is not said of the next.
  vtkNew<vtkPolyData> empty;
  test.Denoise(empty);
  CHECK(filter->GetMeanSpacing() == 0.0 && filter->GetNumberOfFittedNormals() == 0);
  CHECK(filter->GetNumberOfPointsNotFinite() == 0 && filter->GetNumberOfParts() == 0);
}

double FlatnessOfCube(vtkPolyData* cloud)
{
  double sum = 0.0;
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    const double* p = cloud->GetPoint(i);
    const double r = std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
    sum += std::abs(r - 1.0);
  }
  return sum;
}

void TestNoiseGetsLess(const PointFilter& about, int& failures)
{
  PointFilterTester test(about);
  auto sphere = SphereCloud(900, 0.04);
  auto cube = CubeCloud(14, 0.05);
  const double round = Roughness(test.Denoise(sphere)) / Roughness(sphere);
  const double flat = FlatnessOfCube(test.Denoise(cube)) / FlatnessOfCube(cube);
  std::cout << about.Name << ": " << round << " of the noise stays on a sphere, " << flat
            << " on a cube\n";
  CHECK((round < 0.9 || about.Is(MAKES_FACETS)) && flat < 0.9);
}

/// With nothing to do, the points keep their bits.
void TestNoIterations(const PointFilter& about, int& failures)
{
  auto cloud = SphereCloud();
  PointFilterTester test(about);
  test.Filter->SetNumberOfOuterIterations(-1);
  CHECK(test.Quiet(cloud));
  CHECK(about.Is(OWN_SETTINGS) || PointDistance(cloud, test.Filter->GetOutput()) == 0.0);
  CHECK(Outwards(test.Filter->GetOutput()) > 0.9 * 600);
}

/// Counts executions.
class Counter : public vtkCommand
{
public:
  vtkTypeMacro(Counter, vtkCommand);
  static Counter* New() { return new Counter; }
  void Execute(vtkObject*, unsigned long, void*) override { ++this->Count; }
  int Count = 0;
};

void TestExecutions(const PointFilter& about, int& failures)
{
  auto cloud = SphereCloud(200);
  cloud->GetPointData()->AddArray(SphereNormals(cloud, "Mine", 0.1));
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(cloud);
  auto filter = about.Make();
  vtkNew<Counter> starts;
  filter->AddObserver(vtkCommand::StartEvent, starts);
  filter->SetInputConnection(producer->GetOutputPort());
  filter->Update();
  filter->Update();
  filter->SetNumberOfThreads(filter->GetNumberOfThreads());
  filter->SetNormalSource(filter->GetNormalSource());
  filter->SetMaximumDisplacement(filter->GetMaximumDisplacement());
  filter->Update();
  CHECK(starts->Count == 1);
  filter->SetNormalSourceToRobustFit();
  filter->Update();
  CHECK(starts->Count == 2);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Mine");
  filter->Update();
  filter->Update();
  CHECK(starts->Count == 3);
  cloud->GetPoints()->Modified();
  cloud->Modified();
  filter->Update();
  filter->Update();
  CHECK(starts->Count == 4);
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
void TestNothingAdded(const PointFilter& about, int& failures)
{
  PointFilterTester test(about);
  auto cloud = Copy(test.Denoise(CloudWithData()));
  if (!about.Is(TELLS_CLASSES))
  {
    cloud->GetPointData()->AddArray(Numbers("FeatureClass", cloud->GetNumberOfPoints()));
  }
  vtkNew<Aborter> aborter;
  aborter->AbortAt = 0.02;
  test.Filter->AddObserver(vtkCommand::ProgressEvent, aborter);
  test.Filter->Modified();
  vtkPolyData* output = test.Denoise(cloud);
  vtkPointData* data = output->GetPointData();
  CHECK(output->GetNumberOfPoints() == 0 ||
    (data->GetArray("PointNumber") && data->GetArray("Normals") && !data->GetArray("Status") &&
      !data->GetArray("Displacement") &&
      (data->GetArray("FeatureClass") == nullptr) == about.Is(TELLS_CLASSES) &&
      output->GetFieldData()->GetNumberOfArrays() == 1));
  test.Filter->RemoveObservers(vtkCommand::ProgressEvent);
  test.Filter->SetAbortExecute(0);

  // Without an iteration there are no classes.
  test.Filter->SetNumberOfOuterIterations(-1);
  cloud->GetPointData()->AddArray(Numbers("FeatureClass", cloud->GetNumberOfPoints()));
  vtkDataArray* classes = test.Denoise(cloud)->GetPointData()->GetArray("FeatureClass");
  CHECK((classes == cloud->GetPointData()->GetArray("FeatureClass")) == !about.Is(TELLS_CLASSES));

  vtkNew<vtkPolyData> empty;
  empty->SetFieldData(cloud->GetFieldData());
  CHECK(test.Denoise(empty)->GetFieldData()->GetNumberOfArrays() == 1);
}

void TestProgressAndAbort(const PointFilter& about, int& failures)
{
  auto cloud = CloudWithData();
  PointFilterTester test(about);
  vtkNew<Aborter> progress;
  test.Filter->AddObserver(vtkCommand::ProgressEvent, progress);
  auto whole = Copy(test.Denoise(cloud));
  CHECK(progress->Monotone && progress->Last == 1.0 && progress->Events >= 5);
  CHECK(PointDistance(cloud, whole) > 1e-4);
  test.Filter->RemoveObservers(vtkCommand::ProgressEvent);

  for (const double at : { 0.0, 0.02, 0.2, 0.4, 0.7 })
  {
    vtkNew<Aborter> aborter;
    aborter->AbortAt = at;
    test.Filter->AddObserver(vtkCommand::ProgressEvent, aborter);
    test.Filter->SetAbortExecute(0);
    test.Filter->Modified();
    vtkPolyData* output = test.Denoise(cloud);
    // The piece that runs is finished, then nothing more happens. The executive reports progress 0
    // before the filter begins to look, may report the end, and may empty what is unfinished.
    CHECK(aborter->Aborted && aborter->EventsAfterAbort <= (at == 0.0 ? 2 : 1));
    CHECK(output->GetNumberOfPoints() == 0 || SameData(cloud, output) ||
      (at > 0.5 && PointDistance(whole, output) == 0.0));
    CHECK(test.Seen->Errors.empty() && test.Seen->Warnings.empty());

    // The next execution is whole again.
    test.Filter->RemoveObservers(vtkCommand::ProgressEvent);
    test.Filter->SetAbortExecute(0);
    test.Filter->Modified();
    CHECK(SameResult(whole, test.Denoise(cloud)));
  }
}

}

int TestPointPipeline(int, char*[])
{
  int failures = 0;
  TestAllPointFilters(TestDataPassThrough, failures);
  TestAllPointFilters(TestReport, failures);
  TestAllPointFilters(TestNoiseGetsLess, failures);
  TestAllPointFilters(TestNoIterations, failures);
  TestAllPointFilters(TestExecutions, failures);
  TestAllPointFilters(TestNothingAdded, failures);
  TestAllPointFilters(TestProgressAndAbort, failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
