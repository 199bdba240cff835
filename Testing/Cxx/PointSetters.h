// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PointSetters.h
 * @brief Tests of the settings that filters for point sets share.
 */

#ifndef PointSetters_h
#define PointSetters_h

#include "PointFilterTester.h"
#include "SetterChanges.h"

namespace PointTest
{

/// Edges, corners, noise, and parts of different density.
inline vtkSmartPointer<vtkPolyData> Cloud()
{
  auto cube = CubeCloud(10, 0.06);
  auto dense = SphereCloud(300, 0.03);
  for (vtkIdType i = 0; i < dense->GetNumberOfPoints(); ++i)
  {
    const double* p = dense->GetPoint(i);
    cube->GetPoints()->InsertNextPoint(0.4 * p[0] + 1.2, 0.4 * p[1], 0.4 * p[2]);
  }
  return cube;
}

/// The same with normals that are not oriented.
inline vtkSmartPointer<vtkPolyData> CloudWithNormals()
{
  auto cloud = Cloud();
  auto normals = SphereNormals(cloud, "Normals", 0.3);
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); i += 3)
  {
    double n[3];
    normals->GetTuple(i, n);
    normals->SetTuple3(i, -n[0], -n[1], -n[2]);
  }
  cloud->GetPointData()->SetNormals(normals);
  return cloud;
}

/// Settings that all filters have.
template <typename Filter>
void TestCommonSettings(int& failures)
{
  Changes<Filter> changes(nullptr, Cloud());
  vtkNew<Filter> defaults;
  const int outer = defaults->GetNumberOfOuterIterations();
  CHECK(!changes([=](Filter* f) { f->SetNumberOfOuterIterations(std::min(4, outer)); }));
  CHECK(changes([](Filter* f) { f->SetNumberOfOuterIterations(5); }));
  CHECK(changes([](Filter* f) { f->SetNumberOfOuterIterations(-1); }));
  CHECK(changes([](Filter* f) { f->SetMaximumDisplacement(0.1); }));
  // Results do not depend on threads.
  CHECK(!changes([](Filter* f) { f->SetNumberOfThreads(2); }));
}

/// Settings of those that start from normals, however they treat them.
template <typename Filter>
void TestNormalSettings(int& failures)
{
  Changes<Filter> changes([](Filter* f) { f->SetNormalSourceToAutomatic(); }, Cloud());
  CHECK(!changes([](Filter* f) { f->SetNormalSourceToRobustFit(); }));
  CHECK(changes([](Filter* f) { f->SetNormalSourceToPlaneFit(); }));
  CHECK(changes([](Filter* f) { f->SetNumberOfNormalNeighbors(10); }));
  Changes<Filter> given(nullptr, CloudWithNormals());
  CHECK(given([](Filter* f) { f->SetNormalSourceToRobustFit(); }));
}

template <typename Filter>
void TestNeighborhoodSettings(int& failures)
{
  const bool renew = vtkSmartPointer<Filter>::New()->GetRenewNeighborhood();
  Changes<Filter> nearest(
    [](Filter* f)
    {
      f->SetNeighborhoodToNearest();
      f->SetNumberOfOuterIterations(2);
    },
    Cloud());
  CHECK(nearest([](Filter* f) { f->SetNeighborhoodToBall(); }));
  CHECK(nearest([](Filter* f) { f->SetNumberOfNeighbors(12); }));
  CHECK(nearest([=](Filter* f) { f->SetRenewNeighborhood(!renew); }));
  CHECK(!nearest([](Filter* f) { f->SetRadius(2.0); }));
  Changes<Filter> ball(
    [](Filter* f)
    {
      f->SetNeighborhoodToBall();
      f->SetNumberOfOuterIterations(2);
    },
    Cloud());
  CHECK(ball([](Filter* f) { f->SetRadius(2.0); }));
  CHECK(ball([](Filter* f) { f->SetMaximumNumberOfNeighbors(9); }));
  CHECK(ball([=](Filter* f) { f->SetRenewNeighborhood(!renew); }));
  CHECK(!ball([](Filter* f) { f->SetNumberOfNeighbors(12); }));
}

}

#endif
