// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Denoising without settings: what goes in comes out with less noise and all its arrays, what is
// not noisy stays, and the report says what was done.

#include "PointClouds.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkDenoiseSurface.h"
#include "vtkIntArray.h"
#include "vtkStringArray.h"
#include "vtkStripper.h"

#include <cstdlib>
#include <limits>

namespace
{

using namespace PointTest;

const double nan = std::numeric_limits<double>::quiet_NaN();

/// A component of the report.
double Figure(vtkPolyData* output, const std::string& name)
{
  vtkDataArray* report = output->GetFieldData()->GetArray("DenoisingReport");
  for (int i = 0; report && i < report->GetNumberOfComponents(); ++i)
  {
    if (name == report->GetComponentName(i))
    {
      return report->GetComponent(0, i);
    }
  }
  std::cerr << "The report has no " << name << "\n";
  return nan;
}

/// Mean distance of points from the surface of the cube [0, n]^3.
double DistanceFromCube(vtkPolyData* surface, double n)
{
  double sum = 0.0;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    double nearest = n;
    for (const double x : p)
    {
      nearest = std::min({ nearest, std::abs(x), std::abs(x - n) });
    }
    sum += nearest;
  }
  return sum / double(surface->GetNumberOfPoints());
}

void TestMeshes(int& failures)
{
  vtkNew<vtkDenoiseSurface> filter;
  vtkNew<Messages> seen;
  seen->Watch(filter);

  auto cube = NoisyBox(14, 0.25);
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Numbers");
  for (vtkIdType i = 0; i < cube->GetNumberOfCells(); ++i)
  {
    numbers->InsertNextValue(int(i));
  }
  cube->GetCellData()->AddArray(numbers);
  vtkNew<vtkPolyData> before;
  before->DeepCopy(cube);
  vtkPolyData* output = Run(filter, cube, seen);
  CHECK(seen->Errors.empty() && seen->Warnings.empty());
  CHECK(PointDistance(cube, before) == 0.0);
  CHECK(output->GetCellData()->GetArray("Numbers"));
  CHECK(output->GetNumberOfCells() == cube->GetNumberOfCells());
  CHECK(DistanceFromCube(output, 14.0) < 0.35 * DistanceFromCube(cube, 14.0));
  // 0.25 / sqrt(3) along the normals, edges of 1 to 1.4.
  CHECK(filter->GetNoiseLevel() > 0.08 && filter->GetNoiseLevel() < 0.18);
  CHECK(filter->GetChosenMethods() != "None" && !filter->GetReason().empty());
  CHECK(Figure(output, "Mean Displacement") == filter->GetMeanDisplacement());
  CHECK(filter->GetMeanDisplacement() > 0.03);
  // Eight edges of 14 each, at 90 degrees; the top is open.
  CHECK(filter->GetNumberOfFeatureEdgesAfter() >= 104);
  CHECK(filter->GetNumberOfFeatureEdgesAfter() <= 122);
  CHECK(std::isnan(Figure(output, "Volume Change")));
  auto* choice =
    vtkStringArray::SafeDownCast(output->GetFieldData()->GetAbstractArray("DenoisingChoice"));
  CHECK(choice && choice->GetValue(0) == filter->GetChosenMethods());
  vtkDataArray* displacement = output->GetPointData()->GetArray("Displacement");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double q[3];
    cube->GetPoint(i, p);
    output->GetPoint(i, q);
    for (int c = 0; c < 3; ++c)
    {
      CHECK(std::abs(q[c] - p[c] - displacement->GetComponent(i, c)) < 1e-9);
    }
  }

  // A curved surface gets other methods, or those that were asked for.
  const std::string forCubes = filter->GetChosenMethods();
  auto sphere = NoisySphere(22, 0.015);
  output = Run(filter, sphere, seen);
  CHECK(Roughness(output) < 0.6 * Roughness(sphere));
  CHECK(std::abs(Figure(output, "Volume Change")) < 0.01);
  CHECK(filter->GetChosenMethods() != forCubes);
  filter->SetSurfaceTypeToCurved();
  Run(filter, cube, seen);
  CHECK(filter->GetChosenMethods() != forCubes);
  filter->SetSurfaceTypeToAny();

  // Nothing to do.
  filter->SetStrength(0.0);
  CHECK(PointDistance(Run(filter, cube, seen), cube) == 0.0);
  CHECK(filter->GetChosenMethods() == "None");
  filter->SetStrength(1.0);
  auto clean = NoisySphere(22, 0.0);
  Run(filter, clean, seen);
  CHECK(filter->GetMeanDisplacement() < 0.02);
  CHECK(PointDistance(Run(filter, NoisyBox(14, 0.0), seen), NoisyBox(14, 0.0)) < 0.02);

  // More strength takes more away.
  filter->SetStrength(0.5);
  Run(filter, sphere, seen);
  const double little = filter->GetMeanDisplacement();
  filter->SetStrength(3.0);
  Run(filter, sphere, seen);
  CHECK(filter->GetMeanDisplacement() > little);
}

