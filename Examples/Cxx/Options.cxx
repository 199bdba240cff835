// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Options.h"

#include "vtkBilateralNormalFilter.h"
#include "vtkBilateralVertexFilter.h"
#include "vtkCurvatureNormalDiffusionFilter.h"
#include "vtkDenoisingMethods.h"
#include "vtkFuzzyVectorMedianNormalFilter.h"
#include "vtkGeometricFidelityNormalFilter.h"
#include "vtkGuidedNormalFilter.h"
#include "vtkHuberNormalFilter.h"
#include "vtkNonIterativeBilateralFilter.h"
#include "vtkNormalDiffusionFilter.h"
#include "vtkNormalVotingTensorFilter.h"
#include "vtkRobustNormalFilter.h"
#include "vtkTukeyBilateralNormalFilter.h"

#include <CLI/CLI.hpp>

namespace
{

/// "Truncated L2" becomes "truncated-l2".
std::string OptionName(std::string name)
{
  for (char& c : name)
  {
    c = c == ' ' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return name;
}

constexpr const char* Composed = "robust"; // the composer, beside the methods of the table

std::vector<std::string> MethodNames()
{
  std::vector<std::string> names = { Composed };
  for (int method = 0; method < vtkDenoisingMethods::GetNumberOfMethods(); ++method)
  {
    names.push_back(OptionName(vtkDenoisingMethods::GetName(method)));
  }
  return names;
}

vtkSmartPointer<vtkMeshDenoisingFilter> MakeMethod(const std::string& name)
{
  for (int method = 0; method < vtkDenoisingMethods::GetNumberOfMethods(); ++method)
  {
    if (name == OptionName(vtkDenoisingMethods::GetName(method)))
    {
      return vtk::TakeSmartPointer(vtkDenoisingMethods::NewFilter(method));
    }
  }
  return vtkSmartPointer<vtkRobustNormalFilter>::New();
}

/// Calls set on the filter as the one of the classes that it is. False if it is none of them.
template <typename... Filters, typename Set>
bool SetOn(vtkMeshDenoisingFilter* filter, Set set)
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

bool SetRangeScale(vtkMeshDenoisingFilter* filter, double scale)
{
  if (auto* robust = vtkRobustNormalFilter::SafeDownCast(filter))
  {
    robust->SetScaleSource(
      scale > 0.0 ? vtkRobustNormalFilter::GIVEN : vtkRobustNormalFilter::DATA_MAD);
  }
  return SetOn<vtkRobustNormalFilter, vtkBilateralNormalFilter, vtkNormalDiffusionFilter,
    vtkHuberNormalFilter, vtkNormalVotingTensorFilter, vtkFuzzyVectorMedianNormalFilter,
    vtkCurvatureNormalDiffusionFilter, vtkGeometricFidelityNormalFilter, vtkGuidedNormalFilter,
    vtkTukeyBilateralNormalFilter, vtkBilateralVertexFilter, vtkNonIterativeBilateralFilter>(filter,
    [scale](auto* one) { one->SetRangeScale(scale); });
}

bool SetSpatialScale(vtkMeshDenoisingFilter* filter, double scale)
{
  return SetOn<vtkRobustNormalFilter, vtkBilateralNormalFilter, vtkHuberNormalFilter,
    vtkGuidedNormalFilter, vtkTukeyBilateralNormalFilter, vtkBilateralVertexFilter,
    vtkNonIterativeBilateralFilter>(filter, [scale](auto* one) { one->SetSpatialScale(scale); });
}

bool SetNorm(vtkMeshDenoisingFilter* filter, int norm)
{
  return SetOn<vtkRobustNormalFilter>(filter, [norm](auto* one) { one->SetNorm(norm); });
}

bool SetOuterIterations(vtkMeshDenoisingFilter* filter, int count)
{
  return SetOn<vtkFaceNormalFilter>(filter,
    [count](auto* one) { one->SetNumberOfOuterIterations(count); });
}

bool SetNormalIterations(vtkMeshDenoisingFilter* filter, int count)
{
  return SetOn<vtkFaceNormalFilter>(filter,
    [count](auto* one) { one->SetNumberOfNormalIterations(count); });
}

bool SetVertexIterations(vtkMeshDenoisingFilter* filter, int count)
{
  return SetOn<vtkFaceNormalFilter>(filter,
    [count](auto* one) { one->SetNumberOfVertexIterations(count); });
}

bool SetMaximumDisplacement(vtkMeshDenoisingFilter* filter, double length)
{
  return SetOn<vtkFaceNormalFilter>(filter,
    [length](auto* one) { one->SetMaximumDisplacement(length); });
}

}

bool ReadOptions(int argc, char* argv[], Options& options, int& exitCode)
{
  CLI::App app("Removes noise from a surface and keeps its edges and its volume.", "denoise");
  app.footer(
    "Files: PLY, OBJ, STL, VTP, VTK; OFF for reading only.\n"
    "Exit codes: 0 done, 1 bad command line, 2 cannot read, 3 cannot denoise, 4 cannot write.");

  std::map<std::string, int> norms;
  for (int norm = 0; norm < vtkRobustNormalFilter::GetNumberOfNorms(); ++norm)
  {
    norms[OptionName(vtkRobustNormalFilter::GetNormName(norm))] = norm;
  }

  app.add_option("input", options.Input, "The surface with noise")->required();
  app.add_option("output", options.Output, "Where the clean surface goes")->required();
  app.add_option("-m,--method", options.Method, "A published method, or robust to compose one")
    ->check(CLI::IsMember(MethodNames()))
    ->capture_default_str();
  app.add_option("--norm", options.Norm, "Error norm of the robust method")
    ->transform(CLI::CheckedTransformer(norms, CLI::ignore_case));
  app
    .add_option("-r,--range-scale", options.RangeScale,
      "Differences of normals that count as noise, in the unit of the method (mostly chord length, "
      "where 0.35 is 20 degrees); 0: from the data")
    ->check(CLI::NonNegativeNumber);
  app
    .add_option("-s,--spatial-scale", options.SpatialScale,
      "Width of the spatial kernel in mean distances of face centroids; 0: none")
    ->check(CLI::NonNegativeNumber);
  app.add_option("-o,--outer-iterations", options.OuterIterations, "Turns of normals and points")
    ->check(CLI::NonNegativeNumber);
  app.add_option("-n,--normal-iterations", options.NormalIterations, "Steps that filter normals")
    ->check(CLI::NonNegativeNumber);
  app.add_option("-v,--vertex-iterations", options.VertexIterations, "Steps that move points")
    ->check(CLI::NonNegativeNumber);
  app
    .add_option("--maximum-displacement", options.MaximumDisplacement,
      "How far points may move in mean edge lengths; 0: any distance")
    ->check(CLI::NonNegativeNumber);
  app.add_option("--boundary", options.Boundary, "What open borders do")
    ->check(CLI::IsMember({ "fixed", "slide", "free" }))
    ->capture_default_str();
  app.add_option("--reference", options.Reference, "A surface without noise to compare with");
  app.add_option("-t,--threads", options.Threads, "Number of threads; 0: all cores")
    ->check(CLI::NonNegativeNumber);
  app.add_flag("-q,--quiet", options.Quiet, "Say nothing unless something is wrong");

  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    exitCode = app.exit(error) == 0 ? 0 : 1;
    return false;
  }
  return true;
}

