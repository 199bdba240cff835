// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceChange.h"

#include "../Metrics.h"

#include <cmath>
#include <limits>

namespace SurfaceDenoising
{

namespace
{

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

void SummarizeDisplacements(const Buffer<double>& lengths, SurfaceChange& change,
  Execution& execution)
{
  const Statistics statistics = Summarize(lengths, lengths, execution);
  if (statistics.Count > 0)
  {
    change.MeanDisplacement = statistics.Mean;
    change.RootMeanSquareDisplacement = statistics.RootMeanSquare;
    change.MaximumDisplacement = statistics.Maximum;
  }
}

}

SurfaceChange MeasureChange(const Buffer<Vec3>& after, const Buffer<Vec3>& before, double unit,
  Execution& execution)
{
  SurfaceChange change;
  change.VolumeChange = NotANumber;
  Buffer<double> lengths(after.size());
  for (std::size_t i = 0; i < after.size(); ++i)
  {
    lengths[i] = (after[i] - before[i]).norm() / unit;
  }
  SummarizeDisplacements(lengths, change, execution);
  return change;
}

SurfaceChange MeasureChange(const TriangleMesh& after, const Buffer<Vec3>& before, double unit,
  double angle, Execution& execution)
{
  SurfaceChange change;
  change.VolumeChange = NotANumber;
  const TriangleMesh mesh{ before, after.Triangles };
  const CompressedRows stars = VertexStars(mesh);
  Buffer<double> lengths;
  lengths.reserve(before.size());
  for (std::size_t v = 0; v < before.size(); ++v)
  {
    if (stars.Row(v).size() > 0)
    {
      lengths.push_back((after.Positions[v] - before[v]).norm() / unit);
    }
  }
  SummarizeDisplacements(lengths, change, execution);

  const EdgeCensus census = TakeEdgeCensus(mesh, stars, execution);
  const double volume = IsClosed(census) ? SignedVolume(mesh, execution) : 0.0;
  if (volume != 0.0)
  {
    change.VolumeChange = (SignedVolume(after, execution) - volume) / std::abs(volume);
  }

  FaceGeometry geometry;
  FaceGeometry geometryAfter;
  ComputeFaceGeometry(mesh, census.MeanEdgeLength, geometry, execution);
  ComputeFaceGeometry(after, census.MeanEdgeLength, geometryAfter, execution);
  for (std::size_t f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    change.FlippedFaces += geometry.Normals[f].dot(geometryAfter.Normals[f]) < 0.0 ? 1 : 0;
  }
  const FeatureAgreement features = CompareFeatureEdges(EdgeAdjacentFaces(mesh, stars, execution),
    geometryAfter.Normals, geometry.Normals, angle, execution);
  change.FeatureEdgesBefore = features.Reference;
  change.FeatureEdgesKept = features.Found;
  change.FeatureEdgesAfter = features.Found + features.Invented;
  return change;
}

}
