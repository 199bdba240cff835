// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Few points, bad points, points of every size and with every kind of cell: every filter for point
// sets gives a sensible result or one clear error for each.

#include "PointFilterTester.h"

#include "vtkFloatArray.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkStripper.h"

#include <cstdlib>
#include <limits>

namespace
{

using namespace PointTest;

const double nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

void TestFewPoints(const PointFilter& about, int& failures)
{
  PointFilterTester test(about);
  vtkNew<vtkPolyData> empty;
  CHECK(test.Quiet(empty) && test.Filter->GetMeanSpacing() == 0.0);
  CHECK(test.Quiet(MakeCloud({})));
  // Below the number of neighbours, and below what defines a plane.
  for (int count = 1; count <= 8; ++count)
  {
    Places points;
    for (int i = 0; i < count; ++i)
    {
      points.push_back({ std::cos(i), std::sin(3.0 * i), 0.1 * i * i });
    }
    auto cloud = MakeCloud(points);
    CHECK(test.Quiet(cloud));
    if (count <= 3 && !about.Is(AS_RELEASED))
    {
      vtkPolyData* output = test.Denoise(cloud);
      CHECK(SameArray(CoordinatesOf(cloud), CoordinatesOf(output)));
      CHECK(CountStatus(output, vtkPointDenoisingFilter::KEPT) == count);
      CHECK(test.Filter->GetNumberOfKeptPoints() == count);
    }
    cloud->GetPointData()->SetNormals(SphereNormals(cloud, "Normals", 0.1));
    CHECK(test.Quiet(cloud));
  }
}

void TestFlatShapes(const PointFilter& about, int& failures)
{
  PointFilterTester test(about);
  // All at one place.
  auto equal = MakeCloud(Places(50, { 1.0, 2.0, 3.0 }));
  CHECK(test.Quiet(equal) && PointDistance(equal, test.Denoise(equal)) == 0.0);
  CHECK(about.Is(AS_RELEASED) ||
    CountStatus(test.Filter->GetOutput(), vtkPointDenoisingFilter::KEPT) == 50);

  Places line;
  Places plane;
  for (int i = 0; i < 144; ++i)
  {
    line.push_back({ 0.1 * i, 0.2 * i, -0.1 * i });
    plane.push_back({ i % 12 + 0.3 * Wobble(2 * i), i / 12 + 0.3 * Wobble(2 * i + 1), 5.0 });
  }
  auto cloud = MakeCloud(line);
  CHECK(test.Quiet(cloud));
  vtkPolyData* output = test.Denoise(cloud);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double* p = output->GetPoint(i);
    CHECK(std::abs(p[1] - 2.0 * p[0]) < 1e-6 && std::abs(p[0] + p[2]) < 1e-6);
  }
  // A plane has no noise.
  cloud = MakeCloud(plane);
  CHECK(test.Quiet(cloud));
  output = test.Denoise(cloud);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    CHECK(std::abs(output->GetPoint(i)[2] - 5.0) < 1e-12);
  }
}

/// Every point twice, or many points at one place.
void TestDuplicates(const PointFilter& about, int& failures)
{
  PointFilterTester test(about);
  auto sphere = SphereCloud();
  const vtkIdType count = sphere->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    double p[3];
    sphere->GetPoint(i, p);
    sphere->GetPoints()->InsertNextPoint(p);
  }
  CHECK(test.Quiet(sphere));
  auto pile = SphereCloud();
  for (int i = 0; i < 100; ++i)
  {
    double p[3];
    pile->GetPoint(7, p);
    pile->GetPoints()->InsertNextPoint(p);
  }
  CHECK(test.Quiet(pile));
  CHECK(PointDistance(pile, test.Denoise(pile)) > 1e-3);
}

void TestBadNumbers(const PointFilter& about, int& failures)
{
  PointFilterTester test(about);
  auto clean = SphereCloud();
  auto expected = Copy(test.Denoise(clean));
  auto cloud = Copy(clean);
  cloud->GetPoints()->InsertNextPoint(nan, 0.0, infinity);
  cloud->GetPoints()->InsertNextPoint(0.5, -infinity, 0.0);
  CHECK(test.Quiet(cloud));
  CHECK(CountStatus(test.Denoise(cloud), vtkPointDenoisingFilter::NOT_FINITE) == 2);
  CHECK(test.Filter->GetNumberOfPointsNotFinite() == 2);
  auto output = Copy(test.Denoise(cloud));
  output->GetPoints()->SetNumberOfPoints(clean->GetNumberOfPoints());
  CHECK(PointDistance(expected, output) == 0.0);

  // Nothing else is there.
  CHECK(test.Quiet(MakeCloud({ { nan, nan, nan } })));
  CHECK(test.Quiet(MakeCloud(Places(30, { 0.0, infinity, 0.0 }))));
  CHECK(test.Filter->GetNumberOfPointsNotFinite() == 30);
  CHECK(test.Quiet(MakeCloud({ { 0, 0, 0 }, { nan, 0, 0 }, { 1, 0, 0 } })));

  CHECK(test.Refuses(MakeCloud({ { 0, 0, 0 }, { 1e200, 0, 0 }, { 0, 1, 0 } }), "too large"));
}

void TestOutliers(const PointFilter& about, int& failures)
{
  PointFilterTester test(about);
  auto cloud = SphereCloud();
  const double before = Roughness(cloud);
  const vtkIdType count = cloud->GetNumberOfPoints();
  const Places far{ { 1e6, 0.0, 0.0 }, { 0.0, -3e6, 2.0 }, { 30.0, 30.0, 30.0 } };
  for (const auto& p : far)
  {
    cloud->GetPoints()->InsertNextPoint(p.data());
  }
  CHECK(test.Quiet(cloud));
  auto output = Copy(test.Denoise(cloud));
  output->GetPoints()->SetNumberOfPoints(count);
  CHECK(about.Is(AS_RELEASED) || Roughness(output) < 0.95 * before);
}

