// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NonIterativeBilateral.h"

#include "SurfaceBall.h"

#include <limits>

namespace SurfaceDenoising
{

void MollifyNormals(const TriangleMesh& mesh, const CompressedRows& stars, double scale,
  double spatialScale, const FaceGeometry& faces, Buffer<Vec3>& normals, Execution& execution)
{
  const double sigma = 0.5 * spatialScale;
  constexpr double anyHeight = std::numeric_limits<double>::infinity();
  Buffer<Vec3> mollified(mesh.NumberOfVertices());
  execution.For(mesh.NumberOfVertices(),
    [&](std::size_t begin, std::size_t end)
    {
      SurfaceBall ball;
      for (std::size_t v = begin; v < end; ++v)
      {
        const Vec3 p = mesh.Positions[v];
        ball.GrowFaces(mesh, stars, faces.Centroids, static_cast<Index>(v), 2.0 * spatialScale);
        const Buffer<double>& weights = ball.Weigh(sigma, anyHeight);
        Vec3 sum(0.0, 0.0, 0.0);
        double total = 0.0;
        for (std::size_t k = 0; k < ball.Size(); ++k)
        {
          const double w = faces.Areas[ball[k]] * weights[k];
          sum += w * (faces.Centroids[ball[k]] - p);
          total += w;
        }
        mollified[v] = total > 0.0 ? Vec3(p + sum / total) : p;
      }
    });
  normals.resize(mesh.NumberOfFaces());
  execution.For(mesh.NumberOfFaces(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t f = begin; f < end; ++f)
      {
        const Triangle& t = mesh.Triangles[f];
        const Vec3& a = mollified[t[0]];
        const Vec3 s = (mollified[t[1]] - a).cross(mollified[t[2]] - a);
        normals[f] = IsDegenerate(s, scale) ? Vec3(0.0, 0.0, 0.0) : Vec3(s.normalized());
      }
    });
}

void PredictVertices(const TriangleMesh& mesh, const CompressedRows& stars,
  const FaceGeometry& faces, double spatialScale, double rangeScale,
  const Buffer<unsigned char>& fixed, Buffer<Vec3>& predicted, Execution& execution)
{
  // Sums of areas and weights that have no digits left.
  const double noWeight = 1e-140 * spatialScale * spatialScale;
  predicted.resize(mesh.NumberOfVertices());
  execution.For(mesh.NumberOfVertices(),
    [&](std::size_t begin, std::size_t end)
    {
      SurfaceBall ball;
      for (std::size_t v = begin; v < end; ++v)
      {
        const Vec3 p = mesh.Positions[v];
        predicted[v] = p;
        if (!fixed.empty() && fixed[v])
        {
          continue;
        }
        ball.GrowFaces(mesh, stars, faces.Centroids, static_cast<Index>(v), 2.0 * spatialScale);
        for (std::size_t k = 0; k < ball.Size(); ++k)
        {
          ball.Heights[k] = faces.Normals[ball[k]].dot(faces.Centroids[ball[k]] - p);
        }
        const Buffer<double>& weights = ball.Weigh(spatialScale, rangeScale);
        Vec3 sum(0.0, 0.0, 0.0);
        double total = 0.0;
        for (std::size_t k = 0; k < ball.Size(); ++k)
        {
          const Vec3& m = faces.Normals[ball[k]];
          const double known = m.squaredNorm() > 0.0 ? 1.0 : 0.0;
          const double w = known * faces.Areas[ball[k]] * weights[k];
          sum += w * ball.Heights[k] * m;
          total += w;
        }
        if (total > noWeight)
        {
          predicted[v] = p + sum / total;
        }
      }
    });
}

bool FilterVerticesByPrediction(PreparedMesh& prepared,
  const NonIterativeBilateralSettings& settings, Execution& execution)
{
  TriangleMesh& mesh = prepared.Mesh();
  const CompressedRows& stars = prepared.Stars();
  const double scale = prepared.Facts().MeanEdgeLength;
  const double spatialScale = settings.SpatialScale * scale;
  if (!(spatialScale > 0.0))
  {
    return true; // all vertices are at the same place
  }
  if (!execution.Proceed(0.1))
  {
    return false;
  }
  FaceGeometry faces;
  ComputeFaceGeometry(mesh, scale, faces, execution);
  Buffer<Vec3> smoothed;
  MollifyNormals(mesh, stars, scale, spatialScale, faces, smoothed, execution);
  faces.Normals.swap(smoothed);
  if (!execution.Proceed(0.4))
  {
    return false;
  }
  const Buffer<unsigned char> nothing;
  Buffer<Vec3> predicted;
  PredictVertices(mesh, stars, faces, spatialScale, settings.RangeScale * scale,
    settings.FixBoundary ? prepared.Edges().BoundaryVertex : nothing, predicted, execution);
  mesh.Positions.swap(predicted);
  return execution.Proceed(1.0);
}

}
