// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaceFilter.h"

#include "FaceCurvature.h"
#include "InterruptedExecution.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// x_ij over all pairs of edge-adjacent faces that have normals, each pair once. Centroids closer
/// than shortest belong to one face that was stored twice.
Buffer<double> AdjacentDifferences(const NeighborGraph& adjacent, const Buffer<Vec3>& normals,
  const Buffer<Vec3>& centroids, NormalArgument argument, double shortest)
{
  Buffer<double> differences;
  differences.reserve(adjacent.NumberOfIds() / 2);
  for (std::size_t f = 0; f < adjacent.NumberOfRows(); ++f)
  {
    for (const Index g : adjacent.Row(f))
    {
      const double distance = (centroids[f] - centroids[g]).norm();
      const Vec3& m = normals[f];
      const Vec3& n = normals[g];
      if (g > f && !m.isZero(0.0) && !n.isZero(0.0) && distance > shortest)
      {
        const bool angle =
          argument == NormalArgument::Angle || argument == NormalArgument::DirectionalCurvature;
        const double x = angle ? std::atan2(m.cross(n).norm(), m.dot(n)) : (m - n).norm();
        differences.push_back(IsCurvature(argument) ? x / distance : x);
      }
    }
  }
  return differences;
}

/// Runs loops whole or, of large meshes, so that they can be stopped half way.
struct Loops
{
  Loops(bool large, Execution& execution, double first, double last)
    : Pieces(execution, first, last)
    , Host(large ? this->Pieces : execution)
  {
  }
  Loops(const Loops&) = delete;
  void operator=(const Loops&) = delete;

  InterruptedExecution Pieces;
  Execution& Host;
};

bool IsBall(FaceNeighborhood neighborhood)
{
  return neighborhood == FaceNeighborhood::Radius || neighborhood == FaceNeighborhood::EdgeRadius;
}

}

FaceFilter::FaceFilter(const TriangleMesh& mesh, const CompressedRows& stars,
  const Buffer<unsigned char>& boundary, double meanEdgeLength, const FaceFilterSettings& settings,
  FaceFilterReport& report)
  : Mesh(mesh)
  , Stars(stars)
  , Boundary(boundary)
  , EdgeLength(meanEdgeLength)
  , Settings(settings)
  , Report(report)
{
}

bool FaceFilter::Renew(Buffer<Vec3>& normals, Execution& execution, double done)
{
  Loops loops(this->IsLarge(), execution, done, done);
  Execution& host = loops.Host;
  ComputeFaceGeometry(this->Mesh, this->EdgeLength, this->Geometry, host);
  const bool first = !this->Renewed;
  this->Renewed = true;
  if (this->EdgeAdjacent.NumberOfRows() == 0)
  {
    this->EdgeAdjacent = EdgeAdjacentFaces(this->Mesh, this->Stars, host);
  }
  if (!host.Proceed(done))
  {
    return false;
  }
  this->Distance = MeanAdjacentDistance(this->EdgeAdjacent, this->Geometry.Centroids, host);
  this->Unit = this->ScaleUnit(host);
  if (this->Settings.Argument == NormalArgument::SiteCurvature)
  {
    this->Curvatures =
      FaceCurvatures(this->Mesh, this->Stars, this->Boundary, this->Geometry, host);
  }
  if (!host.Proceed(done))
  {
    return false;
  }
  if (normals.empty())
  {
    normals.swap(this->Geometry.Normals);
  }
  Release(this->Geometry.Normals);
  if (first)
  {
    this->Report.MeanCentroidDistance = this->Distance;
    this->ChooseScale(normals);
  }
  if (!this->KeepsAdjacency())
  {
    this->EdgeAdjacent = NeighborGraph();
  }
  if (this->Settings.NormalIterations > 0 &&
    (first || (IsBall(this->Settings.Neighborhood) && this->Settings.RenewNeighborhood)))
  {
    this->FindNeighbors(host);
  }
  return host.Proceed(done);
}

