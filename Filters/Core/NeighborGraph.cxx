// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NeighborGraph.h"

#include "IndexSet.h"
#include "KdTree.h"

namespace SurfaceDenoising
{

namespace
{

struct DistanceSum
{
  double Sum = 0.0;
  std::size_t Count = 0;

  DistanceSum& operator+=(const DistanceSum& other)
  {
    this->Sum += other.Sum;
    this->Count += other.Count;
    return *this;
  }
};

/// From the centroid of a face to those of its edge-adjacent faces.
DistanceSum AdjacentDistances(const NeighborGraph& adjacent, const Buffer<Vec3>& centroids,
  std::size_t f)
{
  DistanceSum sum;
  for (const Index g : adjacent.Row(f))
  {
    sum.Sum += (centroids[f] - centroids[g]).norm();
    ++sum.Count;
  }
  return sum;
}

/// The faces that share an edge with a face, or a vertex that is no large fan.
void AppendSharingBesideFans(const TriangleMesh& mesh, const CompressedRows& stars, std::size_t f,
  Buffer<Index>& row)
{
  const std::size_t first = row.size();
  const Triangle& t = mesh.Triangles[f];
  for (const Index v : t)
  {
    const bool fan = stars.Row(v).size() > LargestFan;
    for (const Index g : stars.Row(v))
    {
      const Triangle& other = mesh.Triangles[g];
      if (g != f &&
        (!fan ||
          std::any_of(t.begin(), t.end(), [&](Index w) { return w != v && HasCorner(other, w); })))
      {
        row.push_back(g);
      }
    }
  }
  std::sort(row.begin() + static_cast<std::ptrdiff_t>(first), row.end());
  row.erase(std::unique(row.begin() + static_cast<std::ptrdiff_t>(first), row.end()), row.end());
}

}

NeighborGraph EdgeAdjacentFaces(const TriangleMesh& mesh, const CompressedRows& stars,
  Execution& execution)
{
  return BuildRows(execution, mesh.NumberOfFaces(),
    [&](std::size_t f, Buffer<Index>& row)
    {
      const Triangle t = mesh.Triangles[f];
      // The faces at the first corner that share another one, then those that share the opposite
      // edge only.
      for (const Index g : stars.Row(t[0]))
      {
        const Triangle& other = mesh.Triangles[g];
        if (g != f &&
          ((t[1] != t[0] && HasCorner(other, t[1])) || (t[2] != t[0] && HasCorner(other, t[2]))))
        {
          row.push_back(g);
        }
      }
      if (t[1] == t[2])
      {
        return;
      }
      for (const Index g : stars.Row(t[1]))
      {
        const Triangle& other = mesh.Triangles[g];
        if (g != f && HasCorner(other, t[2]) && !HasCorner(other, t[0]))
        {
          row.push_back(g);
        }
      }
    });
}

NeighborGraph VertexSharingFaces(const TriangleMesh& mesh, const CompressedRows& stars,
  Execution& execution)
{
  return BuildRows(execution, mesh.NumberOfFaces(),
    [&](std::size_t f, Buffer<Index>& row)
    {
      const Triangle t = mesh.Triangles[f];
      const auto isFan = [&](Index v) { return stars.Row(v).size() > LargestFan; };
      if (isFan(t[0]) || isFan(t[1]) || isFan(t[2]))
      {
        AppendSharingBesideFans(mesh, stars, f, row);
        return;
      }
      // A face is taken at the first of the three corners that it shares.
      for (const Index g : stars.Row(t[0]))
      {
        if (g != f)
        {
          row.push_back(g);
        }
      }
      for (const Index g : stars.Row(t[1]))
      {
        if (!HasCorner(mesh.Triangles[g], t[0]))
        {
          row.push_back(g);
        }
      }
      for (const Index g : stars.Row(t[2]))
      {
        const Triangle& other = mesh.Triangles[g];
        if (!HasCorner(other, t[0]) && !HasCorner(other, t[1]))
        {
          row.push_back(g);
        }
      }
    });
}

NeighborGraph FacesWithinRadius(const NeighborGraph& connections, const Buffer<Vec3>& centroids,
  double radius, std::size_t most, Execution& execution)
{
  const double limit = radius * radius;
  return BuildRowsWith(execution, centroids.size(),
    [&]
    {
      // Whether a face was seen already, near or far, is asked more often than anything else, and
      // every distance is computed once.
      return [&, seen = IndexSet()](std::size_t f, Buffer<Index>& row) mutable
      {
        const std::size_t first = row.size();
        const Vec3 centre = centroids[f];
        auto grow = [&](Index from)
        {
          for (const Index g : connections.Row(from))
          {
            if (seen.Insert(g) && (centroids[g] - centre).squaredNorm() <= limit)
            {
              row.push_back(g);
            }
          }
        };
        seen.Clear();
        seen.Insert(static_cast<Index>(f));
        grow(static_cast<Index>(f));
        // Whole steps, which do not depend on the order of faces.
        for (std::size_t next = first; next < row.size() && row.size() - first <= most;)
        {
          for (const std::size_t end = row.size(); next < end; ++next)
          {
            grow(row[next]);
          }
        }
      };
    });
}

Buffer<double> SharedEdgeLengths(const TriangleMesh& mesh, const NeighborGraph& graph,
  Execution& execution)
{
  Buffer<double> lengths(graph.NumberOfIds());
  execution.For(graph.NumberOfRows(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t f = begin; f < end; ++f)
      {
        const Triangle& t = mesh.Triangles[f];
        for (std::uint64_t p = graph.Offsets[f]; p < graph.Offsets[f + 1]; ++p)
        {
          const Triangle& other = mesh.Triangles[graph.Ids[p]];
          double sum = 0.0;
          for (int corner = 0; corner < 3; ++corner)
          {
            const Index a = t[corner];
            const Index b = t[(corner + 1) % 3];
            // A face that repeats a vertex runs along its one edge twice.
            const bool again = corner > 0 && HasCorner({ t[0], t[1], t[1] }, a) &&
              HasCorner({ t[0], t[1], t[1] }, b);
            if (a != b && !again && HasCorner(other, a) && HasCorner(other, b))
            {
              sum += (mesh.Positions[a] - mesh.Positions[b]).norm();
            }
          }
          lengths[p] = sum;
        }
      }
    });
  return lengths;
}

