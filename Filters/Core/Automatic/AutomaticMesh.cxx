// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "AutomaticMesh.h"

#include "../Stopwatch.h"
#include "CandidateChains.h"
#include "ProgressShare.h"
#include "SpikeRepair.h"
#include "Spikes.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>

namespace SurfaceDenoising
{

namespace
{

/// Faces that chains are tried on: enough to tell them apart, few enough to try them all.
constexpr std::size_t SampleFaces = 12000;
/// Patches have rims. Meshes up to this size are taken as they are.
constexpr std::size_t WholeFaces = 20000;
/// Noise below this, in mean edge lengths, is not told from the shape of coarse meshes.
constexpr double LeastLevel = 0.035;
/// Noise that is taken for too strong costs a little detail, noise that is taken for too weak
/// leaves most of it: the assumed noise is somewhat above what was found. Weak noise is found too
/// strong already.
double Caution(double level) { return std::min(1.1, 0.95 + level); }

/// Chains that take away as much more than the noise that is assumed say that there is more.
constexpr double LargestExcess = 1.3;
constexpr double MostCorrection = 3.0;
/// A gain below this is not certain: the mean square error must fall to this share of that of the
/// input.
constexpr double LargestError = 0.8;
/// The same as the caution for surfaces with so many folded faces that the noise has any direction.
/// It is stronger than its part along the normals looks.
constexpr double CautionIfFolded = 1.3;
constexpr double StronglyFolded = 0.02;
/// Folded faces, or noise in mean edge lengths, from which on it is worth to take folds out first.
constexpr double SlightlyFolded = 0.01;
constexpr double StrongLevel = 0.4;

std::string Describe(const SurfaceNoise& noise)
{
  char text[128];
  std::snprintf(text, sizeof(text), "Noise of %.2f mean edge lengths (%.0f degrees)", noise.Level,
    noise.NormalAngle);
  return text;
}

/// True if the first vertex update also moves vertices along the surface: the others leave folds.
bool MovesAlongSurface(const CandidateChain& chain)
{
  const VertexScheme scheme = chain.Steps.front().Vertices.Scheme;
  return scheme == VertexScheme::IntegralFit || scheme == VertexScheme::EdgeWeighted;
}

MeshSample SampleOf(const TriangleMesh& mesh, Execution& execution)
{
  return TakeSample(mesh, mesh.NumberOfFaces() > WholeFaces ? SampleFaces : WholeFaces, execution);
}

/// What the mesh itself would say, from a part of it.
bool LooksImpulsive(const TriangleMesh& mesh, Execution& execution)
{
  const MeshSample sample = SampleOf(mesh, execution);
  const CompressedRows stars = VertexStars(sample.Mesh);
  return AreImpulses(sample.Mesh, stars, FindSpikes(sample.Mesh, stars, execution), execution);
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

namespace
{

double MeanOf(const GroupRisks& risks)
{
  return std::accumulate(risks.begin(), risks.end(), 0.0) / double(RiskGroups);
}

/// The risks of all candidates, and the least of what they take from the flattest faces.
bool FindRisks(const std::vector<const CandidateChain*>& candidates, ChainRisk& risk,
  std::vector<GroupRisks>& risks, double& removed, Execution& execution)
{
  risks.resize(candidates.size());
  removed = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < candidates.size(); ++k)
  {
    const double part = 1.0 / double(candidates.size());
    ProgressShare share(execution, double(k) * part, double(k + 1) * part);
    if (!risk.Of(candidates[k]->Steps, risks[k], share))
    {
      return false;
    }
    removed = std::min(removed, risk.RemovedFromFlats());
  }
  return true;
}

}

bool IsNoisy(const SurfaceNoise& noise, double strength)
{
  return strength * noise.Level >= LeastLevel;
}

double AssumedDeviation(const SurfaceNoise& noise, double foldedShare, double strength)
{
  const double caution = foldedShare > StronglyFolded ? CautionIfFolded : Caution(noise.Level);
  return caution * strength * noise.Deviation;
}

bool PlanDenoising(const TriangleMesh& mesh, const AutomaticSettings& settings, AutomaticPlan& plan,
  Execution& execution)
{
  plan = AutomaticPlan();
  const double strength = settings.CheckedStrength();
  const MeshSample sample = SampleOf(mesh, execution);
  plan.Noise = EstimateNoise(sample.Mesh, VertexStars(sample.Mesh), execution);
  if (!IsNoisy(plan.Noise, strength))
  {
    plan.Reason = strength > 0.0 ? Describe(plan.Noise) + " is none to speak of: nothing to do"
                                 : "A strength of 0: nothing to do";
    return execution.Proceed(1.0);
  }
  ProgressShare start(execution, 0.0, 0.05);
  ChainRisk risk(sample, PilotChain(), start);
  const bool folded = risk.FoldedShare() > StronglyFolded;
  const double assumed = AssumedDeviation(plan.Noise, risk.FoldedShare(), strength);
  risk.Assume(assumed, start);
  std::vector<const CandidateChain*> candidates;
  for (const CandidateChain& chain : CandidateChains())
  {
    const bool wanted =
      !chain.Unfolds || plan.Noise.Level > StrongLevel || risk.FoldedShare() > SlightlyFolded;
    if (settings.Considers(chain.Type) && wanted && (!folded || MovesAlongSurface(chain)))
    {
      candidates.push_back(&chain);
    }
  }
  std::vector<GroupRisks> risks;
  double removed = 0.0;
  ProgressShare first(execution, 0.05, 0.5);
  if (!FindRisks(candidates, risk, risks, removed, first))
  {
    return false;
  }
  // Noise of heavy tails is found too weak: then all chains take more of it away.
  const double excess = removed * strength * strength;
  if (excess > LargestExcess)
  {
    risk.Assume(std::min(MostCorrection, std::sqrt(excess)) * assumed, execution);
    ProgressShare second(execution, 0.5, 1.0);
    if (!FindRisks(candidates, risk, risks, removed, second))
    {
      return false;
    }
  }
  // Only those with a gain that is certain.
  std::vector<GroupRisks> certain;
  std::vector<const CandidateChain*> chains;
  for (std::size_t k = 0; k < candidates.size(); ++k)
  {
    if (MeanOf(risks[k]) < LargestError)
    {
      certain.push_back(risks[k]);
      chains.push_back(candidates[k]);
    }
  }
  plan.Reason = Describe(plan.Noise);
  if (chains.empty())
  {
    plan.Reason += ", but no method would make it much less: nothing to do";
    return execution.Proceed(1.0);
  }
  const std::size_t best = LeastRisk(certain);
  plan.Steps = chains[best]->Steps;
  plan.Methods = chains[best]->Methods;
  plan.Reason += std::string(", ") + chains[best]->Purpose;
  plan.ExpectedError = std::max(0.0, MeanOf(certain[best]));
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
  {
    const Stopwatch stopwatch(report.PlanSeconds);
    if (!prepared.Prepare(execution))
    {
      return false;
    }
    before = prepared.Mesh().Positions;
    if ((settings.CheckedStrength() > 0.0 && LooksImpulsive(prepared.Mesh(), execution) &&
          !RepairSpikes(prepared.Mesh(), prepared.Stars(), prepared.Edges(),
            report.RepairedVertices, repair)) ||
      !PlanDenoising(prepared.Mesh(), settings, report.Plan, plan))
    {
      return false;
    }
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
