// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Inputs that are not a clean triangle mesh: a sensible result or one clear error for each.

#include "MeshTestTools.h"

#include "vtkAppendPolyData.h"
#include "vtkBilateralNormalFilter.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkStripper.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkTriangleFilter.h"

#include <cstdlib>
#include <limits>

namespace
{

using MeshTest::MakeSurface;
using MeshTest::NoisySphere;
using MeshTest::PointDistance;
using MeshTest::Roughness;
using Polygons = std::vector<std::vector<vtkIdType>>;

const double nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

class Tester
{
public:
  Tester() { this->Seen->Watch(this->Filter); }

  vtkPolyData* Denoise(vtkPolyData* input)
  {
    return MeshTest::Run(this->Filter, input, this->Seen);
  }
  /// The result is finite and nothing was said.
  bool Quiet(vtkPolyData* input)
  {
    vtkPolyData* output = this->Denoise(input);
    return this->Seen->Errors.empty() && this->Seen->Warnings.empty() &&
      output->GetNumberOfCells() == input->GetNumberOfCells() &&
      std::isfinite(PointDistance(input, output));
  }
  /// One error that contains the text, and no output.
  bool Refuses(vtkPolyData* input, const std::string& text)
  {
    vtkPolyData* output = this->Denoise(input);
    return this->Seen->Errors.find(text) != std::string::npos && output->GetNumberOfPoints() == 0;
  }

  vtkNew<vtkBilateralNormalFilter> Filter;
  vtkNew<MeshTest::Messages> Seen;
};

void TestNothingToDo(Tester& test, int& failures)
{
  vtkNew<vtkPolyData> empty;
  CHECK(test.Quiet(empty));

  auto cloud = MakeSurface({ { 0, 0, 0 }, { 1, 0, 0 } }, {});
  vtkPolyData* output = test.Denoise(cloud);
  CHECK(output->GetNumberOfPoints() == 2 && PointDistance(cloud, output) == 0.0);
  CHECK(test.Seen->Warnings.find("no polygons") != std::string::npos);

  auto triangle = MakeSurface({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } });
  CHECK(test.Quiet(triangle) && PointDistance(triangle, test.Denoise(triangle)) == 0.0);
}

void TestPolygons(Tester& test, int& failures)
{
  auto quads = MeshTest::QuadGrid(20, 0.2);
  CHECK(test.Quiet(quads));
  vtkPolyData* output = test.Denoise(quads);
  CHECK(output->GetPolys()->GetMaxCellSize() == 4);
  CHECK(output->GetCellData()->GetArray("FilteredNormals")->GetNumberOfTuples() == 400);
  CHECK(PointDistance(quads, output) > 0.01);

  // An L-shaped hexagon beside a pentagon: a fan would cover area outside of the first.
  auto large = MakeSurface({ { 0, 0, 0.1 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 }, { 1, 2, 0 },
                             { 0, 2, 0 }, { 3, 0, 0 }, { 4, 1, 0.2 }, { 3, 2, 0 } },
    { { 0, 1, 2, 3, 4, 5 }, { 1, 6, 7, 8, 2 } });
  CHECK(test.Quiet(large));

  // Strips move as the triangles that they are made of.
  auto sphere = NoisySphere();
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(sphere);
  stripper->Update();
  vtkPolyData* strips = stripper->GetOutput();
  CHECK(strips->GetNumberOfStrips() > 0);
  vtkNew<vtkPolyData> fromTriangles;
  fromTriangles->DeepCopy(test.Denoise(sphere));
  CHECK(test.Quiet(strips));
  output = test.Denoise(strips);
  CHECK(PointDistance(fromTriangles, output) < 1e-6);
  CHECK(output->GetNumberOfStrips() == strips->GetNumberOfStrips());
}

void TestBadNumbers(Tester& test, int& failures)
{
  for (const double bad : { nan, infinity, -infinity })
  {
    auto sphere = NoisySphere();
    sphere->GetPoints()->SetPoint(17, 0.0, bad, 0.0);
    CHECK(test.Refuses(sphere, "Point 17"));
    auto quads = MeshTest::QuadGrid(4, 0.1);
    quads->GetPoints()->SetPoint(7, 0.0, bad, 0.0);
    CHECK(test.Refuses(quads, "Point 7"));
  }
  // Without a polygon the point concerns nobody.
  auto sphere = NoisySphere();
  const vtkIdType stray = sphere->GetPoints()->InsertNextPoint(nan, 0.0, 0.0);
  vtkPolyData* output = test.Denoise(sphere);
  CHECK(test.Seen->Errors.empty());
  CHECK(std::isnan(output->GetPoint(stray)[0]));
  CHECK(output->GetPoint(0)[2] != sphere->GetPoint(0)[2]);

  auto missing = MakeSurface({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 3 } });
  CHECK(test.Refuses(missing, "Cell 0"));
  missing =
    MakeSurface({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 1, 2, -1 } });
  CHECK(test.Refuses(missing, "Cell 1"));

  auto huge = MakeSurface({ { 0, 0, 0 }, { 1e200, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } });
  CHECK(test.Refuses(huge, "too large"));
}

void TestDegenerateFaces(Tester& test, int& failures)
{
  // A repeated vertex, three vertices on a line, two vertices at one place, and a polygon of two
  // points.
  auto sphere = NoisySphere();
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
  const Polygons degenerate{ { a, a, b }, { a, a, a }, { a, middle, b }, { a, twin, b } };
  for (const auto& polygon : degenerate)
  {
    sphere->GetPolys()->InsertNextCell(3, polygon.data());
  }
  CHECK(test.Quiet(sphere));
  // In single precision the middle of an edge is not quite on it.
  CHECK(test.Filter->GetNumberOfDegenerateFaces() >= 3);

  auto edge = MakeSurface({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1 }, { 0, 1, 2 } });
  CHECK(test.Quiet(edge));

  auto allFlat = MakeSurface({ { 1, 1, 1 }, { 1, 1, 1 }, { 1, 1, 1 } }, { { 0, 1, 2 } });
  CHECK(test.Quiet(allFlat));
}

