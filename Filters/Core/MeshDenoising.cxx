// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshDenoising.h"

#include <chrono>

namespace SurfaceDenoising
{

namespace
{

/// Adds the seconds of its life to a sum.
class Stopwatch
{
public:
  explicit Stopwatch(double& seconds)
    : Seconds(seconds)
    , Start(std::chrono::steady_clock::now())
  {
  }
  ~Stopwatch()
  {
    const std::chrono::duration<double> life = std::chrono::steady_clock::now() - this->Start;
    this->Seconds += life.count();
  }
  Stopwatch(const Stopwatch&) = delete;
  void operator=(const Stopwatch&) = delete;

private:
  double& Seconds;
  std::chrono::steady_clock::time_point Start;
};

/// x_ij over all pairs of edge-adjacent faces that have normals, each pair once. Centroids closer
/// than shortest belong to one face that was stored twice.
Buffer<double> AdjacentDifferences(const TriangleMesh& mesh, const CompressedRows& stars,
  const FaceGeometry& geometry, NormalArgument argument, double shortest)
{
  Buffer<double> differences;
  differences.reserve(mesh.NumberOfFaces() * 3 / 2);
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    VisitEdgeAdjacentFaces(mesh, stars, f,
      [&](Index g)
      {
        const double distance = (geometry.Centroids[f] - geometry.Centroids[g]).norm();
        if (g > f && geometry.Areas[f] > 0.0 && geometry.Areas[g] > 0.0 && distance > shortest)
        {
          const Vec3& m = geometry.Normals[f];
          const Vec3& n = geometry.Normals[g];
          const double angle = std::atan2(m.cross(n).norm(), m.dot(n));
          differences.push_back(argument == NormalArgument::Chord
              ? (m - n).norm()
              : (argument == NormalArgument::Angle ? angle : angle / distance));
        }
      });
  }
  return differences;
}

/// The work on one mesh, stage by stage.
class Denoiser
{
public:
  Denoiser(PreparedMesh& prepared, const MeshDenoisingSettings& settings,
    MeshDenoisingReport& report, Execution& execution)
    : Mesh(prepared.Mesh())
    , Stars(prepared.Stars())
    , Edges(prepared.Edges())
    , Settings(settings)
    , Report(report)
    , Exec(execution)
  {
  }

  bool Run(Buffer<Vec3>& normals);

private:
  double ScaleUnit() const;
  void ChooseScale();
  void BuildGraph();
  bool FilterNormals(Buffer<Vec3>& normals, double first, double last);

  TriangleMesh& Mesh;
  const CompressedRows& Stars;
  const EdgeCensus& Edges;
  const MeshDenoisingSettings& Settings;
  MeshDenoisingReport& Report;
  Execution& Exec;

