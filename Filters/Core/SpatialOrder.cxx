// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SpatialOrder.h"

#include "Bounds.h"
#include "InterruptedLoops.h"

#include <atomic>
#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// Smaller meshes stay in the caches of the processor whatever their order.
constexpr std::size_t FewFaces = 50000;
constexpr double ManyEdgeLengths = 20.0;

/// Moves bit i of a number below 2^21 to bit 3 i.
std::uint64_t SpreadBits(std::uint64_t x)
{
  x = (x | (x << 32)) & 0x001f00000000ffff;
  x = (x | (x << 16)) & 0x001f0000ff0000ff;
  x = (x | (x << 8)) & 0x100f00f00f00f00f;
  x = (x | (x << 4)) & 0x10c30c30c30c30c3;
  x = (x | (x << 2)) & 0x1249249249249249;
  return x;
}

/// Position along a Z-order curve through the cube that begins at low.
std::uint64_t ZOrder(const Vec3& p, const Vec3& low, double cellsPerLength)
{
  std::uint64_t code = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    code |= SpreadBits(static_cast<std::uint64_t>((p[axis] - low[axis]) * cellsPerLength)) << axis;
  }
  return code;
}

/// A position along a curve and who is there.
struct NumberedCode
{
  /// So many digits of so many bits are the high bits.
  static constexpr int Digits = 3;
  static constexpr int DigitBits = 11;
  static constexpr int LowBits = 64 - Digits * DigitBits;

  std::uint64_t Code;
  Index Number;

  std::uint64_t HighBits() const { return this->Code >> LowBits; }
  std::size_t Digit(int digit) const
  {
    return (this->Code >> (LowBits + digit * DigitBits)) & ((1 << DigitBits) - 1);
  }
};

/// Sorts by the high bits of the codes, digit by digit. Equal ones stay in their order. Returns
/// false if the execution asked to stop.
bool SortByHighBits(Buffer<NumberedCode>& codes, Execution& execution)
{
  constexpr std::size_t buckets = std::size_t(1) << NumberedCode::DigitBits;
  Buffer<NumberedCode> sorted(codes.size());
  for (int digit = 0; digit < NumberedCode::Digits; ++digit)
  {
    std::array<std::size_t, buckets + 1> starts{};
    auto count = [&](std::size_t k) { ++starts[codes[k].Digit(digit) + 1]; };
    if (!ForInOrder(codes.size(), count, execution, 0.0))
    {
      return false;
    }
    for (std::size_t bucket = 1; bucket < buckets; ++bucket)
    {
      starts[bucket] += starts[bucket - 1];
    }
    auto move = [&](std::size_t k) { sorted[starts[codes[k].Digit(digit)]++] = codes[k]; };
    if (!ForInOrder(codes.size(), move, execution, 0.0))
    {
      return false;
    }
    codes.swap(sorted);
  }
  return true;
}

/// The numbers of the finite points as they come: what work that was stopped goes on with.
Buffer<Index> FiniteNumbers(const Buffer<Vec3>& points)
{
  Buffer<Index> numbers;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (points[i].allFinite())
    {
      numbers.push_back(static_cast<Index>(i));
    }
  }
  return numbers;
}

/// Mean of step(i) for i in [0, count) where it is finite.
template <typename Step>
double MeanStep(Execution& execution, std::size_t count, Step step)
{
  const double sum = OrderedSum(execution, count, 0.0,
    [&step](std::size_t i)
    {
      const double length = step(i);
      return std::isfinite(length) ? length : 0.0;
    });
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

}

bool IsScattered(const TriangleMesh& mesh, Execution& execution)
{
  if (mesh.NumberOfFaces() < FewFaces)
  {
    return false;
  }
  const Buffer<Vec3>& p = mesh.Positions;
  const double edge = MeanStep(execution, mesh.NumberOfFaces(),
    [&](std::size_t f) { return (p[mesh.Triangles[f][0]] - p[mesh.Triangles[f][1]]).norm(); });
  const double fromFaceToFace = MeanStep(execution, mesh.NumberOfFaces() - 1,
    [&](std::size_t f) { return (mesh.Centroid(f) - mesh.Centroid(f + 1)).norm(); });
  const double fromVertexToVertex = MeanStep(execution, mesh.NumberOfVertices() - 1,
    [&](std::size_t v) { return (p[v] - p[v + 1]).norm(); });
  return std::max(fromFaceToFace, fromVertexToVertex) > ManyEdgeLengths * edge;
}

