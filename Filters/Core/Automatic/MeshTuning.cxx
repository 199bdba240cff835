// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshTuning.h"

#include "../Stopwatch.h"
#include "AutomaticMesh.h"
#include "CandidateChains.h"
#include "ProgressShare.h"

namespace SurfaceDenoising
{

namespace
{

/// Faces that values are tried on, each of them twice, and those that the best are confirmed on.
constexpr std::size_t TrialFaces = 5000;
constexpr std::size_t FineFaces = 16000;

/// The repaired mesh.
bool Repair(TriangleMesh& mesh, Execution& execution)
{
  PreparedMesh prepared(mesh);
  if (!prepared.Prepare(execution))
  {
    return false;
  }
  mesh = TriangleMesh(prepared.Mesh());
  return true;
}

class MeshJudge : public OpenSettings::Judge
{
public:
  MeshJudge(ChainRisk& risk, const MeshOperation& method)
    : Risk(risk)
    , Operation(method)
  {
  }

  bool Try(Execution& execution) override
  {
    this->Risks.emplace_back();
    return this->Risk.Of(this->Operation, this->Risks.back(), execution);
  }

  std::vector<std::size_t> Ranking() const override { return RankRisks(this->Risks); }

private:
  ChainRisk& Risk;
  const MeshOperation& Operation;
  std::vector<GroupRisks> Risks;
};

}

bool MeasureNoise(const TriangleMesh& mesh, SurfaceNoise& noise, Execution& execution)
{
  TriangleMesh repaired = mesh;
  if (!Repair(repaired, execution))
  {
    return false;
  }
  const MeshSample sample = TakeSample(repaired, FineFaces, execution);
  noise = EstimateNoise(sample.Mesh, VertexStars(sample.Mesh), execution);
  return true;
}

bool TuneForMesh(const TriangleMesh& mesh, OpenSettings& open, const MeshOperation& method,
  MeshTuningReport& report, Execution& execution)
{
  report = MeshTuningReport();
  const Stopwatch stopwatch(report.Seconds);
  TriangleMesh repaired = mesh;
  if (!Repair(repaired, execution))
  {
    return false;
  }
  const MeshSample large = TakeSample(repaired, FineFaces, execution);
  report.Noise = EstimateNoise(large.Mesh, VertexStars(large.Mesh), execution);
  report.NoNoiseFound = !IsNoisy(report.Noise);
  if (!report.NoNoiseFound)
  {
    const MeshSample small = TakeSample(repaired, TrialFaces, execution);
    ChainRisk fine(large, PilotChain(), execution);
    ChainRisk rough(small, PilotChain(), execution);
    const double deviation = AssumedDeviation(report.Noise, fine.FoldedShare());
    fine.Assume(deviation, execution);
    rough.Assume(deviation, execution);
    MeshJudge first(rough, method);
    MeshJudge second(fine, method);
    ProgressShare searching(execution, 0.0, 0.7);
    ProgressShare confirming(execution, 0.7, 1.0);
    if (!open.Search(first, searching) ||
      (large.Mesh.NumberOfFaces() > small.Mesh.NumberOfFaces() &&
        !open.Confirm(first, second, confirming)))
    {
      return false;
    }
  }
  open.Keep();
  return execution.Proceed(1.0);
}

}
