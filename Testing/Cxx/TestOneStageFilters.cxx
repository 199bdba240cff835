// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// The filters of one stage: data that passes, settings that matter, input and settings that are
// bad.

#include "MeshTestTools.h"

#include "vtkAnisotropicMeanCurvatureFilter.h"
#include "vtkBilateralVertexFilter.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkMeanCurvatureFlowFilter.h"
#include "vtkNonIterativeBilateralFilter.h"
#include "vtkPointData.h"

#include <cstdlib>
#include <functional>
#include <limits>
#include <sstream>

namespace
{

using MeshTest::NoisySphere;
using MeshTest::PointDistance;
using MeshTest::QuadGrid;

const double nan = std::numeric_limits<double>::quiet_NaN();

/// Aborts as soon as the work has begun.
class Aborter : public vtkCommand
{
public:
  vtkTypeMacro(Aborter, vtkCommand);
  static Aborter* New() { return new Aborter; }
  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
    this->Last = algorithm->GetProgress();
    if (this->Last >= this->At)
    {
      algorithm->SetAbortExecute(1);
    }
  }
  double At = 0.02;
  double Last = 0.0;
};

void TestPassing(vtkOneStageFilter* filter, int& failures)
{
  auto surface = NoisySphere();
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("Numbers");
  numbers->SetNumberOfTuples(surface->GetNumberOfPoints());
  numbers->Fill(4.0);
  surface->GetPointData()->AddArray(numbers);
  vtkNew<vtkPolyData> before;
  before->DeepCopy(surface);
  const vtkMTimeType stamp = surface->GetMTime();
  vtkNew<MeshTest::Messages> seen;
  seen->Watch(filter);
  vtkPolyData* output = MeshTest::Run(filter, surface, seen);
  CHECK(seen->Errors.empty() && seen->Warnings.empty());
  CHECK(surface->GetMTime() == stamp && PointDistance(surface, before) == 0.0);
  CHECK(PointDistance(surface, output) > 1e-4);
  CHECK(MeshTest::Roughness(output) < 0.8 * MeshTest::Roughness(surface));
  CHECK(output->GetPolys() == surface->GetPolys());
  CHECK(output->GetPointData()->GetArray("Numbers") == numbers);
  CHECK(output->GetPointData()->GetNormals() == nullptr);
  CHECK(output->GetCellData()->GetArray("FilteredNormals") == nullptr);
  vtkDataArray* report = output->GetFieldData()->GetArray("DenoisingReport");
  CHECK(report && report->GetComponent(0, 0) == filter->GetMeanEdgeLength());
  CHECK(filter->GetMeanEdgeLength() > 0.0);

  // Polygons and strips of other sizes, and an open border.
  auto quads = QuadGrid(20, 0.2);
  output = MeshTest::Run(filter, quads, seen);
  CHECK(seen->Errors.empty() && output->GetPolys()->GetMaxCellSize() == 4);
  CHECK(PointDistance(quads, output) > 0.01);
  CHECK(output->GetPoint(0)[2] == quads->GetPoint(0)[2]);
  CHECK(filter->GetNumberOfBoundaryEdges() == 80);
}

/// Seams of an STL file stay closed, and faces may run in any direction.
void TestTopology(vtkOneStageFilter* filter, int& failures)
{
  auto sphere = NoisySphere(24);
  vtkNew<MeshTest::Messages> seen;
  vtkNew<vtkPolyData> clean;
  clean->DeepCopy(MeshTest::Run(filter, sphere, seen));

  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<vtkIdType>> soup;
  std::vector<vtkIdType> originals;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < sphere->GetNumberOfCells(); ++cell)
  {
    sphere->GetCellPoints(cell, ids);
    const vtkIdType first = static_cast<vtkIdType>(points.size());
    soup.push_back({ first, first + 1, first + 2 });
    if (cell % 3 == 0)
    {
      std::swap(soup.back()[1], soup.back()[2]);
    }
    for (vtkIdType i = 0; i < 3; ++i)
    {
      const double* p = sphere->GetPoint(ids->GetId(i));
      points.push_back({ p[0], p[1], p[2] });
      originals.push_back(ids->GetId(i));
    }
  }
  auto scattered = MeshTest::MakeSurface(points, soup);
  vtkPolyData* output = MeshTest::Run(filter, scattered, seen);
  CHECK(seen->Errors.empty() && seen->Warnings.empty());
  CHECK(filter->GetNumberOfTurnedFaces() > 0);
  CHECK(filter->GetNumberOfSeamPoints() ==
    scattered->GetNumberOfPoints() - sphere->GetNumberOfPoints());
  double largest = 0.0;
  for (std::size_t i = 0; i < originals.size(); ++i)
  {
    double p[3];
    double q[3];
    output->GetPoint(static_cast<vtkIdType>(i), p);
    clean->GetPoint(originals[i], q);
    largest = std::max(largest, std::sqrt(vtkMath::Distance2BetweenPoints(p, q)));
  }
  CHECK(largest < 1e-6);

  auto sheets = MeshTest::MakeSurface(
    { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0.5 }, { -1, 0.1, 0.5 }, { 0, 1, 0.5 }, { 0, 0, 0.5 } },
    { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 }, { 0, 5, 1 }, { 0, 0, 1 }, { 3, 3, 3 } });
  CHECK(std::isfinite(PointDistance(sheets, MeshTest::Run(filter, sheets, seen))));
  filter->FixBoundaryOff();
  CHECK(std::isfinite(PointDistance(sheets, MeshTest::Run(filter, sheets, seen))));
  filter->FixBoundaryOn();
}