SpatialOrder FindSpatialOrder(const TriangleMesh& mesh, Execution& execution)
{
  Vec3 low = mesh.Centroid(0);
  Vec3 high = low;
  for (std::size_t f = 1; f < mesh.NumberOfFaces(); ++f)
  {
    low = low.cwiseMin(mesh.Centroid(f));
    high = high.cwiseMax(mesh.Centroid(f));
  }
  const double extent = (high - low).maxCoeff();
  const double cellsPerLength = extent > 0.0 ? ((1 << 21) - 1) / extent : 0.0;

  std::vector<std::pair<std::uint64_t, Index>> codes(mesh.NumberOfFaces());
  execution.For(codes.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t f = begin; f < end; ++f)
      {
        codes[f] = { ZOrder(mesh.Centroid(f), low, cellsPerLength), static_cast<Index>(f) };
      }
    });
  std::sort(codes.begin(), codes.end());

  SpatialOrder order;
  order.Faces.reserve(mesh.NumberOfFaces());
  order.Vertices.reserve(mesh.NumberOfVertices());
  std::vector<bool> seen(mesh.NumberOfVertices(), false);
  auto take = [&](Index v)
  {
    if (!seen[v])
    {
      seen[v] = true;
      order.Vertices.push_back(v);
    }
  };
  for (const auto& code : codes)
  {
    order.Faces.push_back(code.second);
    for (const Index v : mesh.Triangles[code.second])
    {
      take(v);
    }
  }
  for (std::size_t v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    take(static_cast<Index>(v));
  }
  return order;
}

Buffer<Index> FindPointOrder(const Buffer<Vec3>& points, const Buffer<Vec3>& vectors,
  Execution& execution)
{
  const Bounds bounds = BoundsOf(points, execution);
  const double extent = bounds.Finite > 0 ? (bounds.High - bounds.Low).maxCoeff() : 0.0;
  const double cellsPerLength = extent > 0.0 ? ((1 << 21) - 1) / extent : 0.0;
  Buffer<NumberedCode> codes(points.size());
  std::atomic<std::size_t> coded{ 0 };
  auto code = [&](std::size_t begin, std::size_t end)
  {
    for (std::size_t i = begin; i < end; ++i)
    {
      const Vec3& p = points[i];
      // Points that are not finite come last.
      codes[i].Code = p.allFinite() ? ZOrder(p, bounds.Low, cellsPerLength) : ~std::uint64_t(0);
      codes[i].Number = static_cast<Index>(i);
    }
    coded += end - begin;
  };
  execution.For(codes.size(), code);
  if (coded < codes.size())
  {
    // Work that was stopped runs no loops; numbers have to be numbers of points all the same.
    code(0, codes.size());
  }
  if (!SortByHighBits(codes, execution))
  {
    return FiniteNumbers(points);
  }
  codes.resize(bounds.Finite);

  auto differs = [](const Vec3& a, const Vec3& b) { return a != b; };
  auto before = [](const Vec3& a, const Vec3& b)
  { return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3); };
  auto less = [&](const NumberedCode& a, const NumberedCode& b)
  {
    if (a.Code != b.Code)
    {
      return a.Code < b.Code;
    }
    const Index i = a.Number;
    const Index j = b.Number;
    if (differs(points[i], points[j]))
    {
      return before(points[i], points[j]);
    }
    if (!vectors.empty() && differs(vectors[i], vectors[j]))
    {
      return before(vectors[i], vectors[j]);
    }
    return i < j;
  };
  Buffer<Index> order(codes.size());
  std::size_t first = 0;
  auto sortUpTo = [&](std::size_t last)
  {
    const bool ends = last == codes.size() || codes[last].HighBits() != codes[first].HighBits();
    if (ends && last - first > 1)
    {
      std::sort(codes.begin() + first, codes.begin() + last, less);
    }
    for (; ends && first < last; ++first)
    {
      order[first] = codes[first].Number;
    }
  };
  const bool finished = ForInOrder(
    codes.size(), [&](std::size_t k) { sortUpTo(k + 1); }, execution, 0.0);
  return finished ? order : FiniteNumbers(points);
}

TriangleMesh Reorder(const TriangleMesh& mesh, const SpatialOrder& order)
{
  TriangleMesh ordered;
  ordered.Positions = Gather(mesh.Positions, order.Vertices);
  ordered.Triangles = Gather(mesh.Triangles, order.Faces);
  Buffer<Index> numberOf(mesh.NumberOfVertices());
  for (std::size_t v = 0; v < order.Vertices.size(); ++v)
  {
    numberOf[order.Vertices[v]] = static_cast<Index>(v);
  }
  for (Triangle& t : ordered.Triangles)
  {
    t = { numberOf[t[0]], numberOf[t[1]], numberOf[t[2]] };
  }
  return ordered;
}

}