/// From atoms to galaxies, and further than anybody goes: the result is finite, and where squares
/// of areas are numbers it is the same as for size 1.
void TestSizes(const PointFilter& about, int& failures)
{
  if (about.Is(AS_RELEASED))
  {
    return;
  }
  PointFilterTester test(about);
  auto cloud = SphereCloud(300);
  auto expected = Copy(test.Denoise(cloud));
  for (const double size : { 1e-200, 1e-90, 1e-60, 1e-9, 1e9, 1e60, 1e90 })
  {
    vtkNew<vtkTransform> scale;
    scale->Scale(size, size, size);
    auto scaled = Moved(cloud, scale);
    vtkPolyData* output = test.Denoise(scaled);
    CHECK(!test.Seen->Errors.empty() || std::isfinite(PointDistance(scaled, output)));
    CHECK(!(size > 1e-70 && size < 1e70) ||
      PointDistance(Moved(expected, scale), output) < 1e-6 * size);
  }
  // Far from the origin little is left of the shape in single precision.
  for (const double distance : { 1e3, 1e5, 1e12 })
  {
    vtkNew<vtkTransform> shift;
    shift->Translate(distance, -distance, distance);
    auto far = Copy(cloud);
    far->GetPoints()->SetDataTypeToFloat();
    shift->TransformPoints(cloud->GetPoints(), far->GetPoints());
    CHECK(far->GetPoints()->GetDataType() == VTK_FLOAT && test.Quiet(far));
  }
}

/// Floats stay floats, doubles stay doubles, integers become doubles, whatever the layout.
void TestStorage(const PointFilter& about, int& failures)
{
  PointFilterTester test(about);
  auto cloud = SphereCloud(300);
  auto expected = Copy(test.Denoise(cloud));
  CHECK(expected->GetPoints()->GetDataType() == VTK_DOUBLE);
  vtkNew<vtkSOADataArrayTemplate<double>> parts;
  parts->SetNumberOfComponents(3);
  parts->SetNumberOfTuples(cloud->GetNumberOfPoints());
  auto single = Copy(cloud);
  single->GetPoints()->SetDataTypeToFloat();
  auto integers = Copy(cloud);
  integers->GetPoints()->SetDataTypeToInt();
  auto rounded = Copy(cloud);
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    double p[3];
    cloud->GetPoint(i, p);
    parts->SetTuple(i, p);
    single->GetPoints()->InsertNextPoint(p);
    integers->GetPoints()->InsertNextPoint(100.0 * p[0], 100.0 * p[1], 100.0 * p[2]);
    rounded->GetPoints()->SetPoint(i, integers->GetPoint(i));
  }
  auto split = Copy(cloud);
  split->GetPoints()->SetData(parts);
  CHECK(PointDistance(expected, test.Denoise(split)) == 0.0 && test.SaidNothing());
  CHECK(test.Quiet(single));
  CHECK(test.Filter->GetOutput()->GetPoints()->GetDataType() == VTK_FLOAT);
  CHECK(PointDistance(expected, test.Filter->GetOutput()) < 1e-3);
  CHECK(test.Quiet(integers));
  expected = Copy(test.Filter->GetOutput());
  CHECK(expected->GetPoints()->GetDataType() == VTK_DOUBLE);
  CHECK(PointDistance(expected, test.Denoise(rounded)) == 0.0);
}

/// Points of any cell and of none move as if there were no cells.
void TestCells(const PointFilter& about, int& failures)
{
  PointFilterTester test(about);
  auto mesh = NoisySphere(18, 0.012);
  mesh->GetPointData()->Initialize();
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(mesh);
  stripper->Update();
  auto strips = Copy(stripper->GetOutput());
  CHECK(strips->GetNumberOfStrips() > 0 && PointDistance(strips, mesh) == 0.0);
  auto bare = Copy(mesh);
  bare->SetPolys(nullptr);
  CHECK(test.Quiet(bare));
  auto expected = Copy(test.Filter->GetOutput());

  auto vertices = Copy(bare);
  AddVertices(vertices);
  CHECK(test.Quiet(vertices) && SameResult(expected, test.Filter->GetOutput()));

  auto lines = Copy(bare);
  vtkNew<vtkCellArray> curves;
  const vtkIdType curve[5] = { 3, 9, 4, 4, 12 };
  curves->InsertNextCell(5, curve);
  curves->InsertNextCell(2, curve);
  lines->SetLines(curves);
  CHECK(test.Quiet(lines) && SameResult(expected, test.Filter->GetOutput()));

  // Polygons tell where outside is, and nothing else.
  const double much = about.Is(AS_RELEASED) ? 1.0 : 1e-9;
  for (vtkPolyData* surface : { mesh.Get(), strips.Get() })
  {
    CHECK(test.Quiet(surface));
    CHECK(PointDistance(expected, test.Filter->GetOutput()) < much);
    surface->SetVerts(vertices->GetVerts());
    surface->SetLines(curves);
    CHECK(test.Quiet(surface));
    CHECK(PointDistance(expected, test.Filter->GetOutput()) < much);
  }
}

}

int TestPointInput(int, char*[])
{
  int failures = 0;
  TestAllPointFilters(TestFewPoints, failures);
  TestAllPointFilters(TestFlatShapes, failures);
  TestAllPointFilters(TestDuplicates, failures);
  TestAllPointFilters(TestBadNumbers, failures);
  TestAllPointFilters(TestOutliers, failures);
  TestAllPointFilters(TestSizes, failures);
  TestAllPointFilters(TestStorage, failures);
  TestAllPointFilters(TestCells, failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
