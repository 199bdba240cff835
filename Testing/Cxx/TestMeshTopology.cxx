// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Surfaces whose faces do not quite belong together: every filter works on what they show.

#include "FilterTester.h"

#include <cstdlib>

namespace
{

using namespace MeshTest;

/// Double precision, so that rounding is far below what is compared.
vtkSmartPointer<vtkPolyData> Sphere()
{
  vtkNew<vtkTransform> identity;
  return Moved(NoisySphere(20, 0.012), identity);
}

/// The points and triangles of both.
vtkSmartPointer<vtkPolyData> Joined(vtkPolyData* a, vtkPolyData* b)
{
  std::vector<std::array<double, 3>> points;
  std::vector<Ids> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkPolyData* part : { a, b })
  {
    const auto first = static_cast<vtkIdType>(points.size());
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      points.emplace_back();
      part->GetPoint(i, points.back().data());
    }
    for (vtkIdType cell = 0; cell < part->GetNumberOfCells(); ++cell)
    {
      part->GetCellPoints(cell, ids);
      triangles.push_back({ first + ids->GetId(0), first + ids->GetId(1), first + ids->GetId(2) });
    }
  }
  return MakeSurface(points, triangles);
}

/// Duplicate points: the soup moves as the mesh it shows.
void TestSeams(const MeshFilter& about, int& failures)
{
  FilterTester test(about);
  auto sphere = Sphere();
  auto clean = Copy(test.Denoise(sphere));
  auto soup = Soup(sphere);
  CHECK(test.Quiet(soup));
  if (about.Is(AS_RELEASED))
  {
    CHECK(test.Filter->GetNumberOfSeamPoints() == 0);
    return;
  }
  CHECK(PointDistance(Soup(clean), test.Denoise(soup)) < 1e-9);
  CHECK(test.Filter->GetNumberOfSeamPoints() ==
    soup->GetNumberOfPoints() - sphere->GetNumberOfPoints());
  CHECK(test.Filter->GetNumberOfBoundaryEdges() == 0);
}

/// Inconsistent orientation: same points, turned normals.
void TestTurnedFaces(const MeshFilter& about, int& failures)
{
  FilterTester test(about);
  auto sphere = Sphere();
  auto clean = Copy(test.Denoise(sphere));
  auto turned = Turned(sphere);
  CHECK(test.Quiet(turned));
  vtkPolyData* output = test.Denoise(turned);
  if (about.Is(AS_RELEASED))
  {
    CHECK(test.Filter->GetNumberOfTurnedFaces() == 0);
    return;
  }
  CHECK(PointDistance(clean, output) < 1e-9);
  CHECK(test.Filter->GetNumberOfTurnedFaces() == (sphere->GetNumberOfCells() + 2) / 3);
  vtkDataArray* normals = output->GetCellData()->GetArray("FilteredNormals");
  vtkDataArray* expected = clean->GetCellData()->GetArray("FilteredNormals");
  for (vtkIdType cell = 0; normals && cell < turned->GetNumberOfCells(); ++cell)
  {
    double m[3];
    double n[3];
    normals->GetTuple(cell, m);
    expected->GetTuple(cell, n);
    const double sign = cell % 3 == 0 ? -1.0 : 1.0;
    CHECK(sign * vtkMath::Dot(m, n) > 1.0 - 1e-9);
  }

  // Both at once, as files from several programs have it.
  CHECK(PointDistance(Soup(clean), test.Denoise(Turned(Soup(sphere)))) < 1e-9);
}

/// Several components: each as if it were alone.
void TestComponents(const MeshFilter& about, int& failures)
{
  FilterTester test(about);
  auto sphere = Sphere();
  auto clean = Copy(test.Denoise(sphere));
  vtkNew<vtkTransform> aside;
  aside->Translate(4.0, 0.0, 0.0);
  auto both = Joined(sphere, Moved(sphere, aside));
  CHECK(test.Quiet(both));
  if (!about.Is(AS_RELEASED) && !about.Is(WHOLE_VOLUME))
  {
    CHECK(PointDistance(Joined(clean, Moved(clean, aside)), test.Denoise(both)) < 1e-7);
  }

  // They may touch at a point or lie at the same place.
  vtkNew<vtkTransform> here;
  CHECK(test.Quiet(Joined(sphere, Moved(sphere, here))));
  CHECK(test.Quiet(MakeSurface(
    { { 0, 0, 0 }, { 1, 0, 0.1 }, { 1, 1, 0 }, { -1, 0, 0 }, { -1, -1, 0.1 }, { 0, 1, 0.2 } },
    { { 0, 1, 2 }, { 0, 3, 4 }, { 0, 2, 5 } })));
}