  FaceGeometry Geometry;
  NeighborGraph Graph;
  double Distance = 0.0; ///< d of the present positions
};

/// Scales of curvatures are given per d.
double Denoiser::ScaleUnit() const
{
  const bool curvature = this->Settings.Argument == NormalArgument::DirectionalCurvature;
  return curvature && this->Distance > 0.0 ? this->Distance : 1.0;
}

void Denoiser::ChooseScale()
{
  const MeshDenoisingSettings& settings = this->Settings;
  if (settings.NormScale > 0.0)
  {
    this->Report.NormScale = settings.NormScale;
    return;
  }
  Buffer<double> differences = AdjacentDifferences(this->Mesh, this->Stars, this->Geometry,
    settings.Argument, 1e-12 * this->Report.MeanEdgeLength);
  const double sigma = RobustScale(differences, settings.Estimator) * this->ScaleUnit();
  this->Report.NoNoiseFound = sigma < 1e-6;
  this->Report.NormScale = ScaleForOutlierBoundary(settings.Norm, sigma);
}

void Denoiser::BuildGraph()
{
  switch (this->Settings.Neighborhood)
  {
    case FaceNeighborhood::EdgeAdjacent:
      this->Graph = EdgeAdjacentFaces(this->Mesh, this->Stars, this->Exec);
      break;
    case FaceNeighborhood::VertexSharing:
      this->Graph = VertexSharingFaces(this->Mesh, this->Stars, this->Exec);
      break;
    case FaceNeighborhood::Radius:
      this->Graph = FacesWithinRadius(VertexSharingFaces(this->Mesh, this->Stars, this->Exec),
        this->Geometry.Centroids, this->Settings.Radius * this->Distance, this->Exec);
      break;
  }
}

bool Denoiser::FilterNormals(Buffer<Vec3>& normals, double first, double last)
{
  const MeshDenoisingSettings& settings = this->Settings;
  NormalFilterSettings filterSettings;
  filterSettings.Norm = MakeErrorNorm(settings.Norm, this->Report.NormScale / this->ScaleUnit());
  filterSettings.Argument = settings.Argument;
  filterSettings.SpatialSigma = settings.SpatialScale * this->Distance;
  filterSettings.AreaWeighted = settings.AreaWeighted;
  filterSettings.IncludeOwn = settings.IncludeOwn;
  NormalFilter filter(this->Graph, filterSettings);
  filter.SetGeometry(this->Geometry.Centroids, this->Geometry.Areas,
    1e-12 * this->Report.MeanEdgeLength, this->Exec);
  Release(this->Geometry.Centroids);

  const Buffer<Vec3> original = settings.Data == NormalData::Original ? normals : Buffer<Vec3>();
  Buffer<Vec3> filtered(normals.size());
  for (int iteration = 0; iteration < settings.NormalIterations; ++iteration)
  {
    if (!this->Exec.Proceed(first + (last - first) * iteration / settings.NormalIterations))
    {
      return false;
    }
    this->Report.UnfilteredFaces = settings.Data == NormalData::Original
      ? filter.Sweep({ normals, normals, original, original }, filtered, this->Exec)
      : filter.Sweep(normals, filtered, this->Exec);
    normals.swap(filtered);
  }
  return true;
}

bool Denoiser::Run(Buffer<Vec3>& normals)
{
  const MeshDenoisingSettings& settings = this->Settings;
  const std::size_t faces = this->Mesh.NumberOfFaces();
  bool given = faces > 0 && normals.size() == faces;

  VertexUpdateSettings vertexSettings = settings.Vertices;
  vertexSettings.MaximumDisplacement *= this->Report.MeanEdgeLength;
  VertexUpdate update(this->Mesh, this->Stars, this->Edges.BoundaryVertex,
    this->Report.MeanEdgeLength, vertexSettings);

  const double share = 0.97 / std::max(1, settings.OuterIterations);
  for (int outer = 0; outer < settings.OuterIterations; ++outer)
  {
    const double first = 0.03 + outer * share;
    // A vertex step costs about a quarter of a normal step.
    const double normalShare = share * 4.0 * settings.NormalIterations /
      std::max(1.0, 4.0 * settings.NormalIterations + settings.VertexIterations);
    {
      const Stopwatch stopwatch(this->Report.SetupSeconds);
      ComputeFaceGeometry(this->Mesh, this->Report.MeanEdgeLength, this->Geometry, this->Exec);
      this->Distance =
        MeanAdjacentDistance(this->Mesh, this->Stars, this->Geometry.Centroids, this->Exec);
      if (outer == 0)
      {
        this->Report.MeanCentroidDistance = this->Distance;
        this->ChooseScale();
      }
      if (!given)
      {
        normals.swap(this->Geometry.Normals);
      }
      Release(this->Geometry.Normals);
      given = false;
      if (settings.NormalIterations > 0 &&
        (outer == 0 || settings.Neighborhood == FaceNeighborhood::Radius))
      {
        this->BuildGraph();
      }
      if (!this->Exec.Proceed(first))
      {
        return false;
      }
    }
    if (settings.NormalIterations > 0 && !this->Report.NoNoiseFound)
    {
      const Stopwatch stopwatch(this->Report.NormalSeconds);
      if (!this->FilterNormals(normals, first, first + normalShare))
      {
        return false;
      }
    }
    if (settings.VertexIterations > 0 && !this->Report.NoNoiseFound)
    {
      const Stopwatch stopwatch(this->Report.VertexSeconds);
      if (!update.Run(this->Mesh.Positions, normals, settings.VertexIterations, this->Exec,
            first + normalShare, first + share))
      {
        return false;
      }
    }
  }
  if (settings.OuterIterations < 1 && !given)
  {
    ComputeFaceGeometry(this->Mesh, this->Report.MeanEdgeLength, this->Geometry, this->Exec);
    normals.swap(this->Geometry.Normals);
  }
  this->Report.GuardedVertices = update.NumberOfGuardedVertices();
  return true;
}

}

bool DenoiseMesh(TriangleMesh& mesh, Buffer<Vec3>& normals, const MeshDenoisingSettings& settings,
  MeshDenoisingReport& report, Execution& execution)
{
  PreparedMesh prepared(mesh);
  {
    const Stopwatch stopwatch(report.SetupSeconds);
    if (!prepared.Prepare(execution))
    {
      return false;
    }
    static_cast<MeshFacts&>(report) = prepared.Facts();
    if (!normals.empty())
    {
      prepared.Enter(normals);
    }
  }
  if (!Denoiser(prepared, settings, report, execution).Run(normals))
  {
    return false;
  }
  prepared.Leave(normals);
  prepared.Finish();
  return execution.Proceed(1.0);
}

}
