// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Automatic/CloudImpulses.h"

#include "Automatic/RobustQuadric.h"
#include "Automatic/SurfaceStep.h"
#include "Metrics.h"
#include "Points/PointNeighbors.h"
#include "Points/PointNormals.h"

#include <cmath>
#include <limits>

namespace SurfaceDenoising
{

namespace
{

constexpr std::size_t BesideCount = 6;
constexpr std::size_t NearbyCount = 20;
constexpr std::size_t NormalNeighbors = 16;
/// Planes that a height needs.
constexpr std::size_t LeastPlanes = 4;

/// How much farther points that were out of place must go than others would, on average.
constexpr double LeastGain = 2.5;

/// The height of a point over what is around it.
class Scorer
{
public:
  Scorer(const Buffer<Vec3>& points, const Buffer<Vec3>& normals,
    const Buffer<unsigned char>& marks)
    : Points(points)
    , Normals(normals)
    , Marks(marks)
  {
  }

  double HeightOf(std::size_t i, Span<Index> nearby)
  {
    this->Heights.clear();
    double scale = 0.0;
    Vec3 sum(0.0, 0.0, 0.0);
    for (const Index j : nearby)
    {
      if (!this->Marks[j] && !this->Normals[j].isZero(0.0))
      {
        const Vec3 offset = this->Points[j] - this->Points[i];
        this->Heights.push_back(std::abs(this->Normals[j].dot(offset)));
        scale += offset.norm();
        sum += this->Normals[j].dot(sum) < 0.0 ? Vec3(-this->Normals[j]) : this->Normals[j];
      }
    }
    if (this->Heights.size() < LeastPlanes || !(scale > 0.0))
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
    this->Quadric.Start(sum.normalized(), scale / double(this->Heights.size()));
    for (const Index j : nearby)
    {
      if (!this->Marks[j])
      {
        this->Quadric.Add(this->Points[j] - this->Points[i]);
      }
    }
    // fmin takes the other one if one is unknown.
    return std::fmin(Percentile(this->Heights, 0.15), std::abs(this->Quadric.Height()));
  }

private:
  const Buffer<Vec3>& Points;
  const Buffer<Vec3>& Normals;
  const Buffer<unsigned char>& Marks;
  Buffer<double> Heights;
  RobustQuadric Quadric;
};

/// Whether those that are marked are off the surface around them, where others beside them are not.
bool IsWorthMoving(const Buffer<Vec3>& points, const CompressedRows& nearest,
  const SpikeSites& sites, const Buffer<unsigned char>& marks, Execution& execution)
{
  constexpr double Nobody = -1.0; // neither marked nor beside one that is
  Buffer<double> steps(points.size(), Nobody);
  execution.For(
    points.size(),
    [&](std::size_t begin, std::size_t end)
    {
      SurfaceStep way;
      for (std::size_t i = begin; i < end; ++i)
      {
        const Span<Index> beside = sites.Beside.Row(i);
        if (!marks[i] &&
          std::none_of(beside.begin(), beside.end(), [&](Index j) { return marks[j]; }))
        {
          continue;
        }
        way.Start();
        for (const Index j : nearest.Row(i))
        {
          if (!marks[j] && !way.IsFull())
          {
            way.Add(points[j] - points[i]);
          }
        }
        Vec3 normal;
        steps[i] = way.Step(normal).norm();
      }
    },
    256);
  double sums[2] = { 0.0, 0.0 };
  std::size_t counts[2] = { 0, 0 };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (steps[i] != Nobody)
    {
      sums[marks[i]] += steps[i];
      ++counts[marks[i]];
    }
  }
  return sums[1] * double(counts[0]) > LeastGain * sums[0] * double(counts[1]);
}

}

bool FindImpulses(const Buffer<Vec3>& points, const CompressedRows& nearest, double spacing,
  Buffer<unsigned char>& marks, Execution& execution)
{
  SpikeSites sites;
  sites.Unit = spacing;
  sites.Counted.assign(points.size(), 1);
  sites.Beside = FirstNeighbors(nearest, BesideCount, execution);
  sites.Nearby = FirstNeighbors(nearest, NearbyCount, execution);
  if (!execution.Proceed(0.0))
  {
    return false;
  }
  const NeighborGraph forNormals = FirstNeighbors(nearest, NormalNeighbors, execution);
  Buffer<Vec3> normals = PlaneFitNormals(points, forNormals, NormalNeighbors, execution);
  if (!execution.Proceed(0.0) ||
    !SharpenNormals(points, forNormals, spacing, normals, execution, 0.0, 0.0))
  {
    return false;
  }
  sites.Score = [&](const Buffer<unsigned char>& found, Execution& host)
  {
    SpikeScores scores;
    scores.Heights.assign(points.size(), std::numeric_limits<double>::quiet_NaN());
    host.For(
      points.size(),
      [&](std::size_t begin, std::size_t end)
      {
        Scorer scorer(points, normals, found);
        for (std::size_t i = begin; i < end; ++i)
        {
          scores.Heights[i] = scorer.HeightOf(i, sites.Nearby.Row(i));
        }
      },
      256);
    CompareWithUsual(scores, sites.Nearby, found, spacing, host);
    return scores;
  };
  return FindImpulses(sites, marks, execution) && execution.Proceed(0.0) &&
    IsWorthMoving(points, nearest, sites, marks, execution);
}

}
