// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeanCurvatureFlow.h"

#include "../ConjugateGradient.h"
#include "../Metrics.h"
#include "CotangentLaplacian.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// Of displacements, so that a position is right to a fraction of this of an edge length.
constexpr double Tolerance = 1e-10;

/// Far more than sensible time steps need; with others, a step ends on the way.
constexpr int MostIterations = 2000;

/// Least area of a vertex in squared mean edge lengths of the input. Without it, parts that have
/// collapsed have no definite place.
constexpr double SmallestMass = 1e-6;

/// A step that loses more volume than this restores makes no sense.
constexpr double LargestScaling = 2.0;

struct PositionSum
{
  Vec3 Sum = Vec3(0.0, 0.0, 0.0);
  std::size_t Count = 0;

  PositionSum& operator+=(const PositionSum& other)
  {
    this->Sum += other.Sum;
    this->Count += other.Count;
    return *this;
  }
};

class Flow
{
public:
  Flow(PreparedMesh& prepared, const MeanCurvatureFlowSettings& settings, Execution& execution)
    : Mesh(prepared.Mesh())
    , Stars(prepared.Stars())
    , Boundary(prepared.Edges().BoundaryVertex)
    , FixBoundary(settings.FixBoundary)
    , TimeStep(settings.TimeStep)
    , UnitArea(prepared.Facts().MeanEdgeLength * prepared.Facts().MeanEdgeLength)
    , Exec(execution)
    , Laplacian(this->Mesh, this->Stars, execution)
    , Masses(this->Mesh.NumberOfVertices())
    , Diagonal(this->Mesh.NumberOfVertices())
    , Rhs(this->Mesh.NumberOfVertices())
    , Displacement(this->Mesh.NumberOfVertices())
  {
  }

  /// Solves for the displacements, which are as exact far from the origin as close to it.
  ConjugateGradientResult Step(double first, double last)
  {
    const double dt = this->TimeStep;
    const std::size_t vertices = this->Mesh.NumberOfVertices();
    this->Laplacian.Update(this->Exec);
    this->Exec.For(vertices,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t v = begin; v < end; ++v)
        {
          const bool fixed = this->FixBoundary && this->Boundary[v];
          const double area =
            this->UnitArea > 0.0 ? this->Laplacian.Masses()[v] / this->UnitArea : 0.0;
          const double mass = std::max(area, SmallestMass);
          this->Masses[v] = mass;
          this->Diagonal[v] = fixed ? 0.0 : mass + dt * this->Laplacian.Diagonal()[v];
          this->Rhs[v] = -dt * this->Laplacian.Apply(this->Mesh.Positions, v);
          this->Displacement[v] = Vec3(0.0, 0.0, 0.0);
        }
      });
    auto multiply = [&](const Buffer<Vec3>& x, Buffer<Vec3>& product)
    {
      this->Exec.For(vertices,
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t v = begin; v < end; ++v)
          {
            product[v] = this->Masses[v] * x[v] + dt * this->Laplacian.Apply(x, v);
          }
        });
    };
    const ConjugateGradientResult result = SolveConjugateGradient(multiply, this->Diagonal,
      this->Rhs, this->Displacement, Tolerance, MostIterations, this->Exec, first, last);
    this->Exec.For(vertices,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t v = begin; v < end; ++v)
        {
          this->Mesh.Positions[v] += this->Displacement[v];
        }
      });
    return result;
  }

  /// Scales the surface about the mean of its vertices. Returns false if the volume is lost.
  bool Restore(double volume)
  {
    const double factor = std::cbrt(volume / SignedVolume(this->Mesh, this->Exec));
    if (!(factor > 0.0 && factor < LargestScaling))
    {
      return false;
    }
    const std::size_t vertices = this->Mesh.NumberOfVertices();
    auto used = [this](std::size_t v) { return this->Stars.Row(v).size() > 0; };
    const PositionSum sum = OrderedSum(this->Exec, vertices, PositionSum(),
      [&](std::size_t v) {
        return used(v) ? PositionSum{ this->Mesh.Positions[v], 1 } : PositionSum();
      });
    const Vec3 centre = sum.Sum / static_cast<double>(std::max<std::size_t>(1, sum.Count));
    this->Exec.For(vertices,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t v = begin; v < end; ++v)
        {
          if (used(v))
          {
            this->Mesh.Positions[v] = centre + factor * (this->Mesh.Positions[v] - centre);
          }
        }
      });
    return true;
  }

private:
  TriangleMesh& Mesh;
  const CompressedRows& Stars;
  const Buffer<unsigned char>& Boundary;
  bool FixBoundary;
  double TimeStep;
  /// Areas and times are relative to this, so that the solver, which squares both sides, has
  /// numbers of moderate size for models of any size.
  double UnitArea;
  Execution& Exec;
  CotangentLaplacian Laplacian;
  Buffer<double> Masses;
  Buffer<double> Diagonal; ///< 0: does not move
  Buffer<Vec3> Rhs;
  Buffer<Vec3> Displacement;
};

}

bool FlowByMeanCurvature(PreparedMesh& prepared, const MeanCurvatureFlowSettings& settings,
  MeanCurvatureFlowReport& report, Execution& execution)
{
  if (settings.Steps <= 0)
  {
    return true;
  }
  const TriangleMesh& mesh = prepared.Mesh();
  // The census of the preparation is older than the turns of faces.
  const bool restore =
    settings.RestoreVolume && IsClosed(TakeEdgeCensus(mesh, prepared.Stars(), execution));
  const double volume = restore ? SignedVolume(mesh, execution) : 0.0;
  report.VolumeRestored = restore;
  Flow flow(prepared, settings, execution);
  const double share = 0.97 / settings.Steps;
  for (int step = 0; step < settings.Steps; ++step)
  {
    const double first = 0.03 + step * share;
    const ConjugateGradientResult result = flow.Step(first, first + share);
    report.SolverIterations += result.Iterations;
    if (result.Stopped)
    {
      return false;
    }
    report.VolumeRestored = report.VolumeRestored && flow.Restore(volume);
  }
  return execution.Proceed(1.0);
}

}
