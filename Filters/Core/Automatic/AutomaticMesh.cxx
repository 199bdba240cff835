// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "AutomaticMesh.h"

#include "../Stopwatch.h"
#include "CandidateChains.h"
#include "ChainTrials.h"
#include "ProgressShare.h"
#include "SpikeRepair.h"
#include "Spikes.h"

#include <cmath>
#include <cstdio>

namespace SurfaceDenoising
{

namespace
{

/// Faces that chains are tried on. Patches have rims: meshes up to this size are taken as they are.
constexpr std::size_t TrialFaces = 24000;
/// The same for large meshes: few enough to try all chains on in less than twice the time that a
/// quick one takes on a million.
constexpr std::size_t LargeMesh = 200000;
constexpr std::size_t TrialFacesOfLarge = 8000;

/// Impulses that were missed, or all of them if they cannot be repaired, are still there and no
/// noise that can be added again in a trial: the expected error must be below this.
constexpr double LargestErrorAmongImpulses = 0.45;

std::string Describe(const SurfaceNoise& noise)
{
  char text[128];
  std::snprintf(text, sizeof(text), "Noise of %.2f mean edge lengths (%.0f degrees)", noise.Level,
    noise.NormalAngle);
  return text;
}

MeshSample SampleOf(const TriangleMesh& mesh, Execution& execution)
{
  return TakeSample(mesh, mesh.NumberOfFaces() > LargeMesh ? TrialFacesOfLarge : TrialFaces,
    execution);
}

/// What the mesh itself would say, from a part of it.
bool LooksImpulsive(const TriangleMesh& mesh, Execution& execution)
{
  const MeshSample sample = SampleOf(mesh, execution);
  const CompressedRows stars = VertexStars(sample.Mesh);
  Buffer<unsigned char> marks;
  return FindImpulses(sample.Mesh, stars, marks, execution);
}

/// Leaves the rest of impulses as it is, if a chain is not certain to be better.
void DoubtAmongImpulses(AutomaticPlan& plan)
{
  if (plan.ExpectedError > LargestErrorAmongImpulses && !plan.Steps.empty())
  {
    plan.Steps.clear();
    plan.Methods.clear();
    plan.ExpectedError = 1.0;
    plan.Reason = Describe(plan.Noise) + ", which may be impulses that are left: nothing to do";
  }
}

/// Root mean square of the displacements along the area-weighted normals of the result.
double RemovedAlongNormals(const TriangleMesh& mesh, const Buffer<Vec3>& before,
  Execution& execution)
{
  const Buffer<Vec3> normals = VertexAreaVectors(mesh, VertexStars(mesh), execution);
  const double sum = OrderedSum(execution, normals.size(), 0.0,
    [&](std::size_t v)
    {
      const double height = normals[v].stableNormalized().dot(mesh.Positions[v] - before[v]);
      return height * height;
    });
  return normals.empty() ? 0.0 : std::sqrt(sum / double(normals.size()));
}

}

bool PlanDenoising(const TriangleMesh& mesh, const AutomaticSettings& settings, AutomaticPlan& plan,
  Execution& execution)
{
  plan = AutomaticPlan();
  const double strength = settings.CheckedStrength();
  const MeshSample sample = SampleOf(mesh, execution);
  plan.Noise = EstimateNoise(sample.Mesh, VertexStars(sample.Mesh), execution);
  if (!(strength > 0.0))
  {
    plan.Reason = "A strength of 0: nothing to do";
    return execution.Proceed(1.0);
  }
  std::vector<const CandidateChain*> candidates;
  for (const CandidateChain& chain : CandidateChains())
  {
    if (settings.Considers(chain.Type))
    {
      candidates.push_back(&chain);
    }
  }
  const TrialSample trialSample(sample, execution);
  ChainTrials trials(trialSample, candidates);
  TrialResult result;
  if (!trials.Run(strength, result, execution))
  {
    return false;
  }
  plan.Reason = Describe(plan.Noise);
  if (!result.Certain)
  {
    plan.Reason += ", but no method would make it less for certain: nothing to do";
    return execution.Proceed(1.0);
  }
  const CandidateChain& chain = *candidates[result.Best];
  plan.Steps = chain.Steps;
  plan.Methods = chain.Methods;
  plan.Reason += std::string(", ") + chain.Purpose;
  plan.ExpectedError = result.Error;
  return execution.Proceed(1.0);
}

bool DenoiseAutomatically(TriangleMesh& mesh, const AutomaticSettings& settings,
  AutomaticReport& report, Execution& execution)
{
  report = AutomaticReport();
  PreparedMesh prepared(mesh);
  ProgressShare repair(execution, 0.0, 0.1);
  ProgressShare plan(execution, 0.1, 0.6);
  ProgressShare denoise(execution, 0.6, 1.0);
  Buffer<Vec3> before;
  bool impulsive = false;
  {
    const Stopwatch stopwatch(report.PlanSeconds);
    if (!prepared.Prepare(execution))
    {
      return false;
    }
    before = prepared.Mesh().Positions;
    impulsive = settings.CheckedStrength() > 0.0 && LooksImpulsive(prepared.Mesh(), execution);
    if ((impulsive &&
          !RepairSpikes(prepared.Mesh(), prepared.Stars(), prepared.Edges(),
            report.RepairedVertices, repair)) ||
      !PlanDenoising(prepared.Mesh(), settings, report.Plan, plan))
    {
      return false;
    }
  }
  if (impulsive)
  {
    DoubtAmongImpulses(report.Plan);
  }
  const MeshFacts facts = prepared.Facts();
  if (!report.Plan.Steps.empty())
  {
    const Stopwatch stopwatch(report.DenoiseSeconds);
    Buffer<Vec3> normals;
    if (!RunChain(prepared.Mesh(), report.Plan.Steps, normals, report.Last, denoise))
    {
      return false;
    }
  }
  if (facts.MeanEdgeLength > 0.0)
  {
    report.Removed = RemovedAlongNormals(prepared.Mesh(), before, execution) / facts.MeanEdgeLength;
  }
  // Facts of the mesh as it came: the work sees it without seams.
  static_cast<MeshFacts&>(report.Last) = facts;
  prepared.Finish();
  return execution.Proceed(1.0);
}

}
