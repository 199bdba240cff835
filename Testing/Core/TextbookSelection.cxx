// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// What chooses among normals: medians and the patches of guided filtering.

#include "TextbookInternals.h"
#include "TextbookVectors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace Textbook
{

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// The first with the least cost, and how far the best with another normal is behind.
std::size_t Cheapest(const std::vector<double>& costs, const std::vector<Vector>& normals,
  double& margin)
{
  std::size_t best = 0;
  for (std::size_t k = 1; k < costs.size(); ++k)
  {
    best = costs[k] < costs[best] ? k : best;
  }
  for (std::size_t k = 0; k < costs.size(); ++k)
  {
    if (costs[k] < Infinity && Length(normals[k] - normals[best]) > 1e-9)
    {
      const double lead = costs[k] > 0.0 ? (costs[k] - costs[best]) / costs[k] : 0.0;
      margin = std::min(margin, lead);
    }
  }
  return best;
}

/// The normals of the face and then of its neighbours, none zero.
std::vector<Vector> NormalsAround(const Surroundings& here, int i,
  const std::vector<Vector>& normals)
{
  std::vector<Vector> around;
  if (Length(normals[i]) > 0.0)
  {
    around.push_back(normals[i]);
  }
  for (const int j : here.Averaged[i])
  {
    if (j != i && Length(normals[j]) > 0.0)
    {
      around.push_back(normals[j]);
    }
  }
  return around;
}

/// The normal with the least sum of angles to all; the fallback if there is none.
Vector DirectionalMedian(const std::vector<Vector>& normals, const Vector& fallback, double& margin)
{
  if (normals.empty())
  {
    return fallback;
  }
  std::vector<double> sums;
  for (const Vector& candidate : normals)
  {
    double sum = 0.0;
    for (const Vector& n : normals)
    {
      sum += AngleBetween(candidate, n);
    }
    sums.push_back(sum);
  }
  return normals[Cheapest(sums, normals, margin)];
}

Vector AngularMedian(const Surroundings& here, const Settings& settings, int i,
  const std::vector<Vector>& normals, double& margin)
{
  std::vector<std::pair<double, int>> sorted; // equal angles by number of the face
  for (const int j : here.Averaged[i])
  {
    if (j != i && Length(normals[j]) > 0.0)
    {
      const std::vector<int>& near = here.AtEdges[i];
      const bool atEdge = std::find(near.begin(), near.end(), j) != near.end();
      const int times = atEdge ? settings.EdgeRepetitions : settings.VertexRepetitions;
      sorted.insert(sorted.end(), times, { AngleBetween(normals[i], normals[j]), j });
    }
  }
  if (sorted.empty())
  {
    return normals[i];
  }
  std::sort(sorted.begin(), sorted.end());
  const std::pair<double, int> median = sorted[(sorted.size() - 1) / 2];
  for (const std::pair<double, int>& other : sorted)
  {
    if (Length(normals[other.second] - normals[median.second]) > 1e-9)
    {
      margin = std::min(margin,
        std::abs(other.first - median.first) / std::max(other.first, median.first));
    }
  }
  return normals[median.second];
}

struct Patch
{
  double Roughness = Infinity;
  Vector Mean = { 0.0, 0.0, 0.0 };
};

/// The face and all that share a point with it.
Patch PatchAround(const Surroundings& here, int centre, const std::vector<Vector>& normals)
{
  std::set<int> faces(here.AtPoints[centre].begin(), here.AtPoints[centre].end());
  faces.insert(centre);
  for (auto f = faces.begin(); f != faces.end();)
  {
    f = Length(normals[*f]) > 0.0 ? std::next(f) : faces.erase(f);
  }

  double range = 0.0;
  double largest = 0.0;
  double sum = 0.0;
  bool hasInnerEdge = false;
  Patch patch;
  double area = 0.0;
  for (const int a : faces)
  {
    for (const int b : faces)
    {
      range = std::max(range, Length(normals[a] - normals[b]));
    }
    for (const int b : here.AtEdges[a])
    {
      if (a < b && faces.count(b) > 0)
      {
        hasInnerEdge = true;
        largest = std::max(largest, Length(normals[a] - normals[b]));
        sum += Length(normals[a] - normals[b]);
      }
    }
    patch.Mean = patch.Mean + here.Areas[a] * normals[a];
    area += here.Areas[a];
  }
  if (faces.size() >= 2 && Length(patch.Mean) > 1e-12 * area)
  {
    patch.Mean = Unit(patch.Mean);
    patch.Roughness = range * (hasInnerEdge ? largest / (1e-9 + sum) : 1.0);
  }
  return patch;
}

std::vector<Vector> PatchNormals(const Surroundings& here, const std::vector<Vector>& normals,
  Margins& margins)
{
  std::vector<Patch> patches;
  for (int j = 0; j < int(normals.size()); ++j)
  {
    patches.push_back(PatchAround(here, j, normals));
  }
  std::vector<Vector> guidance = normals;
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    std::vector<double> costs = { patches[i].Roughness };
    std::vector<Vector> means = { patches[i].Mean };
    for (const int j : here.AtPoints[i])
    {
      costs.push_back(patches[j].Roughness);
      means.push_back(patches[j].Mean);
    }
    const std::size_t best = Cheapest(costs, means, margins[i]);
    if (costs[best] < Infinity)
    {
      guidance[i] = means[best];
    }
  }
  return guidance;
}

}

Fields LookAt(const Surroundings& here, const Settings& settings,
  const std::vector<Vector>& current, const std::vector<Vector>& original, Margins& margins)
{
  const std::vector<Vector>& averaged = settings.Averaged == Data::Original ? original : current;
  Fields fields = { current, current, averaged, averaged };
  if (settings.Guide == Guidance::Patch)
  {
    fields.Centres = PatchNormals(here, current, margins);
    fields.Compared = fields.Centres;
  }
  if (settings.Guide == Guidance::Median)
  {
    for (int i = 0; i < int(current.size()); ++i)
    {
      fields.Centres[i] =
        DirectionalMedian(NormalsAround(here, i, current), current[i], margins[i]);
    }
  }
  return fields;
}

std::vector<Vector> SelectMedians(const Surroundings& here, const Settings& settings,
  const Fields& fields, Margins& margins)
{
  const std::vector<Vector>& normals = fields.Current;
  std::vector<Vector> filtered = normals;
  for (int i = 0; i < int(normals.size()); ++i)
  {
    const bool hasOpinion = Length(normals[i]) > 0.0;
    if (settings.Selection == MedianKind::Angular && hasOpinion)
    {
      filtered[i] = AngularMedian(here, settings, i, normals, margins[i]);
    }
    else
    {
      filtered[i] = DirectionalMedian(NormalsAround(here, i, normals), normals[i], margins[i]);
    }
  }
  return filtered;
}

}
