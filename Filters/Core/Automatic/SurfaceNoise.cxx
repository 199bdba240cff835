// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceNoise.h"

#include "../Metrics.h"
#include "../OneStage/VertexRings.h"
#include "../RobustScale.h"
#include "Spikes.h"

#include <Eigen/Cholesky>

#include <cmath>
#include <limits>

namespace SurfaceDenoising
{

namespace
{

constexpr double NoFit = std::numeric_limits<double>::quiet_NaN();
/// Of the absolute value of a normally distributed number.
constexpr double LowerQuartile = 0.318639363964375;
/// A fit of more points costs more and tells no more.
constexpr std::size_t MostNeighbors = 400;

/// Adds one more ring to a sorted list of vertices.
void Grow(const CompressedRows& rings, std::vector<Index>& vertices)
{
  const std::size_t inner = vertices.size();
  for (std::size_t k = 0; k < inner; ++k)
  {
    const Span<Index> ring = rings.Row(vertices[k]);
    vertices.insert(vertices.end(), ring.begin(), ring.end());
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
}

/// |r| / sqrt(1 + g) of a fit with the given number of terms: 6 of a quadric, 10 of a cubic.
template <int Terms>
double Residual(const Buffer<Vec3>& positions, const std::vector<Index>& around, Index centre,
  const Vec3& normal)
{
  using Row = Eigen::Matrix<double, Terms, 1>;
  const std::size_t count = around.size() - 1;
  if (count < Terms + 2 || count > MostNeighbors)
  {
    return NoFit;
  }
  double scale = 0.0;
  for (const Index w : around)
  {
    scale += (positions[w] - positions[centre]).norm() / double(count);
  }
  const double length = normal.stableNorm();
  if (!(scale > 0.0) || !(length > 0.0))
  {
    return NoFit;
  }
  const Vec3 up = normal / length;
  const Vec3 x = up.unitOrthogonal();
  const Vec3 y = up.cross(x);
  Eigen::Matrix<double, Terms, Terms> matrix = Eigen::Matrix<double, Terms, Terms>::Zero();
  Row right = Row::Zero();
  for (const Index w : around)
  {
    if (w == centre)
    {
      continue;
    }
    const Vec3 d = (positions[w] - positions[centre]) / scale;
    const double a = d.dot(x);
    const double b = d.dot(y);
    double terms[10] = { 1.0, a, b, a * a, a * b, b * b, a * a * a, a * a * b, a * b * b,
      b * b * b };
    const Eigen::Map<Row> row(terms);
    matrix += row * row.transpose();
    right += d.dot(up) * row;
  }
  // Points on a few lines do not determine all terms.
  matrix.diagonal().array() += 1e-9 * double(count);
  const Eigen::LDLT<Eigen::Matrix<double, Terms, Terms>> solver(matrix);
  const Row first = solver.solve(Row::Unit(0));
  return std::abs(first.dot(right)) * scale / std::sqrt(1.0 + std::max(0.0, first[0]));
}

double QuartileScale(const Buffer<double>& residuals, std::size_t& samples)
{
  Buffer<double> values;
  std::copy_if(residuals.begin(), residuals.end(), std::back_inserter(values),
    [](double value) { return std::isfinite(value); });
  samples = values.size();
  return values.empty() ? 0.0 : Percentile(values, 0.25) / LowerQuartile;
}

/// Median over the faces of sqrt(sum 1 / h_i^2): how much a unit of noise turns a face.
double MedianTurn(const TriangleMesh& mesh, double edgeLength)
{
  Buffer<double> turns;
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    const Vec3 area = mesh.DoubleAreaVector(f);
    if (IsDegenerate(area, edgeLength))
    {
      continue;
    }
    const Triangle& t = mesh.Triangles[f];
    double squares = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      squares += (mesh.Positions[t[(k + 1) % 3]] - mesh.Positions[t[k]]).squaredNorm();
    }
    turns.push_back(std::sqrt(squares) / area.norm());
  }
  return Median(turns);
}

}

SurfaceNoise EstimateNoise(const TriangleMesh& mesh, const CompressedRows& stars,
  Execution& execution)
{
  SurfaceNoise noise;
  const CompressedRows rings = VertexRings(mesh, stars, execution);
  const EdgeCensus census = TakeEdgeCensus(mesh, stars, execution);
  const Buffer<Vec3> normals = SmoothNormals(mesh, stars, rings, 2, execution);
  Buffer<double> fine(mesh.NumberOfVertices());
  Buffer<double> coarse(mesh.NumberOfVertices());
  execution.For(
    mesh.NumberOfVertices(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Index> around;
      for (std::size_t i = begin; i < end; ++i)
      {
        const Index v = static_cast<Index>(i);
        fine[v] = coarse[v] = NoFit;
        if (census.BoundaryVertex[v] || rings.Row(v).size() > MostNeighbors)
        {
          continue;
        }
        around.assign(1, v);
        Grow(rings, around);
        Grow(rings, around);
        fine[v] = Residual<10>(mesh.Positions, around, v, normals[v]);
        if (std::isfinite(fine[v]))
        {
          Grow(rings, around);
          coarse[v] = Residual<6>(mesh.Positions, around, v, normals[v]);
        }
      }
    },
    256);
  std::size_t samples = 0;
  const double t = QuartileScale(coarse, samples);
  const double s = QuartileScale(fine, noise.Samples);
  const double l = census.MeanEdgeLength;
  noise.Deviation = std::sqrt(std::max(0.0, s * s - 0.25 * std::max(0.0, t * t - s * s)));
  if (l > 0.0)
  {
    const double ratio = noise.Deviation / l;
    noise.Level = std::min(2.0, ratio / std::sqrt(std::max(0.01, 1.0 - 1.56 * ratio * ratio)));
    noise.NormalAngle =
      std::atan(noise.Deviation * MedianTurn(mesh, l)) * (180.0 / 3.14159265358979323846);
  }
  const Buffer<unsigned char> spikes = FindSpikes(mesh, stars, execution);
  std::size_t marked = 0;
  std::size_t used = 0;
  for (std::size_t v = 0; v < spikes.size(); ++v)
  {
    marked += spikes[v];
    used += stars.Row(v).size() > 0 ? 1 : 0;
  }
  noise.SpikeShare = used > 0 ? double(marked) / double(used) : 0.0;
  return noise;
}

}
