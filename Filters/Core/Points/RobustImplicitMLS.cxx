// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RobustImplicitMLS.h"

#include "BallTree.h"
#include "ImplicitSurface.h"
#include "InterruptedExecution.h"
#include "PointNeighbors.h"
#include "PointUpdate.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// 2 / sqrt(pi): rho_j = 2 r_k(j) / sqrt(k) is so many spacings.
constexpr double RhoOverSpacing = 1.1283791670955126;

/// A projection ends when |f| is below so many rho.
constexpr double Tolerance = 1e-4;

/**
 * Samples are looked up for places at most so many spacings away from the point, and again where
 * the projection goes further. The 16 nearest points are 2.3 spacings around: the margin adds a few
 * candidates wherever the point is, even beside a part that is a thousand times as dense.
 */
constexpr double Margin = 0.25;

class RobustImplicitMLS : public PointOperator
{
public:
  explicit RobustImplicitMLS(const RobustImplicitMLSSettings& settings)
    : Settings(settings)
  {
  }

  bool Run(PointSet& points, Execution& execution, double first, double last) override
  {
    Buffer<double> radii(points.Size());
    execution.For(points.Size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          radii[i] = IsSample(points, i)
            ? this->Settings.FilterScale * RhoOverSpacing * points.Spacings[i]
            : 0.0;
        }
      });
    const BallTree balls(points.Positions, radii, execution);
    Buffer<Vec3> places(points.Size());
    Buffer<Vec3> normals(points.Size());
    InterruptedExecution interrupted(execution, first, last);
    interrupted.For(
      points.Size(),
      [&](std::size_t begin, std::size_t end)
      {
        ImplicitSurface surface; // its memory serves all points of a stretch
        for (std::size_t i = begin; i < end; ++i)
        {
          places[i] = points.Positions[i];
          normals[i] = points.Normals[i];
          if (!this->Project(points, balls, radii, surface, places[i], normals[i], i))
          {
            points.Status[i] = PointStatus::Kept;
          }
        }
      },
      512);
    if (!interrupted.Proceed(last))
    {
      return false;
    }
    MoveTo(places, points, execution);
    TurnTo(normals, points, execution);
    return true;
  }

private:
  /**
   * False without a normal, and for a point that coincides with its 16 nearest ones: its own
   * spacing is 0, whatever stands in for it, and heaps of points at one place, where some devices
   * put what they did not see, would all have to look at one another.
   */
  static bool IsSample(const PointSet& points, std::size_t i)
  {
    const Span<Index> row = points.Neighbors.Row(i);
    const std::size_t count = std::min(row.size(), SpacingNeighbors);
    const bool heap = points.Spacings[i] == points.Spacing && count > 0 &&
      points.Positions[row[count - 1]] == points.Positions[i];
    return !heap && !points.Normals[i].isZero(0.0);
  }

  /// The samples that reach x or what is closer to it than margin, relative to point i.
  void Gather(const PointSet& points, const BallTree& balls, const Buffer<double>& radii,
    std::size_t i, const Vec3& x, double margin, ImplicitSurface& surface) const
  {
    const Vec3& origin = points.Positions[i];
    const Vec3& side = points.Normals[i];
    surface.Clear();
    balls.Visit(origin + x, margin,
      [&](Index j)
      {
        const Vec3& n = points.Normals[j];
        const bool turn = this->Settings.Unoriented && n.dot(side) < 0.0;
        surface.Add(points.Positions[j] - origin, turn ? Vec3(-n) : n, radii[j]);
      });
  }

  /// False if the point stays as it is.
  bool Project(const PointSet& points, const BallTree& balls, const Buffer<double>& radii,
    ImplicitSurface& surface, Vec3& place, Vec3& normal, std::size_t i) const
  {
    if (normal.isZero(0.0))
    {
      return false;
    }
    const double margin = Margin * points.Spacings[i];
    const double tolerance = Tolerance * RhoOverSpacing * points.Spacings[i];
    Vec3 x(0.0, 0.0, 0.0); // relative to the point
    Vec3 centre = x;       // of what was gathered
    this->Gather(points, balls, radii, i, x, margin, surface);
    for (int step = 0; step < this->Settings.MaximumProjections; ++step)
    {
      if ((x - centre).norm() > 0.999 * margin) // rounding is far below
      {
        centre = x;
        this->Gather(points, balls, radii, i, x, margin, surface);
      }
      const ImplicitValue at = surface.Evaluate(x, this->Settings);
      if (!(at.Weight > 0.0) || !at.Gradient.allFinite())
      {
        return false;
      }
      const double slope = at.Gradient.norm();
      normal = slope < 1e-8 ? normal : Vec3(at.Gradient / slope);
      x -= at.Value * normal;
      if (std::abs(at.Value) < tolerance)
      {
        break;
      }
    }
    place += x;
    return true;
  }

  RobustImplicitMLSSettings Settings;
};

}

std::unique_ptr<PointOperator> MakeRobustImplicitMLS(const RobustImplicitMLSSettings& settings)
{
  return std::make_unique<RobustImplicitMLS>(settings);
}

}
