// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// What vtkVotingTensorPointFilter tells of the released program, and what has no part in it.

#include "PointClouds.h"

#include "vtkVotingTensorPointFilter.h"

#include <cstdlib>

namespace
{

using namespace PointTest;

vtkSmartPointer<vtkVotingTensorPointFilter> MakeReleased()
{
  auto filter = vtkSmartPointer<vtkVotingTensorPointFilter>::New();
  filter->AsReleasedOn();
  filter->SetNumberOfOuterIterations(3);
  return filter;
}

int CountKept(vtkPolyData* output) { return CountStatus(output, vtkPointDenoisingFilter::KEPT); }

/// The array Status and the figures say the same of points that stay where they were.
void TestKeptPoints(int& failures)
{
  vtkNew<vtkTransform> shift;
  shift->Translate(0.1, 1234.56, 0.3);
  auto cloud = Moved(SphereCloud(), shift);
  const auto count = static_cast<int>(cloud->GetNumberOfPoints());
  auto filter = MakeReleased();
  vtkNew<Messages> seen;
  seen->Watch(filter);
  vtkPolyData* output = Run(filter, cloud, seen);
  CHECK(PointDistance(cloud, output) > 1e-4);
  CHECK(CountKept(output) == filter->GetNumberOfKeptPoints());
  CHECK(CountKept(output) == Figure(output, "Kept Points"));
  CHECK(Figure(output, "Outer Iterations") == 3.0);
  CHECK(Figure(output, "Fitted Normals") == count && filter->GetNumberOfFittedNormals() == count);

  // No step is that short.
  filter->SetMaximumDisplacement(1e-12);
  output = Run(filter, cloud, seen);
  CHECK(SameArray(CoordinatesOf(cloud), CoordinatesOf(output)));
  CHECK(CountKept(output) == count && filter->GetNumberOfKeptPoints() == count);
  CHECK(Figure(output, "Kept Points") == count);

  // Without iterations there is nothing that a point is kept from.
  filter->SetNumberOfOuterIterations(-1);
  output = Run(filter, cloud, seen);
  CHECK(SameArray(CoordinatesOf(cloud), CoordinatesOf(output)));
  CHECK(CountKept(output) == 0 && filter->GetNumberOfKeptPoints() == 0);
  CHECK(Figure(output, "Outer Iterations") == 0.0);

  cloud->GetPointData()->SetNormals(SphereNormals(cloud, "Measured"));
  output = Run(filter, cloud, seen);
  CHECK(Figure(output, "Fitted Normals") == 0.0 && filter->GetNumberOfFittedNormals() == 0);
  CHECK(seen->Errors.empty() && seen->Warnings.empty());
}

/// Settings that the program does not have are neither looked for nor errors.
void TestIgnoredSettings(int& failures)
{
  auto cloud = SphereCloud();
  vtkNew<Messages> seen;
  auto filter = MakeReleased();
  seen->Watch(filter);
  auto expected = Copy(Run(filter, cloud, seen));
  using Filter = vtkPointDenoisingFilter;
  for (const int source : { Filter::INPUT, Filter::PLANE_FIT, Filter::ROBUST_FIT })
  {
    filter->SetNormalSource(source);
    CHECK(SameResult(expected, Run(filter, cloud, seen)));
  }
  filter->SetNormalSourceToAutomatic();
  filter->SetNumberOfNormalNeighbors(0);
  filter->SetRadius(0.0);
  filter->SetNormalScale(0.0);
  filter->SetSpatialScale(0.0);
  vtkPolyData* output = Run(filter, cloud, seen);
  CHECK(SameResult(expected, output));
  for (const char* name : { "NumberOfNormalNeighbors", "Radius", "NormalScale", "SpatialScale" })
  {
    CHECK(std::isnan(filter->GetChosenValue(name)));
  }
  CHECK(std::isnan(Figure(output, "Noise In Spacings")));
  CHECK(seen->Errors.empty() && seen->Warnings.empty());
}

/// What the data would have to choose is an error, and nothing is said of what was before.
void TestNeededSettings(int& failures)
{
  auto cloud = SphereCloud();
  vtkNew<Messages> seen;
  auto filter = MakeReleased();
  seen->Watch(filter);
  auto refuses = [&]
  {
    const bool empty = Run(filter, cloud, seen)->GetNumberOfPoints() == 0;
    const bool forgotten =
      filter->GetMeanSpacing() == 0.0 && filter->GetNumberOfFittedNormals() == 0;
    return empty && forgotten &&
      seen->Errors.find("takes nothing from the data") != std::string::npos;
  };
  Run(filter, cloud, seen);
  CHECK(filter->GetMeanSpacing() > 0.0);
  filter->SetNumberOfOuterIterations(0);
  CHECK(refuses());
  filter->SetNumberOfOuterIterations(3);
  Run(filter, cloud, seen);
  filter->StopAtNoiseOn();
  CHECK(refuses());
  filter->StopAtNoiseOff();
  Run(filter, cloud, seen);
  filter->SetAngleThreshold(0.0);
  CHECK(refuses());
}

}

int TestReleasedPoints(int, char*[])
{
  int failures = 0;
  TestKeptPoints(failures);
  TestIgnoredSettings(failures);
  TestNeededSettings(failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
