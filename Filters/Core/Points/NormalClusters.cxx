// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NormalClusters.h"

#include <algorithm>
#include <cmath>

namespace SurfaceDenoising
{

namespace
{

double Likeness(const Vec3& a, const Vec3& b, bool unoriented)
{
  const double dot = a.dot(b);
  return unoriented ? std::abs(dot) : dot;
}

Vec3 Turned(const Vec3& n, const Vec3& side, bool unoriented)
{
  return unoriented && n.dot(side) < 0.0 ? Vec3(-n) : n;
}

/// The member that is least like the centre it is most like.
std::size_t Farthest(const std::vector<Vec3>& normals, const std::vector<Vec3>& centres,
  bool unoriented)
{
  std::size_t farthest = 0;
  double least = 2.0;
  for (std::size_t k = 0; k < normals.size(); ++k)
  {
    double most = -2.0;
    for (const Vec3& centre : centres)
    {
      most = std::max(most, Likeness(normals[k], centre, unoriented));
    }
    if (most < least)
    {
      least = most;
      farthest = k;
    }
  }
  return farthest;
}

/// Assigns members to centres; returns whether any changed.
bool Assign(const std::vector<Vec3>& normals, const std::vector<Vec3>& centres, bool unoriented,
  std::vector<int>& of)
{
  bool changed = false;
  for (std::size_t k = 0; k < normals.size(); ++k)
  {
    int best = 0;
    double most = -2.0;
    for (std::size_t c = 0; c < centres.size(); ++c)
    {
      const double like = Likeness(normals[k], centres[c], unoriented);
      if (like > most)
      {
        most = like;
        best = static_cast<int>(c);
      }
    }
    changed = changed || of[k] != best;
    of[k] = best;
  }
  return changed;
}

/// Centres become the means of their members; those without members or mean stay.
void Average(const std::vector<Vec3>& normals, const std::vector<int>& of, bool unoriented,
  std::vector<Vec3>& centres)
{
  for (std::size_t c = 0; c < centres.size(); ++c)
  {
    Vec3 sum(0.0, 0.0, 0.0);
    for (std::size_t k = 0; k < normals.size(); ++k)
    {
      if (of[k] == static_cast<int>(c))
      {
        sum += Turned(normals[k], centres[c], unoriented);
      }
    }
    const double length = sum.norm();
    if (length > 1e-12)
    {
      centres[c] = sum / length;
    }
  }
}

/// Leaves out clusters without members.
void DropEmpty(std::vector<Vec3>& centres, std::vector<int>& of)
{
  int kept = 0;
  for (int c = 0; c < static_cast<int>(centres.size()); ++c)
  {
    if (std::find(of.begin(), of.end(), c) != of.end())
    {
      std::replace(of.begin(), of.end(), c, kept);
      centres[kept++] = centres[c];
    }
  }
  centres.resize(kept);
}

bool AreSeparated(const std::vector<Vec3>& normals, const NormalClusters& clusters,
  const NormalClusterSettings& settings)
{
  const std::vector<Vec3>& centres = clusters.Centres;
  auto squaredChord = [&](const Vec3& a, const Vec3& b)
  { return 2.0 * (1.0 - Likeness(a, b, settings.Unoriented)); };
  double spread = 0.0;
  for (std::size_t k = 0; k < normals.size(); ++k)
  {
    spread += squaredChord(normals[k], centres[clusters.Of[k]]);
  }
  double least = 4.0;
  for (std::size_t a = 0; a < centres.size(); ++a)
  {
    for (std::size_t b = 0; b < a; ++b)
    {
      least = std::min(least, squaredChord(centres[a], centres[b]));
    }
  }
  return least * static_cast<double>(normals.size()) >=
    settings.Separation * settings.Separation * spread;
}

}

void ClusterNormals(const std::vector<Vec3>& normals, const Vec3& side,
  const NormalClusterSettings& settings, NormalClusters& clusters)
{
  const bool unoriented = settings.Unoriented;
  std::vector<Vec3>& centres = clusters.Centres;
  std::vector<int>& of = clusters.Of;
  Vec3 mean(0.0, 0.0, 0.0);
  for (const Vec3& n : normals)
  {
    mean += Turned(n, side, unoriented);
  }
  mean = mean.norm() > 1e-12 ? Vec3(mean.normalized()) : normals[0];
  const double limit = std::cos(settings.Angle);
  for (int count = 1; count <= std::max(1, settings.Maximum); ++count)
  {
    centres.assign(1, mean);
    if (count > 1)
    {
      centres[0] = normals[Farthest(normals, centres, unoriented)];
      while (centres.size() < static_cast<std::size_t>(count))
      {
        centres.push_back(normals[Farthest(normals, centres, unoriented)]);
      }
    }
    of.assign(normals.size(), -1);
    for (int round = 0; round < settings.Rounds && Assign(normals, centres, unoriented, of);
         ++round)
    {
      Average(normals, of, unoriented, centres);
    }
    double least = 1.0;
    for (std::size_t k = 0; k < normals.size(); ++k)
    {
      least = std::min(least, Likeness(normals[k], centres[of[k]], unoriented));
    }
    if (least > limit)
    {
      break;
    }
  }
  DropEmpty(centres, of);
  if (centres.size() > 1 && !AreSeparated(normals, clusters, settings))
  {
    centres.assign(1, mean);
    of.assign(normals.size(), 0);
  }
}

}
