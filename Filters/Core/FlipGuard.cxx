// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FlipGuard.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

constexpr double CosineOfSteepest = 0.17364817766693033; // 80 degrees
constexpr int HalvingRounds = 5;

/// Cosine between the normal of a face and its target, -1 for a face without area.
double Agreement(const Triangle& t, const Buffer<Vec3>& positions, const Vec3& target,
  double smallestArea)
{
  const Vec3 s = (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]);
  const double length = s.norm();
  return 0.5 * length < smallestArea ? -1.0 : s.dot(target) / length;
}

void SortAndUnite(std::vector<Index>& ids)
{
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

}

std::size_t PreventFlips(const TriangleMesh& topology, const CompressedRows& stars, double scale,
  const Buffer<Vec3>& targets, const Buffer<Vec3>& positions, Buffer<Vec3>& moved,
  Execution& execution)
{
  const double smallestArea = 1e-8 * scale * scale;
  auto fails = [&](std::size_t f)
  {
    const Triangle& t = topology.Triangles[f];
    const Vec3& target = targets[f];
    if (target.squaredNorm() == 0.0)
    {
      return false;
    }
    // Nearly all faces are fine, which shows without a root.
    const Vec3 s = (moved[t[1]] - moved[t[0]]).cross(moved[t[2]] - moved[t[0]]);
    const double cosine = s.dot(target);
    const double square = s.squaredNorm();
    if (cosine > 0.0 && cosine * cosine > 1.0001 * CosineOfSteepest * CosineOfSteepest * square &&
      square > 4.0001 * smallestArea * smallestArea)
    {
      return false;
    }
    const double now = Agreement(t, moved, target, smallestArea);
    return now < CosineOfSteepest && now < Agreement(t, positions, target, smallestArea);
  };

  // Few faces fail: after one pass over all, the rounds deal with lists.
  const CompressedRows failing = BuildRows(
    execution, (topology.NumberOfFaces() + 1023) / 1024,
    [&](std::size_t block, Buffer<Index>& found)
    {
      const std::size_t last = std::min(topology.NumberOfFaces(), (block + 1) * 1024);
      for (std::size_t f = block * 1024; f < last; ++f)
      {
        if (fails(f))
        {
          found.push_back(static_cast<Index>(f));
        }
      }
    },
    4);

  std::vector<Index> faces(failing.Ids.begin(), failing.Ids.end());
  std::vector<Index> guarded;
  for (int round = 0; !faces.empty(); ++round)
  {
    std::vector<Index> vertices;
    for (const Index f : faces)
    {
      const Triangle& t = topology.Triangles[f];
      vertices.insert(vertices.end(), t.begin(), t.end());
    }
    SortAndUnite(vertices);
    guarded.insert(guarded.end(), vertices.begin(), vertices.end());

    faces.clear();
    for (const Index v : vertices)
    {
      moved[v] = round < HalvingRounds ? Vec3(0.5 * (positions[v] + moved[v])) : positions[v];
      faces.insert(faces.end(), stars.Row(v).begin(), stars.Row(v).end());
    }
    SortAndUnite(faces);
    faces.erase(std::remove_if(faces.begin(), faces.end(), [&](Index f) { return !fails(f); }),
      faces.end());
  }
  SortAndUnite(guarded);
  return guarded.size();
}

}
