// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Cells of every kind, numbers of every size: every filter gives a sensible result or one clear
// error for each.

#include "FilterTester.h"

#include "vtkStripper.h"

#include <cstdlib>
#include <limits>

namespace
{

using namespace MeshTest;

const double nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

vtkSmartPointer<vtkPolyData> Sphere() { return NoisySphere(16, 0.015); }

vtkSmartPointer<vtkPolyData> OneTriangle(const Ids& polygon = { 0, 1, 2 })
{
  return MakeSurface({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { polygon });
}

void TestNothingToDo(const MeshFilter& about, int& failures)
{
  FilterTester test(about);
  vtkNew<vtkPolyData> empty;
  CHECK(test.Quiet(empty));

  auto cloud = MakeSurface({ { 0, 0, 0 }, { 1, 0, 0 } }, {});
  vtkPolyData* output = test.Denoise(cloud);
  CHECK(output->GetNumberOfPoints() == 2 && PointDistance(cloud, output) == 0.0);
  CHECK(test.Seen->Errors.empty());
  CHECK(test.Seen->Warnings.find("no polygons") != std::string::npos);

  auto triangle = OneTriangle();
  CHECK(test.Quiet(triangle));
  CHECK(about.Is(AS_RELEASED) || PointDistance(triangle, test.Denoise(triangle)) == 0.0);
}

void TestPolygons(const MeshFilter& about, int& failures)
{
  FilterTester test(about);
  auto quads = QuadGrid(12, 0.2);
  CHECK(test.Quiet(quads));
  vtkPolyData* output = test.Denoise(quads);
  CHECK(output->GetPolys()->GetMaxCellSize() == 4);
  CHECK(PointDistance(quads, output) > 1e-3);
  CHECK(test.Filter->GetNumberOfBoundaryEdges() == 48);
  CHECK(about.Is(AS_RELEASED) || output->GetPoint(0)[2] == quads->GetPoint(0)[2]);

  // An L-shaped hexagon beside a pentagon: a fan would cover area outside of the first.
  auto large = MakeSurface({ { 0, 0, 0.1 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 }, { 1, 2, 0 },
                             { 0, 2, 0 }, { 3, 0, 0 }, { 4, 1, 0.2 }, { 3, 2, 0 } },
    { { 0, 1, 2, 3, 4, 5 }, { 1, 6, 7, 8, 2 } });
  CHECK(test.Quiet(large));

  // Strips move as the triangles that they are made of.
  auto sphere = Sphere();
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(sphere);
  stripper->Update();
  vtkPolyData* strips = stripper->GetOutput();
  CHECK(strips->GetNumberOfStrips() > 0);
  auto fromTriangles = Copy(test.Denoise(sphere));
  CHECK(test.Quiet(strips));
  output = test.Denoise(strips);
  CHECK(PointDistance(fromTriangles, output) < 1e-6);
  CHECK(output->GetNumberOfStrips() == strips->GetNumberOfStrips());
}

void TestBadNumbers(const MeshFilter& about, int& failures)
{
  FilterTester test(about);
  for (const double bad : { nan, infinity, -infinity })
  {
    auto sphere = Sphere();
    sphere->GetPoints()->SetPoint(17, 0.0, bad, 0.0);
    CHECK(test.Refuses(sphere, "Point 17"));
    auto quads = QuadGrid(4, 0.1);
    quads->GetPoints()->SetPoint(7, 0.0, bad, 0.0);
    CHECK(test.Refuses(quads, "Point 7"));
  }
  // Without a polygon the point concerns nobody.
  auto sphere = Sphere();
  const vtkIdType stray = sphere->GetPoints()->InsertNextPoint(nan, 0.0, infinity);
  vtkPolyData* output = test.Denoise(sphere);
  CHECK(test.SaidNothing());
  CHECK(std::isnan(output->GetPoint(stray)[0]) && output->GetPoint(stray)[2] == infinity);
  double largest = 0.0;
  for (vtkIdType i = 0; i < stray; ++i)
  {
    double p[3];
    double q[3];
    sphere->GetPoint(i, p);
    output->GetPoint(i, q);
    const double d = std::sqrt(vtkMath::Distance2BetweenPoints(p, q));
    largest = std::isfinite(d) ? std::max(largest, d) : infinity;
  }
  CHECK(largest > 1e-4 && std::isfinite(largest));

  CHECK(test.Refuses(OneTriangle({ 0, 1, 3 }), "Cell 0"));
  auto missing = OneTriangle();
  const vtkIdType negative[4] = { 0, 1, 2, -1 };
  missing->GetPolys()->InsertNextCell(4, negative);
  CHECK(test.Refuses(missing, "Cell 1"));

  auto huge = MakeSurface({ { 0, 0, 0 }, { 1e200, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } });
  CHECK(test.Refuses(huge, "too large"));
}

/// From atoms to galaxies, and further than anybody goes: the result is finite, and where products
/// of four lengths are numbers it is the same as for size 1.
void TestSizes(const MeshFilter& about, int& failures)
{
  FilterTester test(about);
  vtkNew<vtkTransform> identity;
  auto sphere = Moved(Sphere(), identity);
  auto expected = Copy(test.Denoise(sphere));
  for (const double size : { 1e-200, 1e-90, 1e-60, 1e-9, 1e9, 1e60, 1e90, 9e99 })
  {
    vtkNew<vtkTransform> scale;
    scale->Scale(size, size, size);
    auto scaled = Moved(sphere, scale);
    vtkPolyData* output = test.Denoise(scaled);
    CHECK(!test.Seen->Errors.empty() || std::isfinite(PointDistance(scaled, output)));
    if (!about.Is(AS_RELEASED) && size > 1e-70 && size < 1e70)
    {
      CHECK(PointDistance(Moved(expected, scale), output) < 1e-6 * size);
    }
  }
  // Far from the origin little is left of the shape in single precision.
  vtkNew<vtkTransform> shift;
  for (const double distance : { 1e3, 1e5, 1e12 })
  {
    shift->Identity();
    shift->Translate(distance, -distance, distance);
    auto far = Copy(sphere);
    far->GetPoints()->SetDataTypeToFloat();
    shift->TransformPoints(sphere->GetPoints(), far->GetPoints());
    CHECK(test.Quiet(far));
  }
}

/// Points that keep their place, as those of which no new one could be computed.
int Unmoved(vtkPolyData* input, vtkPolyData* output)
{
  int count = 0;
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    double p[3];
    input->GetPoint(i, p);
    count += vtkMath::Distance2BetweenPoints(p, output->GetPoint(i)) == 0.0;
  }
  return count;
}

void TestDegenerateFaces(const MeshFilter& about, int& failures)
{
  FilterTester test(about);
  // A repeated vertex, three vertices on a line, two vertices at one place, and a polygon of two
  // points.
  auto sphere = Sphere();
  vtkNew<vtkIdList> corners;
  sphere->GetPolys()->GetCellAtId(100, corners);
  const vtkIdType a = corners->GetId(0);
  const vtkIdType b = corners->GetId(1);
  double p[3];
  double q[3];
  sphere->GetPoint(a, p);
  sphere->GetPoint(b, q);
  const vtkIdType middle = sphere->GetPoints()->InsertNextPoint(0.5 * (p[0] + q[0]),
    0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2]));
  const vtkIdType twin = sphere->GetPoints()->InsertNextPoint(p);
  const std::vector<Ids> degenerate{ { a, a, b }, { a, a, a }, { a, middle, b }, { a, twin, b } };
  for (const auto& polygon : degenerate)
  {
    sphere->GetPolys()->InsertNextCell(3, polygon.data());
  }
  CHECK(test.Quiet(sphere));
  CHECK(Unmoved(sphere, test.Denoise(sphere)) < 10);
  // In single precision the middle of an edge is not quite on it.
  CHECK(test.Filter->GetNumberOfDegenerateFaces() >= 3);

  auto edge = MakeSurface({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1 }, { 0, 1, 2 } });
  CHECK(test.Quiet(edge));
  CHECK(test.Quiet(MakeSurface({ { 1, 1, 1 }, { 1, 1, 1 }, { 1, 1, 1 } }, { { 0, 1, 2 } })));
  CHECK(test.Quiet(MakeSurface({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 } },
    { { 0, 1, 2 }, { 1, 2, 3 }, { 0, 0, 0 } })));

  // A face twice, and one with a back: centroids that coincide.
  CHECK(test.Quiet(
    MakeSurface({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 1, 2 } })));
  CHECK(test.Quiet(
    MakeSurface({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 2, 1, 0 } })));
  auto doubled = Sphere();
  for (vtkIdType cell = 0; cell < 20; ++cell)
  {
    doubled->GetPolys()->GetCellAtId(7 * cell, corners);
    doubled->GetPolys()->InsertNextCell(corners);
  }
  CHECK(test.Quiet(doubled));
  const vtkIdType lonely = doubled->GetPoints()->InsertNextPoint(1.0, 1.0, 1.0);
  doubled->GetPoints()->InsertNextPoint(1.1, 1.0, 1.0);
  doubled->GetPoints()->InsertNextPoint(1.0, 1.1, 1.0);
  const vtkIdType leaf[3] = { lonely, lonely + 1, lonely + 2 };
  doubled->GetPolys()->InsertNextCell(3, leaf);
  doubled->GetPolys()->InsertNextCell(3, leaf);
  doubled->Modified();
  CHECK(test.Quiet(doubled));
  CHECK(Unmoved(doubled, test.Denoise(doubled)) < 10);
  LimitIterations(test.Filter, 1); // more may hide what became of the doubled face
  CHECK(test.Quiet(doubled));
}

