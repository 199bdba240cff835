// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Every point method and what they are measured against, on the same points with the same normals,
// neighbours and threads. Run it with --benchmark_enable_random_interleaving: then all take turns,
// and whatever else the machine does slows down all of them.

#include "CostOf.h"
#include "NoisyCloud.h"
#include "PointFilter.h"
#include "PointPeers.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>

#include <benchmark/benchmark.h>

#include <cstring>
#include <map>

namespace
{

constexpr int Small = 100000;
constexpr int Medium = 1000000;
constexpr int Large = 4000000;

/// Made once: sampling takes longer than most methods.
vtkPolyData* CloudOf(vtkIdType count)
{
  static std::map<vtkIdType, vtkSmartPointer<vtkPolyData>> clouds;
  const auto entry = clouds.insert({ count, nullptr });
  if (entry.second)
  {
    entry.first->second = NoisyCloud(count);
  }
  return entry.first->second;
}

/// A component of the report that the filter leaves in its output.
double Reported(vtkPolyData* output, const char* name)
{
  vtkDataArray* report = output->GetFieldData()->GetArray("DenoisingReport");
  for (int i = 0; i < report->GetNumberOfComponents(); ++i)
  {
    if (std::strcmp(report->GetComponentName(i), name) == 0)
    {
      return report->GetComponent(0, i);
    }
  }
  return 0.0;
}

void Take(const Cost& cost, benchmark::State& state)
{
  state.SetIterationTime(cost.Seconds);
  state.counters["processor_s"] = cost.ProcessorSeconds;
  state.counters["points"] = double(state.range(0));
}

/// Arguments: number of points, threads, normals given or not.
void Method(benchmark::State& state, const std::string& name)
{
  vtkPolyData* cloud = CloudOf(state.range(0));
  if (!cloud)
  {
    state.SkipWithError("set SURFACE_DENOISING_BENCHMARK_MESH to an OFF file");
    return;
  }
  const vtkSmartPointer<vtkPolyData> bare = WithoutNormals(cloud);
  vtkPolyData* input = state.range(2) ? cloud : bare.Get();
  for (auto _ : state)
  {
    const vtkSmartPointer<vtkPointDenoisingFilter> filter = PointFilter(name);
    filter->SetNumberOfThreads(int(state.range(1)));
    filter->SetInputData(input);
    Take(CostOf([&] { filter->Update(); }), state);
    state.counters["setup_s"] = Reported(filter->GetOutput(), "Seconds Of Setup");
    state.counters["filter_s"] = Reported(filter->GetOutput(), "Seconds Of Filtering");
  }
}

/// The same arguments; normals are always given.
void Peer(benchmark::State& state, const std::string& name)
{
  vtkPolyData* cloud = CloudOf(state.range(0));
  if (!cloud)
  {
    state.SkipWithError("set SURFACE_DENOISING_BENCHMARK_MESH to an OFF file");
    return;
  }
  for (auto _ : state)
  {
    Take(CostOf(PointPeer(name, cloud, int(state.range(1)))), state);
  }
}

using Function = void (*)(benchmark::State&, const std::string&);

void Register(Function function, const std::string& name, int points, int threads, int normals = 1)
{
  benchmark::RegisterBenchmark(("Points/" + name).c_str(), function, name)
    ->ArgNames({ "points", "threads", "normals" })
    ->Args({ points, threads, normals })
    ->Iterations(1)
    ->Repetitions(3)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();
}

bool RegisterAll()
{
  for (const int threads : { 1, 2 })
  {
    for (const std::string& name : PointFilterNames())
    {
      Register(Method, name, Medium, threads);
    }
    for (const char* name : { "Bilateral Point", "Robust Point Normal" })
    {
      Register(Method, name, Medium, threads, 0);
      Register(Method, name, Small, threads);
      Register(Method, name, Large, threads);
    }
    for (const std::string& name : PointPeerNames())
    {
      if (threads <= PointPeerThreads())
      {
        Register(Peer, name, Small, threads);
        Register(Peer, name, Medium, threads);
      }
    }
  }
  return true;
}

const bool Registered = RegisterAll();

}
