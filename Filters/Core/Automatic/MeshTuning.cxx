// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshTuning.h"

#include "../Stopwatch.h"
#include "CandidateChains.h"
#include "ProgressShare.h"

namespace SurfaceDenoising
{

namespace
{

/// Faces that values are tried on, each of them twice, and those that the best are confirmed on.
constexpr std::size_t TrialFaces = 5000;
constexpr std::size_t FineFaces = 16000;

/// Noise below this, in mean edge lengths, is not told from the shape of coarse meshes.
constexpr double LeastLevel = 0.035;

/**
 * The deviation of the noise to assume: somewhat more than was found. Noise that is taken for too
 * strong costs a little detail, noise that is taken for too weak leaves most of it. Weak noise is
 * found too strong already. Many folded faces say that the noise has any direction; it is stronger
 * than its part along the normals looks.
 */
double AssumedDeviation(const SurfaceNoise& noise, double foldedShare)
{
  const double caution = foldedShare > 0.02 ? 1.3 : std::min(1.1, 0.95 + noise.Level);
  return caution * noise.Deviation;
}

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
  MeshJudge(MeshRisk& risk, const MeshOperation& method)
    : Risk(risk)
    , Operation(method)
  {
  }

  bool Try(Execution& execution) override
  {
    this->Risks.emplace_back();
    return this->Risk.Of(this->Operation, this->Risks.back(), execution);
  }

  std::vector<double> Costs() const override { return CompareRisks(this->Risks); }

private:
  MeshRisk& Risk;
  const MeshOperation& Operation;
  std::vector<GroupRisks> Risks;
};

}

bool IsNoisy(const SurfaceNoise& noise) { return noise.Level >= LeastLevel; }

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
    MeshRisk fine(large, PilotChain(), execution);
    MeshRisk rough(small, PilotChain(), execution);
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