void TestPolygons(int& failures)
{
  vtkNew<vtkDenoiseSurface> filter;
  vtkNew<Messages> seen;
  seen->Watch(filter);
  auto quads = QuadGrid(24, 0.2);
  vtkPolyData* output = Run(filter, quads, seen);
  CHECK(output->GetNumberOfPolys() == 24 * 24 && PointDistance(output, quads) > 0.01);

  auto sphere = NoisySphere(20, 0.015);
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(sphere);
  stripper->Update();
  const double apart =
    PointDistance(Run(filter, stripper->GetOutput(), seen), stripper->GetOutput());
  CHECK(filter->GetOutput()->GetNumberOfStrips() == stripper->GetOutput()->GetNumberOfStrips());
  CHECK(apart > 0.001);

  // By the points alone, the polygons stay.
  filter->PointsOnlyOn();
  output = Run(filter, quads, seen);
  CHECK(output->GetNumberOfPolys() == 24 * 24 && output->GetPointData()->GetArray("Status"));
}

void TestClouds(int& failures)
{
  vtkNew<vtkDenoiseSurface> filter;
  vtkNew<Messages> seen;
  seen->Watch(filter);
  auto sphere = SphereCloud(800, 0.03);
  vtkPolyData* output = Run(filter, sphere, seen);
  CHECK(seen->Errors.empty() && seen->Warnings.empty());
  CHECK(Roughness(output) < 0.6 * Roughness(sphere));
  CHECK(filter->GetNoiseLevel() > 0.1 && filter->GetNoiseLevel() < 0.35);
  CHECK(output->GetPointData()->GetNormals() && output->GetPointData()->GetArray("Displacement"));
  CHECK(Figure(output, "Mean Displacement") > 0.0);
  CHECK(!filter->GetReason().empty() && filter->GetChosenMethods() != "None");

  // Single points that are off the surface go back, and the others stay.
  auto pricked = SphereCloud(1200, 0.0);
  for (vtkIdType i = 0; i < pricked->GetNumberOfPoints(); i += 10)
  {
    double p[3];
    pricked->GetPoint(i, p);
    vtkMath::MultiplyScalar(p, 1.06);
    pricked->GetPoints()->SetPoint(i, p);
  }
  output = Run(filter, pricked, seen);
  CHECK(Roughness(output) < 0.3 * Roughness(pricked));
  CHECK(filter->GetReason().find("120 single points") == 0 && filter->GetNumberOfOutliers() == 120);

  // Clean clouds stay, and get normals.
  auto clean = SphereCloud(1200, 0.0);
  output = Run(filter, clean, seen);
  CHECK(filter->GetMeanDisplacement() < 0.02);
  double n[3];
  output->GetPointData()->GetNormals()->GetTuple(0, n);
  CHECK(std::abs(vtkMath::Norm(n) - 1.0) < 1e-9);

  // Points that are not finite stay as they are.
  sphere->GetPoints()->SetPoint(7, nan, 0.0, 0.0);
  output = Run(filter, sphere, seen);
  CHECK(seen->Errors.empty() && std::isnan(output->GetPoint(7)[0]));
  CHECK(std::isfinite(output->GetPoint(8)[0]));
}