void TestBadInput(vtkOneStageFilter* filter, int& failures)
{
  vtkNew<MeshTest::Messages> seen;
  seen->Watch(filter);
  vtkNew<vtkPolyData> empty;
  CHECK(MeshTest::Run(filter, empty, seen)->GetNumberOfPoints() == 0 && seen->Errors.empty());
  auto cloud = MeshTest::MakeSurface({ { 0, 0, 0 }, { 1, 0, 0 } }, {});
  CHECK(PointDistance(cloud, MeshTest::Run(filter, cloud, seen)) == 0.0);
  CHECK(seen->Warnings.find("no polygons") != std::string::npos);
  auto place = MeshTest::MakeSurface({ { 1, 1, 1 }, { 1, 1, 1 }, { 1, 1, 1 } }, { { 0, 1, 2 } });
  CHECK(PointDistance(place, MeshTest::Run(filter, place, seen)) == 0.0 && seen->Errors.empty());
  auto sphere = NoisySphere();
  sphere->GetPoints()->SetPoint(17, 0.0, nan, 0.0);
  CHECK(MeshTest::Run(filter, sphere, seen)->GetNumberOfPoints() == 0);
  CHECK(seen->Errors.find("Point 17") != std::string::npos);
}

void TestAbort(vtkOneStageFilter* filter, int& failures)
{
  auto surface = NoisySphere(60);
  for (const double at : { 0.02, 0.5, 2.0 })
  {
    vtkNew<Aborter> aborter;
    aborter->At = at;
    const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, aborter);
    filter->SetInputData(surface);
    filter->SetAbortExecute(0);
    filter->Modified();
    filter->Update();
    vtkPolyData* output = filter->GetOutput();
    const bool whole = PointDistance(surface, output) > 1e-4 && output->GetNumberOfPoints() > 0;
    CHECK(whole == (at > 1.0));
    CHECK(!whole || aborter->Last == 1.0);
    filter->RemoveObserver(tag);
  }
}

template <typename Filter>
void TestFilter(int& failures)
{
  vtkNew<Filter> filter;
  TestPassing(filter, failures);
  TestTopology(filter, failures);
  TestBadInput(filter, failures);
  TestAbort(filter, failures);
}

/// True if the setting makes a difference to the points of an open surface.
template <typename Filter>
bool Changes(std::function<void(Filter*)> set)
{
  auto grid = QuadGrid(24, 0.25);
  vtkNew<Filter> filter;
  filter->SetInputData(grid);
  filter->Update();
  vtkNew<vtkPolyData> before;
  before->DeepCopy(filter->GetOutput());
  set(filter);
  filter->Update();
  return PointDistance(before, filter->GetOutput()) > 1e-9;
}

