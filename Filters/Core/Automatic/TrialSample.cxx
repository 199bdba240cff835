// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrialSample.h"

#include "../Metrics.h"
#include "../Noise.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

constexpr double Degrees = 180.0 / 3.14159265358979323846;

/// Noise in random directions along the surface, to that across: filters leave part of the former
/// in the surface, where it is still.
constexpr double AlongSurface = 0.9;

/// Vertices that turn a face over go back half way as often, and then all the way.
constexpr int HalvingRounds = 8;
constexpr int StandingRounds = 4;

/// The angle between unit vectors at this distance.
double AngleAt(double distance) { return 2.0 * std::asin(std::min(1.0, 0.5 * distance)) * Degrees; }

}

Buffer<Vec3> FaceNormals(const TriangleMesh& mesh, Execution& execution)
{
  FaceGeometry geometry;
  ComputeFaceGeometry(mesh, 0.0, geometry, execution);
  return std::move(geometry.Normals);
}

TriangleMesh Displaced(const TriangleMesh& mesh, const Buffer<Vec3>& steps, double factor)
{
  TriangleMesh moved = mesh;
  for (std::size_t v = 0; v < steps.size(); ++v)
  {
    moved.Positions[v] += factor * steps[v];
  }
  return moved;
}

TrialSample::TrialSample(const MeshSample& sample, Execution& execution)
  : Sample(sample)
{
  this->Stars = VertexStars(sample.Mesh);
  this->MeanEdgeLength = TakeEdgeCensus(sample.Mesh, this->Stars, execution).MeanEdgeLength;
  this->Adjacent = EdgeAdjacentFaces(sample.Mesh, this->Stars, execution);
  for (std::size_t f = 0; f < sample.Inner.size(); ++f)
  {
    if (sample.Inner[f])
    {
      this->Faces.push_back(static_cast<Index>(f));
    }
  }
}

double TrialSample::MeanAngle(const Buffer<Vec3>& a, const Buffer<Vec3>& b,
  Execution& execution) const
{
  const double sum = OrderedSum(execution, this->Faces.size(), 0.0,
    [&](std::size_t k)
    {
      const Index f = this->Faces[k];
      return AngleAt((a[f] - b[f]).norm());
    });
  return sum / std::max(1.0, double(this->Faces.size()));
}

std::vector<double> TrialSample::Bends(const Buffer<Vec3>& normals,
  const std::vector<double>& fractions) const
{
  Buffer<double> squares;
  squares.reserve(3 * this->Faces.size());
  for (const Index f : this->Faces)
  {
    for (const Index g : this->Adjacent.Row(f))
    {
      squares.push_back((normals[f] - normals[g]).squaredNorm());
    }
  }
  std::vector<double> bends;
  for (const double fraction : fractions)
  {
    bends.push_back(squares.empty() ? 0.0 : AngleAt(std::sqrt(Percentile(squares, fraction))));
  }
  return bends;
}

double TrialSample::FoldedShare(const Buffer<Vec3>& normals) const
{
  std::size_t pairs = 0;
  std::size_t folded = 0;
  for (const Index f : this->Faces)
  {
    for (const Index g : this->Adjacent.Row(f))
    {
      ++pairs;
      folded += normals[f].dot(normals[g]) < -0.5 ? 1 : 0;
    }
  }
  return double(folded) / std::max(1.0, double(pairs));
}

TrialResidual TrialSample::Residual(const TriangleMesh& mesh, const TriangleMesh& surface,
  Execution& execution) const
{
  const Buffer<Vec3> normals = VertexAreaVectors(surface, this->Stars, execution);
  Buffer<double> distances(normals.size());
  for (std::size_t v = 0; v < distances.size(); ++v)
  {
    const Vec3 step = mesh.Positions[v] - surface.Positions[v];
    distances[v] = step.dot(normals[v].stableNormalized());
  }
  double products = 0.0;
  double squares = 0.0;
  for (const Index f : this->Faces)
  {
    const Triangle& t = surface.Triangles[f];
    for (int k = 0; k < 3; ++k)
    {
      const double a = distances[t[k]];
      const double b = distances[t[(k + 1) % 3]];
      products += 2.0 * a * b;
      squares += a * a + b * b;
    }
  }
  TrialResidual residual;
  if (squares > 0.0)
  {
    residual.Size = std::sqrt(squares / (6.0 * double(this->Faces.size())));
    residual.Correlation = products / squares;
  }
  return residual;
}

TriangleMesh TrialSample::Resampled(const TriangleMesh& surface, Execution& execution) const
{
  Buffer<Vec3> steps = VertexAreaVectors(surface, this->Stars, execution);
  for (std::size_t v = 0; v < steps.size(); ++v)
  {
    const Vec3 normal = steps[v].stableNormalized();
    const Vec3 step = this->Sample.Mesh.Positions[v] - surface.Positions[v];
    steps[v] = step - normal.dot(step) * normal;
  }
  TriangleMesh moved = Displaced(surface, steps, 1.0);
  Buffer<unsigned char> turned(steps.size());
  for (int round = 0; round < HalvingRounds + StandingRounds; ++round)
  {
    std::fill(turned.begin(), turned.end(), 0);
    for (std::size_t f = 0; f < surface.NumberOfFaces(); ++f)
    {
      if (!(moved.DoubleAreaVector(f).dot(surface.DoubleAreaVector(f)) > 0.0))
      {
        for (const Index v : surface.Triangles[f])
        {
          turned[v] = 1;
        }
      }
    }
    for (std::size_t v = 0; v < turned.size(); ++v)
    {
      if (turned[v])
      {
        steps[v] *= round < HalvingRounds ? 0.5 : 0.0;
        moved.Positions[v] = surface.Positions[v] + steps[v];
      }
    }
  }
  return moved;
}

Buffer<Vec3> TrialSample::Noise(const TriangleMesh& surface, TrialNoise kind,
  Execution& execution) const
{
  Buffer<Vec3> noise = VertexAreaVectors(surface, this->Stars, execution);
  NoiseParameters parameters;
  parameters.Deviation = 1.0;
  parameters.Seed = 1;
  const NoiseSource source(parameters, noise.size());
  for (std::size_t v = 0; v < noise.size(); ++v)
  {
    const Index key = this->Sample.Keys[v];
    const Vec3 normal = noise[v].stableNormalized();
    noise[v] = normal;
    if (kind == TrialNoise::RandomDirections)
    {
      const Vec3 outwards = surface.Positions[v] - this->Sample.Middle;
      const Vec3 x = (outwards - outwards.dot(normal) * normal).stableNormalized();
      const Vec3 direction = source.Direction(key);
      noise[v] =
        direction[2] * normal + AlongSurface * (direction[0] * x + direction[1] * normal.cross(x));
    }
    noise[v] *= source.Amplitude(key);
  }
  return noise;
}

}
