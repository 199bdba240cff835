// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// The filters of one stage: settings that matter, and settings that are bad. What they have in
// common with the others is tested with all filters.

#include "MeshTestTools.h"

#include "vtkAnisotropicMeanCurvatureFilter.h"
#include "vtkBilateralVertexFilter.h"
#include "vtkMeanCurvatureFlowFilter.h"
#include "vtkNonIterativeBilateralFilter.h"

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

/// With borders that move, on a border where three sheets meet.
template <typename Filter>
void TestFreeBoundary(int& failures)
{
  vtkNew<Filter> filter;
  vtkNew<MeshTest::Messages> seen;
  auto sheets = MeshTest::MakeSurface(
    { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0.5 }, { -1, 0.1, 0.5 }, { 0, 1, 0.5 }, { 0, 0, 0.5 } },
    { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 }, { 0, 5, 1 }, { 0, 0, 1 }, { 3, 3, 3 } });
  filter->FixBoundaryOff();
  CHECK(std::isfinite(PointDistance(sheets, MeshTest::Run(filter, sheets, seen))));
  auto grid = QuadGrid(8, 0.2);
  CHECK(MeshTest::Run(filter, grid, seen)->GetPoint(0)[2] != grid->GetPoint(0)[2]);
  filter->FixBoundaryOn();
  CHECK(MeshTest::Run(filter, grid, seen)->GetPoint(0)[2] == grid->GetPoint(0)[2]);
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
  (filter->*set)(nan);
  CHECK(MeshTest::Run(filter, surface, seen)->GetNumberOfPoints() == 0);
  CHECK(seen->Errors.find(name + " must not be negative") != std::string::npos);
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
  TestFreeBoundary<vtkMeanCurvatureFlowFilter>(failures);
  TestFreeBoundary<vtkAnisotropicMeanCurvatureFilter>(failures);
  TestFreeBoundary<vtkBilateralVertexFilter>(failures);
  TestFreeBoundary<vtkNonIterativeBilateralFilter>(failures);
  TestSettings(failures);
  TestVolume(failures);
  TestBadSettings(failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
