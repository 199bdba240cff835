// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MovingRobustPCA.h"

#include "InterruptedExecution.h"
#include "PointUpdate.h"
#include "RobustScale.h"
#include "RowPlanes.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// What a patch tells about its members.
struct Patch
{
  Vec3 Normal;   ///< zero if there is no plane
  double Offset; ///< of the plane from the point along the normal
  double Limit;  ///< of the residuals of members that are trusted
  bool Uniform;  ///< all members count the same

  /// Of a member, given relative to the point.
  double ResidualOf(const Vec3& p) const { return this->Normal.dot(p) - this->Offset; }
};

class MovingRobustPCA : public PointOperator
{
public:
  explicit MovingRobustPCA(const MovingRobustPCASettings& settings)
    : Settings(settings)
  {
  }

  void Renew(PointSet& points, Execution&) override
  {
    this->Containing = Transpose(points.Neighbors, points.Size());
  }

  bool Run(PointSet& points, Execution& execution, double first, double last) override
  {
    const double middle = first + 0.9 * (last - first);
    InterruptedExecution fitting(execution, first, middle);
    this->FitPatches(points, fitting);
    if (!fitting.Proceed(middle))
    {
      return false;
    }
    InterruptedExecution averaging(execution, middle, last);
    Buffer<Vec3> places;
    this->Average(points, places, averaging);
    if (!averaging.Proceed(last))
    {
      return false;
    }
    MoveTo(places, points, execution);
    this->TakeNormals(points, execution);
    return true;
  }

private:
  /// Calls use(i, weights) with the w_ij of the rows of a graph, the point itself first.
  template <typename Use>
  void VisitRows(const PointSet& points, const NeighborGraph& graph, Execution& execution, Use use)
  {
    NormalFilter filter(graph, WeightsBySimilarNormals(this->Settings.NormalAngle));
    const Buffer<double> noAreas;
    filter.SetGeometry({ points.Positions, noAreas, 0.0 }, execution);
    const Buffer<Vec3>& normals = points.Normals;
    filter.VisitWeights({ normals, normals, normals, normals }, execution, use);
  }

  void FitPatches(const PointSet& points, Execution& execution)
  {
    this->Patches.resize(points.Size());
    this->VisitRows(points, points.Neighbors, execution,
      [&](std::size_t i, const double* weights)
      {
        static thread_local WeightedPatch members;
        static thread_local Buffer<double> residuals;
        members.Take(points.Positions, i, points.Neighbors.Row(i), weights);
        const double epsilon = this->Settings.Regularization * points.SpacingAt(i);
        const Plane plane =
          FitRobustPlane(members.Points, members.Weights, { epsilon, this->Settings.Rounds });
        Patch& patch = this->Patches[i];
        patch.Normal = plane.Normal;
        patch.Offset = plane.Normal.dot(plane.Centre);
        patch.Uniform = members.Uniform;
        residuals.clear();
        for (const Vec3& p : members.Points)
        {
          residuals.push_back(patch.ResidualOf(p));
        }
        patch.Limit = TrustLimit(residuals, epsilon);
      });
  }

  /// Weights are symmetric, so that those of the patches that contain a point are a row as well.
  void Average(const PointSet& points, Buffer<Vec3>& places, Execution& execution)
  {
    const Buffer<Vec3>& positions = points.Positions;
    places.resize(points.Size());
    this->VisitRows(points, this->Containing, execution,
      [&](std::size_t j, const double* weights)
      {
        Vec3 move(0.0, 0.0, 0.0);
        double total = 0.0;
        auto add = [&](std::size_t i, double weight)
        {
          const Patch& patch = this->Patches[i];
          const double residual = patch.ResidualOf(positions[j] - positions[i]);
          if (!patch.Normal.isZero(0.0) && std::abs(residual) <= patch.Limit)
          {
            const double trust = patch.Uniform ? 1.0 : weight;
            move -= trust * residual * patch.Normal;
            total += trust;
          }
        };
        add(j, *weights++);
        for (const Index i : this->Containing.Row(j))
        {
          add(i, *weights++);
        }
        const Patch& own = this->Patches[j];
        places[j] = positions[j];
        if (own.Normal.isZero(0.0))
        {
          return;
        }
        places[j] += total > NormalFilter::NoWeight
          ? Vec3(move / (std::max(0.0, this->Settings.Fidelity) + total))
          : Vec3(own.Offset * own.Normal);
      });
  }

  void TakeNormals(PointSet& points, Execution& execution)
  {
    execution.For(points.Size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          const Vec3& normal = this->Patches[i].Normal;
          Vec3& n = points.Normals[i];
          if (normal.isZero(0.0))
          {
            points.Status[i] = PointStatus::Kept;
          }
          else
          {
            n = normal.dot(n) < 0.0 ? Vec3(-normal) : normal;
          }
        }
      });
  }

  MovingRobustPCASettings Settings;
  NeighborGraph Containing; ///< the patches that every point is a neighbour in
  Buffer<Patch> Patches;
};

}

double TrustLimit(Buffer<double>& residuals, double epsilon)
{
  for (double& residual : residuals)
  {
    residual = std::abs(residual);
  }
  return std::max(3.0 * MadConsistency * Median(residuals), epsilon);
}

std::unique_ptr<PointOperator> MakeMovingRobustPCA(const MovingRobustPCASettings& settings)
{
  return std::make_unique<MovingRobustPCA>(settings);
}

}
