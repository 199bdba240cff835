// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file SurfaceChecks.h
 * @brief Numbers that must be right, and surfaces of which they are known.
 */

#ifndef SurfaceChecks_h
#define SurfaceChecks_h

#include "MeshTestTools.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace SurfaceChecks
{

using MeshTest::MakeSurface;
using MeshTest::Messages;

/// Counts what failed; ExitCode() is the result of the test.
inline int Failures = 0;

inline int ExitCode() { return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE; }

inline void Check(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "FAILED: " << what << "\n";
    ++Failures;
  }
}

inline void CheckNear(double actual, double expected, double tolerance, const std::string& what)
{
  if (!(std::abs(actual - expected) <= tolerance))
  {
    std::cerr << "FAILED: " << what << ": " << actual << " instead of " << expected << "\n";
    ++Failures;
  }
}

inline void CheckNaN(double actual, const std::string& what)
{
  Check(std::isnan(actual), what + " is not defined, but is " + std::to_string(actual));
}

/// True if there was neither error nor warning.
inline bool Silent(Messages* messages)
{
  return messages->Errors.empty() && messages->Warnings.empty();
}

using Point = std::array<double, 3>;

/// The unit cube of six quads that share their corners; corner i has the bits of i as coordinates.
inline vtkSmartPointer<vtkPolyData> MakeCube()
{
  return MakeSurface({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
                       { 0, 1, 1 }, { 1, 1, 1 } },
    { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 },
      { 1, 3, 7, 5 } });
}

inline vtkSmartPointer<vtkPolyData> DeepCopy(vtkPolyData* surface)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(surface);
  return copy;
}

/// A deep copy of which each point p became scale * p + shift.
inline vtkSmartPointer<vtkPolyData> Transformed(vtkPolyData* surface, double scale,
  const Point& shift)
{
  vtkSmartPointer<vtkPolyData> copy = DeepCopy(surface);
  for (vtkIdType i = 0; i < copy->GetNumberOfPoints(); ++i)
  {
    Point p;
    copy->GetPoint(i, p.data());
    copy->GetPoints()->SetPoint(i, scale * p[0] + shift[0], scale * p[1] + shift[1],
      scale * p[2] + shift[2]);
  }
  return copy;
}

/// True if the points are the same to the last bit.
inline bool SamePoints(vtkPolyData* a, vtkPolyData* b)
{
  return MeshTest::PointDistance(a, b) == 0.0;
}

}

#endif
