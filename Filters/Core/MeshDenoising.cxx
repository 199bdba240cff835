// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshDenoising.h"

#include "Stopwatch.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// Root mean square angle between normals, in radians: sqrt(2) times the deviation per axis that
/// the median tells if the differences are 2D Gaussian vectors.
double RobustAngle(const Buffer<Vec3>& a, const Buffer<Vec3>& b)
{
  Buffer<double> angles(a.size());
  for (std::size_t f = 0; f < a.size(); ++f)
  {
    angles[f] = 2.0 * std::asin(std::min(1.0, 0.5 * (a[f] - b[f]).norm()));
  }
  return std::sqrt(2.0) * RobustScale(angles, ScaleEstimator::Rayleigh);
}

/// The stages in turn. Returns false if the execution asked to stop.
bool Alternate(PreparedMesh& prepared, Buffer<Vec3>& normals, const MeshDenoisingSettings& settings,
  MeshDenoisingReport& report, Execution& execution)
{
  TriangleMesh& mesh = prepared.Mesh();
  const EdgeCensus& edges = prepared.Edges();
  const double edgeLength = report.MeanEdgeLength;
  FaceFilter filter(mesh, prepared.Stars(), edges.BoundaryVertex, edgeLength, settings, report);
  VertexUpdateSettings vertexSettings = settings.Vertices;
  vertexSettings.MaximumDisplacement *= edgeLength;
  VertexUpdate update(mesh, prepared.Stars(), edges.BoundaryVertex, edgeLength, vertexSettings);

  Buffer<Vec3> start;
  bool enough = false;
  const FaceFilter::Verdict verdict = [&](const Buffer<Vec3>& now)
  {
    enough = settings.Residual > 0.0 && RobustAngle(now, start) >= settings.Residual;
    return enough;
  };
  const double share = 0.97 / std::max(1, settings.OuterIterations);
  // A vertex step costs about a quarter of a normal step.
  const double normalShare = share * 4.0 * settings.NormalIterations /
    std::max(1.0, 4.0 * settings.NormalIterations + settings.VertexIterations);
  for (int outer = 0; outer < settings.OuterIterations && !enough; ++outer)
  {
    const double first = 0.03 + outer * share;
    {
      const Stopwatch stopwatch(report.SetupSeconds);
      if (!filter.Renew(normals, execution, first))
      {
        return false;
      }
    }
    if (outer == 0 && settings.Residual > 0.0)
    {
      start = normals;
    }
    if (report.NoNoiseFound)
    {
      return true;
    }
    if (settings.NormalIterations > 0)
    {
      const Stopwatch stopwatch(report.NormalSeconds);
      if (!filter.Run(normals, verdict, execution, first, first + normalShare))
      {
        return false;
      }
    }
    if (settings.VertexIterations > 0)
    {
      const Stopwatch stopwatch(report.VertexSeconds);
      if (!update.Run(mesh.Positions, normals, settings.VertexIterations, execution,
            first + normalShare, first + share))
      {
        return false;
      }
    }
    ++report.OuterIterations;
    if (settings.VertexIterations > 0 && outer + 1 < settings.OuterIterations && !enough)
    {
      normals.clear(); // the next iteration starts from those of the faces, which have moved
    }
  }
  if (settings.OuterIterations < 1 && !filter.Renew(normals, execution, 0.03))
  {
    return false;
  }
  report.GuardedVertices = update.NumberOfGuardedVertices();
  report.VertexIterations = update.NumberOfSteps();
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
    if (normals.size() != mesh.NumberOfFaces())
    {
      normals.clear();
    }
    if (!normals.empty())
    {
      prepared.Enter(normals);
    }
  }
  if (!Alternate(prepared, normals, settings, report, execution))
  {
    return false;
  }
  prepared.Leave(normals);
  prepared.Finish();
  return execution.Proceed(1.0);
}

}
