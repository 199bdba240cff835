// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SpikeScores.h"

#include "../Metrics.h"
#include "../OneStage/VertexRings.h"
#include "RobustQuadric.h"

#include <cmath>
#include <limits>

namespace SurfaceDenoising
{

namespace
{

constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t MostNeighbors = 400;
/// Planes that a height needs.
constexpr std::size_t LeastPlanes = 4;

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
    if (count > MostNeighbors || !(scale > 0.0) || !(length > 0.0))
    {
      return Unknown;
    }
    this->Quadric.Start(normal / length, scale);
    for (const Index w : nearby)
    {
      if (!this->Marks[w])
      {
        this->Quadric.Add(this->Mesh.Positions[w] - this->Mesh.Positions[v]);
      }
    }
    return std::abs(this->Quadric.Height());
  }

private:
  const TriangleMesh& Mesh;
  const CompressedRows& Stars;
  const FaceGeometry& Geometry;
  const Buffer<unsigned char>& Marks;
  std::vector<Index> Faces;
  Buffer<double> Values;
  RobustQuadric Quadric;
};

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
  const Buffer<Vec3> normals = SmoothNormals(mesh, stars, rings, 1, execution);
  const std::size_t count = mesh.NumberOfVertices();
  SpikeScores scores;
  scores.Heights.assign(count, Unknown);
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
  CompareWithUsual(scores, nearby, marks, edges.MeanEdgeLength, execution);
  return scores;
}

}
