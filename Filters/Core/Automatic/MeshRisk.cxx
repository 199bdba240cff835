// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshRisk.h"

#include "../Noise.h"
#include "ProgressShare.h"
#include "TrialSample.h"

#include <cmath>
#include <limits>

namespace SurfaceDenoising
{

namespace
{

/// b, the step of the derivative in deviations of the noise.
constexpr double Step = 0.3;
/// What a folded face costs, in mean square errors of the input.
constexpr double FoldCost = 0.5;
/// What it costs if the faces of flat groups do not lie in line with their neighbours.
constexpr double RoughnessCost = 1.0;
/// Risks that differ by less are the same.
constexpr double Softening = 0.003;

}

MeshRisk::MeshRisk(const MeshSample& sample, const MethodChain& pilot, Execution& execution)
  : Sample(sample)
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

  this->Group(vertexNormals);
  this->Adjacent = EdgeAdjacentFaces(sample.Mesh, VertexStars(sample.Mesh), execution);
}

void MeshRisk::Group(const Buffer<Vec3>& vertexNormals)
{
  this->VertexNormals.resize(vertexNormals.size());
  for (std::size_t v = 0; v < vertexNormals.size(); ++v)
  {
    this->VertexNormals[v] = vertexNormals[v].stableNormalized();
  }
  const TriangleMesh& mesh = this->Sample.Mesh;
  Buffer<Index> order;
  Buffer<double> bends(mesh.NumberOfFaces());
  std::size_t folded = 0;
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    bends[f] = 0.0;
    for (const Index v : mesh.Triangles[f])
    {
      bends[f] += (this->Normals[f] - this->VertexNormals[v]).squaredNorm();
    }
    if (this->Traces[f] > 0.0)
    {
      order.push_back(static_cast<Index>(f));
      folded += mesh.DoubleAreaVector(f).dot(this->Normals[f]) < 0.0 ? 1 : 0;
    }
  }
  this->Folded = order.empty() ? 0.0 : double(folded) / double(order.size());
  std::sort(order.begin(), order.end(),
    [&](Index a, Index b) { return bends[a] < bends[b] || (bends[a] == bends[b] && a < b); });
  this->Groups.resize(RiskGroups);
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    this->Groups[k * RiskGroups / order.size()].push_back(order[k]);
  }
}

void MeshRisk::Assume(double deviation, Execution& execution)
{
  this->Deviation = deviation;
  this->Plus = this->Sample.Mesh;
  this->Minus = this->Sample.Mesh;
  NoiseParameters parameters;
  parameters.Deviation = Step * deviation;
  const NoiseSource noise(parameters, this->Sample.Mesh.NumberOfVertices());
  for (std::size_t v = 0; v < this->VertexNormals.size(); ++v)
  {
    const Vec3 step = noise.Amplitude(this->Sample.Keys[v]) * this->VertexNormals[v];
    this->Plus.Positions[v] += step;
    this->Minus.Positions[v] -= step;
  }
  this->RoughnessBefore = this->RoughnessOf(this->Plus, execution);
}

/// Mean square difference between the normals of the faces of the flat groups and those of their
/// neighbours.
MeshRisk::FlatRoughness MeshRisk::RoughnessOf(const TriangleMesh& mesh, Execution& execution) const
{
  const Buffer<Vec3> normals = FaceNormals(mesh, execution);
  FlatRoughness roughness;
  for (std::size_t g = 0; g < FlatGroups; ++g)
  {
    const Buffer<Index>& faces = this->Groups[g];
    const double sum = OrderedSum(execution, faces.size(), 0.0,
      [&](std::size_t k)
      {
        double squares = 0.0;
        const Span<Index> row = this->Adjacent.Row(faces[k]);
        for (const Index f : row)
        {
          squares += (normals[f] - normals[faces[k]]).squaredNorm();
        }
        return row.size() > 0 ? squares / double(row.size()) : 0.0;
      });
    roughness[g] = faces.empty() ? 0.0 : sum / double(faces.size());
  }
  return roughness;
}

Vec3 MeshRisk::Turn(const Buffer<Vec3>& to, const Buffer<Vec3>& from, std::size_t face) const
{
  const Triangle& t = this->Sample.Mesh.Triangles[face];
  Vec3 turn(0.0, 0.0, 0.0);
  for (int k = 0; k < 3; ++k)
  {
    turn += this->Normals[face].dot(to[t[k]] - from[t[k]]) * this->Gradients[face][k];
  }
  return turn;
}

bool MeshRisk::Of(const MeshOperation& operation, GroupRisks& risks, Execution& execution)
{
  TriangleMesh plus = this->Plus;
  TriangleMesh minus = this->Minus;
  ProgressShare first(execution, 0.0, 0.5);
  ProgressShare second(execution, 0.5, 1.0);
  if (!operation(plus, first) || !operation(minus, second))
  {
    return false;
  }
  const FlatRoughness roughness = this->RoughnessOf(plus, execution);
  for (std::size_t g = 0; g < RiskGroups; ++g)
  {
    const Buffer<Index>& group = this->Groups[g];
    const double removed = OrderedSum(execution, group.size(), 0.0,
      [&](std::size_t k)
      {
        const Index f = group[k];
        const double noise = this->Deviation * this->Deviation * this->Traces[f];
        return 0.5 *
          (this->Turn(plus.Positions, this->Plus.Positions, f).squaredNorm() +
            this->Turn(minus.Positions, this->Minus.Positions, f).squaredNorm()) /
          noise;
      });
    const double sum = removed +
      OrderedSum(execution, group.size(), 0.0,
        [&](std::size_t k)
        {
          const Index f = group[k];
          const double noise = this->Deviation * this->Deviation * this->Traces[f];
          const double kept = this->Turn(plus.Positions, minus.Positions, f)
                                .dot(this->Turn(this->Plus.Positions, this->Minus.Positions, f)) /
            (4.0 * Step * Step);
          const double folded = plus.DoubleAreaVector(f).dot(this->Normals[f]) < 0.0 ? 1.0 : 0.0;
          return 2.0 * kept / noise - 1.0 + FoldCost * folded;
        });
    risks[g] = group.empty() ? 0.0 : sum / double(group.size());
    if (g<FlatGroups&& this->RoughnessBefore[g]> 0.0)
    {
      risks[g] += RoughnessCost * roughness[g] / this->RoughnessBefore[g];
    }
  }
  return true;
}

std::vector<double> CompareRisks(const std::vector<GroupRisks>& risks)
{
  std::vector<double> sums(risks.size(), 0.0);
  for (std::size_t g = 0; g < RiskGroups; ++g)
  {
    double least = std::numeric_limits<double>::infinity();
    for (const GroupRisks& risk : risks)
    {
      least = std::min(least, risk[g]);
    }
    for (std::size_t k = 0; k < risks.size(); ++k)
    {
      sums[k] += std::sqrt(risks[k][g] - least + Softening);
    }
  }
  return sums;
}

}
