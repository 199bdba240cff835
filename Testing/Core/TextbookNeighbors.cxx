// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextbookInternals.h"
#include "TextbookVectors.h"

#include <algorithm>
#include <set>

namespace Textbook
{

std::map<Edge, std::vector<int>> FacesOfEdges(const Mesh& mesh)
{
  std::map<Edge, std::vector<int>> faces;
  for (int f = 0; f < int(mesh.Faces.size()); ++f)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const int a = mesh.Faces[f][corner];
      const int b = mesh.Faces[f][(corner + 1) % 3];
      if (a != b)
      {
        faces[{ std::min(a, b), std::max(a, b) }].push_back(f);
      }
    }
  }
  return faces;
}

std::vector<std::vector<int>> FacesOfPoints(const Mesh& mesh)
{
  std::vector<std::vector<int>> faces(mesh.Points.size());
  for (int f = 0; f < int(mesh.Faces.size()); ++f)
  {
    for (const int v : mesh.Faces[f])
    {
      // A face that repeats a point is one face all the same.
      if (faces[v].empty() || faces[v].back() != f)
      {
        faces[v].push_back(f);
      }
    }
  }
  return faces;
}

namespace
{

Neighbors WithoutSelf(const std::vector<std::set<int>>& sets)
{
  Neighbors neighbors(sets.size());
  for (int f = 0; f < int(sets.size()); ++f)
  {
    for (const int g : sets[f])
    {
      if (g != f)
      {
        neighbors[f].push_back(g);
      }
    }
  }
  return neighbors;
}

Neighbors Grow(const Mesh& mesh, const Neighbors& connected, double radius)
{
  std::vector<std::set<int>> sets(mesh.Faces.size());
  for (int f = 0; f < int(sets.size()); ++f)
  {
    const Vector centre = Centroid(mesh, mesh.Faces[f]);
    std::vector<int> grown = { f };
    sets[f].insert(f);
    for (std::size_t next = 0; next < grown.size(); ++next)
    {
      for (const int g : connected[grown[next]])
      {
        if (sets[f].count(g) == 0 && Length(Centroid(mesh, mesh.Faces[g]) - centre) <= radius)
        {
          sets[f].insert(g);
          grown.push_back(g);
        }
      }
    }
  }
  return WithoutSelf(sets);
}

}

std::vector<std::vector<int>> Rings(const Mesh& mesh)
{
  std::vector<std::set<int>> sets(mesh.Points.size());
  for (const Face& face : mesh.Faces)
  {
    for (const int v : face)
    {
      sets[v].insert(face.begin(), face.end());
    }
  }
  return WithoutSelf(sets);
}

Neighbors FacesAtEdges(const Mesh& mesh)
{
  std::vector<std::set<int>> sets(mesh.Faces.size());
  for (const auto& edge : FacesOfEdges(mesh))
  {
    for (const int f : edge.second)
    {
      sets[f].insert(edge.second.begin(), edge.second.end());
    }
  }
  return WithoutSelf(sets);
}

Neighbors FacesAtPoints(const Mesh& mesh)
{
  const std::vector<std::vector<int>> facesOfPoint = FacesOfPoints(mesh);
  std::vector<std::set<int>> sets(mesh.Faces.size());
  for (std::size_t f = 0; f < sets.size(); ++f)
  {
    for (const int v : mesh.Faces[f])
    {
      sets[f].insert(facesOfPoint[v].begin(), facesOfPoint[v].end());
    }
  }
  return WithoutSelf(sets);
}

Neighbors FacesWithin(const Mesh& mesh, double radius)
{
  return Grow(mesh, FacesAtPoints(mesh), radius);
}

Neighbors FacesWithinAcrossEdges(const Mesh& mesh, double radius)
{
  return Grow(mesh, FacesAtEdges(mesh), radius);
}

std::vector<bool> BoundaryPoints(const Mesh& mesh)
{
  std::vector<bool> boundary(mesh.Points.size(), false);
  for (const auto& edge : FacesOfEdges(mesh))
  {
    if (edge.second.size() == 1)
    {
      boundary[edge.first.first] = true;
      boundary[edge.first.second] = true;
    }
  }
  return boundary;
}

std::vector<bool> MovingPoints(const Mesh& mesh)
{
  const std::vector<std::vector<int>> stars = FacesOfPoints(mesh);
  std::vector<bool> moves = BoundaryPoints(mesh);
  for (std::size_t v = 0; v < moves.size(); ++v)
  {
    moves[v] = !moves[v] && !stars[v].empty();
  }
  return moves;
}

double MeanEdgeLength(const Mesh& mesh)
{
  double sum = 0.0;
  const std::map<Edge, std::vector<int>> edges = FacesOfEdges(mesh);
  for (const auto& edge : edges)
  {
    sum += Length(mesh.Points[edge.first.first] - mesh.Points[edge.first.second]);
  }
  return edges.empty() ? 0.0 : sum / double(edges.size());
}

double MeanCentroidDistance(const Mesh& mesh)
{
  const Neighbors adjacent = FacesAtEdges(mesh);
  double sum = 0.0;
  int count = 0;
  for (std::size_t f = 0; f < adjacent.size(); ++f)
  {
    for (const int g : adjacent[f])
    {
      sum += Length(Centroid(mesh, mesh.Faces[f]) - Centroid(mesh, mesh.Faces[g]));
      ++count;
    }
  }
  return count > 0 ? sum / count : 0.0;
}

}
