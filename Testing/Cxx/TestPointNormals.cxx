// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Where the normals come from that filters for point sets start with, what is wrong with them, and
// what becomes of them.

#include "PointFilterTester.h"

#include "vtkDataObject.h"
#include "vtkNormalPointUpdate.h"
#include "vtkStripper.h"

#include <cstdlib>

namespace
{

using namespace PointTest;

void StartFrom(vtkAlgorithm* filter, const char* name)
{
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
}

/// The chosen array comes before the active normals, those before an array called Normals.
void TestWhichNormals(const PointFilter& about, int& failures)
{
  if (about.Is(AS_RELEASED))
  {
    return;
  }
  auto bare = SphereCloud();
  PointFilterTester test(about);
  auto fitted = Copy(test.Denoise(bare));
  CHECK(test.Filter->GetNumberOfFittedNormals() == bare->GetNumberOfPoints());

  auto named = Copy(bare);
  named->GetPointData()->AddArray(SphereNormals(bare, "Normals", 0.2));
  CHECK(named->GetPointData()->GetNormals() == nullptr && test.Quiet(named));
  auto expected = Copy(test.Filter->GetOutput());
  CHECK(test.Filter->GetNumberOfFittedNormals() == 0);
  // Those that look at positions alone take the side.
  const bool same = about.Is(IGNORES_NORMALS);
  CHECK(SameResult(fitted, expected) == same);

  auto active = Copy(bare);
  active->GetPointData()->SetNormals(SphereNormals(bare, "Normals", 0.2));
  CHECK(test.Quiet(active) && SameResult(expected, test.Filter->GetOutput()));

  // With another name, and others that are called Normals.
  active = Copy(bare);
  active->GetPointData()->SetNormals(SphereNormals(bare, "Mine", 0.2));
  active->GetPointData()->AddArray(SphereNormals(bare, "Normals", 0.4));
  CHECK(test.Quiet(active) && SameResult(expected, test.Filter->GetOutput()));
  vtkPointData* output = test.Filter->GetOutput()->GetPointData();
  CHECK(SameArray(output->GetArray("Mine"), active->GetPointData()->GetArray("Mine")));

  auto chosen = Copy(bare);
  chosen->GetPointData()->SetNormals(SphereNormals(bare, "Active", 0.4));
  chosen->GetPointData()->AddArray(SphereNormals(bare, "Normals", 0.4));
  chosen->GetPointData()->AddArray(SphereNormals(bare, "Mine", 0.2));
  CHECK(SameResult(expected, test.Denoise(chosen)) == same);
  StartFrom(test.Filter, "None");
  CHECK(SameResult(expected, test.Denoise(chosen)) == same);
  StartFrom(test.Filter, "Mine");
  CHECK(test.Quiet(chosen) && SameResult(expected, test.Filter->GetOutput()));
  StartFrom(test.Filter, "Active");
  CHECK(SameResult(expected, test.Denoise(chosen)) == same);
  // Of floats, and of any length.
  StartFrom(test.Filter, "Mine");
  chosen->GetPointData()->AddArray(SphereNormals(bare, "Mine", 0.2, 7e30));
  CHECK(test.Quiet(chosen) && PointDistance(expected, test.Filter->GetOutput()) < 1e-9);
}

/// What the settings say is taken.
void TestSources(const PointFilter& about, int& failures)
{
  if (about.Is(AS_RELEASED))
  {
    return;
  }
  using Filter = vtkPointDenoisingFilter;
  auto bare = SphereCloud();
  auto given = Copy(bare);
  given->GetPointData()->SetNormals(SphereNormals(bare, "Normals", 0.3));
  for (const int source : { Filter::AUTOMATIC, Filter::INPUT })
  {
    PointFilterTester test(about);
    test.Filter->SetNormalSource(source);
    CHECK(test.Quiet(given) && test.Filter->GetNumberOfFittedNormals() == 0);
  }
  for (const int source : { Filter::PLANE_FIT, Filter::ROBUST_FIT })
  {
    // Those of the input tell the side.
    PointFilterTester test(about);
    test.Filter->SetNormalSource(source);
    CHECK(test.Quiet(bare));
    auto expected = Copy(test.Filter->GetOutput());
    CHECK(test.Quiet(given) && SameResult(expected, test.Filter->GetOutput()));
    CHECK(test.Filter->GetNumberOfFittedNormals() == bare->GetNumberOfPoints());
    auto inside = Copy(bare);
    inside->GetPointData()->SetNormals(SphereNormals(bare, "Normals", 0.3, -1.0));
    CHECK(test.Quiet(inside));
    CHECK(Outwards(expected) > 0.9 * 600 && Outwards(test.Filter->GetOutput()) < -0.9 * 600);
    CHECK(PointDistance(expected, test.Filter->GetOutput()) < 1e-9);
  }

  PointFilterTester test(about);
  test.Filter->SetNormalSourceToInput();
  CHECK(test.Refuses(bare, "no point normals"));
  auto lines = Copy(bare);
  vtkNew<vtkCellArray> curve;
  const vtkIdType ids[3] = { 1, 2, 3 };
  curve->InsertNextCell(3, ids);
  lines->SetLines(curve);
  AddVertices(lines);
  CHECK(test.Refuses(lines, "no point normals"));
  vtkNew<vtkPolyData> empty;
  CHECK(test.Quiet(empty));
}

/// Arrays that cannot be normals are errors.
void TestWrongArrays(const PointFilter& about, int& failures)
{
  auto cloud = SphereCloud(100);
  PointFilterTester test(about);
  StartFrom(test.Filter, "Mine");
  CHECK(test.Refuses(cloud, "no point array Mine"));
  vtkNew<vtkDoubleArray> elsewhere;
  elsewhere->DeepCopy(SphereNormals(cloud, "Mine"));
  AddVertices(cloud);
  cloud->GetCellData()->AddArray(elsewhere);
  CHECK(test.Refuses(cloud, "no point array Mine"));
  test.Filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Mine");
  CHECK(test.Refuses(cloud, "no point array Mine"));
  StartFrom(test.Filter, "Mine");
  for (const int components : { 1, 2, 4 })
  {
    vtkNew<vtkDoubleArray> flat;
    flat->SetName("Mine");
    flat->SetNumberOfComponents(components);
    flat->SetNumberOfTuples(cloud->GetNumberOfPoints());
    flat->FillValue(1.0);
    cloud->GetPointData()->AddArray(flat);
    CHECK(test.Refuses(cloud, "Array Mine is no field of point normals"));
  }
  auto normals = SphereNormals(cloud, "Mine");
  for (const vtkIdType count : { 99, 0, 101 })
  {
    normals->SetNumberOfTuples(count);
    normals->Modified();
    cloud->GetPointData()->AddArray(normals);
    CHECK(test.Refuses(cloud, "Array Mine is no field of point normals"));
  }
  StartFrom(test.Filter, "None");
  normals->SetName("Normals");
  CHECK(test.Refuses(cloud, "Array Normals is no field of point normals"));
  cloud->GetPointData()->SetNormals(normals);
  CHECK(test.Refuses(cloud, "Array Normals is no field of point normals"));
  // The next execution is as if nothing had been.
  cloud->GetPointData()->Initialize();
  CHECK(test.Quiet(cloud));
}

/// Points without a normal, zero or not finite, get one.
void TestMissingNormals(const PointFilter& about, int& failures)
{
  if (about.Is(AS_RELEASED))
  {
    return;
  }
  auto cloud = SphereCloud();
  PointFilterTester test(about);
  for (const double bad : { 0.0, vtkMath::Nan(), vtkMath::Inf() })
  {
    auto normals = SphereNormals(cloud, "Normals", 0.1);
    for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); i += 3)
    {
      normals->SetTuple3(i, bad, bad, bad);
    }
    cloud->GetPointData()->SetNormals(normals);
    CHECK(test.Quiet(cloud) && test.Filter->GetNumberOfFittedNormals() == 200);
    CHECK(Outwards(test.Filter->GetOutput()) > 0.9 * 600);
    test.Filter->SetNormalSourceToInput();
    CHECK(test.Quiet(cloud) && test.Filter->GetNumberOfFittedNormals() == 200);
    test.Filter->SetNormalSourceToAutomatic();
    normals->FillValue(bad);
    normals->Modified();
    CHECK(test.Quiet(cloud) && test.Filter->GetNumberOfFittedNormals() == 600);
    CHECK(Outwards(test.Filter->GetOutput()) > 0.9 * 600);
  }
}