void TestStorage(const MeshFilter& about, int& failures)
{
  FilterTester test(about);
  auto sphere = Sphere();
  auto expected = Copy(test.Denoise(sphere));
  for (const bool wide : { false, true })
  {
    auto copy = Copy(sphere);
    CHECK(
      wide ? copy->GetPolys()->ConvertTo64BitStorage() : copy->GetPolys()->ConvertTo32BitStorage());
    CHECK(PointDistance(expected, test.Denoise(copy)) == 0.0);
  }

  // Integer coordinates become doubles, floats stay floats.
  for (const int type : { VTK_INT, VTK_UNSIGNED_SHORT, VTK_LONG_LONG })
  {
    auto grid = QuadGrid(6, 0.0);
    vtkNew<vtkPoints> integers;
    integers->SetDataType(type);
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      const double* p = grid->GetPoint(i);
      integers->InsertNextPoint(p[0], p[1], i % 2 == 0 ? 0.0 : 1.0);
    }
    grid->SetPoints(integers);
    CHECK(test.Quiet(grid));
    CHECK(test.Denoise(grid)->GetPoints()->GetDataType() == VTK_DOUBLE);
  }
  CHECK(test.Denoise(sphere)->GetPoints()->GetDataType() == VTK_FLOAT);
}

}

int TestMeshInput(int, char*[])
{
  int failures = 0;
  TestAllMeshFilters(TestNothingToDo, failures);
  TestAllMeshFilters(TestPolygons, failures);
  TestAllMeshFilters(TestBadNumbers, failures);
  TestAllMeshFilters(TestSizes, failures);
  TestAllMeshFilters(TestDegenerateFaces, failures);
  TestAllMeshFilters(TestStorage, failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
