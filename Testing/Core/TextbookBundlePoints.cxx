// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextbookBundleInternals.h"

namespace TextbookBundles
{

namespace
{

using Field = std::vector<std::vector<Point>>; ///< a vector for each normal of each bundle

/// The normal of point j, and what belongs to it in another field, seen from direction v.
const Point& Matched(const Cloud& cloud, int j, const Point& v, const Field& field,
  const Parameters& parameters)
{
  return field[j][MostLike(v, cloud.Bundles[j], parameters.Unoriented)];
}

struct Patch
{
  double H = 1e300;
  Point Mean = Point(0.0, 0.0, 0.0);
};

Patch PatchAt(const Cloud& cloud, int j, int m, const Parameters& parameters)
{
  Patch patch;
  const Point& centre = cloud.Bundles[j][m];
  if (!HasNormal(centre))
  {
    return patch;
  }
  std::vector<Point> members = { centre };
  const std::vector<int>& row = cloud.Neighbors[j];
  for (int k = 0; k < std::min<int>(parameters.PatchNeighbors, static_cast<int>(row.size())); ++k)
  {
    const Point& n = Matched(cloud, row[k], centre, cloud.Bundles, parameters);
    if (HasNormal(n) && Like(n, centre, parameters.Unoriented) >= parameters.PatchMemberAgreement)
    {
      members.push_back(Facing(n, centre, parameters.Unoriented));
    }
  }
  double phi = 0.0;
  double sum = 0.0;
  Point mean(0.0, 0.0, 0.0);
  for (std::size_t a = 0; a < members.size(); ++a)
  {
    mean += members[a];
    for (std::size_t b = 0; b < a; ++b)
    {
      phi = std::max(phi, (members[a] - members[b]).norm());
      sum += (members[a] - members[b]).norm();
    }
  }
  patch.H = phi * (phi / (1e-9 + sum));
  patch.Mean = mean.normalized();
  return patch;
}

Field Guidance(const Cloud& cloud, const Parameters& parameters)
{
  std::vector<std::vector<Patch>> patches;
  for (int i = 0; i < static_cast<int>(cloud.Bundles.size()); ++i)
  {
    patches.emplace_back();
    for (int m = 0; m < static_cast<int>(cloud.Bundles[i].size()); ++m)
    {
      patches[i].push_back(PatchAt(cloud, i, m, parameters));
    }
  }
  Field guidance = cloud.Bundles;
  for (int i = 0; i < static_cast<int>(cloud.Bundles.size()); ++i)
  {
    for (int m = 0; m < static_cast<int>(cloud.Bundles[i].size()); ++m)
    {
      const Point& n = cloud.Bundles[i][m];
      if (!HasNormal(n))
      {
        continue;
      }
      Patch best = patches[i][m];
      const std::vector<int>& row = cloud.Neighbors[i];
      for (int k = 0; k < std::min<int>(parameters.PatchNeighbors, static_cast<int>(row.size()));
           ++k)
      {
        const int other = MostLike(n, cloud.Bundles[row[k]], parameters.Unoriented);
        const bool agrees =
          Like(n, cloud.Bundles[row[k]][other], parameters.Unoriented) >= parameters.PatchAgreement;
        if (agrees && patches[row[k]][other].H < best.H)
        {
          best = patches[row[k]][other];
        }
      }
      guidance[i][m] = Facing(best.Mean, n, parameters.Unoriented);
    }
  }
  return guidance;
}

/// The joint bilateral filter.
void FilterNormals(Cloud& cloud, const Parameters& parameters)
{
  const Field guidance = Guidance(cloud, parameters);
  Field filtered = cloud.Bundles;
  for (int i = 0; i < static_cast<int>(cloud.Bundles.size()); ++i)
  {
    for (int m = 0; m < static_cast<int>(cloud.Bundles[i].size()); ++m)
    {
      const Point& own = cloud.Bundles[i][m];
      const Point& guide = guidance[i][m];
      Point sum = own;
      for (const int j : cloud.Neighbors[i])
      {
        const Point& n = Matched(cloud, j, guide, cloud.Bundles, parameters);
        const Point& other = Matched(cloud, j, guide, guidance, parameters);
        // Without a direction of one's own all are alike.
        const double x = HasNormal(guide) ? Difference(guide, other, parameters.Unoriented) : 0.0;
        const double d = (cloud.Positions[j] - cloud.Positions[i]).norm();
        sum += Gauss(d, parameters.SpatialScale) * Gauss(x, parameters.RangeScale) *
          Facing(n, own, parameters.Unoriented);
      }
      if (sum.norm() > 1e-12)
      {
        filtered[i][m] = sum.normalized();
      }
    }
  }
  cloud.Bundles = filtered;
}

void MovePoints(Cloud& cloud, const Parameters& parameters)
{
  const int count = static_cast<int>(cloud.Positions.size());
  const std::vector<Point> before = cloud.Positions;
  for (int step = 0; step < parameters.PointIterations; ++step)
  {
    std::vector<Point> next = cloud.Positions;
    for (int i = 0; i < count; ++i)
    {
      for (const Point& v : cloud.Bundles[i])
      {
        Point sum(0.0, 0.0, 0.0);
        double weights = 0.0;
        for (const int j : cloud.Neighbors[i])
        {
          const Point& u = Matched(cloud, j, v, cloud.Bundles, parameters);
          const double d = (before[j] - before[i]).norm();
          const double x = HasNormal(v) ? Difference(u, v, parameters.Unoriented) : 0.0;
          const double pull = cloud.Bundles[j].size() > 1 ? parameters.FeaturePull : 1.0;
          const double w =
            pull * Gauss(d, parameters.SpatialScale) * Gauss(x, parameters.RangeScale);
          const Point e = cloud.Positions[j] - cloud.Positions[i];
          sum += w * (u * u.dot(e) + v * v.dot(e));
          weights += w;
        }
        if (weights > 0.0 && HasNormal(v))
        {
          next[i] += sum / (3.0 * weights);
        }
      }
      if (parameters.MaximumDisplacement > 0.0 &&
        (next[i] - cloud.Start[i]).norm() > parameters.MaximumDisplacement)
      {
        next[i] = cloud.Positions[i];
      }
    }
    cloud.Positions = next;
  }
}

}

void Denoise(Cloud& cloud, const Parameters& parameters)
{
  const int count = static_cast<int>(cloud.Positions.size());
  cloud.Bundles = FirstBundles(cloud, parameters);
  for (int iteration = 0; iteration < parameters.NormalIterations; ++iteration)
  {
    FilterNormals(cloud, parameters);
  }
  MovePoints(cloud, parameters);
  cloud.Means.clear();
  for (int i = 0; i < count; ++i)
  {
    const Point before = cloud.Normals[i];
    Point mean(0.0, 0.0, 0.0);
    Point closest = Facing(cloud.Bundles[i][0], before, parameters.Unoriented);
    for (const Point& bundled : cloud.Bundles[i])
    {
      const Point n = Facing(bundled, before, parameters.Unoriented);
      mean += n;
      closest = n.dot(before) > closest.dot(before) ? n : closest;
    }
    cloud.Means.push_back(HasNormal(mean) ? Point(mean.normalized()) : mean);
    cloud.Normals[i] = closest;
  }
}

}
