// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Every method of the table beside the bilateral filter with the same iterations. The two take
// turns, so that whatever else the machine does slows down both.

#include "CostOf.h"
#include "MethodFilter.h"
#include "NoisySurface.h"
#include "SMPExecution.h"

#include <vtkAlgorithm.h>
#include <vtkBilateralNormalFilter.h>
#include <vtkNew.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>

using namespace SurfaceDenoising;

namespace
{

/// Outer iterations of a schedule that are measured: the first ones, as the others are like them.
constexpr int MeasuredOuterIterations = 3;

/// The mesh of the benchmark before, if it is the same: cutting takes longer than most methods.
const TriangleMesh& MeshOf(int cuts)
{
  static int present = 0;
  static TriangleMesh mesh;
  if (present != cuts)
  {
    mesh = TriangleMesh(); // before there is another one
    mesh = NoisyMesh(cuts);
    present = cuts;
  }
  return mesh;
}

/// Of denoising a copy of the mesh, not of copying. Without the way from and to VTK, which is the
/// same for all methods and would hide differences.
Cost CostOfMethod(const TriangleMesh& mesh, const MeshDenoisingSettings& settings,
  MeshDenoisingReport& report)
{
  TriangleMesh work = mesh;
  Buffer<Vec3> normals;
  vtkNew<vtkAlgorithm> nobody;
  SMPExecution execution(nobody);
  Cost cost;
  RunOnThreads(0,
    [&] { cost = CostOf([&] { DenoiseMesh(work, normals, settings, report, execution); }); });
  return cost;
}

struct Comparison
{
  Cost Method;
  Cost Bilateral;
};

Comparison CompareTwoStages(const MethodRow& row, const TriangleMesh& mesh, benchmark::State& state)
{
  MeshDenoisingSettings settings = row.Settings;
  settings.OuterIterations = std::min(settings.OuterIterations, MeasuredOuterIterations);
  MeshDenoisingSettings bilateral = SettingsOf(Method::BilateralNormal);
  // A solve has no number of iterations to compare with: what the local scheme takes instead of it.
  if (settings.Operator != NormalOperator::GlobalSolve)
  {
    bilateral.OuterIterations = settings.OuterIterations;
    bilateral.NormalIterations = settings.NormalIterations;
    bilateral.VertexIterations = settings.VertexIterations;
  }
  MeshDenoisingReport report;
  MeshDenoisingReport ignored;
  const Comparison comparison = { CostOfMethod(mesh, settings, report),
    CostOfMethod(mesh, bilateral, ignored) };
  state.counters["setup_s"] = report.SetupSeconds;
  state.counters["normals_s"] = report.NormalSeconds;
  state.counters["vertices_s"] = report.VertexSeconds;
  state.counters["solver_iterations"] = double(report.SolverIterations);
  state.counters["outer"] = settings.OuterIterations;
  state.counters["normal"] = settings.NormalIterations;
  state.counters["vertex"] = settings.VertexIterations;
  return comparison;
}

/// A step of a method of one stage is worth one iteration of each kind.
Comparison CompareOneStage(const MethodRow& row, const TriangleMesh& mesh)
{
  const vtkSmartPointer<vtkPolyData> surface = ToPolyData(mesh);
  const vtkSmartPointer<vtkMeshDenoisingFilter> filter = MethodFilter(row.Id, 1);
  filter->SetInputData(surface);
  vtkNew<vtkBilateralNormalFilter> bilateral;
  bilateral->SetNumberOfOuterIterations(1);
  bilateral->SetNumberOfNormalIterations(1);
  bilateral->SetNumberOfVertexIterations(1);
  bilateral->SetInputData(surface);
  return { CostOf([&] { filter->Update(); }), CostOf([&] { bilateral->Update(); }) };
}

/// Argument: cuts per edge.
void CompareMethod(benchmark::State& state, const MethodRow& row)
{
  const TriangleMesh& mesh = MeshOf(int(state.range(0)));
  if (mesh.NumberOfFaces() == 0)
  {
    state.SkipWithError("set SURFACE_DENOISING_BENCHMARK_MESH to an OFF file");
    return;
  }
  for (auto _ : state)
  {
    const Comparison comparison =
      row.TwoStage ? CompareTwoStages(row, mesh, state) : CompareOneStage(row, mesh);
    state.SetIterationTime(comparison.Method.Seconds);
    state.counters["processor_s"] = comparison.Method.ProcessorSeconds;
    state.counters["bilateral_s"] = comparison.Bilateral.Seconds;
    state.counters["bilateral_processor_s"] = comparison.Bilateral.ProcessorSeconds;
  }
  state.counters["faces"] = double(mesh.NumberOfFaces());
}

void Register(const MethodRow& row, int cuts)
{
  benchmark::RegisterBenchmark((std::string("Method/") + row.Name).c_str(), CompareMethod, row)
    ->ArgName("cuts")
    ->Arg(cuts)
    ->Iterations(1)
    ->Repetitions(3)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();
}

bool RegisterAll()
{
  for (const MethodRow& row : Methods())
  {
    Register(row, 9);
  }
  // Guidance visits neighbours of neighbours: their share of the caches must not show.
  Register(Methods()[static_cast<std::size_t>(Method::GuidedNormal)], 3);
  Register(Methods()[static_cast<std::size_t>(Method::GuidedNormal)], 18);
  return true;
}

const bool Registered = RegisterAll();

}
