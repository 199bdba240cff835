// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// How much memory a method takes at its peak beyond its input, output included. Linux only: the
// high-water mark of the resident set, reset before the method runs. One input per process, so that
// nothing is left over from another one.
//
// peak-memory <size> [<name>] prints the number of elements, bytes per element and the name. A name
// in the table of methods wants cuts per edge as its size, and elements are faces; without name it
// is the bilateral filter. A point method or a program that these are compared with wants the
// number of points. peak-memory names prints the names of these.

#include "MethodFilter.h"
#include "NoisyCloud.h"
#include "NoisySurface.h"
#include "PointFilter.h"
#include "PointPeers.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
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

/// A method with its input, ready to run.
struct Work
{
  std::function<void()> Run;
  double Elements = 0.0;
};

Work MeshWork(const SurfaceDenoising::MethodRow& row, int cuts)
{
  const vtkSmartPointer<vtkPolyData> surface = ToPolyData(NoisyMesh(cuts));
  const vtkSmartPointer<vtkMeshDenoisingFilter> filter = MethodFilter(row.Id, OuterIterations);
  filter->SetInputData(surface);
  return { [filter] { filter->Update(); }, static_cast<double>(surface->GetNumberOfPolys()) };
}

/// Nothing to run for an unknown name.
Work PointWork(const std::string& name, int count)
{
  const vtkSmartPointer<vtkPolyData> cloud = NoisyCloud(count);
  if (!cloud)
  {
    return {};
  }
  Work work{ PointPeer(name, cloud, 1), static_cast<double>(count) };
  if (const vtkSmartPointer<vtkPointDenoisingFilter> filter = PointFilter(name))
  {
    filter->SetInputData(cloud);
    work.Run = [filter] { filter->Update(); };
  }
  return work;
}

}

int main(int argc, char** argv)
{
  if (argc > 1 && std::string(argv[1]) == "names")
  {
    for (const auto& names : { PointFilterNames(), PointPeerNames() })
    {
      for (const std::string& name : names)
      {
        std::printf("%s\n", name.c_str());
      }
    }
    return 0;
  }
  const int size = argc > 1 ? std::atoi(argv[1]) : 0;
  const std::string name = argc > 2 ? argv[2] : "Bilateral Normal";
  Work work;
  if (size > 0)
  {
    const SurfaceDenoising::MethodRow* row = FindMethod(name);
    work = row ? MeshWork(*row, size) : PointWork(name, size);
  }
  if (work.Elements == 0.0)
  {
    std::fprintf(stderr, "peak-memory: give the size, and the mesh in the environment\n");
    return 1;
  }
  if (!work.Run)
  {
    std::fprintf(stderr, "peak-memory: there is no method %s\n", name.c_str());
    return 1;
  }
  std::ofstream("/proc/self/clear_refs") << 5;
  const double before = Status("VmRSS");
  work.Run();
  std::printf("%.0f %.1f %s\n", work.Elements, (Status("VmHWM") - before) / work.Elements,
    name.c_str());
  return 0;
}
