// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SpikeScores.h"

#include "../Metrics.h"

#include <Eigen/Cholesky>

#include <cmath>
#include <limits>

namespace SurfaceDenoising
{

namespace
{

constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t MostNeighbors = 400;
/// Planes and vertices that a height needs, and heights that a ratio needs.
constexpr std::size_t LeastPlanes = 4;
constexpr std::size_t LeastPoints = 8;
constexpr std::size_t LeastHeights = 5;
constexpr int Reweightings = 6;

using Row = Eigen::Matrix<double, 6, 1>;

/// What a thread needs to score vertices one after the other.
class Scorer
{
public:
  Scorer(const TriangleMesh& mesh, const CompressedRows& stars, const FaceGeometry& geometry,
    const Buffer<unsigned char>& marks)
    : Mesh(mesh)
    , Stars(stars)
    , Geometry(geometry)
    , Marks(marks)
  {
  }

  /// From the planes around v.
  double OffPlanes(Index v)
  {
    this->Faces.clear();
    for (const Index f : this->Stars.Row(v))
    {
      for (const Index w : this->Mesh.Triangles[f])
      {
        const Span<Index> star = this->Stars.Row(w);
        if (star.size() <= MostNeighbors)
        {
          this->Faces.insert(this->Faces.end(), star.begin(), star.end());
        }
      }
    }
    std::sort(this->Faces.begin(), this->Faces.end());
    this->Faces.erase(std::unique(this->Faces.begin(), this->Faces.end()), this->Faces.end());
    this->Values.clear();
    for (const Index f : this->Faces)
    {
      const Triangle& t = this->Mesh.Triangles[f];
      if (!HasCorner(t, v) && this->Geometry.Areas[f] > 0.0 && !this->Marks[t[0]] &&
        !this->Marks[t[1]] && !this->Marks[t[2]])
      {
        const Vec3 d = this->Mesh.Positions[v] - this->Geometry.Centroids[f];
        this->Values.push_back(std::abs(this->Geometry.Normals[f].dot(d)));
      }
    }
    return this->Values.size() < LeastPlanes ? Unknown : Percentile(this->Values, 0.15);
  }

  /// From the quadric around v, along the given direction.
  double OffQuadric(Index v, Span<Index> nearby, const Vec3& normal)
  {
    const double length = normal.stableNorm();
    double scale = 0.0;
    std::size_t count = 0;
    for (const Index w : nearby)
    {
      if (!this->Marks[w])
      {
        scale += (this->Mesh.Positions[w] - this->Mesh.Positions[v]).norm();
        ++count;
      }
    }
    scale /= double(std::max<std::size_t>(count, 1));
    if (count < LeastPoints || count > MostNeighbors || !(scale > 0.0) || !(length > 0.0))
    {
      return Unknown;
    }
    const Vec3 up = normal / length;
    const Vec3 x = up.unitOrthogonal();
    const Vec3 y = up.cross(x);
    this->Rows.clear();
    this->Values.clear();
    for (const Index w : nearby)
    {
      if (!this->Marks[w])
      {
        const Vec3 d = (this->Mesh.Positions[w] - this->Mesh.Positions[v]) / scale;
        const double a = d.dot(x);
        const double b = d.dot(y);
        this->Rows.emplace_back();
        this->Rows.back() << 1.0, a, b, a * a, a * b, b * b;
        this->Values.push_back(d.dot(up));
      }
    }
    this->Weights.assign(count, 1.0);
    Row terms = Row::Zero();
    for (int step = 0; step < Reweightings; ++step)
    {
      Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
      Row right = Row::Zero();
      for (std::size_t k = 0; k < count; ++k)
      {
        const Row weighted = this->Weights[k] * this->Rows[k];
        matrix += weighted * this->Rows[k].transpose();
        right += this->Values[k] * weighted;
      }
      // Points on a few lines do not determine all terms.
      matrix.diagonal().array() += 1e-9 * double(count);
      terms = matrix.ldlt().solve(right);
      for (std::size_t k = 0; k < count; ++k)
      {
        const double residual = std::abs(this->Values[k] - terms.dot(this->Rows[k]));
        this->Weights[k] = 1.0 / std::max(0.01, residual);
      }
    }
    return std::abs(terms[0]) * scale;
  }

private:
  const TriangleMesh& Mesh;
  const CompressedRows& Stars;
  const FaceGeometry& Geometry;
  const Buffer<unsigned char>& Marks;
  std::vector<Index> Faces;
  Buffer<double> Values;
  Buffer<double> Weights;
  std::vector<Row> Rows;
};

/// Sums of the area vectors around each vertex and its ring: one spike does not tilt them much.
Buffer<Vec3> RingNormals(const TriangleMesh& mesh, const CompressedRows& stars,
  const CompressedRows& rings, Execution& execution)
{
  Buffer<Vec3> own(mesh.NumberOfVertices(), Vec3(0.0, 0.0, 0.0));
  Buffer<Vec3> normals(mesh.NumberOfVertices());
  execution.For(own.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t v = begin; v < end; ++v)
      {
        for (const Index f : stars.Row(v))
        {
          own[v] += mesh.DoubleAreaVector(f);
        }
      }
    });
  execution.For(own.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t v = begin; v < end; ++v)
      {
        normals[v] = own[v];
        for (const Index w : rings.Row(v))
        {
          normals[v] += own[w];
        }
      }
    });
  return normals;
}

}