void TestNonManifold(const MeshFilter& about, int& failures)
{
  FilterTester test(about);
  // Three sheets at one edge.
  CHECK(test.Quiet(
    MakeSurface({ { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0.5 }, { -1, 0.1, 0.5 }, { 0, 1, 0.5 } },
      { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } })));
  CHECK(test.Filter->GetNumberOfNonManifoldEdges() == 1);

  // With faces that are none among them.
  CHECK(test.Quiet(MakeSurface(
    { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0.5 }, { -1, 0.1, 0.5 }, { 0, 1, 0.5 }, { 0, 0, 0.5 } },
    { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 }, { 0, 5, 1 }, { 0, 0, 1 }, { 3, 3, 3 } })));

  // A wall through a sphere: its faces hang on points of the sphere all around.
  auto sphere = Sphere();
  const vtkIdType middle = sphere->GetPoints()->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < 60; ++cell)
  {
    sphere->GetPolys()->GetCellAtId(200 + cell, corners);
    const vtkIdType wall[3] = { corners->GetId(0), corners->GetId(1), middle };
    sphere->GetPolys()->InsertNextCell(3, wall);
  }
  CHECK(test.Quiet(sphere));
  CHECK(test.Filter->GetNumberOfNonManifoldEdges() > 30);

  // A strip with half a turn has no orientation.
  std::vector<std::array<double, 3>> points;
  std::vector<Ids> triangles;
  const vtkIdType count = 24;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * static_cast<double>(i) / count;
    for (const double side : { -0.3, 0.3 })
    {
      const double r = 1.0 + side * std::cos(0.5 * angle);
      points.push_back({ r * std::cos(angle), r * std::sin(angle),
        side * std::sin(0.5 * angle) + 0.02 * Wobble(i) });
    }
    const bool last = i + 1 == count;
    const vtkIdType a = 2 * i;
    const vtkIdType c = last ? 1 : a + 2;
    const vtkIdType d = last ? 0 : a + 3;
    triangles.push_back({ a, c, d });
    triangles.push_back({ a, d, a + 1 });
  }
  CHECK(test.Quiet(MakeSurface(points, triangles)));
}

/// Points of no polygon stay, wherever they are among the others, and nobody notices them.
void TestIsolatedPoints(const MeshFilter& about, int& failures)
{
  FilterTester test(about);
  auto sphere = Sphere();
  auto clean = Copy(test.Denoise(sphere));
  const vtkIdType count = sphere->GetNumberOfPoints();
  std::vector<std::array<double, 3>> points{ { 5.0, 6.0, 7.0 } };
  for (vtkIdType i = 0; i < count; ++i)
  {
    points.emplace_back();
    sphere->GetPoint(i, points.back().data());
    if (i == 30)
    {
      points.push_back({ -70.0, 0.01, 0.02 });
    }
  }
  points.push_back(points[5]); // at the place of another one
  std::vector<Ids> triangles;
  vtkNew<vtkIdList> ids;
  auto newId = [](vtkIdType id) { return id > 30 ? id + 2 : id + 1; };
  for (vtkIdType cell = 0; cell < sphere->GetNumberOfCells(); ++cell)
  {
    sphere->GetCellPoints(cell, ids);
    triangles.push_back({ newId(ids->GetId(0)), newId(ids->GetId(1)), newId(ids->GetId(2)) });
  }
  auto surface = MakeSurface(points, triangles);
  CHECK(test.Quiet(surface));
  vtkPolyData* output = test.Denoise(surface);
  for (const vtkIdType lonely : { vtkIdType(0), vtkIdType(32), count + 2 })
  {
    CHECK(vtkMath::Distance2BetweenPoints(output->GetPoint(lonely),
            points[static_cast<std::size_t>(lonely)].data()) == 0.0);
  }
  double largest = 0.0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    double p[3];
    clean->GetPoint(i, p);
    const double* q = output->GetPoint(newId(i));
    largest = std::max(largest, std::sqrt(vtkMath::Distance2BetweenPoints(p, q)));
  }
  CHECK(about.Is(AS_RELEASED) || largest < 1e-9);
}

}

int TestMeshTopology(int, char*[])
{
  int failures = 0;
  TestAllMeshFilters(TestSeams, failures);
  TestAllMeshFilters(TestTurnedFaces, failures);
  TestAllMeshFilters(TestComponents, failures);
  TestAllMeshFilters(TestNonManifold, failures);
  TestAllMeshFilters(TestIsolatedPoints, failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
