// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// The bilateral filter beside what it is measured against: the textbook version, VTK's own
// smoothing, and the speed at which the machine copies memory.

#include "NeighborGraph.h"
#include "NoisySurface.h"
#include "SMPExecution.h"
#include "Textbook.h"

#include <vtkBilateralNormalFilter.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkSMPTools.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <benchmark/benchmark.h>

#include <chrono>
#include <cstring>

using namespace SurfaceDenoising;

namespace
{

constexpr int NormalIterations = 20;
constexpr int VertexIterations = 10;

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

/**
 * Bytes that one sweep over the normals has to move per face with m neighbours, if every
 * neighbour's normal is still in a cache: m indices and fixed weights, an offset, a normal read,
 * one written.
 */
double BytesPerFace(double m)
{
  return m * (sizeof(Index) + sizeof(double)) + sizeof(std::uint64_t) + 2 * sizeof(Vec3);
}

double MeanNeighbors(const TriangleMesh& mesh)
{
  Execution serial;
  const NeighborGraph graph = VertexSharingFaces(mesh, VertexStars(mesh), serial);
  return double(graph.NumberOfIds()) / double(graph.NumberOfRows());
}

void CountFaces(benchmark::State& state, double faces)
{
  state.counters["faces"] = faces;
  state.counters["ns/face"] = benchmark::Counter(faces * 1e-9,
    benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Arguments: cuts per edge, random order.
void Bilateral(benchmark::State& state)
{
  const TriangleMesh mesh = NoisyMesh(int(state.range(0)), state.range(1) != 0);
  if (mesh.NumberOfFaces() == 0)
  {
    state.SkipWithError("set SURFACE_DENOISING_BENCHMARK_MESH to an OFF file");
    return;
  }
  const vtkSmartPointer<vtkPolyData> surface = ToPolyData(mesh);
  const double faces = double(mesh.NumberOfFaces());
  double setup = 0.0;
  double normals = 0.0;
  double vertices = 0.0;
  for (auto _ : state)
  {
    vtkNew<vtkBilateralNormalFilter> filter;
    filter->SetNumberOfNormalIterations(NormalIterations);
    filter->SetNumberOfVertexIterations(VertexIterations);
    filter->SetInputData(surface);
    filter->Update();
    setup += Reported(filter->GetOutput(), "Seconds Of Setup");
    normals += Reported(filter->GetOutput(), "Seconds Of Normal Filtering");
    vertices += Reported(filter->GetOutput(), "Seconds Of Vertex Update");
  }
  CountFaces(state, faces);
  const double runs = double(state.iterations());
  state.counters["setup_s"] = setup / runs;
  state.counters["normals_s"] = normals / runs;
  state.counters["vertices_s"] = vertices / runs;
  state.counters["sweep_GB/s"] =
    1e-9 * BytesPerFace(MeanNeighbors(mesh)) * faces * NormalIterations * runs / normals;
}

void TextbookBilateral(benchmark::State& state)
{
  const TriangleMesh mesh = NoisyMesh(int(state.range(0)));
  Textbook::Mesh copy;
  for (const Vec3& p : mesh.Positions)
  {
    copy.Points.push_back({ p[0], p[1], p[2] });
  }
  for (const Triangle& t : mesh.Triangles)
  {
    copy.Faces.push_back({ int(t[0]), int(t[1]), int(t[2]) });
  }
  for (auto _ : state)
  {
    Textbook::Mesh work = copy;
    Textbook::Settings settings;
    settings.NormalIterations = NormalIterations;
    settings.VertexIterations = VertexIterations;
    benchmark::DoNotOptimize(Textbook::Denoise(work, settings));
  }
  // What is left without iterations are neighbourhoods and boundary.
  Textbook::Settings none;
  none.NormalIterations = 0;
  none.VertexIterations = 0;
  const auto start = std::chrono::steady_clock::now();
  benchmark::DoNotOptimize(Textbook::Denoise(copy, none));
  const std::chrono::duration<double> setup = std::chrono::steady_clock::now() - start;
  state.counters["setup_s"] = setup.count();
  CountFaces(state, double(mesh.NumberOfFaces()));
}

void WindowedSinc(benchmark::State& state)
{
  const TriangleMesh mesh = NoisyMesh(int(state.range(0)));
  const vtkSmartPointer<vtkPolyData> surface = ToPolyData(mesh);
  for (auto _ : state)
  {
    vtkNew<vtkWindowedSincPolyDataFilter> filter;
    filter->SetNumberOfIterations(20);
    filter->SetInputData(surface);
    filter->Update();
  }
  CountFaces(state, double(mesh.NumberOfFaces()));
}

/// a[i] = b[i] on all threads, far beyond the caches; reads and writes count.
void Copy(benchmark::State& state)
{
  const vtkIdType count = 1 << 25;
  Buffer<double> from(count);
  Buffer<double> to(count);
  auto copy = [](const double* source, double* target, vtkIdType length)
  {
    vtkSMPTools::For(0, length, length / 64,
      [=](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          target[i] = source[i];
        }
        benchmark::ClobberMemory();
      });
  };
  RunOnThreads(0,
    [&]
    {
      std::fill(from.begin(), from.end(), 1.0);
      copy(from.data(), to.data(), count);
      for (auto _ : state)
      {
        copy(from.data(), to.data(), count);
      }
    });
  state.counters["GB/s"] = benchmark::Counter(2e-9 * sizeof(double) * double(count),
    benchmark::Counter::kIsIterationInvariantRate);
}

}

// The fastest of several runs counts: whatever else the machine does can only add time.
BENCHMARK(Copy)->Repetitions(3)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(Bilateral)
  ->ArgNames({ "cuts", "shuffled" })
  ->ArgsProduct({ { 3, 9, 18 }, { 0, 1 } })
  ->Iterations(1)
  ->Repetitions(5)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
BENCHMARK(WindowedSinc)
  ->ArgName("cuts")
  ->Arg(3)
  ->Arg(9)
  ->Arg(18)
  ->Iterations(1)
  ->Repetitions(3)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
BENCHMARK(TextbookBilateral)
  ->ArgName("cuts")
  ->Arg(3)
  ->Arg(9)
  ->Iterations(1)
  ->Repetitions(2)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
