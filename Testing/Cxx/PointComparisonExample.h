// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PointComparisonExample.h
 * @brief Comparisons of points, and an example of which all numbers are known.
 */

#ifndef PointComparisonExample_h
#define PointComparisonExample_h

#include "SurfaceChecks.h"
#include "TestSurfaces.h"
#include "vtkSurfaceComparison.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <limits>

namespace PointComparison
{

using namespace SurfaceChecks;

inline const double NotANumber = std::numeric_limits<double>::quiet_NaN();
using Points = std::vector<Point>;

inline vtkSmartPointer<vtkSurfaceComparison> Compare(vtkPolyData* result, vtkPolyData* reference,
  int rings = 2)
{
  auto comparison = vtkSmartPointer<vtkSurfaceComparison>::New();
  vtkNew<Messages> messages;
  messages->Watch(comparison);
  comparison->SetInputData(result);
  comparison->SetReferenceData(reference);
  comparison->SetFeatureRings(rings);
  comparison->Update();
  Check(Silent(messages), "nothing to complain about: " + messages->Errors + messages->Warnings);
  return comparison;
}

inline vtkSmartPointer<vtkPolyData> Cloud(const Points& points) { return MakeSurface(points, {}); }

/// Gives the points normals, active or not.
inline vtkSmartPointer<vtkPolyData> WithNormals(vtkPolyData* data, const Points& normals,
  bool active = true)
{
  vtkSmartPointer<vtkPolyData> copy = DeepCopy(data);
  vtkNew<vtkDoubleArray> array;
  array->SetName("Normals");
  array->SetNumberOfComponents(3);
  for (const Point& n : normals)
  {
    array->InsertNextTuple(n.data());
  }
  copy->GetPointData()->AddArray(array);
  if (active)
  {
    copy->GetPointData()->SetNormals(array);
  }
  return copy;
}

inline double PointValue(vtkSurfaceComparison* comparison, const char* name, vtkIdType point)
{
  return comparison->GetOutput()->GetPointData()->GetArray(name)->GetTuple1(point);
}

inline bool HasPointArray(vtkSurfaceComparison* comparison, const char* name)
{
  return comparison->GetOutput()->GetPointData()->HasArray(name) != 0;
}

// The example: three points near a plane, and the corners of a square in it.
inline const Points Near{ { 0, 0, 0.1 }, { 1, 0, -0.2 }, { 0, 1, 0.05 } };
inline const Points NearNormals{ { 0, 0, -1 }, { 0.1, 0, 1 }, { 1, 0, 1 } };
inline const Points Corners{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } };
inline const Points Up(4, { 0, 0, 1 });

inline vtkSmartPointer<vtkPolyData> BigSquare()
{
  return MakeSurface({ { -9, -9, 0 }, { 10, -9, 0 }, { 10, 8, 0 }, { -9, 8, 0 } },
    { { 0, 1, 2, 3 } });
}

inline void CheckExampleNormals(vtkSurfaceComparison* c)
{
  CheckNear(PointValue(c, "PointNormalAngleError", 0), 0.0, 1e-6, "first normal");
  CheckNear(PointValue(c, "PointNormalAngleError", 1), 5.710593, 1e-6, "second normal");
  CheckNear(PointValue(c, "PointNormalAngleError", 2), 45.0, 1e-6, "third normal");
  CheckNear(c->GetMeanPointNormalAngle(), 16.903531, 1e-6, "mean angle of normals");
  CheckNear(c->GetRMSPointNormalAngle(), 26.189125, 1e-6, "RMS angle of normals");
  CheckNear(c->GetSharePointNormalsWithin10(), 0.666667, 1e-6, "share of good normals");
  Check(c->GetFlippedPointNormals() == 1.0, "one normal is flipped");
}

}

#endif
