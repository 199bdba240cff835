// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BilateralVertices.h"

#include "SurfaceBall.h"
#include "VertexRings.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

class Filter
{
public:
  Filter(PreparedMesh& prepared, const BilateralVerticesSettings& settings, Execution& execution)
    : Mesh(prepared.Mesh())
    , Stars(prepared.Stars())
    , Rings(VertexRings(this->Mesh, this->Stars, execution))
    , Settings(settings)
    , Smallest(1e-12 * prepared.Facts().MeanEdgeLength)
    , FaceVectors(this->Mesh.NumberOfFaces())
  {
  }

  void Sweep(const Buffer<unsigned char>& boundary, Buffer<Vec3>& moved, Execution& execution)
  {
    execution.For(this->Mesh.NumberOfFaces(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t f = begin; f < end; ++f)
        {
          this->FaceVectors[f] = this->Mesh.DoubleAreaVector(f);
        }
      });
    execution.For(this->Mesh.NumberOfVertices(),
      [&](std::size_t begin, std::size_t end)
      {
        SurfaceBall ball;
        for (std::size_t v = begin; v < end; ++v)
        {
          moved[v] = this->Settings.FixBoundary && boundary[v]
            ? this->Mesh.Positions[v]
            : this->Filtered(static_cast<Index>(v), ball);
        }
      });
  }

private:
  Vec3 Filtered(Index v, SurfaceBall& ball) const
  {
    const Vec3 p = this->Mesh.Positions[v];
    Vec3 normal(0.0, 0.0, 0.0);
    for (const Index f : this->Stars.Row(v))
    {
      normal += this->FaceVectors[f];
    }
    const double length = normal.norm();
    const double spatial = this->Settings.SpatialScale * this->ShortestEdge(v);
    if (!(length > 0.0 && spatial > 0.0))
    {
      return p;
    }
    normal /= length;

    ball.GrowVertices(this->Rings, this->Mesh.Positions, v, 2.0 * spatial);
    for (std::size_t k = 0; k < ball.Size(); ++k)
    {
      ball.Heights[k] = normal.dot(this->Mesh.Positions[ball[k]] - p);
    }
    const double range =
      std::max(this->Settings.RangeScale * Deviation(ball.Heights), this->Smallest);
    const Buffer<double>& weights = ball.Weigh(spatial, range);
    double sum = 0.0;
    double total = 0.0;
    for (std::size_t k = 0; k < ball.Size(); ++k)
    {
      sum += weights[k] * ball.Heights[k];
      total += weights[k];
    }
    return p + sum / total * normal; // the vertex itself has weight 1
  }

  /// Not counting edges without length.
  double ShortestEdge(Index v) const
  {
    double shortest = 0.0;
    for (const Index w : this->Rings.Row(v))
    {
      const double square = (this->Mesh.Positions[w] - this->Mesh.Positions[v]).squaredNorm();
      if (square > this->Smallest * this->Smallest && (shortest == 0.0 || square < shortest))
      {
        shortest = square;
      }
    }
    return std::sqrt(shortest);
  }

  /// The standard deviation of the absolute values.
  static double Deviation(const Buffer<double>& heights)
  {
    const double count = static_cast<double>(heights.size());
    double mean = 0.0;
    for (const double h : heights)
    {
      mean += std::abs(h) / count;
    }
    double variance = 0.0;
    for (const double h : heights)
    {
      variance += (std::abs(h) - mean) * (std::abs(h) - mean) / count;
    }
    return std::sqrt(variance);
  }

  const TriangleMesh& Mesh;
  const CompressedRows& Stars;
  const CompressedRows Rings;
  const BilateralVerticesSettings Settings;
  const double Smallest; ///< length that is none
  Buffer<Vec3> FaceVectors;
};

}

bool FilterVerticesBilaterally(PreparedMesh& prepared, const BilateralVerticesSettings& settings,
  Execution& execution)
{
  if (settings.Iterations <= 0)
  {
    return true;
  }
  Filter filter(prepared, settings, execution);
  Buffer<Vec3> moved(prepared.Mesh().NumberOfVertices());
  for (int iteration = 0; iteration < settings.Iterations; ++iteration)
  {
    if (!execution.Proceed(0.03 + 0.97 * iteration / settings.Iterations))
    {
      return false;
    }
    filter.Sweep(prepared.Edges().BoundaryVertex, moved, execution);
    prepared.Mesh().Positions.swap(moved);
  }
  return execution.Proceed(1.0);
}

}
