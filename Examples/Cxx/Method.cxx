// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Method.h"
#include "Options.h"

#include "vtkBilateralNormalFilter.h"
#include "vtkBilateralPointFilter.h"
#include "vtkBilateralVertexFilter.h"
#include "vtkCurvatureNormalDiffusionFilter.h"
#include "vtkDenoisingMethods.h"
#include "vtkFuzzyVectorMedianNormalFilter.h"
#include "vtkGeometricFidelityNormalFilter.h"
#include "vtkGuidedNormalFilter.h"
#include "vtkGuidedPointNormalFilter.h"
#include "vtkHuberNormalFilter.h"
#include "vtkNonIterativeBilateralFilter.h"
#include "vtkNormalDiffusionFilter.h"
#include "vtkNormalVotingTensorFilter.h"
#include "vtkPointDenoisingMethods.h"
#include "vtkRobustNormalFilter.h"
#include "vtkRobustPointNormalFilter.h"
#include "vtkRollingPointNormalFilter.h"
#include "vtkTukeyBilateralNormalFilter.h"

#include <algorithm>
#include <cctype>

namespace
{

// The composers, beside the methods of the tables.
constexpr const char* Composed = "robust";
constexpr const char* ComposedPoints = "robust-point-normal";

/// The number in a table of methods, -1 if it is not there.
template <typename Table>
int FindIn(const std::string& name)
{
  int method = Table::GetNumberOfMethods() - 1;
  while (method >= 0 && name != OptionName(Table::GetName(method)))
  {
    --method;
  }
  return method;
}

vtkSmartPointer<vtkPolyDataAlgorithm> MakeMethod(const std::string& name)
{
  vtkSmartPointer<vtkPolyDataAlgorithm> filter;
  if (name == Composed)
  {
    filter = vtkSmartPointer<vtkRobustNormalFilter>::New();
  }
  else if (name == ComposedPoints)
  {
    filter = vtkSmartPointer<vtkRobustPointNormalFilter>::New();
  }
  else if (IsForPoints(name))
  {
    filter.TakeReference(
      vtkPointDenoisingMethods::NewFilter(FindIn<vtkPointDenoisingMethods>(name)));
  }
  else
  {
    filter.TakeReference(vtkDenoisingMethods::NewFilter(FindIn<vtkDenoisingMethods>(name)));
  }
  return filter;
}

/// Calls set on the filter as the one of the classes that it is. False if it is none of them.
template <typename... Filters, typename Set>
bool SetOn(vtkPolyDataAlgorithm* filter, Set set)
{
  auto setOn = [&set](auto* one)
  {
    if (one)
    {
      set(one);
    }
    return one != nullptr;
  };
  return (setOn(Filters::SafeDownCast(filter)) || ...);
}

bool SetRangeScale(vtkPolyDataAlgorithm* filter, double scale)
{
  if (auto* robust = vtkRobustNormalFilter::SafeDownCast(filter))
  {
    robust->SetScaleSource(
      scale > 0.0 ? vtkRobustNormalFilter::GIVEN : vtkRobustNormalFilter::DATA_MAD);
  }
  bool taken = false; // what a filter does not know it bounds
  SetOn<vtkRobustNormalFilter, vtkBilateralNormalFilter, vtkNormalDiffusionFilter,
    vtkHuberNormalFilter, vtkNormalVotingTensorFilter, vtkFuzzyVectorMedianNormalFilter,
    vtkCurvatureNormalDiffusionFilter, vtkGeometricFidelityNormalFilter, vtkGuidedNormalFilter,
    vtkTukeyBilateralNormalFilter, vtkBilateralVertexFilter, vtkNonIterativeBilateralFilter,
    vtkRobustPointNormalFilter, vtkGuidedPointNormalFilter, vtkRollingPointNormalFilter>(filter,
    [scale, &taken](auto* one)
    {
      one->SetRangeScale(scale);
      taken = one->GetRangeScale() == scale;
    });
  return taken;
}

bool SetSpatialScale(vtkPolyDataAlgorithm* filter, double scale)
{
  bool taken = false; // what a filter does not know it bounds
  SetOn<vtkRobustNormalFilter, vtkBilateralNormalFilter, vtkHuberNormalFilter,
    vtkGuidedNormalFilter, vtkTukeyBilateralNormalFilter, vtkBilateralVertexFilter,
    vtkNonIterativeBilateralFilter, vtkRobustPointNormalFilter, vtkGuidedPointNormalFilter,
    vtkBilateralPointFilter, vtkRollingPointNormalFilter>(filter,
    [scale, &taken](auto* one)
    {
      one->SetSpatialScale(scale);
      taken = one->GetSpatialScale() == scale;
    });
  return taken;
}

bool SetNorm(vtkPolyDataAlgorithm* filter, int norm)
{
  return SetOn<vtkRobustNormalFilter, vtkRobustPointNormalFilter>(filter,
    [norm](auto* one) { one->SetNorm(norm); });
}

bool SetOuterIterations(vtkPolyDataAlgorithm* filter, int count)
{
  return SetOn<vtkFaceNormalFilter, vtkPointDenoisingFilter>(filter,
    [count](auto* one) { one->SetNumberOfOuterIterations(count); });
}

bool SetNormalIterations(vtkPolyDataAlgorithm* filter, int count)
{
  return SetOn<vtkFaceNormalFilter, vtkRobustPointNormalFilter, vtkGuidedPointNormalFilter>(filter,
    [count](auto* one) { one->SetNumberOfNormalIterations(count); });
}

bool SetVertexIterations(vtkPolyDataAlgorithm* filter, int count)
{
  return SetOn<vtkFaceNormalFilter>(filter,
           [count](auto* one) { one->SetNumberOfVertexIterations(count); }) ||
    SetOn<vtkPointFittingFilter, vtkGuidedPointNormalFilter, vtkRollingPointNormalFilter>(filter,
      [count](auto* one) { one->SetNumberOfPointIterations(count); });
}

bool SetMaximumDisplacement(vtkPolyDataAlgorithm* filter, double length)
{
  return SetOn<vtkFaceNormalFilter, vtkPointDenoisingFilter>(filter,
    [length](auto* one) { one->SetMaximumDisplacement(length); });
}

bool SetBoundary(vtkPolyDataAlgorithm* filter, const std::string& boundary)
{
  const int handling = boundary == "free" ? vtkFaceNormalFilter::FREE
    : boundary == "slide"                 ? vtkFaceNormalFilter::SLIDE
                                          : vtkFaceNormalFilter::FIXED;
  return SetOn<vtkFaceNormalFilter>(filter,
           [handling](auto* one) { one->SetBoundaryHandling(handling); }) ||
    SetOn<vtkOneStageFilter>(filter,
      [&boundary](auto* one) { one->SetFixBoundary(boundary == "fixed"); });
}

}