NeighborGraph NearestPoints(const Buffer<Vec3>& points, std::size_t count, Execution& execution)
{
  const KdTree tree(points);
  return BuildRows(execution, points.size(),
    [&](std::size_t i, Buffer<Index>& row)
    {
      static thread_local std::vector<Index> found;
      // One more than asked for, because the point finds itself; among coincident points it may
      // not.
      tree.Nearest(points[i], count + 1, found);
      const std::size_t first = row.size();
      for (const Index j : found)
      {
        if (j != i && row.size() - first < count)
        {
          row.push_back(j);
        }
      }
    });
}

Buffer<double> MeanAdjacentDistances(const NeighborGraph& adjacent, const Buffer<Vec3>& centroids,
  Execution& execution)
{
  Buffer<double> means(adjacent.NumberOfRows());
  execution.For(means.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t f = begin; f < end; ++f)
      {
        const DistanceSum sum = AdjacentDistances(adjacent, centroids, f);
        means[f] = sum.Count > 0 ? sum.Sum / static_cast<double>(sum.Count) : 0.0;
      }
    });
  return means;
}

double MeanAdjacentDistance(const NeighborGraph& adjacent, const Buffer<Vec3>& centroids,
  Execution& execution)
{
  const DistanceSum total = OrderedSum(execution, adjacent.NumberOfRows(), DistanceSum(),
    [&](std::size_t f) { return AdjacentDistances(adjacent, centroids, f); });
  return total.Count > 0 ? total.Sum / static_cast<double>(total.Count) : 0.0;
}

}
