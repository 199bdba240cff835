// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// How much memory the bilateral filter takes at its peak beyond its input, output included. Linux
// only: the high-water mark of the resident set, reset before the filter runs. One mesh per
// process, so that nothing is left over from another one.
//
// peak-memory <cuts per edge> prints faces and bytes per face.

#include "NoisySurface.h"

#include <vtkBilateralNormalFilter.h>
#include <vtkNew.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

namespace
{

/// An entry of /proc/self/status, in bytes.
double Status(const std::string& key)
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
  {
    double kilobytes = 0.0;
    if (word == key + ":" && status >> kilobytes)
    {
      return 1024.0 * kilobytes;
    }
  }
  return 0.0;
}

}

int main(int argc, char** argv)
{
  const int cuts = argc > 1 ? std::atoi(argv[1]) : 0;
  const vtkSmartPointer<vtkPolyData> surface =
    ToPolyData(cuts > 0 ? NoisyMesh(cuts) : SurfaceDenoising::TriangleMesh());
  const double faces = static_cast<double>(surface->GetNumberOfPolys());
  if (faces == 0.0)
  {
    std::fprintf(stderr, "peak-memory: give the cuts per edge, and the mesh in the environment\n");
    return 1;
  }
  vtkNew<vtkBilateralNormalFilter> filter;
  filter->SetInputData(surface);
  std::ofstream("/proc/self/clear_refs") << 5;
  const double before = Status("VmRSS");
  filter->Update();
  std::printf("%.0f %.1f\n", faces, (Status("VmHWM") - before) / faces);
  return 0;
}
