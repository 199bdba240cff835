// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// What results must not depend on, for every filter for point sets: threads, order, place,
// direction, size, and for those that ignore them the signs of normals.

#include "PointFilterTester.h"

#include <cstdlib>

namespace
{

using namespace PointTest;

void TestThreads(const PointFilter& about, int& failures)
{
  // Loops of less than 4096 steps may stay on one thread.
  auto cloud = SphereCloud(4500, 0.01);
  cloud->GetPointData()->SetNormals(SphereNormals(cloud, "Normals", 0.2));
  for (const bool fitted : { false, true })
  {
    vtkSmartPointer<vtkPolyData> first;
    for (const int threads : { 1, 2, 5 })
    {
      PointFilterTester test(about);
      test.Filter->SetNumberOfThreads(threads);
      LimitIterations(test.Filter, 1);
      if (fitted)
      {
        test.Filter->SetNormalSourceToRobustFit();
      }
      vtkPolyData* output = test.Denoise(cloud);
      first = first ? first : Copy(output);
      CHECK(test.SaidNothing() && SameResult(first, output));
    }
  }
}

/// Two clouds without any symmetry, the second with normals.
std::vector<vtkSmartPointer<vtkPolyData>> Clouds()
{
  auto sphere = SphereCloud(500);
  sphere->GetPointData()->SetNormals(SphereNormals(sphere, "Normals", 0.2));
  return { CubeCloud(), sphere };
}

vtkSmartPointer<vtkPolyData> InOrder(vtkPolyData* cloud, const Ids& order)
{
  auto shuffled = Permuted(cloud, order, {});
  if (vtkDataArray* normals = cloud->GetPointData()->GetNormals())
  {
    vtkNew<vtkDoubleArray> array;
    array->DeepCopy(normals);
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      array->SetTuple(order[i], static_cast<vtkIdType>(i), normals);
    }
    shuffled->GetPointData()->SetNormals(array);
  }
  return shuffled;
}

void TestOrder(const PointFilter& about, int& failures)
{
  if (about.Is(AS_RELEASED))
  {
    return;
  }
  PointFilterTester test(about);
  for (const auto& cloud : Clouds())
  {
    auto expected = Copy(test.Denoise(cloud));
    const Ids order = Shuffled(cloud->GetNumberOfPoints(), 3);
    vtkPolyData* output = test.Denoise(InOrder(cloud, order));
    auto wanted = InOrder(expected, order);
    CHECK(PointDistance(wanted, output) == 0.0);
    CHECK(SameArray(wanted->GetPointData()->GetNormals(), output->GetPointData()->GetNormals()));
  }
}

void TestMotion(const PointFilter& about, int& failures)
{
  if (about.Is(AS_RELEASED))
  {
    return;
  }
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
  PointFilterTester test(about);
  for (const auto& cloud : Clouds())
  {
    auto expected = Copy(test.Denoise(cloud));
    for (vtkTransform* motion : { shift.Get(), turn.Get(), large.Get(), small.Get() })
    {
      auto moved = Moved(cloud, motion);
      if (vtkDataArray* normals = cloud->GetPointData()->GetNormals())
      {
        vtkNew<vtkDoubleArray> turned;
        turned->SetNumberOfComponents(3);
        motion->TransformNormals(normals, turned);
        moved->GetPointData()->SetNormals(turned);
      }
      vtkPolyData* output = test.Denoise(moved);
      CHECK(PointDistance(Moved(expected, motion), output) < 1e-6 * moved->GetLength());
      // Normals turn, but do not scale.
      double largest = 0.0;
      for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
      {
        double m[3];
        double n[3];
        expected->GetPointData()->GetNormals()->GetTuple(i, m);
        motion->TransformNormal(m, m);
        output->GetPointData()->GetNormals()->GetTuple(i, n);
        largest = std::max(largest, std::sqrt(vtkMath::Distance2BetweenPoints(m, n)));
      }
      CHECK(largest < 1e-6);
    }
  }
}

/// Normals of which every other one, at random, points the other way.
vtkSmartPointer<vtkPolyData> Flipped(vtkPolyData* cloud)
{
  auto flipped = Copy(cloud);
  vtkDataArray* normals = flipped->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < flipped->GetNumberOfPoints(); ++i)
  {
    double n[3];
    normals->GetTuple(i, n);
    if (Wobble(11 * i) < 0.0)
    {
      normals->SetTuple3(i, -n[0], -n[1], -n[2]);
    }
  }
  return flipped;
}

void TestSigns(const PointFilter& about, int& failures)
{
  if (about.Is(OWN_SETTINGS) || about.Is(AS_RELEASED)) // which are for oriented normals
  {
    return;
  }
  auto sphere = SphereCloud();
  sphere->GetPointData()->SetNormals(SphereNormals(sphere, "Normals", 0.1));
  auto cube = CubeCloud();
  cube->GetPointData()->SetNormals(SphereNormals(cube, "Normals", 0.1));
  for (vtkPolyData* cloud : { sphere.Get(), cube.Get() })
  {
    PointFilterTester test(about);
    test.Filter->SetNormalOrientationToKeep();
    if (!about.Is(IGNORES_SIGNS))
    {
      IgnoreSigns(test.Filter);
    }
    auto flipped = Flipped(cloud);
    auto expected = Copy(test.Denoise(cloud));
    CHECK(test.Quiet(flipped));
    vtkPolyData* output = test.Filter->GetOutput();
    CHECK(PointDistance(expected, output) < 1e-12);
    CHECK(PointDistance(expected, cloud) > 1e-3);
    // Where normals are given, those of the result are on the same side.
    int turned = 0;
    for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
    {
      double m[3];
      double n[3];
      expected->GetPointData()->GetNormals()->GetTuple(i, m);
      output->GetPointData()->GetNormals()->GetTuple(i, n);
      const double sign = Wobble(11 * i) < 0.0 ? -1.0 : 1.0;
      turned += !(sign * vtkMath::Dot(m, n) > 1.0 - 1e-9);
    }
    CHECK(turned == 0 || about.Is(MAKES_FACETS));

    // Oriented again, they are as good as they were.
    test.Filter->SetNormalOrientationToAutomatic();
    auto oriented = Copy(test.Denoise(cloud));
    CHECK(PointDistance(oriented, test.Denoise(flipped)) < 1e-12);
  }
}

}

int TestPointInvariance(int, char*[])
{
  int failures = 0;
  TestAllPointFilters(TestThreads, failures);
  TestAllPointFilters(TestOrder, failures);
  TestAllPointFilters(TestMotion, failures);
  TestAllPointFilters(TestSigns, failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
