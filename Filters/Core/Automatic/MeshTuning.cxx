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

/// Faces that values are tried on, each of them twice.
constexpr std::size_t TrialFaces = 5000;

/// A sample of a mesh as it comes.
bool SampleAsPrepared(const TriangleMesh& mesh, MeshSample& sample, Execution& execution)
{
  TriangleMesh copy = mesh;
  PreparedMesh prepared(copy);
  if (!prepared.Prepare(execution))
  {
    return false;
  }
  sample = TakeSample(prepared.Mesh(), TrialFaces, execution);
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

  std::size_t Best() const override { return LeastRisk(this->Risks); }

private:
  ChainRisk& Risk;
  const MeshOperation& Operation;
  std::vector<GroupRisks> Risks;
};

}

bool MeasureNoise(const TriangleMesh& mesh, SurfaceNoise& noise, Execution& execution)
{
  MeshSample sample;
  if (!SampleAsPrepared(mesh, sample, execution))
  {
    return false;
  }
  noise = EstimateNoise(sample.Mesh, VertexStars(sample.Mesh), execution);
  return true;
}

bool TuneForMesh(const TriangleMesh& mesh, OpenSettings& open, const MeshOperation& method,
  MeshTuningReport& report, Execution& execution)
{
  report = MeshTuningReport();
  const Stopwatch stopwatch(report.Seconds);
  MeshSample sample;
  if (!SampleAsPrepared(mesh, sample, execution))
  {
    return false;
  }
  report.Noise = EstimateNoise(sample.Mesh, VertexStars(sample.Mesh), execution);
  report.NoNoiseFound = !IsNoisy(report.Noise);
  if (!report.NoNoiseFound)
  {
    ChainRisk risk(sample, PilotChain(), execution);
    risk.Assume(AssumedDeviation(report.Noise, risk.FoldedShare()), execution);
    MeshJudge judge(risk, method);
    if (!open.Search(judge, execution))
    {
      return false;
    }
  }
  open.Keep();
  return execution.Proceed(1.0);
}

}