void TestOddInput(int& failures)
{
  vtkNew<vtkDenoiseSurface> filter;
  vtkNew<Messages> seen;
  seen->Watch(filter);
  vtkNew<vtkPolyData> empty;
  CHECK(Run(filter, empty, seen)->GetNumberOfPoints() == 0 && seen->Errors.empty());
  for (int count = 1; count < 6; ++count)
  {
    auto few = MakeCloud(Places(count, { 1.0, 2.0, 3.0 }));
    CHECK(PointDistance(Run(filter, few, seen), few) == 0.0 && seen->Errors.empty());
  }
  auto triangle =
    MakeSurface({ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } }, { { 0, 1, 2 } });
  CHECK(PointDistance(Run(filter, triangle, seen), triangle) == 0.0 && seen->Errors.empty());
  auto flat = MakeSurface({ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } }, { { 0, 1, 1 } });
  CHECK(PointDistance(Run(filter, flat, seen), flat) == 0.0 && seen->Errors.empty());

  auto sphere = NoisySphere(20, 0.01);
  sphere->GetPoints()->SetPoint(5, nan, 0.0, 0.0);
  filter->SetInputData(sphere);
  Run(filter, sphere, seen);
  CHECK(!seen->Errors.empty());
}

/// Stops at the given progress; the input then passes through.
void TestAbort(int& failures)
{
  for (const bool cloud : { false, true })
  {
    vtkSmartPointer<vtkPolyData> input = cloud ? SphereCloud(600, 0.03) : NoisyBox(10, 0.2);
    vtkNew<vtkDenoiseSurface> before;
    before->SetInputData(input);
    before->SetStrength(0.0);
    before->Update();
    CHECK(before->GetOutput()->GetFieldData()->GetNumberOfArrays() == 2);
    input->GetPointData()->SetNormals(before->GetOutput()->GetPointData()->GetNormals());
    for (double at : { 0.0, 0.3, 0.7 })
    {
      vtkNew<vtkDenoiseSurface> filter;
      vtkNew<vtkCallbackCommand> stop;
      stop->SetClientData(&at);
      stop->SetCallback(
        [](vtkObject* caller, unsigned long, void* data, void*)
        {
          auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
          if (algorithm->GetProgress() >= *static_cast<double*>(data))
          {
            algorithm->SetAbortExecute(1);
          }
        });
      filter->AddObserver(vtkCommand::ProgressEvent, stop);
      filter->SetInputData(before->GetOutput());
      filter->Update();
      // The executive of VTK may empty the output. What the filter before has told is not taken for
      // what this one tells.
      vtkPolyData* output = filter->GetOutput();
      CHECK(output->GetNumberOfPoints() == 0 ||
        (PointDistance(output, input) == 0.0 && SameData(output, input)));
    }
  }
}

void TestThreads(int& failures)
{
  for (const bool cloud : { false, true })
  {
    vtkSmartPointer<vtkPolyData> input = cloud ? SphereCloud(800, 0.03) : NoisySphere(20, 0.015);
    vtkNew<vtkDenoiseSurface> one;
    vtkNew<vtkDenoiseSurface> many;
    one->SetNumberOfThreads(1);
    many->SetNumberOfThreads(3);
    for (vtkDenoiseSurface* filter : { one.Get(), many.Get() })
    {
      filter->SetInputData(input);
      filter->Update();
    }
    CHECK(PointDistance(one->GetOutput(), many->GetOutput()) == 0.0);
    CHECK(PointDistance(one->GetOutput(), input) > 0.0);
  }
}

}

int TestDenoiseSurface(int, char*[])
{
  int failures = 0;
  TestMeshes(failures);
  TestPolygons(failures);
  TestClouds(failures);
  TestOddInput(failures);
  TestAbort(failures);
  TestThreads(failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
