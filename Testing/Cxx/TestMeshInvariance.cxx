// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// What results must not depend on, for every filter: threads, order, place, direction, size.

#include "FilterTester.h"

#include <cstdlib>

namespace
{

using namespace MeshTest;

void TestThreads(const MeshFilter& about, int& failures)
{
  // Loops of less than 4096 steps stay on one thread: this many points and faces do not. The long
  // schedules of presets are the same loops again and again.
  auto surface = NoisySphere(about.Is(OWN_ITERATIONS) ? 48 : 68, 0.005);
  CHECK(about.Is(OWN_ITERATIONS) || surface->GetNumberOfPoints() > 4096);
  vtkSmartPointer<vtkPolyData> first;
  const std::vector<int> all =
    about.Is(OWN_ITERATIONS) ? std::vector<int>{ 1, 3 } : std::vector<int>{ 1, 2, 3, 0 };
  for (const int threads : all)
  {
    FilterTester test(about);
    test.Filter->SetNumberOfThreads(threads);
    LimitIterations(test.Filter, 2);
    vtkPolyData* output = test.Denoise(surface);
    if (!first)
    {
      first = Copy(output);
    }
    CHECK(PointDistance(first, output) == 0.0);
    CHECK(!about.IsTwoStage() || NormalDistance(first, output) == 0.0);
  }
}

/// A closed and an open surface of triangles without any symmetry, in double precision.
std::vector<vtkSmartPointer<vtkPolyData>> Surfaces()
{
  vtkNew<vtkTransform> identity;
  return { Moved(NoisySphere(18, 0.012), identity), NoisyBox(5, 0.15) };
}

void TestOrder(const MeshFilter& about, int& failures)
{
  if (about.Is(AS_RELEASED))
  {
    return;
  }
  FilterTester test(about);
  for (const auto& surface : Surfaces())
  {
    auto expected = Copy(test.Denoise(surface));
    const Ids points = Shuffled(surface->GetNumberOfPoints(), 3);
    const Ids cells = Shuffled(surface->GetNumberOfCells(), 4);
    vtkPolyData* output = test.Denoise(Permuted(surface, points, cells));
    CHECK(PointDistance(Permuted(expected, points, cells), output) < 1e-8 * surface->GetLength());
    CHECK(!about.IsTwoStage() || NormalDistance(expected, output, cells) < 1e-7);
  }
}

void TestMotion(const MeshFilter& about, int& failures)
{
  vtkNew<vtkTransform> shift;
  shift->Translate(16.0, -8.0, 4.0);
  vtkNew<vtkTransform> turn;
  turn->RotateWXYZ(63.0, 0.3, -0.7, 0.5);
  vtkNew<vtkTransform> large;
  large->Scale(1000.0, 1000.0, 1000.0);
  vtkNew<vtkTransform> small;
  small->RotateWXYZ(170.0, -0.9, 0.2, 0.1);
  small->Scale(1e-4, 1e-4, 1e-4);
  small->Translate(3.0, 2.0, -5.0);
  FilterTester test(about);
  for (const auto& surface : Surfaces())
  {
    auto expected = Copy(test.Denoise(surface));
    for (vtkTransform* motion : { shift.Get(), turn.Get(), large.Get(), small.Get() })
    {
      // The released program knows up from down and large from small, but not here from there.
      if (about.Is(AS_RELEASED) && motion != shift.Get())
      {
        continue;
      }
      auto moved = Moved(surface, motion);
      vtkPolyData* output = test.Denoise(moved);
      CHECK(PointDistance(Moved(expected, motion), output) < 1e-8 * moved->GetLength());
      // Normals turn, but do not scale.
      auto* normals = expected->GetCellData()->GetArray("FilteredNormals");
      for (vtkIdType cell = 0; normals && cell < normals->GetNumberOfTuples(); ++cell)
      {
        double m[3];
        double n[3];
        normals->GetTuple(cell, m);
        motion->TransformNormal(m, m);
        output->GetCellData()->GetArray("FilteredNormals")->GetTuple(cell, n);
        CHECK(vtkMath::Distance2BetweenPoints(m, n) < 1e-14);
      }
    }
  }
}

}

int TestMeshInvariance(int, char*[])
{
  int failures = 0;
  TestAllMeshFilters(TestThreads, failures);
  TestAllMeshFilters(TestOrder, failures);
  TestAllMeshFilters(TestMotion, failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
