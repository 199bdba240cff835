// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextbookInternals.h"
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

bool IsGrown(Neighborhood faces)
{
  return faces == Neighborhood::Radius || faces == Neighborhood::EdgeRadius;
}

Neighbors FindNeighbors(const Mesh& mesh, Neighborhood faces, double radius)
{
  switch (faces)
  {
    case Neighborhood::EdgeAdjacent:
      return FacesAtEdges(mesh);
    case Neighborhood::VertexSharing:
      return FacesAtPoints(mesh);
    case Neighborhood::Radius:
      return FacesWithin(mesh, radius);
    case Neighborhood::EdgeRadius:
      return FacesWithinAcrossEdges(mesh, radius);
  }
  return {};
}

/// What follows from the points, with lengths measured against the mean edge of the input.
void Measure(Surroundings& here, const Mesh& mesh, double edge)
{
  const std::size_t faces = mesh.Faces.size();
  here.Surface = &mesh;
  here.ShortestDistance = 1e-12 * edge;
  here.Centroids.resize(faces);
  here.Areas.resize(faces);
  here.Normals.resize(faces);
  for (std::size_t f = 0; f < faces; ++f)
  {
    const Vector s = AreaVector(mesh, mesh.Faces[f]);
    const bool degenerate = !(Length(s) > 1e-12 * edge * edge);
    here.Centroids[f] = Centroid(mesh, mesh.Faces[f]);
    here.Areas[f] = degenerate ? 0.0 : Length(s);
    here.Normals[f] = degenerate ? Vector{ 0.0, 0.0, 0.0 } : Unit(s);
  }
}

/// Per face, the mean distance to the centroids of adjacent faces; the common one if that is 0.
std::vector<double> DistancesOfFaces(const Surroundings& here, double common)
{
  std::vector<double> distances;
  for (std::size_t f = 0; f < here.AtEdges.size(); ++f)
  {
    double sum = 0.0;
    for (const int g : here.AtEdges[f])
    {
      sum += Length(here.Centroids[f] - here.Centroids[g]);
    }
    distances.push_back(sum > 0.0 ? sum / double(here.AtEdges[f].size()) : common);
  }
  return distances;
}

/// The scales, which follow from the distances as they are now.
void Scale(Surroundings& here, const Settings& settings, double distance, double edge)
{
  here.NormScale = settings.Scale;
  if (settings.Compared != Argument::Chord && settings.Compared != Argument::Angle)
  {
    here.NormScale /= settings.ScaleUnit == CurvatureUnit::EdgeLength ? edge : distance;
  }
  here.SpatialSigmas.assign(here.Areas.size(), distance);
  if (settings.Width == SpatialWidth::PerFace)
  {
    here.SpatialSigmas = DistancesOfFaces(here, distance);
  }
  for (double& sigma : here.SpatialSigmas)
  {
    sigma *= settings.SpatialScale;
  }
}

std::vector<Vector> Filtered(const Surroundings& here, const Settings& settings,
  const Fields& fields, Margins& margins)
{
  switch (settings.Step)
  {
    case Operator::Average:
      return Average(here, settings, fields, margins);
    case Operator::Diffusion:
      return Diffuse(here, settings, fields, margins);
    case Operator::GlobalSolve:
      return SolveGlobally(here, settings, fields, margins);
    case Operator::Median:
      return SelectMedians(here, settings, fields, margins);
    case Operator::VotingTensor:
      return VoteByTensor(here, settings, fields, margins);
  }
  return fields.Current;
}

}

std::vector<Vector> Denoise(Mesh& mesh, const Settings& settings, std::vector<double>* margins)
{
  if (settings.AsReleased)
  {
    return DenoiseAsReleased(mesh, settings.Scale, settings.Relaxation, settings.OuterIterations,
      margins);
  }
  const std::size_t faces = mesh.Faces.size();
  const std::vector<Vector> input = mesh.Points;
  const double edge = MeanEdgeLength(mesh);
  Margins nearest(faces, std::numeric_limits<double>::infinity());
  std::vector<Vector> normals(faces);
  Surroundings here;
  if (settings.Guide == Guidance::Patch)
  {
    here.AtPoints = FacesAtPoints(mesh);
  }
  if (settings.Guide == Guidance::Patch || settings.Step == Operator::Median ||
    settings.Width == SpatialWidth::PerFace)
  {
    here.AtEdges = FacesAtEdges(mesh);
  }
  double relaxation = settings.Relaxation;
  for (int outer = 0; outer < settings.OuterIterations; ++outer)
  {
    const double distance = MeanCentroidDistance(mesh);
    Measure(here, mesh, edge);
    Scale(here, settings, distance, MeanEdgeLength(mesh));
    if (outer == 0 || (IsGrown(settings.Faces) && settings.RenewNeighborhood))
    {
      here.Averaged = FindNeighbors(mesh, settings.Faces, settings.Radius * distance);
      for (int f = 0; settings.IncludeOwn && f < int(faces); ++f)
      {
        here.Averaged[f].push_back(f);
      }
    }
    if (settings.Compared == Argument::FaceCurvature)
    {
      here.Curvatures = FaceCurvatures(mesh, here.Normals);
    }

    normals = here.Normals;
    for (int iteration = 0; iteration < settings.NormalIterations; ++iteration)
    {
      normals =
        Filtered(here, settings, LookAt(here, settings, normals, here.Normals, nearest), nearest);
    }

    UpdatePoints(mesh, normals, settings.VertexUpdate, settings.FreeBoundary,
      settings.VertexIterations, relaxation, input, settings.MaximumDisplacement * edge);
    relaxation *= std::pow(0.7, settings.VertexIterations);
    if (settings.VertexIterations > 0 && settings.InputPull > 0.0)
    {
      PullToInput(mesh, normals, settings.FreeBoundary, input, settings.InputPull);
    }
  }
  if (margins)
  {
    *margins = nearest;
  }
  return normals;
}

}
