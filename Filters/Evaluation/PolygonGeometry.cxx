// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PolygonGeometry.h"

#include "vtkPolyData.h"

#include <algorithm>

namespace SurfaceDenoising
{

namespace
{

using Edge = std::pair<Index, Index>;

/**
 * Calls use(first, last) for the faces [first, last) of every polygon. The triangles of a strip are
 * polygons of their own.
 */
template <typename Use>
void ForPolygons(vtkPolyData* surface, const MeshView& view, Use use)
{
  const std::size_t faces = view.Mesh.NumberOfFaces();
  const vtkIdType firstStrip = view.FirstCell + surface->GetNumberOfPolys();
  for (std::size_t first = 0; first < faces;)
  {
    const vtkIdType cell = view.CellOfFace(first);
    std::size_t last = first + 1;
    while (cell < firstStrip && last < faces && view.CellOfFace(last) == cell)
    {
      ++last;
    }
    use(first, last);
    first = last;
  }
}

/// Sorts the edges and removes repetitions; with dropRepeated, also the edge that is repeated.
void Unrepeat(std::vector<Edge>& edges, bool dropRepeated)
{
  std::sort(edges.begin(), edges.end());
  auto kept = edges.begin();
  for (auto run = edges.begin(); run != edges.end();)
  {
    const auto next =
      std::find_if(run, edges.end(), [&run](const Edge& edge) { return edge != *run; });
    if (!dropRepeated || next - run == 1)
    {
      *kept++ = *run;
    }
    run = next;
  }
  edges.erase(kept, edges.end());
}

}

double MeanPolygonEdgeLength(vtkPolyData* surface, const MeshView& view, Execution& execution)
{
  const TriangleMesh& mesh = view.Mesh;
  if (view.FaceCell.empty()) // triangles only
  {
    return TakeEdgeCensus(mesh, VertexStars(mesh), execution).MeanEdgeLength;
  }

  std::vector<Edge> edges;
  std::vector<Edge> own;
  ForPolygons(surface, view,
    [&](std::size_t first, std::size_t last)
    {
      own.clear();
      for (std::size_t f = first; f < last; ++f)
      {
        const Triangle& t = mesh.Triangles[f];
        for (int corner = 0; corner < 3; ++corner)
        {
          const Edge edge = std::minmax({ t[corner], t[(corner + 1) % 3] });
          if (edge.first != edge.second)
          {
            own.push_back(edge);
          }
        }
      }
      Unrepeat(own, true); // diagonals belong to two triangles of the polygon
      edges.insert(edges.end(), own.begin(), own.end());
    });
  Unrepeat(edges, false);
  double sum = 0.0;
  for (const Edge& edge : edges)
  {
    sum += (mesh.Positions[edge.first] - mesh.Positions[edge.second]).norm();
  }
  return edges.empty() ? 0.0 : sum / static_cast<double>(edges.size());
}

Buffer<Vec3> VertexNormals(vtkPolyData* surface, const MeshView& view, double scale)
{
  const TriangleMesh& mesh = view.Mesh;
  Buffer<Vec3> normals;
  normals.assign(mesh.NumberOfVertices(), Vec3(0.0, 0.0, 0.0));
  std::vector<Index> corners;
  ForPolygons(surface, view,
    [&](std::size_t first, std::size_t last)
    {
      // The area vectors of the triangles add up to that of the polygon, however it was cut.
      Vec3 area(0.0, 0.0, 0.0);
      corners.clear();
      for (std::size_t f = first; f < last; ++f)
      {
        area += mesh.DoubleAreaVector(f);
        corners.insert(corners.end(), mesh.Triangles[f].begin(), mesh.Triangles[f].end());
      }
      std::sort(corners.begin(), corners.end());
      corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
      for (const Index v : corners)
      {
        normals[v] += area;
      }
    });
  for (Vec3& normal : normals)
  {
    const double length = normal.norm();
    normal = length > 1e-12 * scale * scale ? Vec3(normal / length) : Vec3(0.0, 0.0, 0.0);
  }
  return normals;
}

}
