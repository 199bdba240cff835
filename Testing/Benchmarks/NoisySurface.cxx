// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NoisySurface.h"

#include "Noise.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkOFFReader.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <numeric>
#include <random>

using namespace SurfaceDenoising;

TriangleMesh ReadMesh(const char* file)
{
  TriangleMesh mesh;
  vtkNew<vtkOFFReader> reader;
  reader->SetFileName(file);
  reader->Update();
  vtkPolyData* surface = reader->GetOutput();
  for (vtkIdType v = 0; v < surface->GetNumberOfPoints(); ++v)
  {
    mesh.Positions.push_back(Vec3(surface->GetPoint(v)));
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType f = 0; f < surface->GetNumberOfCells(); ++f)
  {
    surface->GetCellPoints(f, ids);
    if (ids->GetNumberOfIds() != 3)
    {
      mesh = TriangleMesh();
      break;
    }
    mesh.Triangles.push_back({ Index(ids->GetId(0)), Index(ids->GetId(1)), Index(ids->GetId(2)) });
  }
  if (mesh.NumberOfFaces() == 0)
  {
    std::fprintf(stderr, "%s is no surface of triangles that can be read.\n", file);
  }
  return mesh;
}

TriangleMesh CleanMesh()
{
  const char* file = std::getenv("SURFACE_DENOISING_BENCHMARK_MESH");
  return file ? ReadMesh(file) : TriangleMesh();
}

TriangleMesh Subdivide(const TriangleMesh& coarse, int k)
{
  TriangleMesh fine;
  fine.Positions = coarse.Positions;
  std::map<std::pair<Index, Index>, Index> firstOnEdge;
  // Point step of k on the way from a to b.
  auto onEdge = [&](Index a, Index b, int step)
  {
    if (a > b)
    {
      std::swap(a, b);
      step = k - step;
    }
    const auto entry = firstOnEdge.insert({ { a, b }, Index(fine.NumberOfVertices()) });
    for (int s = 1; entry.second && s < k; ++s)
    {
      const double t = double(s) / k;
      fine.Positions.push_back((1.0 - t) * coarse.Positions[a] + t * coarse.Positions[b]);
    }
    return entry.first->second + Index(step) - 1;
  };
  for (const Triangle& t : coarse.Triangles)
  {
    // at(i, j): i steps towards the second corner and j towards the third.
    std::vector<Index> lattice;
    for (int i = 0; i <= k; ++i)
    {
      for (int j = 0; i + j <= k; ++j)
      {
        Index v;
        if (i == k || j == k || i + j == 0)
        {
          v = i == k ? t[1] : (j == k ? t[2] : t[0]);
        }
        else if (i == 0 || j == 0 || i + j == k)
        {
          v = j == 0 ? onEdge(t[0], t[1], i)
                     : (i == 0 ? onEdge(t[0], t[2], j) : onEdge(t[1], t[2], j));
        }
        else
        {
          v = Index(fine.NumberOfVertices());
          fine.Positions.push_back(
            (double(k - i - j) * coarse.Positions[t[0]] + double(i) * coarse.Positions[t[1]] +
              double(j) * coarse.Positions[t[2]]) /
            double(k));
        }
        lattice.push_back(v);
      }
    }
    auto at = [&lattice, k](int i, int j) { return lattice[i * (k + 1) - i * (i - 1) / 2 + j]; };
    for (int i = 0; i < k; ++i)
    {
      for (int j = 0; i + j < k; ++j)
      {
        fine.Triangles.push_back({ at(i, j), at(i + 1, j), at(i, j + 1) });
        if (i + j + 1 < k)
        {
          fine.Triangles.push_back({ at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) });
        }
      }
    }
  }
  return fine;
}

namespace
{

void Shuffle(TriangleMesh& mesh)
{
  std::mt19937 random(1);
  std::vector<Index> place(mesh.NumberOfVertices());
  std::iota(place.begin(), place.end(), Index(0));
  std::shuffle(place.begin(), place.end(), random);
  Buffer<Vec3> positions(place.size());
  for (std::size_t v = 0; v < place.size(); ++v)
  {
    positions[place[v]] = mesh.Positions[v];
  }
  mesh.Positions.swap(positions);
  for (Triangle& t : mesh.Triangles)
  {
    t = { place[t[0]], place[t[1]], place[t[2]] };
  }
  std::shuffle(mesh.Triangles.begin(), mesh.Triangles.end(), random);
}

}

TriangleMesh NoisyMesh(int k, bool shuffled)
{
  TriangleMesh mesh = Subdivide(CleanMesh(), k);
  Execution serial;
  const double edge = TakeEdgeCensus(mesh, VertexStars(mesh), serial).MeanEdgeLength;
  NoiseParameters parameters;
  parameters.Deviation = 0.2 * edge;
  const NoiseSource noise(parameters, mesh.NumberOfVertices());
  for (std::size_t v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    mesh.Positions[v] += noise.Amplitude(v) * noise.Direction(v);
  }
  if (shuffled)
  {
    Shuffle(mesh);
  }
  return mesh;
}

vtkSmartPointer<vtkPolyData> ToPolyData(const TriangleMesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.NumberOfVertices()));
  for (std::size_t v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    points->SetPoint(static_cast<vtkIdType>(v), mesh.Positions[v].data());
  }
  vtkNew<vtkCellArray> polys;
  polys->AllocateExact(static_cast<vtkIdType>(mesh.NumberOfFaces()),
    static_cast<vtkIdType>(3 * mesh.NumberOfFaces()));
  for (const Triangle& t : mesh.Triangles)
  {
    polys->InsertNextCell({ vtkIdType(t[0]), vtkIdType(t[1]), vtkIdType(t[2]) });
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(polys);
  return surface;
}
