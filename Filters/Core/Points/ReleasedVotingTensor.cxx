// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReleasedVotingTensor.h"

#include "PlaneFit.h"
#include "PointNeighbors.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// Determinants are taken to be nothing below this, whatever the size of the model.
constexpr double Nothing = 1e-10;

double MeanDistance(const Buffer<Vec3>& points, const NeighborGraph& nearest)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    double distances = 0.0;
    for (const Index j : nearest.Row(i))
    {
      distances += (points[j] - points[i]).norm();
    }
    sum += distances / std::max<std::size_t>(1, nearest.Row(i).size());
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

class Program
{
public:
  Program(const ReleasedVotingTensorSettings& settings, ReleasedVotingTensorReport& report,
    Buffer<Vec3>& positions, Buffer<Vec3>& normals)
    : Settings(settings)
    , Report(report)
    , Positions(positions)
    , Normals(normals)
    , Start(positions)
  {
  }

  bool Run(Execution& execution)
  {
    const std::size_t count =
      static_cast<std::size_t>(std::max(1, this->Settings.NumberOfNeighbors));
    const NeighborGraph nearest = NearestPoints(this->Positions, count, execution);
    this->Report.Spacing = MeanDistance(this->Positions, nearest);
    if (this->Normals.empty())
    {
      this->Normals = ReleasedStartNormals(this->Positions, nearest, execution);
    }
    this->Neighbors =
      PointsWithinRadius(this->Positions, 5.0 * this->Report.Spacing, NoIndex, execution);
    this->Report.Classes.assign(this->Positions.size(), FeatureClass::Flat);

    const int iterations = this->Settings.Iterations;
    Buffer<Vec3> filtered(this->Positions.size(), Vec3(0.0, 0.0, 0.0));
    for (int iteration = 0; iteration < iterations; ++iteration)
    {
      const double first = 0.1 + 0.9 * iteration / iterations;
      if (!execution.Proceed(first))
      {
        return false;
      }
      this->FilterNormals(filtered, execution);
      this->Normals = filtered;
      if (!this->MovePoints(execution, first))
      {
        return false;
      }
    }
    return execution.Proceed(1.0);
  }

private:
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

  bool MovePoints(Execution& execution, double fraction)
  {
    constexpr std::size_t pointsBetweenQuestions = 16384;
    this->Report.Rejected = 0;
    for (std::size_t i = 0; i < this->Positions.size(); ++i)
    {
      if (i % pointsBetweenQuestions == 0 && !execution.Proceed(fraction))
      {
        return false;
      }
      this->Move(i);
    }
    return true;
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
    FeatureClass& kind = this->Report.Classes[i];
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
    if ((place - this->Start[i]).squaredNorm() < limit * limit)
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
  Buffer<Vec3>& Positions;
  Buffer<Vec3>& Normals;
  Buffer<Vec3> Start;
  NeighborGraph Neighbors;
};

}

bool DenoiseAsReleased(Buffer<Vec3>& positions, Buffer<Vec3>& normals,
  const ReleasedVotingTensorSettings& settings, ReleasedVotingTensorReport& report,
  Execution& execution)
{
  return Program(settings, report, positions, normals).Run(execution);
}

}