void TestSettings(int& failures)
{
  using Flow = vtkMeanCurvatureFlowFilter;
  CHECK(Changes<Flow>([](Flow* f) { f->SetNumberOfIterations(4); }));
  CHECK(Changes<Flow>([](Flow* f) { f->SetTimeStep(0.3); }));
  CHECK(Changes<Flow>([](Flow* f) { f->FixBoundaryOff(); }));
  using Anisotropic = vtkAnisotropicMeanCurvatureFilter;
  CHECK(Changes<Anisotropic>([](Anisotropic* f) { f->SetNumberOfIterations(11); }));
  CHECK(Changes<Anisotropic>([](Anisotropic* f) { f->SetTimeStep(0.05); }));
  CHECK(Changes<Anisotropic>([](Anisotropic* f) { f->SetEdgeThreshold(0.6); }));
  CHECK(Changes<Anisotropic>([](Anisotropic* f) { f->PrescribeCurvatureOn(); }));
  CHECK(Changes<Anisotropic>([](Anisotropic* f) { f->FixBoundaryOff(); }));
  using Vertices = vtkBilateralVertexFilter;
  CHECK(Changes<Vertices>([](Vertices* f) { f->SetNumberOfIterations(4); }));
  CHECK(Changes<Vertices>([](Vertices* f) { f->SetSpatialScale(1.5); }));
  CHECK(Changes<Vertices>([](Vertices* f) { f->SetRangeScale(1.5); }));
  CHECK(Changes<Vertices>([](Vertices* f) { f->FixBoundaryOff(); }));
  using Once = vtkNonIterativeBilateralFilter;
  CHECK(Changes<Once>([](Once* f) { f->SetSpatialScale(1.5); }));
  CHECK(Changes<Once>([](Once* f) { f->SetRangeScale(0.5); }));
  CHECK(Changes<Once>([](Once* f) { f->FixBoundaryOff(); }));
}

void TestVolume(int& failures)
{
  vtkNew<vtkMeanCurvatureFlowFilter> filter;
  vtkNew<MeshTest::Messages> seen;
  seen->Watch(filter);
  auto sphere = NoisySphere();
  vtkNew<vtkPolyData> shrunk;
  shrunk->DeepCopy(MeshTest::Run(filter, sphere, seen));
  filter->RestoreVolumeOn();
  CHECK(PointDistance(shrunk, MeshTest::Run(filter, sphere, seen)) > 1e-4);
  CHECK(seen->Warnings.empty());
  MeshTest::Run(filter, QuadGrid(8, 0.1), seen);
  CHECK(seen->Warnings.find("not closed") != std::string::npos);
}

template <typename Filter>
void Refuses(void (Filter::*set)(double), const std::string& name, int& failures)
{
  vtkNew<Filter> filter;
  vtkNew<MeshTest::Messages> seen;
  seen->Watch(filter);
  auto surface = NoisySphere(12);
  for (const double bad : { 0.0, -1.0, nan })
  {
    (filter->*set)(bad);
    filter->Modified(); // -1 becomes 0, which it was before
    CHECK(MeshTest::Run(filter, surface, seen)->GetNumberOfPoints() == 0);
    CHECK(seen->Errors.find(name + " must be positive") != std::string::npos);
  }
  for (const double extreme : { 1e-300, 1e300 })
  {
    (filter->*set)(extreme);
    CHECK(std::isfinite(PointDistance(surface, MeshTest::Run(filter, surface, seen))));
    CHECK(seen->Errors.empty());
  }
  std::ostringstream text;
  filter->Print(text);
  CHECK(text.str().find(name + ": ") != std::string::npos);
  CHECK(text.str().find("FixBoundary: 1") != std::string::npos);
}

void TestBadSettings(int& failures)
{
  Refuses(&vtkMeanCurvatureFlowFilter::SetTimeStep, "TimeStep", failures);
  Refuses(&vtkAnisotropicMeanCurvatureFilter::SetTimeStep, "TimeStep", failures);
  Refuses(&vtkAnisotropicMeanCurvatureFilter::SetEdgeThreshold, "EdgeThreshold", failures);
  Refuses(&vtkBilateralVertexFilter::SetSpatialScale, "SpatialScale", failures);
  Refuses(&vtkBilateralVertexFilter::SetRangeScale, "RangeScale", failures);
  Refuses(&vtkNonIterativeBilateralFilter::SetSpatialScale, "SpatialScale", failures);
  Refuses(&vtkNonIterativeBilateralFilter::SetRangeScale, "RangeScale", failures);
}

}

int TestOneStageFilters(int, char*[])
{
  int failures = 0;
  TestFilter<vtkMeanCurvatureFlowFilter>(failures);
  TestFilter<vtkAnisotropicMeanCurvatureFilter>(failures);
  TestFilter<vtkBilateralVertexFilter>(failures);
  TestFilter<vtkNonIterativeBilateralFilter>(failures);
  TestSettings(failures);
  TestVolume(failures);
  TestBadSettings(failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
