// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SpatialOrder.h"

#include <cmath>
#include <limits>

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
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  Buffer<std::pair<std::uint64_t, Index>> codes;
  codes.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (points[i].allFinite())
    {
      low = low.cwiseMin(points[i]);
      high = high.cwiseMax(points[i]);
      codes.emplace_back(0, static_cast<Index>(i));
    }
  }
  const double extent = codes.empty() ? 0.0 : (high - low).maxCoeff();
  const double cellsPerLength = extent > 0.0 ? ((1 << 21) - 1) / extent : 0.0;
  execution.For(codes.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t k = begin; k < end; ++k)
      {
        codes[k].first = ZOrder(points[codes[k].second], low, cellsPerLength);
      }
    });
  auto differs = [](const Vec3& a, const Vec3& b) { return a != b; };
  auto before = [](const Vec3& a, const Vec3& b)
  { return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3); };
  std::sort(codes.begin(), codes.end(),
    [&](const auto& a, const auto& b)
    {
      if (a.first != b.first)
      {
        return a.first < b.first;
      }
      const Index i = a.second;
      const Index j = b.second;
      if (differs(points[i], points[j]))
      {
        return before(points[i], points[j]);
      }
      if (!vectors.empty() && differs(vectors[i], vectors[j]))
      {
        return before(vectors[i], vectors[j]);
      }
      return i < j;
    });
  Buffer<Index> order(codes.size());
  for (std::size_t k = 0; k < codes.size(); ++k)
  {
    order[k] = codes[k].second;
  }
  return order;
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
