// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceBall.h"

#include "../Vectorize.h"

#include <limits>

namespace SurfaceDenoising
{

namespace
{

/// The square of the radius with the slack.
double Limit(double radius) { return radius * radius * (1.0 + 1e-10); }

/// Both Gaussians in one.
SURFACEDENOISING_VECTORIZED
void WeighEntries(const double* squares, const double* heights, std::size_t count, double spatial,
  double range, double* weights)
{
  for (std::size_t k = 0; k < count; ++k)
  {
    weights[k] = ExpOfNegative(-(spatial * squares[k] + range * (heights[k] * heights[k])));
  }
}

}

void SurfaceBall::GrowVertices(const CompressedRows& rings, const Buffer<Vec3>& positions, Index v,
  double radius)
{
  const double limit = Limit(radius);
  const Vec3 centre = positions[v];
  this->Found.assign(1, v);
  this->Squares.assign(1, 0.0);
  this->Seen.Clear();
  this->Seen.Insert(v);
  for (std::size_t next = 0; next < this->Found.size(); ++next)
  {
    for (const Index w : rings.Row(this->Found[next]))
    {
      if (!this->Seen.Insert(w))
      {
        continue;
      }
      const double square = (positions[w] - centre).squaredNorm();
      if (square <= limit)
      {
        this->Found.push_back(w);
        this->Squares.push_back(square);
      }
    }
  }
  this->Heights.assign(this->Found.size(), 0.0);
}

void SurfaceBall::GrowFaces(const TriangleMesh& mesh, const CompressedRows& stars,
  const Buffer<Vec3>& centroids, Index v, double radius)
{
  const double limit = Limit(radius);
  const Vec3 centre = mesh.Positions[v];
  this->Found.clear();
  this->Squares.clear();
  this->Seen.Clear();
  this->SeenCorners.Clear();
  this->Corners.assign(1, v);
  this->SeenCorners.Insert(v);
  for (std::size_t next = 0; next < this->Corners.size(); ++next)
  {
    for (const Index f : stars.Row(this->Corners[next]))
    {
      if (!this->Seen.Insert(f))
      {
        continue;
      }
      const double square = (centroids[f] - centre).squaredNorm();
      if (!(square <= limit))
      {
        continue;
      }
      this->Found.push_back(f);
      this->Squares.push_back(square);
      for (const Index w : mesh.Triangles[f])
      {
        if (this->SeenCorners.Insert(w))
        {
          this->Corners.push_back(w);
        }
      }
    }
  }
  this->Heights.assign(this->Found.size(), 0.0);
}

const Buffer<double>& SurfaceBall::Weigh(double spatialScale, double rangeScale)
{
  // The limit is for squares of scales that underflow.
  auto factor = [](double scale)
  { return std::min(0.5 / (scale * scale), std::numeric_limits<double>::max()); };
  this->Weights.resize(this->Found.size());
  WeighEntries(this->Squares.data(), this->Heights.data(), this->Found.size(), factor(spatialScale),
    factor(rangeScale), this->Weights.data());
  return this->Weights;
}

}