/// An inside-out surface has inside-out normals.
void TestPolygons(const PointFilter& about, int& failures)
{
  if (about.Is(AS_RELEASED))
  {
    return;
  }
  auto surface = NoisySphere(18, 0.012);
  surface->GetPointData()->Initialize();
  auto turned = Copy(surface);
  turned->BuildCells();
  for (vtkIdType cell = 0; cell < turned->GetNumberOfCells(); ++cell)
  {
    turned->ReverseCell(cell);
  }
  const double all = 0.45 * static_cast<double>(surface->GetNumberOfPoints());
  vtkNew<vtkStripper> stripper;
  for (const double side : { 1.0, -1.0 })
  {
    vtkPolyData* mesh = side > 0.0 ? surface : turned;
    PointFilterTester test(about);
    CHECK(test.Quiet(mesh) && side * Outwards(test.Filter->GetOutput()) > all);
    CHECK(test.Filter->GetNumberOfFittedNormals() == mesh->GetNumberOfPoints());
    stripper->SetInputData(mesh);
    stripper->Update();
    CHECK(test.Quiet(stripper->GetOutput()));
    CHECK(side * Outwards(test.Filter->GetOutput()) > all);
    // Normals of the points are worth more.
    auto given = Copy(mesh);
    given->GetPointData()->SetNormals(SphereNormals(mesh, "Normals", 0.1, -side));
    CHECK(test.Quiet(given) && side * Outwards(test.Filter->GetOutput()) < -all);
    // What a filter left of the surface before is no longer about this one.
    given->GetPointData()->SetActiveNormals(nullptr);
    CHECK(test.Quiet(given) && side * Outwards(test.Filter->GetOutput()) > all);
    CHECK(test.Filter->GetNumberOfFittedNormals() == mesh->GetNumberOfPoints());

    test.Filter->SetNormalSourceToInput();
    CHECK(test.Quiet(mesh) && side * Outwards(test.Filter->GetOutput()) > all);
    CHECK(test.Filter->GetNumberOfFittedNormals() == 0);
    test.Filter->SetNormalSourceToPlaneFit();
    CHECK(test.Quiet(mesh) && side * Outwards(test.Filter->GetOutput()) > all);
    test.Filter->SetNormalOrientationToSpanningTree();
    CHECK(test.Quiet(mesh) && Outwards(test.Filter->GetOutput()) > all);
    CHECK(test.Filter->GetNumberOfParts() >= 1);
  }
  // A point that no filter can use does not change what the others are told.
  auto broken = Copy(turned);
  broken->GetPoints()->SetPoint(40, vtkMath::Nan(), 0.0, 0.0);
  PointFilterTester test(about);
  CHECK(test.Quiet(broken) && test.Filter->GetNumberOfPointsNotFinite() == 1);
  double outwards = 0.0;
  vtkDataArray* normals = test.Filter->GetOutput()->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < broken->GetNumberOfPoints(); ++i)
  {
    outwards += i == 40 ? 0.0 : vtkMath::Dot(normals->GetTuple3(i), broken->GetPoint(i));
  }
  CHECK(outwards < -all);
}

