// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Removes noise from a surface or a point cloud: reads a file, filters its normals, fits its
// points, writes a file.

#include "Method.h"
#include "Options.h"
#include "SurfaceFile.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSurfaceComparison.h"

#include <chrono>
#include <cstdio>
#include <iostream>

#ifdef _WIN32
#include <io.h>
#define isatty _isatty
#define fileno _fileno
#else
#include <unistd.h>
#endif

namespace
{

enum ExitCodes
{
  Done = 0,
  BadCommandLine = 1,
  CannotRead = 2,
  CannotDenoise = 3,
  CannotWrite = 4
};

/// Says how far the filter is: a bar on a terminal, every tenth elsewhere.
class ProgressBar : public vtkCommand
{
public:
  static ProgressBar* New() { return new ProgressBar; }

  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    const int percent =
      static_cast<int>(100.0 * vtkAlgorithm::SafeDownCast(caller)->GetProgress() + 0.5);
    if (percent / this->Step == this->Last / this->Step)
    {
      return;
    }
    this->Last = percent;
    if (this->IsTerminal)
    {
      const std::string bar(static_cast<std::size_t>(percent) * 40 / 100, '#');
      std::fprintf(stderr, "\rdenoising [%-40s] %3d%%%s", bar.c_str(), percent,
        percent == 100 ? "\n" : "");
    }
    else
    {
      std::fprintf(stderr, "denoising %d%%\n", percent);
    }
  }

private:
  bool IsTerminal = isatty(fileno(stderr)) != 0;
  int Step = isatty(fileno(stderr)) ? 1 : 10;
  int Last = 0;
};

int Complain(const std::string& path, const std::string& message, int exitCode)
{
  std::cerr << "denoise: " << path << ": " << message << "\n";
  return exitCode;
}

void PrintComparison(const char* name, vtkPolyData* surface, vtkPolyData* reference)
{
  vtkNew<vtkSurfaceComparison> comparison;
  comparison->SetInputData(surface);
  comparison->SetReferenceData(reference);
  comparison->Update();
  if (HasPolygons(surface) && HasPolygons(reference))
  {
    std::printf("%-8s mean normal angle %.2f degrees, E_v %.2f thousandths of the diagonal\n", name,
      comparison->GetMeanNormalAngle(), 1000.0 * comparison->GetRelativePositionError());
  }
  else
  {
    std::printf("%-8s mean distance %.2f, largest %.2f thousandths of the diagonal\n", name,
      1000.0 * comparison->GetRelativeMeanDistance(),
      1000.0 * comparison->GetRelativeMaximumDistance());
  }
}

}

int main(int argc, char* argv[])
{
  Options options;
  int exitCode = Done;
  if (!ReadOptions(argc, argv, options, exitCode))
  {
    return exitCode;
  }

  std::string message;
  // Known before the work is done, not after.
  if (!CanWriteSurfaceFile(options.Output, message))
  {
    return Complain(options.Output, message, CannotWrite);
  }
  const bool needsPolygons = !options.Method.empty() && !IsForPoints(options.Method);
  const auto input =
    ReadSurfaceFile(options.Input, message, needsPolygons ? Needs::Polygons : Needs::Points);
  if (!input)
  {
    return Complain(options.Input, message, CannotRead);
  }
  if (!CanHold(options.Output, input, message))
  {
    return Complain(options.Output, message, CannotWrite);
  }
  if (options.Method.empty())
  {
    options.Method = DefaultMethod(HasPolygons(input));
  }
  vtkSmartPointer<vtkPolyData> reference;
  if (!options.Reference.empty() &&
    !(reference = ReadSurfaceFile(options.Reference, message,
        IsForPoints(options.Method) ? Needs::Points : Needs::Polygons)))
  {
    return Complain(options.Reference, message, CannotRead);
  }

  const auto filter = MakeFilter(options, message);
  if (!filter)
  {
    std::cerr << "denoise: " << message << "\n";
    return BadCommandLine;
  }
  vtkNew<MessageKeeper> keeper;
  keeper->Watch(filter);
  if (!options.Quiet)
  {
    vtkNew<ProgressBar> progress;
    filter->AddObserver(vtkCommand::ProgressEvent, progress);
  }
  filter->SetInputData(input);
  const auto start = std::chrono::steady_clock::now();
  filter->Update();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (!keeper->Error.empty())
  {
    return Complain(options.Input, keeper->Error, CannotDenoise);
  }
  if (!keeper->Warning.empty())
  {
    std::cerr << "denoise: " << options.Input << ": " << keeper->Warning << "\n";
  }

  vtkPolyData* output = filter->GetOutput();
  if (!WriteSurfaceFile(options.Output, output, message))
  {
    return Complain(options.Output, message, CannotWrite);
  }
  if (!options.Quiet)
  {
    std::printf("%lld points, %lld polygons, %.2f seconds\n",
      static_cast<long long>(output->GetNumberOfPoints()),
      static_cast<long long>(output->GetNumberOfPolys() + output->GetNumberOfStrips()),
      seconds.count());
  }
  if (reference)
  {
    PrintComparison("before:", input, reference);
    PrintComparison("after:", output, reference);
  }
  return Done;
}
