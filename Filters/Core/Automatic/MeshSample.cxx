// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshSample.h"

#include "OutwardOrder.h"

namespace SurfaceDenoising
{

namespace
{

constexpr std::size_t Patches = 6;
/// Of the faces of a patch, those that count: a chain of filters sees some ten rings far.
constexpr double InnerShare = 0.6;

/// The distances of all face centroids from a place, squared.
Buffer<double> FaceDistances(const TriangleMesh& mesh, const Vec3& from, Execution& execution)
{
  Buffer<double> distances(mesh.NumberOfFaces());
  execution.For(distances.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t f = begin; f < end; ++f)
      {
        distances[f] = (mesh.Centroid(f) - from).squaredNorm();
      }
    });
  return distances;
}

}

Vec3 MiddleOf(const TriangleMesh& mesh, Execution& execution)
{
  Buffer<unsigned char> used(mesh.NumberOfVertices(), 0);
  for (const Triangle& triangle : mesh.Triangles)
  {
    for (const Index v : triangle)
    {
      used[v] = 1;
    }
  }
  const Vec3 nowhere = Vec3::Zero();
  const Vec3 sum = OrderedSum(execution, used.size(), nowhere,
    [&](std::size_t v) -> const Vec3& { return used[v] ? mesh.Positions[v] : nowhere; });
  const auto count = std::count(used.begin(), used.end(), static_cast<unsigned char>(1));
  return sum / std::max(1.0, double(count));
}

MeshSample TakeSample(const TriangleMesh& mesh, std::size_t faces, Execution& execution)
{
  MeshSample sample;
  const Vec3 middle = MiddleOf(mesh, execution);
  sample.Middle = middle;
  Buffer<unsigned char> chosen(mesh.NumberOfFaces(), 1); // 0: not there, 1: inner, 2: near a rim
  if (mesh.NumberOfFaces() > faces)
  {
    std::fill(chosen.begin(), chosen.end(), static_cast<unsigned char>(0));
    const Buffer<Index> outwards = OrderBy(FaceDistances(mesh, middle, execution));
    const std::size_t size = std::max<std::size_t>(1, faces / Patches);
    for (std::size_t p = 0; p < Patches; ++p)
    {
      const Index centre = outwards[mesh.NumberOfFaces() * (2 * p + 1) / (2 * Patches)];
      const Buffer<double> distances = FaceDistances(mesh, mesh.Centroid(centre), execution);
      Buffer<double> sorted = distances;
      const auto nth = [&](std::size_t n)
      {
        std::nth_element(sorted.begin(), sorted.begin() + std::ptrdiff_t(n), sorted.end());
        return sorted[n];
      };
      const double rim = nth(size);
      const double inner = nth(std::size_t(InnerShare * double(size)));
      for (std::size_t f = 0; f < chosen.size(); ++f)
      {
        if (distances[f] < inner)
        {
          chosen[f] = 1;
        }
        else if (distances[f] < rim && chosen[f] == 0)
        {
          chosen[f] = 2;
        }
      }
    }
  }
  Buffer<Index> place(mesh.NumberOfVertices(), NoIndex);
  Buffer<double> distances;
  for (std::size_t f = 0; f < chosen.size(); ++f)
  {
    if (chosen[f] == 0)
    {
      continue;
    }
    Triangle t = mesh.Triangles[f];
    for (Index& v : t)
    {
      if (place[v] == NoIndex)
      {
        place[v] = static_cast<Index>(sample.Mesh.NumberOfVertices());
        sample.Mesh.Positions.push_back(mesh.Positions[v]);
        distances.push_back((mesh.Positions[v] - middle).squaredNorm());
      }
      v = place[v];
    }
    sample.Mesh.Triangles.push_back(t);
    sample.Inner.push_back(chosen[f] == 1 ? 1 : 0);
  }
  const Buffer<Index> outwards = OrderBy(distances);
  sample.Keys.resize(outwards.size());
  for (std::size_t k = 0; k < outwards.size(); ++k)
  {
    sample.Keys[outwards[k]] = static_cast<Index>(k);
  }
  return sample;
}

}
