// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Metrics.h"

#include <cmath>
#include <limits>
#include <utility>

namespace SurfaceDenoising
{

namespace
{

constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();

/// A weighted sum on its way to becoming a mean.
struct WeightedSum
{
  double Sum = 0.0;
  double Weight = 0.0;

  WeightedSum& operator+=(const WeightedSum& other)
  {
    this->Sum += other.Sum;
    this->Weight += other.Weight;
    return *this;
  }

  double Mean() const { return this->Weight > 0.0 ? this->Sum / this->Weight : Undefined; }
};

}

double AngleBetween(const Vec3& a, const Vec3& b)
{
  if (a.isZero(0.0) || b.isZero(0.0))
  {
    return Undefined;
  }
  // acos(a.b) loses half of the digits near 0 and 180 degrees.
  constexpr double degrees = 57.295779513082320877;
  return std::atan2(a.cross(b).norm(), a.dot(b)) * degrees;
}

Statistics Summarize(const Buffer<double>& values, const Buffer<double>& weights,
  Execution& execution)
{
  auto mean = [&](auto term)
  {
    return OrderedSum(execution, values.size(), WeightedSum(),
      [&](std::size_t i) { return std::isnan(values[i]) ? WeightedSum() : term(i); })
      .Mean();
  };
  Statistics result;
  result.Mean = mean([&](std::size_t i) { return WeightedSum{ values[i], 1.0 }; });
  result.RootMeanSquare = std::sqrt(mean(
    [&](std::size_t i) {
      return WeightedSum{ values[i] * values[i], 1.0 };
    }));
  result.WeightedMean = weights.empty()
    ? Undefined
    : mean(
        [&](std::size_t i) {
          return WeightedSum{ weights[i] * values[i], weights[i] };
        });

  Buffer<double> sample;
  sample.reserve(values.size());
  std::copy_if(values.begin(), values.end(), std::back_inserter(sample),
    [](double value) { return !std::isnan(value); });
  result.Count = sample.size();
  result.Median = Percentile(sample, 0.5);
  result.Percentile95 = Percentile(sample, 0.95);
  result.Maximum = Percentile(sample, 1.0);
  return result;
}

double Percentile(Buffer<double>& values, double fraction)
{
  if (values.empty())
  {
    return Undefined;
  }
  const double position = fraction * static_cast<double>(values.size() - 1);
  const std::size_t below = static_cast<std::size_t>(position);
  const auto lower = values.begin() + static_cast<std::ptrdiff_t>(below);
  std::nth_element(values.begin(), lower, values.end());
  const double share = position - static_cast<double>(below);
  if (share == 0.0)
  {
    return *lower;
  }
  const double upper = *std::min_element(lower + 1, values.end());
  return *lower + share * (upper - *lower);
}

double AreaWeightedDistance(const TriangleMesh& mesh, const Buffer<double>& areas,
  const Buffer<double>& distances, Execution& execution)
{
  const WeightedSum sum = OrderedSum(execution, mesh.NumberOfFaces(), WeightedSum(),
    [&](std::size_t f)
    {
      WeightedSum face;
      for (const Index v : mesh.Triangles[f])
      {
        face += { areas[f] * distances[v] * distances[v], areas[f] };
      }
      return face;
    });
  return std::sqrt(sum.Mean());
}

bool IsClosed(const EdgeCensus& census)
{
  return census.NumberOfEdges > 0 && census.NumberOfBoundaryEdges == 0 &&
    census.NumberOfNonManifoldEdges == 0 && census.NumberOfInconsistentEdges == 0;
}

double SignedVolume(const TriangleMesh& mesh, Execution& execution)
{
  // Any origin gives the volume of a closed mesh; one on a face saves the digits of a far position.
  const Vec3 origin =
    mesh.Triangles.empty() ? Vec3(0.0, 0.0, 0.0) : mesh.Positions[mesh.Triangles[0][0]];
  const double sum = OrderedSum(execution, mesh.NumberOfFaces(), 0.0,
    [&](std::size_t f)
    { return (mesh.Positions[mesh.Triangles[f][0]] - origin).dot(mesh.DoubleAreaVector(f)); });
  return sum / 6.0;
}

double TriangleQuality(const TriangleMesh& mesh, const Buffer<double>& areas, Execution& execution)
{
  const WeightedSum sum = OrderedSum(execution, mesh.NumberOfFaces(), WeightedSum(),
    [&](std::size_t f)
    {
      if (areas[f] == 0.0)
      {
        return WeightedSum();
      }
      const Triangle& t = mesh.Triangles[f];
      const double a = (mesh.Positions[t[1]] - mesh.Positions[t[2]]).norm();
      const double b = (mesh.Positions[t[2]] - mesh.Positions[t[0]]).norm();
      const double c = (mesh.Positions[t[0]] - mesh.Positions[t[1]]).norm();
      const double radius = a * b * c / (4.0 * areas[f]);
      return WeightedSum{ radius / std::min({ a, b, c }), 1.0 };
    });
  return sum.Mean();
}

FeatureAgreement CompareFeatureEdges(const NeighborGraph& edgeAdjacentFaces,
  const Buffer<Vec3>& normals, const Buffer<Vec3>& referenceNormals, double angle,
  Execution& execution)
{
  return OrderedSum(execution, edgeAdjacentFaces.NumberOfRows(), FeatureAgreement(),
    [&](std::size_t f)
    {
      FeatureAgreement face;
      for (const Index g : edgeAdjacentFaces.Row(f))
      {
        if (g > f) // the other face sees the same edge
        {
          const bool expected = AngleBetween(referenceNormals[f], referenceNormals[g]) > angle;
          const bool present = AngleBetween(normals[f], normals[g]) > angle;
          face.Reference += expected;
          face.Found += expected && present;
          face.Invented += present && !expected;
        }
      }
      return face;
    });
}

Buffer<unsigned char> FacesNearFeatures(const TriangleMesh& mesh, const CompressedRows& stars,
  const NeighborGraph& edgeAdjacentFaces, const Buffer<Vec3>& normals, double angle, int rings,
  Execution& execution)
{
  // Two faces that share an edge and this vertex share an edge that ends at this vertex.
  auto endsFeature = [&](Index v)
  {
    for (const Index f : stars.Row(v))
    {
      for (const Index g : edgeAdjacentFaces.Row(f))
      {
        if (g > f && HasCorner(mesh.Triangles[g], v) &&
          AngleBetween(normals[f], normals[g]) > angle)
        {
          return true;
        }
      }
    }
    return false;
  };
  Buffer<unsigned char> near(mesh.NumberOfFaces(), 0);
  auto touchesNearFace = [&](Index v)
  {
    const Span<Index> star = stars.Row(v);
    return std::any_of(star.begin(), star.end(), [&](Index f) { return near[f] != 0; });
  };
  // Vertices look at faces and faces at vertices, so that nobody writes what another one reads.
  Buffer<unsigned char> reached(mesh.NumberOfVertices());
  std::ptrdiff_t found = -1;
  for (int ring = 0; ring < rings; ++ring)
  {
    execution.For(reached.size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t v = begin; v < end; ++v)
        {
          const Index vertex = static_cast<Index>(v);
          reached[v] = ring == 0 ? endsFeature(vertex) : touchesNearFace(vertex);
        }
      });
    execution.For(near.size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t f = begin; f < end; ++f)
        {
          const Triangle& t = mesh.Triangles[f];
          near[f] = reached[t[0]] || reached[t[1]] || reached[t[2]];
        }
      });
    const std::ptrdiff_t before = std::exchange(found, std::count(near.begin(), near.end(), 1));
    if (found == before) // further rings are empty
    {
      break;
    }
  }
  return near;
}

DividedMean MeansByMark(const Buffer<double>& values, const Buffer<unsigned char>& marks,
  Execution& execution)
{
  auto mean = [&](bool marked)
  {
    return OrderedSum(execution, values.size(), WeightedSum(),
      [&](std::size_t i)
      {
        return std::isnan(values[i]) || (marks[i] != 0) != marked ? WeightedSum()
                                                                  : WeightedSum{ values[i], 1.0 };
      })
      .Mean();
  };
  return { mean(true), mean(false) };
}

}
