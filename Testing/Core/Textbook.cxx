// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextbookVectors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Textbook
{

double Weight(Norm norm, double scale, double x)
{
  const double delta = 0.05; // below it truncated L1 grows no more
  switch (norm)
  {
    case Norm::L2:
      return 1.0;
    case Norm::TruncatedL2:
      return x <= scale ? 1.0 : 0.0;
    case Norm::L1:
      return 1.0 / std::max(x, scale);
    case Norm::TruncatedL1:
      return x <= scale ? 1.0 / std::max(x, std::min(delta, scale)) : 0.0;
    case Norm::Huber:
      return x <= scale ? 1.0 : scale / x;
    case Norm::Lorentzian:
      return 1.0 / (1.0 + x * x / (2.0 * scale * scale));
    case Norm::Gaussian:
      return std::exp(-x * x / (2.0 * scale * scale));
    case Norm::Tukey:
    {
      const double u = 1.0 - (x / scale) * (x / scale);
      return x <= scale ? u * u : 0.0;
    }
    case Norm::Box:
      return x <= scale ? 1.0 : 0.1;
    case Norm::Centin:
      return x <= scale ? 1.0 : scale * scale / ((x - scale) * (x - scale) + scale * scale);
  }
  return 0.0;
}

namespace
{

double Compare(Argument argument, const Vector& m, const Vector& n, double distance)
{
  switch (argument)
  {
    case Argument::Chord:
      return Length(m - n);
    case Argument::Angle:
      return std::atan2(Length(Cross(m, n)), Dot(m, n));
    case Argument::DirectionalCurvature:
      return std::atan2(Length(Cross(m, n)), Dot(m, n)) / distance;
  }
  return 0.0;
}

Neighbors FindNeighbors(const Mesh& mesh, const Settings& settings, double radius)
{
  Neighbors neighbors = settings.Faces == Neighborhood::EdgeAdjacent ? FacesAtEdges(mesh)
    : settings.Faces == Neighborhood::VertexSharing                  ? FacesAtPoints(mesh)
                                                                     : FacesWithin(mesh, radius);
  for (int f = 0; settings.IncludeOwn && f < int(neighbors.size()); ++f)
  {
    neighbors[f].push_back(f);
  }
  return neighbors;
}

/// What does not change while normals are filtered.
struct Surroundings
{
  Neighbors Averaged;
  std::vector<Vector> Centroids;
  std::vector<double> Areas; // 0: degenerate
  double SpatialSigma;
  double NormScale;
  double ShortestDistance;
};

/// centres and data are the same field, unless the data stays the original.
std::vector<Vector> Sweep(const Surroundings& here, const Settings& settings,
  const std::vector<Vector>& centres, const std::vector<Vector>& data, std::vector<double>* margins)
{
  std::vector<Vector> filtered = centres;
  for (std::size_t i = 0; i < centres.size(); ++i)
  {
    const bool hasOpinion = Length(centres[i]) > 0.0;
    Vector sum = { 0.0, 0.0, 0.0 };
    double total = 0.0;
    for (const int j : here.Averaged[i])
    {
      if (here.Areas[j] == 0.0)
      {
        continue;
      }
      const double distance = Length(here.Centroids[i] - here.Centroids[j]);
      const double x = hasOpinion
        ? Compare(settings.Compared, centres[i], data[j], std::max(distance, here.ShortestDistance))
        : 0.0;
      double w = Weight(settings.WeightNorm, here.NormScale, x);
      if (settings.SpatialScale > 0.0)
      {
        w *= std::exp(-distance * distance / (2.0 * here.SpatialSigma * here.SpatialSigma));
      }
      if (settings.AreaWeighted)
      {
        w *= here.Areas[j];
      }
      sum = sum + w * data[j];
      total += w;
      if (margins)
      {
        (*margins)[i] = std::min((*margins)[i], std::abs(x - here.NormScale) / here.NormScale);
      }
    }
    // Weights next to nothing are no weights, and opposite normals have no mean.
    if (Length(sum) > std::max(1e-140, 1e-12 * total))
    {
      filtered[i] = (1.0 / Length(sum)) * sum;
    }
  }
  return filtered;
}

}

std::vector<Vector> Denoise(Mesh& mesh, const Settings& settings, std::vector<double>* margins)
{
  const std::size_t faces = mesh.Faces.size();
  if (margins)
  {
    margins->assign(faces, std::numeric_limits<double>::infinity());
  }
  const double edge = MeanEdgeLength(mesh);
  std::vector<Vector> normals(faces);
  Surroundings here;
  for (int outer = 0; outer < settings.OuterIterations; ++outer)
  {
    const double distance = MeanCentroidDistance(mesh);
    const bool curvature = settings.Compared == Argument::DirectionalCurvature;
    here.NormScale = curvature ? settings.Scale / distance : settings.Scale;
    here.SpatialSigma = settings.SpatialScale * distance;
    here.ShortestDistance = 1e-12 * edge;
    if (outer == 0 || settings.Faces == Neighborhood::Radius)
    {
      here.Averaged = FindNeighbors(mesh, settings, settings.Radius * distance);
    }
    here.Centroids.resize(faces);
    here.Areas.resize(faces);
    for (std::size_t f = 0; f < faces; ++f)
    {
      const Vector s = AreaVector(mesh, mesh.Faces[f]);
      const bool degenerate = !(Length(s) > 1e-12 * edge * edge);
      here.Centroids[f] = Centroid(mesh, mesh.Faces[f]);
      here.Areas[f] = degenerate ? 0.0 : Length(s);
      normals[f] = degenerate ? Vector{ 0.0, 0.0, 0.0 } : (1.0 / Length(s)) * s;
    }

    const std::vector<Vector> original = normals;
    for (int iteration = 0; iteration < settings.NormalIterations; ++iteration)
    {
      normals = Sweep(here, settings, normals,
        settings.Averaged == Data::Original ? original : normals, margins);
    }
    UpdatePoints(mesh, normals, settings.VertexUpdate, settings.FreeBoundary,
      settings.VertexIterations);
  }
  return normals;
}

}
