// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PointFilter.h"

#include <vtkPointDenoisingMethods.h>
#include <vtkPointNeighborhoodFilter.h>
#include <vtkRobustPointNormalFilter.h>

namespace
{

const std::string Composer = "Robust Point Normal";

/// The same with one step of normals and one of points, as other methods have: its own defaults are
/// two and five.
const std::string OneStep = "Robust Point Normal, one step";

/// Methods that are not measured.
const std::string LeftOut = "Voting Tensor Point";

vtkSmartPointer<vtkPointDenoisingFilter> FindFilter(const std::string& name)
{
  if (name == Composer || name == OneStep)
  {
    auto composer = vtkSmartPointer<vtkRobustPointNormalFilter>::New();
    if (name == OneStep)
    {
      composer->SetNumberOfNormalIterations(1);
      composer->SetNumberOfPointIterations(1);
    }
    return composer;
  }
  for (int method = 0; method < vtkPointDenoisingMethods::GetNumberOfMethods(); ++method)
  {
    if (name == vtkPointDenoisingMethods::GetName(method))
    {
      return vtk::TakeSmartPointer(vtkPointDenoisingMethods::NewFilter(method));
    }
  }
  return nullptr;
}

}

std::vector<std::string> PointFilterNames()
{
  std::vector<std::string> names{ Composer, OneStep };
  for (int method = 0; method < vtkPointDenoisingMethods::GetNumberOfMethods(); ++method)
  {
    const std::string name = vtkPointDenoisingMethods::GetName(method);
    if (name != LeftOut)
    {
      names.push_back(name);
    }
  }
  return names;
}

vtkSmartPointer<vtkPointDenoisingFilter> PointFilter(const std::string& name)
{
  auto filter = FindFilter(name);
  if (filter)
  {
    filter->SetNumberOfOuterIterations(1);
  }
  // The others have balls around samples and no other neighbourhood.
  if (auto* neighborhood = vtkPointNeighborhoodFilter::SafeDownCast(filter))
  {
    neighborhood->SetNeighborhoodToNearest();
    neighborhood->SetNumberOfNeighbors(BenchmarkNeighbors);
  }
  return filter;
}
