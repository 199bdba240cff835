// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReleasedVotingTensor.h"

#include "InputNeighbors.h"
#include "InterruptedLoops.h"
#include "PlaneFit.h"
#include "SpatialOrder.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// Determinants are taken to be nothing below this, whatever the size of the model.
constexpr double Nothing = 1e-10;

double MeanDistance(const Buffer<Vec3>& points, const NeighborGraph& nearest, Execution& execution)
{
  Buffer<double> means(points.size());
  execution.For(points.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        double distances = 0.0;
        for (const Index j : nearest.Row(i))
        {
          distances += (points[j] - points[i]).norm();
        }
        means[i] = distances / std::max<std::size_t>(1, nearest.Row(i).size());
      }
    });
  double sum = 0.0;
  for (const double mean : means)
  {
    sum += mean;
  }
  return points.empty() ? 0.0 : sum / static_cast<double>(points.size());
}

/// a^-1 b by the adjugate; b if a is singular.
Vec3 Solve(const Mat3& a, const Vec3& b)
{
  const Vec3 x = a.col(1).cross(a.col(2));
  const double determinant = a.col(0).dot(x);
  if (std::abs(determinant) < Nothing)
  {
    return b;
  }
  const Vec3 y = a.col(2).cross(a.col(0));
  const Vec3 z = a.col(0).cross(a.col(1));
  return Vec3(x.dot(b), y.dot(b), z.dot(b)) / determinant;
}

/// Points are held along a curve through space: those of neighbours are near in memory as well.
class Program
{
public:
  Program(const ReleasedVotingTensorSettings& settings, ReleasedVotingTensorReport& report)
    : Settings(settings)
    , Report(report)
  {
  }

  bool Run(Buffer<Vec3>& positions, Buffer<Vec3>& normals, Execution& execution)
  {
    if (!this->SetUp(positions, normals, execution))
    {
      return false;
    }
    const int iterations = this->Settings.Iterations;
    Buffer<Vec3> filtered(this->Positions.size(), Vec3(0.0, 0.0, 0.0));
    for (int iteration = 0; iteration < iterations; ++iteration)
    {
      const double share = 0.9 / iterations;
      const double first = 0.1 + share * iteration;
      InterruptedExecution interrupted(execution, first, first + 0.5 * share);
      this->FilterNormals(filtered, interrupted);
      if (!interrupted.Proceed(first))
      {
        return false;
      }
      this->Normals = filtered;
      if (!this->MovePoints(execution, first + 0.5 * share))
      {
        return false;
      }
    }
    if (!execution.Proceed(1.0))
    {
      return false;
    }
    Scatter(this->Positions, this->Points.Numbers, positions);
    Scatter(this->Normals, this->Points.Numbers, normals);
    Scatter(this->Classes, this->Points.Numbers, this->Report.Classes);
    return true;
  }

private:
  bool SetUp(const Buffer<Vec3>& positions, const Buffer<Vec3>& given, Execution& execution)
  {
    this->Points = OrderedPoints(positions, execution);
    if (!execution.Proceed(0.0))
    {
      return false;
    }
    InterruptedExecution interrupted(execution, 0.0, 0.02);
    const std::size_t count =
      static_cast<std::size_t>(std::max(1, this->Settings.NumberOfNeighbors));
    const NeighborGraph nearest = NearestOfInput(this->Points, count, interrupted);
    if (!interrupted.Proceed(0.02))
    {
      return false;
    }
    InterruptedExecution distances(execution, 0.02);
    this->Report.Spacing = MeanDistance(positions, nearest, distances);
    if (!distances.Proceed(0.02))
    {
      return false;
    }
    Buffer<Vec3> fitted;
    if (given.empty() && !ReleasedStartNormals(positions, nearest, fitted, execution, 0.02, 0.05))
    {
      return false;
    }
    InterruptedExecution gathering(execution, 0.05);
    this->Normals = Gather(given.empty() ? fitted : given, this->Points.Numbers, gathering);
    if (!gathering.Proceed(0.05))
    {
      return false;
    }
    InterruptedExecution balls(execution, 0.05, 0.1);
    this->Neighbors = BallsOfInput(this->Points, 5.0 * this->Report.Spacing, balls);
    this->Positions = this->Points.Positions;
    this->Classes.assign(positions.size(), FeatureClass::Flat);
    return balls.Proceed(0.1);
  }