/// The update alone wants normals, and does not change them.
void TestPointUpdate(int& failures)
{
  vtkNew<vtkNormalPointUpdate> update;
  vtkNew<Messages> seen;
  seen->Watch(update);
  CHECK(update->GetNormalSource() == vtkNormalPointUpdate::INPUT);
  auto cloud = SphereCloud();
  CHECK(Run(update, cloud, seen)->GetNumberOfPoints() == 0);
  CHECK(seen->Errors.find("no point normals") != std::string::npos);
  auto normals = SphereNormals(cloud, "Predicted", 0.0, 3.0);
  cloud->GetPointData()->AddArray(normals);
  StartFrom(update, "Predicted");
  vtkPolyData* output = Run(update, cloud, seen);
  CHECK(seen->Errors.empty() && Roughness(output) < 0.5 * Roughness(cloud));
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    double m[3];
    double n[3];
    normals->GetTuple(i, m);
    output->GetPointData()->GetNormals()->GetTuple(i, n);
    vtkMath::MultiplyScalar(n, 3.0);
    CHECK(vtkMath::Distance2BetweenPoints(m, n) < 1e-24);
  }
}

}

int TestPointNormals(int, char*[])
{
  int failures = 0;
  TestAllPointFilters(TestWhichNormals, failures);
  TestAllPointFilters(TestSources, failures);
  TestAllPointFilters(TestWrongArrays, failures);
  TestAllPointFilters(TestMissingNormals, failures);
  TestAllPointFilters(TestPolygons, failures);
  TestPointUpdate(failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
