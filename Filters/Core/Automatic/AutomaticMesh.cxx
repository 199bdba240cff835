// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "AutomaticMesh.h"

#include "../Stopwatch.h"
#include "CandidateChains.h"
#include "ProgressShare.h"

#include <cmath>
#include <cstdio>

namespace SurfaceDenoising
{

namespace
{

/// Faces that chains are tried on: enough to tell them apart, few enough to try them all.
constexpr std::size_t SampleFaces = 20000;
/// Noise below this, in mean edge lengths, is not told from the shape of coarse meshes.
constexpr double LeastLevel = 0.035;
/// Noise that is taken for too strong costs a little detail, noise that is taken for too weak
/// leaves most of it: the assumed noise is somewhat above what was found.
constexpr double Caution = 1.1;

std::string Describe(const SurfaceNoise& noise)
{
  char text[128];
  std::snprintf(text, sizeof(text), "Noise of %.2f mean edge lengths (%.0f degrees)", noise.Level,
    noise.NormalAngle);
  return text;
}

/// Root mean square of the displacements along the area-weighted normals of the result.
double RemovedAlongNormals(const TriangleMesh& mesh, const Buffer<Vec3>& before,
  Execution& execution)
{
  Buffer<Vec3> normals(mesh.NumberOfVertices(), Vec3(0.0, 0.0, 0.0));
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    for (const Index v : mesh.Triangles[f])
    {
      normals[v] += mesh.DoubleAreaVector(f);
    }
  }
  const double sum = OrderedSum(execution, normals.size(), 0.0,
    [&](std::size_t v)
    {
      const double height = normals[v].stableNormalized().dot(mesh.Positions[v] - before[v]);
      return height * height;
    });
  return normals.empty() ? 0.0 : std::sqrt(sum / double(normals.size()));
}

}

bool PlanDenoising(const TriangleMesh& mesh, double strength, AutomaticPlan& plan,
  Execution& execution)
{
  plan = AutomaticPlan();
  strength = strength > 0.0 ? std::min(strength, 10.0) : 0.0;
  const MeshSample sample = TakeSample(mesh, SampleFaces, execution);
  plan.Noise = EstimateNoise(sample.Mesh, VertexStars(sample.Mesh), execution);
  if (!(strength * plan.Noise.Level >= LeastLevel))
  {
    plan.Reason = strength > 0.0 ? Describe(plan.Noise) + " is none to speak of: nothing to do"
                                 : "A strength of 0: nothing to do";
    return execution.Proceed(1.0);
  }
  const ChainRisk risk(sample, Caution * strength * plan.Noise.Deviation, PilotChain(), execution);
  const CandidateChain* best = nullptr;
  double least = risk.Of({}, execution);
  const std::vector<CandidateChain>& chains = CandidateChains();
  for (std::size_t k = 0; k < chains.size(); ++k)
  {
    const double count = double(chains.size());
    ProgressShare share(execution, double(k) / count, double(k + 1) / count);
    const double error = risk.Of(chains[k].Steps, share);
    if (std::isnan(error))
    {
      return false;
    }
    if (error < least)
    {
      least = error;
      best = &chains[k];
    }
  }
  plan.Reason = Describe(plan.Noise);
  if (best)
  {
    plan.Steps = best->Steps;
    plan.Methods = best->Methods;
    plan.Reason += std::string(", ") + best->Purpose;
    plan.ExpectedError = std::max(0.0, least);
  }
  else
  {
    plan.Reason += ", but no method would make it less: nothing to do";
  }
  return execution.Proceed(1.0);
}

bool DenoiseAutomatically(TriangleMesh& mesh, double strength, AutomaticReport& report,
  Execution& execution)
{
  report = AutomaticReport();
  PreparedMesh prepared(mesh);
  ProgressShare plan(execution, 0.0, 0.5);
  ProgressShare denoise(execution, 0.5, 1.0);
  {
    const Stopwatch stopwatch(report.PlanSeconds);
    if (!prepared.Prepare(execution) ||
      !PlanDenoising(prepared.Mesh(), strength, report.Plan, plan))
    {
      return false;
    }
  }
  const MeshFacts facts = prepared.Facts();
  if (!report.Plan.Steps.empty())
  {
    const Stopwatch stopwatch(report.DenoiseSeconds);
    const Buffer<Vec3> before = prepared.Mesh().Positions;
    Buffer<Vec3> normals;
    if (!RunChain(prepared.Mesh(), report.Plan.Steps, normals, report.Last, denoise))
    {
      return false;
    }
    report.Removed = RemovedAlongNormals(prepared.Mesh(), before, execution) / facts.MeanEdgeLength;
  }
  // Facts of the mesh as it came: the work sees it without seams.
  static_cast<MeshFacts&>(report.Last) = facts;
  prepared.Finish();
  return execution.Proceed(1.0);
}

}
