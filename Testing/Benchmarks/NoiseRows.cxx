// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NoiseRows.h"

using namespace SurfaceDenoising;

namespace
{

constexpr double ImpulsiveFraction = 0.2;

}

const std::vector<NoiseRow>& NoiseRows()
{
  static const std::vector<NoiseRow> rows = {
    { "normals", NoiseKind::Gaussian, 0.1, true },
    { "normals", NoiseKind::Gaussian, 0.2, true },
    { "normals", NoiseKind::Gaussian, 0.3, true },
    { "normals", NoiseKind::Gaussian, 0.5, true },
    { "normals", NoiseKind::Gaussian, 0.7, true },
    { "directions", NoiseKind::Gaussian, 0.1, false },
    { "directions", NoiseKind::Gaussian, 0.3, false },
    { "directions", NoiseKind::Gaussian, 0.7, false },
    { "impulses, normals", NoiseKind::Impulsive, 0.5, true },
    { "impulses, directions", NoiseKind::Impulsive, 0.5, false },
  };
  return rows;
}

TriangleMesh WithNoise(const TriangleMesh& clean, const NoiseRow& row)
{
  Execution serial;
  const CompressedRows stars = VertexStars(clean);
  const double edgeLength = TakeEdgeCensus(clean, stars, serial).MeanEdgeLength;
  NoiseParameters parameters;
  parameters.Kind = row.Kind;
  parameters.Deviation = row.Deviation * edgeLength;
  parameters.Fraction = ImpulsiveFraction;
  const NoiseSource noise(parameters, clean.NumberOfVertices());
  const Buffer<Vec3> normals = VertexAreaVectors(clean, stars, serial);
  TriangleMesh mesh = clean;
  for (std::size_t v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    mesh.Positions[v] += noise.Amplitude(v) *
      (row.AlongNormals ? Vec3(normals[v].stableNormalized()) : noise.Direction(v));
  }
  return mesh;
}
