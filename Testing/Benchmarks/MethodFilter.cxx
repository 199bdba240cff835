// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MethodFilter.h"

#include <vtkAnisotropicMeanCurvatureFilter.h>
#include <vtkBilateralVertexFilter.h>
#include <vtkMeanCurvatureFlowFilter.h>
#include <vtkMedianNormalFilter.h>
#include <vtkNonIterativeBilateralFilter.h>
#include <vtkNormalVotingTensorFilter.h>
#include <vtkRobustNormalFilter.h>

#include <algorithm>

using namespace SurfaceDenoising;

namespace
{

using FilterPointer = vtkSmartPointer<vtkMeshDenoisingFilter>;

FilterPointer Composed(const MethodRow& row, int outerIterations)
{
  auto filter = vtkSmartPointer<vtkRobustNormalFilter>::New();
  for (int preset = 0; preset < vtkRobustNormalFilter::GetNumberOfPresets(); ++preset)
  {
    if (std::string(row.Name) == vtkRobustNormalFilter::GetPresetName(preset))
    {
      filter->CopyPreset(preset);
      filter->SetNumberOfOuterIterations(outerIterations);
      return filter;
    }
  }
  return nullptr;
}

template <typename Filter>
FilterPointer TwoStage(int outerIterations)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetNumberOfOuterIterations(outerIterations);
  return filter;
}

template <typename Filter>
FilterPointer OneStage(int iterations)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetNumberOfIterations(std::min(iterations, filter->GetNumberOfIterations()));
  return filter;
}

}

FilterPointer MethodFilter(Method method, int outerIterations)
{
  const MethodRow& row = Methods()[static_cast<std::size_t>(method)];
  const int outer = std::min(outerIterations, row.Settings.OuterIterations);
  if (row.Composed)
  {
    return Composed(row, outer);
  }
  switch (method)
  {
    case Method::MedianNormal:
      return TwoStage<vtkMedianNormalFilter>(outer);
    case Method::WeightedMedianNormal:
    {
      const FilterPointer filter = TwoStage<vtkMedianNormalFilter>(outer);
      vtkMedianNormalFilter::SafeDownCast(filter)->SetMedianTypeToWeighted();
      return filter;
    }
    case Method::NormalVotingTensor:
      return TwoStage<vtkNormalVotingTensorFilter>(outer);
    case Method::MeanCurvatureFlow:
      return OneStage<vtkMeanCurvatureFlowFilter>(outerIterations);
    case Method::AnisotropicMeanCurvature:
      return OneStage<vtkAnisotropicMeanCurvatureFilter>(outerIterations);
    case Method::BilateralVertex:
      return OneStage<vtkBilateralVertexFilter>(outerIterations);
    case Method::NonIterativeBilateral:
      return vtkSmartPointer<vtkNonIterativeBilateralFilter>::New();
    default:
      return nullptr;
  }
}

const MethodRow* FindMethod(const std::string& name)
{
  const auto row = std::find_if(Methods().begin(), Methods().end(),
    [&name](const MethodRow& candidate) { return name == candidate.Name; });
  return row != Methods().end() ? &*row : nullptr;
}