/// Every triangle has points of its own, as in an STL file.
vtkSmartPointer<vtkPolyData> Soup(vtkPolyData* surface)
{
  std::vector<std::array<double, 3>> points;
  Polygons triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetCellPoints(cell, ids);
    std::vector<vtkIdType> triangle;
    for (vtkIdType i = 0; i < 3; ++i)
    {
      double p[3];
      surface->GetPoint(ids->GetId(i), p);
      triangle.push_back(static_cast<vtkIdType>(points.size()));
      points.push_back({ p[0], p[1], p[2] });
    }
    triangles.push_back(triangle);
  }
  return MakeSurface(points, triangles);
}

void TestTopology(Tester& test, int& failures)
{
  auto sphere = NoisySphere();
  vtkNew<vtkPolyData> clean;
  clean->DeepCopy(test.Denoise(sphere));
  CHECK(Roughness(clean) < 0.7 * Roughness(sphere));

  // Duplicate points: the soup moves as the mesh it shows.
  auto soup = Soup(sphere);
  CHECK(test.Quiet(soup));
  CHECK(PointDistance(Soup(clean), test.Denoise(soup)) < 1e-6);
  CHECK(test.Filter->GetNumberOfSeamPoints() ==
    soup->GetNumberOfPoints() - sphere->GetNumberOfPoints());

  // Inconsistent orientation: every third face turned round, same points, turned normals.
  vtkNew<vtkPolyData> turned;
  turned->DeepCopy(sphere);
  turned->BuildCells();
  for (vtkIdType cell = 0; cell < turned->GetNumberOfCells(); cell += 3)
  {
    turned->ReverseCell(cell);
  }
  CHECK(test.Quiet(turned));
  vtkPolyData* output = test.Denoise(turned);
  CHECK(PointDistance(clean, output) < 1e-6);
  CHECK(test.Filter->GetNumberOfTurnedFaces() > 0);
  vtkDataArray* normals = output->GetCellData()->GetArray("FilteredNormals");
  vtkDataArray* expected = clean->GetCellData()->GetArray("FilteredNormals");
  for (vtkIdType cell = 0; cell < turned->GetNumberOfCells(); ++cell)
  {
    double m[3];
    double n[3];
    normals->GetTuple(cell, m);
    expected->GetTuple(cell, n);
    const double sign = cell % 3 == 0 ? -1.0 : 1.0;
    CHECK(sign * vtkMath::Dot(m, n) > 1.0 - 1e-6);
  }

  // Several components: each as if it were alone.
  vtkNew<vtkTransform> aside;
  aside->Translate(3.0, 0.0, 0.0);
  vtkNew<vtkTransformPolyDataFilter> moved;
  moved->SetTransform(aside);
  moved->SetInputData(sphere);
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(sphere);
  both->AddInputConnection(moved->GetOutputPort());
  both->Update();
  CHECK(test.Quiet(both->GetOutput()));
  output = test.Denoise(both->GetOutput());
  double largest = 0.0;
  for (vtkIdType i = 0; i < clean->GetNumberOfPoints(); ++i)
  {
    largest = std::max(largest,
      std::sqrt(vtkMath::Distance2BetweenPoints(clean->GetPoint(i),
        std::array<double, 3>{ output->GetPoint(i)[0], output->GetPoint(i)[1],
          output->GetPoint(i)[2] }
          .data())));
  }
  CHECK(largest < 1e-5);

  // Three sheets at one edge.
  auto sheets =
    MakeSurface({ { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0.5 }, { -1, 0.1, 0.5 }, { 0, 1, 0.5 } },
      { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } });
  CHECK(test.Quiet(sheets));
  CHECK(test.Filter->GetNumberOfNonManifoldEdges() == 1);
}

void TestStorage(Tester& test, int& failures)
{
  auto sphere = NoisySphere();
  vtkNew<vtkPolyData> expected;
  expected->DeepCopy(test.Denoise(sphere));
  for (const bool wide : { false, true })
  {
    vtkNew<vtkPolyData> copy;
    copy->DeepCopy(sphere);
    CHECK(
      wide ? copy->GetPolys()->ConvertTo64BitStorage() : copy->GetPolys()->ConvertTo32BitStorage());
    CHECK(PointDistance(expected, test.Denoise(copy)) == 0.0);
  }

  // Integer coordinates become doubles, floats stay floats.
  vtkNew<vtkPolyData> grid;
  grid->DeepCopy(MeshTest::QuadGrid(6, 0.0));
  vtkNew<vtkPoints> integers;
  integers->SetDataType(VTK_INT);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const double* p = grid->GetPoint(i);
    integers->InsertNextPoint(p[0], p[1], i % 2 == 0 ? 0.0 : 1.0);
  }
  grid->SetPoints(integers);
  CHECK(test.Quiet(grid));
  CHECK(test.Denoise(grid)->GetPoints()->GetDataType() == VTK_DOUBLE);
  CHECK(test.Denoise(sphere)->GetPoints()->GetDataType() == VTK_FLOAT);
}

}

int TestMeshInput(int, char*[])
{
  int failures = 0;
  Tester test;
  TestNothingToDo(test, failures);
  TestPolygons(test, failures);
  TestBadNumbers(test, failures);
  TestDegenerateFaces(test, failures);
  TestTopology(test, failures);
  TestStorage(test, failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