  void FilterNormals(Buffer<Vec3>& filtered, Execution& execution) const
  {
    const Buffer<Vec3>& normals = this->Normals;
    execution.For(normals.size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          const Vec3& n = normals[i];
          Mat3 tensor = Mat3::Zero();
          double count = 0.0;
          for (const Index j : this->Neighbors.Row(i))
          {
            if (n.dot(normals[j]) > this->Settings.Similarity)
            {
              tensor += normals[j] * normals[j].transpose();
              count += 1.0;
            }
          }
          if (count > 0.0)
          {
            const Eigensystem system = Decompose(tensor / count);
            Vec3 sum = this->Settings.Damping * n;
            for (int k = 0; k < 3; ++k)
            {
              if (k == 2 || !(system.Values[k] < this->Settings.EigenvalueThreshold))
              {
                const Vec3 e = system.Vectors.col(k);
                sum += e.dot(n) * e;
              }
            }
            filtered[i] = sum.normalized();
          }
        }
      });
  }

  /// In the order of the input, which may lead through all of the memory.
  bool MovePoints(Execution& execution, double fraction)
  {
    this->Report.Rejected = 0;
    return ForInOrder(
      this->Positions.size(), [&](std::size_t number) { this->Move(this->Points.Places[number]); },
      execution, fraction, 4096);
  }

  void Move(std::size_t i)
  {
    const double tau = this->Settings.EigenvalueThreshold;
    const Vec3 p = this->Positions[i];
    PlaneSum similar;
    similar.Add(Vec3(0.0, 0.0, 0.0));
    for (const Index j : this->Neighbors.Row(i))
    {
      if (this->Normals[i].dot(this->Normals[j]) > this->Settings.Similarity)
      {
        similar.Add(this->Positions[j] - p);
      }
    }
    const Plane plane = similar.FitAxes();
    const Vec3 values = plane.Variances / plane.Variances.norm();
    if (!values.allFinite())
    {
      return; // nothing similar, or all at one place
    }
    FeatureClass& kind = this->Classes[i];
    Vec3 place;
    if (values[0] < tau && values[1] < tau && values[2] > tau)
    {
      kind = FeatureClass::Edge;
      const Vec3& e = plane.Along;
      place = this->SolveQuadric(i, e, e * e.transpose());
    }
    else if (values[0] < tau && values[1] > tau && values[2] > tau)
    {
      kind = FeatureClass::Flat;
      place = this->Smoothed(i);
    }
    else
    {
      kind = FeatureClass::Corner;
      place = this->SolveQuadric(i, Vec3(0.0, 0.0, 0.0), Mat3::Zero());
    }
    const double limit = this->Settings.Limit * this->Report.Spacing;
    if ((place - this->Points.Positions[i]).squaredNorm() < limit * limit)
    {
      this->Positions[i] = place;
    }
    else
    {
      ++this->Report.Rejected;
    }
  }

  /// Where the planes of all neighbours meet, seen along e.
  Vec3 SolveQuadric(std::size_t i, const Vec3& e, Mat3 a) const
  {
    const Vec3& p = this->Positions[i];
    Vec3 b = a * p;
    for (const Index j : this->Neighbors.Row(i))
    {
      const Vec3& n = this->Normals[j];
      const Vec3& q = this->Positions[j];
      const Vec3 m = n - e.dot(n) * e;
      a += m * m.transpose();
      b += m.dot(q) * m; // the part of q along e adds nothing
    }
    return Solve(a, b);
  }

  Vec3 Smoothed(std::size_t i) const
  {
    const double r = 2.0 * this->Report.Spacing;
    const Vec3& p = this->Positions[i];
    const Vec3& n = this->Normals[i];
    double heights = 0.0;
    double total = 0.0;
    for (const Index j : this->Neighbors.Row(i))
    {
      const Vec3 e = this->Positions[j] - p;
      const double weight = std::exp(-8.0 * (n - this->Normals[j]).squaredNorm() / (r * r)) *
        std::exp(-4.0 * e.squaredNorm() / (r * r));
      heights += weight * n.dot(e);
      total += weight;
    }
    return p +
      this->Settings.Step * heights / total * n; // not a number, thus rejected, without weight
  }

  const ReleasedVotingTensorSettings& Settings;
  ReleasedVotingTensorReport& Report;
  OrderedPoints Points; ///< before the first step
  Buffer<Vec3> Positions;
  Buffer<Vec3> Normals;
  Buffer<FeatureClass> Classes;
  NeighborGraph Neighbors;
};

}

bool DenoiseAsReleased(Buffer<Vec3>& positions, Buffer<Vec3>& normals,
  const ReleasedVotingTensorSettings& settings, ReleasedVotingTensorReport& report,
  Execution& execution)
{
  return Program(settings, report).Run(positions, normals, execution);
}

}
