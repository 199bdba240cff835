// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// How much memory a method takes at its peak beyond its input, output included. Linux only: the
// high-water mark of the resident set, reset before the filter runs. One mesh per process, so that
// nothing is left over from another one.
//
// peak-memory <cuts per edge> [<name in the table of methods>] prints faces, bytes per face and the
// name; without name it is the bilateral filter.

#include "MethodFilter.h"
#include "NoisySurface.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

namespace
{

/// What later outer iterations hold besides the first one is there in the second.
constexpr int OuterIterations = 2;

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
  const SurfaceDenoising::MethodRow* row = FindMethod(argc > 2 ? argv[2] : "Bilateral Normal");
  if (!row)
  {
    std::fprintf(stderr, "peak-memory: there is no method %s\n", argv[2]);
    return 1;
  }
  const vtkSmartPointer<vtkPolyData> surface =
    ToPolyData(cuts > 0 ? NoisyMesh(cuts) : SurfaceDenoising::TriangleMesh());
  const double faces = static_cast<double>(surface->GetNumberOfPolys());
  if (faces == 0.0)
  {
    std::fprintf(stderr, "peak-memory: give the cuts per edge, and the mesh in the environment\n");
    return 1;
  }
  const vtkSmartPointer<vtkMeshDenoisingFilter> filter = MethodFilter(row->Id, OuterIterations);
  filter->SetInputData(surface);
  std::ofstream("/proc/self/clear_refs") << 5;
  const double before = Status("VmRSS");
  filter->Update();
  std::printf("%.0f %.1f %s\n", faces, (Status("VmHWM") - before) / faces, row->Name);
  return 0;
}
