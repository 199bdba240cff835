// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PatchGuidance.h"

#include "Vectorize.h"

#include <cmath>
#include <limits>

namespace SurfaceDenoising
{

namespace
{

/// The largest of the squared chords between n vectors.
SURFACEDENOISING_VECTORIZED
double LargestSquaredChord(const double* x, const double* y, const double* z, std::size_t n)
{
  double largest = 0.0;
  for (std::size_t a = 0; a + 1 < n; ++a)
  {
    for (std::size_t b = a + 1; b < n; ++b)
    {
      const double dx = x[b] - x[a];
      const double dy = y[b] - y[a];
      const double dz = z[b] - z[a];
      const double square = dx * dx + dy * dy + dz * dz;
      largest = square > largest ? square : largest;
    }
  }
  return largest;
}

bool ShareVertex(const Triangle& s, const Triangle& t)
{
  return HasCorner(t, s[0]) || HasCorner(t, s[1]) || HasCorner(t, s[2]);
}

}

PatchGuidance::PatchGuidance(const TriangleMesh& mesh, const NeighborGraph& edgeAdjacent,
  const NeighborGraph& vertexSharing, Execution& execution)
  : Members(vertexSharing)
  , Adjacent(edgeAdjacent)
{
  this->InnerEdges = BuildRows(execution, mesh.NumberOfFaces(),
    [&](std::size_t f, Buffer<Index>& row)
    {
      const Triangle& patch = mesh.Triangles[f];
      auto add = [&](Index a)
      {
        for (std::uint64_t p = this->Adjacent.Offsets[a]; p < this->Adjacent.Offsets[a + 1]; ++p)
        {
          const Index b = this->Adjacent.Ids[p];
          if (a < b && ShareVertex(mesh.Triangles[b], patch))
          {
            row.push_back(static_cast<Index>(p));
          }
        }
      };
      add(static_cast<Index>(f));
      for (const Index a : vertexSharing.Row(f))
      {
        add(a);
      }
    });
}

void PatchGuidance::Compute(const Buffer<Vec3>& normals, const Buffer<double>& areas,
  Buffer<Vec3>& guidance, Execution& execution)
{
  const std::size_t faces = normals.size();
  const double infinity = std::numeric_limits<double>::infinity();
  this->EdgeChords.resize(this->Adjacent.NumberOfIds());
  this->Inconsistency.resize(faces);
  this->PatchNormals.resize(faces);
  guidance.resize(faces);

  execution.For(faces,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t f = begin; f < end; ++f)
      {
        for (std::uint64_t p = this->Adjacent.Offsets[f]; p < this->Adjacent.Offsets[f + 1]; ++p)
        {
          const Vec3& other = normals[this->Adjacent.Ids[p]];
          const bool counts = !normals[f].isZero(0.0) && !other.isZero(0.0);
          this->EdgeChords[p] = counts ? (normals[f] - other).norm() : -1.0;
        }
      }
    });

  execution.For(faces,
    [&](std::size_t begin, std::size_t end)
    {
      Buffer<double> x;
      Buffer<double> y;
      Buffer<double> z;
      for (std::size_t f = begin; f < end; ++f)
      {
        x.clear();
        y.clear();
        z.clear();
        Vec3 sum(0.0, 0.0, 0.0);
        double area = 0.0;
        auto add = [&](std::size_t a)
        {
          const Vec3& n = normals[a];
          if (!n.isZero(0.0))
          {
            x.push_back(n[0]);
            y.push_back(n[1]);
            z.push_back(n[2]);
            sum += areas[a] * n;
            area += areas[a];
          }
        };
        add(f);
        for (const Index a : this->Members.Row(f))
        {
          add(a);
        }

        const double range = std::sqrt(LargestSquaredChord(x.data(), y.data(), z.data(), x.size()));
        double sharpest = -1.0;
        double total = 0.0;
        for (const Index edge : this->InnerEdges.Row(f))
        {
          sharpest = std::max(sharpest, this->EdgeChords[edge]);
          total += std::max(0.0, this->EdgeChords[edge]);
        }
        const double saliency = sharpest >= 0.0 ? sharpest / (1e-9 + total) : 1.0;
        const double length = sum.norm();
        const bool valid = x.size() >= 2 && length > 1e-12 * area;
        this->Inconsistency[f] = valid ? range * saliency : infinity;
        this->PatchNormals[f] = valid ? Vec3(sum / length) : normals[f];
      }
    });

  execution.For(faces,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t f = begin; f < end; ++f)
      {
        std::size_t best = f;
        for (const Index candidate : this->Members.Row(f))
        {
          best = this->Inconsistency[candidate] < this->Inconsistency[best] ? candidate : best;
        }
        guidance[f] = this->Inconsistency[best] < infinity ? this->PatchNormals[best] : normals[f];
      }
    });
}

}