/// Scales of curvatures are given times this length.
double FaceFilter::ScaleUnit(Execution& execution) const
{
  double unit = 1.0;
  if (IsCurvature(this->Settings.Argument))
  {
    unit = this->Settings.Unit == CurvatureUnit::EdgeLength
      ? TakeEdgeCensus(this->Mesh, this->Stars, execution).MeanEdgeLength
      : this->Distance;
  }
  return unit > 0.0 ? unit : 1.0;
}

void FaceFilter::ChooseScale(const Buffer<Vec3>& normals)
{
  const FaceFilterSettings& settings = this->Settings;
  if (settings.NormScale > 0.0)
  {
    this->Report.NormScale = settings.NormScale;
    return;
  }
  Buffer<double> values = this->Curvatures;
  if (values.empty())
  {
    values = AdjacentDifferences(this->EdgeAdjacent, normals, this->Geometry.Centroids,
      settings.Argument, 1e-12 * this->EdgeLength);
  }
  const double sigma = RobustScale(values, settings.Estimator) * this->Unit;
  this->Report.NoNoiseFound = sigma < 1e-6;
  this->Report.NormScale = ScaleForOutlierBoundary(settings.Norm, sigma);
}

void FaceFilter::FindNeighbors(Execution& execution)
{
  const FaceFilterSettings& settings = this->Settings;
  const FaceNeighborhood wanted = settings.Neighborhood;
  const bool patches = settings.Guidance == NormalGuidance::Patch;
  if (this->VertexSharing.NumberOfRows() == 0 &&
    (patches || wanted == FaceNeighborhood::VertexSharing || wanted == FaceNeighborhood::Radius))
  {
    this->VertexSharing = VertexSharingFaces(this->Mesh, this->Stars, execution);
  }
  if (patches && !this->Patches)
  {
    this->Patches = std::make_unique<PatchGuidance>(this->Mesh, this->EdgeAdjacent,
      this->VertexSharing, execution);
  }
  if (IsBall(wanted))
  {
    this->Ball = FacesWithinRadius(wanted == FaceNeighborhood::Radius ? this->VertexSharing
                                                                      : this->EdgeAdjacent,
      this->Geometry.Centroids, settings.Radius * this->Distance, LargestBall, execution);
  }
}

bool FaceFilter::KeepsAdjacency() const
{
  return this->Settings.Neighborhood == FaceNeighborhood::EdgeAdjacent ||
    this->Settings.Neighborhood == FaceNeighborhood::EdgeRadius ||
    this->Settings.Guidance == NormalGuidance::Patch || this->Settings.LocalSpatialScale;
}

const NeighborGraph& FaceFilter::Graph() const
{
  return IsBall(this->Settings.Neighborhood)                        ? this->Ball
    : this->Settings.Neighborhood == FaceNeighborhood::EdgeAdjacent ? this->EdgeAdjacent
                                                                    : this->VertexSharing;
}

void FaceFilter::SetGeometry(NormalFilter& filter, Execution& execution)
{
  const FaceFilterSettings& settings = this->Settings;
  const NeighborGraph& graph = filter.Neighbors();
  const Buffer<Vec3>& centroids = this->Geometry.Centroids;
  const double shortest = 1e-12 * this->EdgeLength;
  SiteGeometry geometry{ centroids, this->Geometry.Areas, shortest };

  Buffer<double> widths;
  if (settings.LocalSpatialScale && settings.SpatialScale > 0.0)
  {
    widths = MeanAdjacentDistances(this->EdgeAdjacent, centroids, execution);
    for (double& width : widths)
    {
      width = settings.SpatialScale * (width > shortest ? width : this->Distance);
    }
    geometry.SpatialSigmas = this->Distance > 0.0 ? &widths : nullptr;
  }
  Buffer<double> couplings;
  if (settings.Weighting == SiteWeight::Coupling)
  {
    couplings = SharedEdgeLengths(this->Mesh, graph, execution);
    execution.For(graph.NumberOfRows(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          for (std::uint64_t p = graph.Offsets[i]; p < graph.Offsets[i + 1]; ++p)
          {
            const double distance = (centroids[i] - centroids[graph.Ids[p]]).norm();
            couplings[p] = distance > shortest ? couplings[p] / distance : 0.0;
          }
        }
      });
    geometry.Couplings = &couplings;
  }
  geometry.Curvatures = &this->Curvatures;
  filter.SetGeometry(geometry, execution);
}

