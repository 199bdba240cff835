// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Denoises a surface from the command line: the program shows how to use the filters from C++.

#include "Messages.h"
#include "Options.h"
#include "Progress.h"
#include "SurfaceIO.h"

#include <vtkBilateralNormalFilter.h>
#include <vtkNew.h>
#include <vtkRobustNormalFilter.h>
#include <vtkSurfaceComparison.h>

#include <chrono>
#include <cstdio>
#include <memory>

namespace
{

vtkSmartPointer<vtkFaceNormalFilter> MakeFilter(const Options& options)
{
  vtkSmartPointer<vtkFaceNormalFilter> filter;
  if (options.Robust)
  {
    vtkNew<vtkRobustNormalFilter> robust;
    robust->SetNorm(options.Norm >= 0 ? options.Norm : vtkRobustNormalFilter::GAUSSIAN);
    robust->SetSpatialScale(options.SpatialScale);
    if (options.RangeScale > 0.0)
    {
      robust->SetScaleSourceToGiven();
      robust->SetRangeScale(options.RangeScale);
    }
    filter = robust;
  }
  else
  {
    vtkNew<vtkBilateralNormalFilter> bilateral;
    bilateral->SetSpatialScale(options.SpatialScale);
    if (options.RangeScale >= 0.0)
    {
      bilateral->SetRangeScale(options.RangeScale);
    }
    filter = bilateral;
  }
  filter->SetNumberOfNormalIterations(options.NormalIterations);
  filter->SetNumberOfVertexIterations(options.VertexIterations);
  filter->SetBoundaryHandling(options.Boundary);
  filter->SetPreventFlips(options.PreventFlips);
  filter->SetNumberOfThreads(options.Threads);
  return filter;
}

int Fail(ExitCode code, const std::string& file, const std::string& reason)
{
  std::fprintf(stderr, "denoise: %s: %s\n", file.c_str(), reason.c_str());
  return code;
}

/// Mean angle between the normals of result and reference in degrees.
double MeanAngle(vtkPolyData* result, vtkPolyData* reference)
{
  vtkNew<vtkSurfaceComparison> comparison;
  comparison->SetInputData(result);
  comparison->SetReferenceData(reference);
  comparison->Update();
  return comparison->GetMeanNormalAngle();
}

}

int main(int argc, char** argv)
{
  Options options;
  int exitCode = Good;
  if (!ParseOptions(argc, argv, options, exitCode))
  {
    return exitCode;
  }

  std::string error;
  const vtkSmartPointer<vtkPolyData> input = ReadSurface(options.Input, error);
  if (!input)
  {
    return Fail(CannotRead, options.Input, error);
  }
  vtkSmartPointer<vtkPolyData> reference;
  if (!options.Reference.empty())
  {
    reference = ReadSurface(options.Reference, error);
    if (!reference)
    {
      return Fail(CannotRead, options.Reference, error);
    }
  }

  const auto start = std::chrono::steady_clock::now();
  const vtkSmartPointer<vtkFaceNormalFilter> filter = MakeFilter(options);
  const Messages messages(filter);
  filter->SetInputData(input);
  {
    const auto progress = options.Quiet ? nullptr : std::make_unique<Progress>(filter);
    filter->Update();
  }
  if (messages.HasErrors())
  {
    return Fail(CannotDenoise, options.Input, messages.GetErrors());
  }
  if (!messages.GetWarnings().empty())
  {
    std::fprintf(stderr, "denoise: %s\n", messages.GetWarnings().c_str());
  }
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;

  vtkPolyData* output = filter->GetOutput();
  if (!WriteSurface(output, options.Output, error))
  {
    return Fail(CannotWrite, options.Output, error);
  }
  if (!options.Quiet)
  {
    std::printf("%lld points, %lld polygons, %.2f seconds, range scale %.4g\n",
      static_cast<long long>(output->GetNumberOfPoints()),
      static_cast<long long>(output->GetNumberOfPolys() + output->GetNumberOfStrips()),
      time.count(), filter->GetUsedRangeScale());
  }
  if (reference)
  {
    std::printf("mean angle between normals: %.3f degrees before, %.3f after\n",
      MeanAngle(input, reference), MeanAngle(output, reference));
  }
  return Good;
}