CompressedRows VerticesNearby(const CompressedRows& rings, Execution& execution)
{
  return BuildRowsWith(execution, rings.Offsets.size() - 1,
    [&rings]
    {
      return [&rings, around = std::vector<Index>()](std::size_t v, Buffer<Index>& row) mutable
      {
        around.clear();
        if (rings.Row(v).size() > MostNeighbors)
        {
          return;
        }
        for (const Index w : rings.Row(v))
        {
          around.push_back(w);
          const Span<Index> next = rings.Row(w);
          if (next.size() <= MostNeighbors)
          {
            around.insert(around.end(), next.begin(), next.end());
          }
        }
        std::sort(around.begin(), around.end());
        const auto last = std::unique(around.begin(), around.end());
        std::copy_if(around.begin(), last, std::back_inserter(row),
          [v](Index w) { return w != static_cast<Index>(v); });
      };
    });
}

SpikeScores ScoreSpikes(const TriangleMesh& mesh, const CompressedRows& stars,
  const CompressedRows& rings, const CompressedRows& nearby, const EdgeCensus& edges,
  const Buffer<unsigned char>& marks, Execution& execution)
{
  FaceGeometry geometry;
  ComputeFaceGeometry(mesh, edges.MeanEdgeLength, geometry, execution);
  const Buffer<Vec3> normals = RingNormals(mesh, stars, rings, execution);
  const std::size_t count = mesh.NumberOfVertices();
  SpikeScores scores;
  scores.Heights.assign(count, Unknown);
  scores.Ratios.assign(count, Unknown);
  execution.For(
    count,
    [&](std::size_t begin, std::size_t end)
    {
      Scorer scorer(mesh, stars, geometry, marks);
      for (std::size_t i = begin; i < end; ++i)
      {
        const Index v = static_cast<Index>(i);
        if (stars.Row(v).size() > 0 && stars.Row(v).size() <= MostNeighbors)
        {
          const double height = scorer.OffPlanes(v);
          // fmin takes the other one if one is unknown.
          scores.Heights[v] = std::isfinite(height)
            ? std::fmin(height, scorer.OffQuadric(v, nearby.Row(v), normals[v]))
            : Unknown;
        }
      }
    },
    256);
  // Rounding errors of flat places are no scale.
  const double least = 1e-12 * edges.MeanEdgeLength;
  execution.For(
    count,
    [&](std::size_t begin, std::size_t end)
    {
      Buffer<double> heights;
      for (std::size_t v = begin; v < end; ++v)
      {
        heights.clear();
        for (const Index w : nearby.Row(v))
        {
          if (!marks[w] && std::isfinite(scores.Heights[w]))
          {
            heights.push_back(scores.Heights[w]);
          }
        }
        if (heights.size() >= LeastHeights && least > 0.0)
        {
          scores.Ratios[v] = scores.Heights[v] / std::max(least, Percentile(heights, 2.0 / 3.0));
        }
      }
    },
    256);
  return scores;
}

}