vtkSmartPointer<vtkMeshDenoisingFilter> MakeFilter(const Options& options, std::string& message)
{
  const auto filter = MakeMethod(options.Method);
  const struct
  {
    const char* Name;
    bool Suits;
  } wishes[] = {
    { "--norm", options.Norm < 0 || SetNorm(filter, options.Norm) },
    { "--range-scale", options.RangeScale < 0.0 || SetRangeScale(filter, options.RangeScale) },
    { "--spatial-scale",
      options.SpatialScale < 0.0 || SetSpatialScale(filter, options.SpatialScale) },
    { "--outer-iterations",
      options.OuterIterations < 0 || SetOuterIterations(filter, options.OuterIterations) },
    { "--normal-iterations",
      options.NormalIterations < 0 || SetNormalIterations(filter, options.NormalIterations) },
    { "--vertex-iterations",
      options.VertexIterations < 0 || SetVertexIterations(filter, options.VertexIterations) },
    { "--maximum-displacement",
      options.MaximumDisplacement < 0.0 ||
        SetMaximumDisplacement(filter, options.MaximumDisplacement) },
  };
  for (const auto& wish : wishes)
  {
    if (!wish.Suits)
    {
      message = std::string(wish.Name) + " has no meaning for the method " + options.Method + ".";
      return nullptr;
    }
  }
  if (auto* twoStage = vtkFaceNormalFilter::SafeDownCast(filter))
  {
    twoStage->SetBoundaryHandling(options.Boundary == "free" ? vtkFaceNormalFilter::FREE
        : options.Boundary == "slide"                        ? vtkFaceNormalFilter::SLIDE
                                                             : vtkFaceNormalFilter::FIXED);
  }
  else if (auto* oneStage = vtkOneStageFilter::SafeDownCast(filter))
  {
    oneStage->SetFixBoundary(options.Boundary == "fixed");
  }
  filter->SetNumberOfThreads(options.Threads);
  return filter;
}