bool FaceFilter::Iterate(const NormalFilter& filter, const Buffer<Vec3>& normals,
  const Buffer<Vec3>& original, Buffer<Vec3>& filtered, Execution& execution, double first,
  double last)
{
  const FaceFilterSettings& settings = this->Settings;
  const NeighborGraph& graph = filter.Neighbors();
  std::size_t& kept = this->Report.UnfilteredFaces;
  const Buffer<Vec3>& data = settings.Data == NormalData::Original ? original : normals;
  const Buffer<Vec3>* centre = &normals;
  const Buffer<Vec3>* compared = &data;
  if (settings.Guidance == NormalGuidance::Patch)
  {
    this->Patches->Compute(normals, this->Geometry.Areas, this->Guide, execution);
    centre = compared = &this->Guide;
  }
  else if (settings.Guidance == NormalGuidance::Median)
  {
    DirectionalMedians(graph, normals, this->Guide, execution);
    centre = &this->Guide;
  }
  const NormalFilter::Fields fields{ normals, *centre, *compared, data };
  switch (settings.Operator)
  {
    case NormalOperator::Average:
    case NormalOperator::Diffusion:
      kept = filter.Sweep(fields, filtered, execution);
      break;
    case NormalOperator::GlobalSolve:
      return SolveForNormals(filter, fields, this->Geometry.Areas, settings.Global, filtered, kept,
        this->Report.SolverIterations, execution, first, last);
    case NormalOperator::Median:
      kept = 0;
      if (settings.Median == MedianKind::Directional)
      {
        DirectionalMedians(graph, normals, filtered, execution);
      }
      else
      {
        kept =
          AngularMedians(graph, this->Mesh, settings.Repetitions, normals, filtered, execution);
      }
      break;
    case NormalOperator::VotingTensor:
      kept = VoteOnNormals(filter, fields, this->Geometry.Centroids, settings.Tensor, filtered,
        execution);
      break;
  }
  return true;
}

bool FaceFilter::Run(Buffer<Vec3>& normals, const Verdict& enough, Execution& execution,
  double first, double last)
{
  const FaceFilterSettings& settings = this->Settings;
  NormalFilterSettings weights;
  weights.Norm = MakeErrorNorm(settings.Norm, this->Report.NormScale / this->Unit);
  weights.Argument = settings.Argument;
  weights.SpatialSigma = settings.SpatialScale * this->Distance;
  weights.Weighting = settings.Weighting;
  weights.IncludeOwn = settings.IncludeOwn;
  weights.Step =
    settings.Operator == NormalOperator::Diffusion ? NormalStep::Diffusion : NormalStep::Average;
  weights.StepLength = settings.StepLength;
  weights.TangentialFlux = settings.TangentialFlux;
  NormalFilter filter(this->Graph(), weights);
  if (settings.Operator != NormalOperator::Median)
  {
    Loops loops(this->IsLarge(), execution, first, first);
    this->SetGeometry(filter, loops.Host);
    if (!loops.Host.Proceed(first))
    {
      return false;
    }
  }
  if (settings.Operator != NormalOperator::VotingTensor)
  {
    Release(this->Geometry.Centroids);
  }

  const Buffer<Vec3> original = settings.Data == NormalData::Original ? normals : Buffer<Vec3>();
  Buffer<Vec3> filtered(normals.size());
  const double share = (last - first) / settings.NormalIterations;
  for (int iteration = 0; iteration < settings.NormalIterations; ++iteration)
  {
    const double begin = first + share * iteration;
    const double end = begin + share;
    // The solver asks by itself.
    Loops loops(this->IsLarge() && settings.Operator != NormalOperator::GlobalSolve, execution,
      begin, end);
    if (!this->Iterate(filter, normals, original, filtered, loops.Host, begin, end) ||
      !loops.Host.Proceed(end))
    {
      return false;
    }
    normals.swap(filtered);
    ++this->Report.NormalIterations;
    if (enough && enough(normals))
    {
      break;
    }
  }
  return true;
}

}
