// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ChainRisk.h"

#include "../Noise.h"
#include "ProgressShare.h"

#include <cmath>
#include <limits>

namespace SurfaceDenoising
{

namespace
{

/// b, the step of the derivative in deviations of the noise.
constexpr double Step = 0.3;
/// What a folded face costs, in mean square errors of the input.
constexpr double FoldCost = 4.0;

}

bool RunChain(TriangleMesh& mesh, const MethodChain& chain, Buffer<Vec3>& normals,
  MeshDenoisingReport& report, Execution& execution)
{
  for (std::size_t k = 0; k < chain.size(); ++k)
  {
    ProgressShare share(execution, double(k) / double(chain.size()),
      double(k + 1) / double(chain.size()));
    normals.clear();
    report = MeshDenoisingReport();
    if (!DenoiseMesh(mesh, normals, chain[k], report, share))
    {
      return false;
    }
  }
  return true;
}

ChainRisk::ChainRisk(const MeshSample& sample, double deviation, const MethodChain& pilot,
  Execution& execution)
  : Sample(sample)
  , Deviation(deviation)
{
  TriangleMesh smooth = sample.Mesh;
  Buffer<Vec3> normals;
  MeshDenoisingReport report;
  RunChain(smooth, pilot, normals, report, execution);

  const std::size_t faces = smooth.NumberOfFaces();
  const double edgeLength = report.MeanEdgeLength;
  this->Normals.resize(faces);
  this->Gradients.resize(faces);
  this->Traces.resize(faces);
  Buffer<Vec3> vertexNormals(smooth.NumberOfVertices(), Vec3(0.0, 0.0, 0.0));
  for (std::size_t f = 0; f < faces; ++f)
  {
    const Triangle& t = smooth.Triangles[f];
    const Vec3 area = smooth.DoubleAreaVector(f);
    this->Normals[f] = area.stableNormalized();
    this->Traces[f] = 0.0;
    double longest = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      vertexNormals[t[k]] += area;
      this->Gradients[f][k] = smooth.Positions[t[(k + 2) % 3]] - smooth.Positions[t[(k + 1) % 3]];
      longest = std::max(longest, this->Gradients[f][k].squaredNorm());
    }
    // Noise turns needles by any angle: theirs is not a small one.
    const double size = std::max(area.norm(), 0.1 * longest);
    const bool counts = sample.Inner[f] && !IsDegenerate(area, edgeLength);
    for (int k = 0; k < 3; ++k)
    {
      this->Gradients[f][k] = this->Normals[f].cross(this->Gradients[f][k]) / size;
      this->Traces[f] += counts ? this->Gradients[f][k].squaredNorm() : 0.0;
    }
  }

  this->Plus = sample.Mesh;
  this->Minus = sample.Mesh;
  NoiseParameters parameters;
  parameters.Deviation = Step * deviation;
  const NoiseSource noise(parameters, sample.Mesh.NumberOfVertices());
  for (std::size_t v = 0; v < sample.Mesh.NumberOfVertices(); ++v)
  {
    const Vec3 step = noise.Amplitude(sample.Keys[v]) * vertexNormals[v].stableNormalized();
    this->Plus.Positions[v] += step;
    this->Minus.Positions[v] -= step;
  }
}

Vec3 ChainRisk::Turn(const Buffer<Vec3>& to, const Buffer<Vec3>& from, std::size_t face) const
{
  const Triangle& t = this->Sample.Mesh.Triangles[face];
  Vec3 turn(0.0, 0.0, 0.0);
  for (int k = 0; k < 3; ++k)
  {
    turn += this->Normals[face].dot(to[t[k]] - from[t[k]]) * this->Gradients[face][k];
  }
  return turn;
}

double ChainRisk::Of(const MethodChain& chain, Execution& execution) const
{
  TriangleMesh plus = this->Plus;
  TriangleMesh minus = this->Minus;
  Buffer<Vec3> normals;
  MeshDenoisingReport report;
  ProgressShare first(execution, 0.0, 0.5);
  ProgressShare second(execution, 0.5, 1.0);
  if (!RunChain(plus, chain, normals, report, first) ||
    !RunChain(minus, chain, normals, report, second))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  // Sums of the risk, of faces, and of folded faces.
  const Vec3 sums = OrderedSum(execution, plus.NumberOfFaces(), Vec3(0.0, 0.0, 0.0),
    [&](std::size_t f) -> Vec3
    {
      const double noise = this->Deviation * this->Deviation * this->Traces[f];
      if (!(noise > 0.0))
      {
        return Vec3::Zero();
      }
      const double removed = 0.5 *
        (this->Turn(plus.Positions, this->Plus.Positions, f).squaredNorm() +
          this->Turn(minus.Positions, this->Minus.Positions, f).squaredNorm());
      const double kept = this->Turn(plus.Positions, minus.Positions, f)
                            .dot(this->Turn(this->Plus.Positions, this->Minus.Positions, f)) /
        (4.0 * Step * Step);
      const double folded = plus.DoubleAreaVector(f).dot(this->Normals[f]) < 0.0 ? 1.0 : 0.0;
      return Vec3((removed + 2.0 * kept) / noise - 1.0, 1.0, folded);
    });
  return sums[1] > 0.0 ? (sums[0] + FoldCost * sums[2]) / sums[1] : 0.0;
}

}