std::string OptionName(std::string name)
{
  for (char& c : name)
  {
    c = c == ' ' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return name;
}

std::vector<std::string> MethodNames()
{
  std::vector<std::string> names = { Composed };
  for (int method = 0; method < vtkDenoisingMethods::GetNumberOfMethods(); ++method)
  {
    names.push_back(OptionName(vtkDenoisingMethods::GetName(method)));
  }
  names.push_back(ComposedPoints);
  for (int method = 0; method < vtkPointDenoisingMethods::GetNumberOfMethods(); ++method)
  {
    names.push_back(OptionName(vtkPointDenoisingMethods::GetName(method)));
  }
  return names;
}

bool IsForPoints(const std::string& method)
{
  return method == ComposedPoints || FindIn<vtkPointDenoisingMethods>(method) >= 0;
}

std::string DefaultMethod(bool hasPolygons)
{
  return hasPolygons ? "bilateral-normal" : ComposedPoints;
}

vtkSmartPointer<vtkPolyDataAlgorithm> MakeFilter(const Options& options, std::string& message)
{
  const auto filter = MakeMethod(options.Method);
  const struct
  {
    const char* Name;
    bool Suits;
  } wishes[] = {
    { "--norm", !options.Norm || SetNorm(filter, *options.Norm) },
    { "--range-scale", !options.RangeScale || SetRangeScale(filter, *options.RangeScale) },
    { "--spatial-scale", !options.SpatialScale || SetSpatialScale(filter, *options.SpatialScale) },
    { "--outer-iterations",
      !options.OuterIterations || SetOuterIterations(filter, *options.OuterIterations) },
    { "--normal-iterations",
      !options.NormalIterations || SetNormalIterations(filter, *options.NormalIterations) },
    { "--vertex-iterations",
      !options.VertexIterations || SetVertexIterations(filter, *options.VertexIterations) },
    { "--maximum-displacement",
      !options.MaximumDisplacement ||
        SetMaximumDisplacement(filter, *options.MaximumDisplacement) },
    { "--boundary", !options.Boundary || SetBoundary(filter, *options.Boundary) },
  };
  for (const auto& wish : wishes)
  {
    if (!wish.Suits)
    {
      message = std::string(wish.Name) + " has no meaning for the method " + options.Method +
        ", or not this value.";
      return nullptr;
    }
  }
  SetOn<vtkMeshDenoisingFilter, vtkPointDenoisingFilter>(filter,
    [&options](auto* one) { one->SetNumberOfThreads(options.Threads); });
  return filter;
}
