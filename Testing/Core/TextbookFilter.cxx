// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// The weight of a pair of faces, and the filters that take means.

#include "TextbookInternals.h"
#include "TextbookVectors.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace Textbook
{

namespace
{

std::set<Edge> EdgesOf(const Face& face)
{
  std::set<Edge> edges;
  for (int corner = 0; corner < 3; ++corner)
  {
    const int a = face[corner];
    const int b = face[(corner + 1) % 3];
    if (a != b)
    {
      edges.insert({ std::min(a, b), std::max(a, b) });
    }
  }
  return edges;
}

double EdgeCoupling(const Surroundings& here, int i, int j, double distance)
{
  if (i == j || distance <= here.ShortestDistance)
  {
    return 0.0;
  }
  const Mesh& mesh = *here.Surface;
  const std::set<Edge> others = EdgesOf(mesh.Faces[j]);
  double length = 0.0;
  for (const Edge& edge : EdgesOf(mesh.Faces[i]))
  {
    if (others.count(edge) > 0)
    {
      length += Length(mesh.Points[edge.first] - mesh.Points[edge.second]);
    }
  }
  return length / distance;
}

double Compare(Argument argument, const Vector& m, const Vector& n, double distance)
{
  switch (argument)
  {
    case Argument::Chord:
      return Length(m - n);
    case Argument::Angle:
      return AngleBetween(m, n);
    case Argument::DirectionalCurvature:
      return AngleBetween(m, n) / distance;
    case Argument::NormalGradient:
      return Length(m - n) / distance;
    case Argument::FaceCurvature:
      break; // does not look at the pair
  }
  return 0.0;
}

}

PairWeight WeightOf(const Surroundings& here, const Settings& settings, const Fields& fields, int i,
  int j, Margins& margins)
{
  const double scale = here.NormScale;
  const auto rangeWeight = [&](double x)
  {
    margins[i] = std::min(margins[i], std::abs(x - scale) / scale);
    return Weight(settings.WeightNorm, scale, x);
  };
  const double distance = Length(here.Centroids[i] - here.Centroids[j]);
  PairWeight weight;
  if (settings.Compared == Argument::FaceCurvature)
  {
    weight.Range = 0.5 * (rangeWeight(here.Curvatures[i]) + rangeWeight(here.Curvatures[j]));
  }
  else
  {
    // A face without normal has no opinion.
    weight.Range = rangeWeight(Length(fields.Centres[i]) > 0.0
        ? Compare(settings.Compared, fields.Centres[i], fields.Compared[j],
            std::max(distance, here.ShortestDistance))
        : 0.0);
  }
  weight.Fixed = settings.Weighting == FaceWeight::Area ? here.Areas[j]
    : settings.Weighting == FaceWeight::EdgeCoupling    ? EdgeCoupling(here, i, j, distance)
                                                        : 1.0;
  if (settings.SpatialScale > 0.0)
  {
    const double sigma = here.SpatialSigmas[i];
    weight.Fixed *= std::exp(-distance * distance / (2.0 * sigma * sigma));
  }
  return weight;
}

std::vector<Vector> Average(const Surroundings& here, const Settings& settings,
  const Fields& fields, Margins& margins)
{
  std::vector<Vector> filtered = fields.Current;
  for (int i = 0; i < int(filtered.size()); ++i)
  {
    Vector sum = { 0.0, 0.0, 0.0 };
    double total = 0.0;
    for (const int j : here.Averaged[i])
    {
      if (here.Areas[j] > 0.0)
      {
        const PairWeight weight = WeightOf(here, settings, fields, i, j, margins);
        sum = sum + weight.Range * weight.Fixed * fields.Averaged[j];
        total += weight.Range * weight.Fixed;
      }
    }
    // Weights next to nothing are no weights, and opposite normals have no mean.
    if (Length(sum) > std::max(1e-140, 1e-12 * total))
    {
      filtered[i] = Unit(sum);
    }
  }
  return filtered;
}

std::vector<Vector> Diffuse(const Surroundings& here, const Settings& settings,
  const Fields& fields, Margins& margins)
{
  std::vector<Vector> filtered = fields.Current;
  for (int i = 0; i < int(filtered.size()); ++i)
  {
    const Vector own = fields.Current[i];
    Vector flux = { 0.0, 0.0, 0.0 };
    double total = 0.0;
    for (const int j : here.Averaged[i])
    {
      if (here.Areas[j] > 0.0)
      {
        const PairWeight weight = WeightOf(here, settings, fields, i, j, margins);
        flux = flux + weight.Range * weight.Fixed * (fields.Averaged[j] - own);
        total += weight.Fixed;
      }
    }
    if (settings.TangentialFlux)
    {
      flux = flux - Dot(flux, own) * own;
    }
    if (total > 1e-140)
    {
      const Vector moved = own + (settings.StepLength / total) * flux;
      filtered[i] = Length(moved) > 1e-12 ? Unit(moved) : own;
    }
  }
  return filtered;
}

}
