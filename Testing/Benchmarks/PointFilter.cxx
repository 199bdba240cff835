// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PointFilter.h"

#include <vtkPointDenoisingMethods.h>
#include <vtkPointNeighborhoodFilter.h>
#include <vtkRobustPointNormalFilter.h>

namespace
{

const std::string Composer = "Robust Point Normal";

/// Methods that are not measured.
const std::string LeftOut = "Voting Tensor Point";

vtkSmartPointer<vtkPointDenoisingFilter> FindFilter(const std::string& name)
{
  if (name == Composer)
  {
    return vtkSmartPointer<vtkRobustPointNormalFilter>::New();
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
  std::vector<std::string> names{ Composer };
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
