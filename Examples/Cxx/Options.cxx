// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Options.h"

#include "vtkBilateralNormalFilter.h"
#include "vtkRobustNormalFilter.h"

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

}

bool ReadOptions(int argc, char* argv[], Options& options, int& exitCode)
{
  CLI::App app("Removes noise from a surface and keeps its edges and its volume.", "denoise");
  app.footer(
    "Files: PLY, OBJ, STL, VTP, VTK; OFF for reading only.\n"
    "Exit codes: 0 done, 1 bad command line, 2 cannot read, 3 cannot denoise, 4 cannot write.");

  std::string method = "bilateral";
  std::map<std::string, int> norms;
  for (int norm = 0; norm < vtkRobustNormalFilter::GetNumberOfNorms(); ++norm)
  {
    norms[OptionName(vtkRobustNormalFilter::GetNormName(norm))] = norm;
  }

  app.add_option("input", options.Input, "The surface with noise")->required();
  app.add_option("output", options.Output, "Where the clean surface goes")->required();
  app.add_option("-m,--method", method, "How normals are filtered")
    ->check(CLI::IsMember({ "bilateral", "robust" }))
    ->capture_default_str();
  app.add_option("--norm", options.Norm, "Error norm of the robust method")
    ->transform(CLI::CheckedTransformer(norms, CLI::ignore_case));
  app
    .add_option("-r,--range-scale", options.RangeScale,
      "Differences of normals (chord length, 0.35 is 20 degrees) that count as noise; 0: from the "
      "data")
    ->check(CLI::Range(0.0, 2.0));
  app
    .add_option("-s,--spatial-scale", options.SpatialScale,
      "Width of the spatial kernel in mean distances of face centroids; 0: none")
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
  options.Robust = method == "robust";
  if (options.Norm >= 0 && !options.Robust)
  {
    std::cerr << "denoise: --norm belongs to --method robust.\n";
    exitCode = 1;
    return false;
  }
  return true;
}

vtkSmartPointer<vtkFaceNormalFilter> MakeFilter(const Options& options)
{
  vtkSmartPointer<vtkFaceNormalFilter> filter;
  if (options.Robust)
  {
    auto robust = vtkSmartPointer<vtkRobustNormalFilter>::New();
    if (options.Norm >= 0)
    {
      robust->SetNorm(options.Norm);
    }
    if (options.RangeScale > 0.0)
    {
      robust->SetScaleSourceToGiven();
      robust->SetRangeScale(options.RangeScale);
    }
    if (options.SpatialScale >= 0.0)
    {
      robust->SetSpatialScale(options.SpatialScale);
    }
    filter = robust;
  }
  else
  {
    auto bilateral = vtkSmartPointer<vtkBilateralNormalFilter>::New();
    if (options.RangeScale >= 0.0)
    {
      bilateral->SetRangeScale(options.RangeScale);
    }
    if (options.SpatialScale >= 0.0)
    {
      bilateral->SetSpatialScale(options.SpatialScale);
    }
    filter = bilateral;
  }
  if (options.NormalIterations >= 0)
  {
    filter->SetNumberOfNormalIterations(options.NormalIterations);
  }
  if (options.VertexIterations >= 0)
  {
    filter->SetNumberOfVertexIterations(options.VertexIterations);
  }
  filter->SetBoundaryHandling(options.Boundary == "free" ? vtkFaceNormalFilter::FREE
      : options.Boundary == "slide"                      ? vtkFaceNormalFilter::SLIDE
                                                         : vtkFaceNormalFilter::FIXED);
  filter->SetMaximumDisplacement(options.MaximumDisplacement);
  filter->SetNumberOfThreads(options.Threads);
  return filter;
}
