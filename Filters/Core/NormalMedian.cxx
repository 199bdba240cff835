// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NormalMedian.h"

#include "Vectorize.h"

#include <atomic>

namespace SurfaceDenoising
{

namespace
{

/// Normals side by side, one array per coordinate, for loops over pairs.
class Candidates
{
public:
  void Gather(const NeighborGraph& graph, const Buffer<Vec3>& normals, std::size_t i,
    bool unoriented = false)
  {
    this->X.clear();
    this->Y.clear();
    this->Z.clear();
    this->Add(normals[i]);
    for (const Index j : graph.Row(i))
    {
      const Vec3& n = normals[j];
      this->Add(unoriented && n.dot(normals[i]) < 0.0 ? Vec3(-n) : n);
    }
  }

  /// The candidate with the least sum of angles, zero without candidates.
  Vec3 DirectionalMedian()
  {
    const std::size_t count = this->X.size();
    if (count == 0)
    {
      return Vec3(0.0, 0.0, 0.0);
    }
    this->Sums.assign(count, 0.0);
    this->Angles.resize(count);
    for (std::size_t a = 0; a + 1 < count; ++a)
    {
      AddAngles(a, count, this->X.data(), this->Y.data(), this->Z.data(), this->Angles.data(),
        this->Sums.data());
    }
    const std::size_t best = static_cast<std::size_t>(
      std::min_element(this->Sums.begin(), this->Sums.end()) - this->Sums.begin());
    return Vec3(this->X[best], this->Y[best], this->Z[best]);
  }

private:
  void Add(const Vec3& n)
  {
    if (!n.isZero(0.0))
    {
      this->X.push_back(n[0]);
      this->Y.push_back(n[1]);
      this->Z.push_back(n[2]);
    }
  }

  /// The angles between candidate a and all after it go to the sums of both.
  SURFACEDENOISING_VECTORIZED
  static void AddAngles(std::size_t a, std::size_t count, const double* xs, const double* ys,
    const double* zs, double* angles, double* sums)
  {
    const double x = xs[a];
    const double y = ys[a];
    const double z = zs[a];
    for (std::size_t b = a + 1; b < count; ++b)
    {
      const double dx = xs[b] - x;
      const double dy = ys[b] - y;
      const double dz = zs[b] - z;
      angles[b] = AngleOfSquaredChord(dx * dx + dy * dy + dz * dz);
    }
    double sum = sums[a];
    for (std::size_t b = a + 1; b < count; ++b)
    {
      sums[b] += angles[b];
      sum += angles[b];
    }
    sums[a] = sum;
  }

  Buffer<double> X;
  Buffer<double> Y;
  Buffer<double> Z;
  Buffer<double> Angles;
  Buffer<double> Sums;
};

bool ShareEdge(const Triangle& s, const Triangle& t)
{
  const bool first = HasCorner(t, s[0]);
  const bool second = s[1] != s[0] && HasCorner(t, s[1]);
  const bool third = s[2] != s[0] && s[2] != s[1] && HasCorner(t, s[2]);
  return first + second + third >= 2;
}

}

void DirectionalMedians(const NeighborGraph& graph, const Buffer<Vec3>& normals,
  Buffer<Vec3>& medians, Execution& execution, bool unoriented)
{
  medians.resize(normals.size());
  execution.For(normals.size(),
    [&](std::size_t begin, std::size_t end)
    {
      Candidates candidates;
      for (std::size_t i = begin; i < end; ++i)
      {
        candidates.Gather(graph, normals, i, unoriented);
        medians[i] = candidates.DirectionalMedian();
      }
    });
}

std::size_t AngularMedians(const NeighborGraph& graph, const TriangleMesh& mesh,
  const MedianRepetitions& repetitions, const Buffer<Vec3>& normals, Buffer<Vec3>& medians,
  Execution& execution)
{
  medians.resize(normals.size());
  std::atomic<std::size_t> kept{ 0 };
  execution.For(normals.size(),
    [&](std::size_t begin, std::size_t end)
    {
      Candidates candidates;
      std::vector<std::pair<double, Index>> sorted; // squared chords grow with angles
      for (std::size_t i = begin; i < end; ++i)
      {
        const Vec3& own = normals[i];
        medians[i] = own;
        if (own.isZero(0.0))
        {
          candidates.Gather(graph, normals, i);
          medians[i] = candidates.DirectionalMedian();
          kept += medians[i].isZero(0.0);
          continue;
        }
        sorted.clear();
        // Wide enough for any number of repetitions.
        std::int64_t total = 0;
        auto repetitionsOf = [&](Index j)
        {
          return ShareEdge(mesh.Triangles[i], mesh.Triangles[j]) ? repetitions.EdgeAdjacent
                                                                 : repetitions.Other;
        };
        for (const Index j : graph.Row(i))
        {
          if (!normals[j].isZero(0.0))
          {
            sorted.emplace_back((normals[j] - own).squaredNorm(), j);
            total += repetitionsOf(j);
          }
        }
        if (total == 0)
        {
          ++kept;
          continue;
        }
        std::sort(sorted.begin(), sorted.end());
        std::int64_t passed = 0;
        for (const auto& candidate : sorted)
        {
          passed += repetitionsOf(candidate.second);
          if (passed > (total - 1) / 2)
          {
            medians[i] = normals[candidate.second];
            break;
          }
        }
      }
    });
  return kept;
}

}
