// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextbookBundleInternals.h"

#include <Eigen/Eigenvalues>

namespace TextbookBundles
{

namespace
{

/// The vector that is least like the one of these centres it is most like.
Point FarthestFrom(const std::vector<Point>& centres, const std::vector<Point>& normals,
  bool unoriented)
{
  std::vector<double> nearness;
  for (const Point& n : normals)
  {
    nearness.push_back(Like(n, centres[MostLike(n, centres, unoriented)], unoriented));
  }
  return normals[std::min_element(nearness.begin(), nearness.end()) - nearness.begin()];
}

}

double Score(const Cloud& cloud, int i, double sigma)
{
  if (cloud.Neighbors[i].empty() || !HasNormal(cloud.Normals[i]))
  {
    return 1.0;
  }
  double sum = 0.0;
  for (const int j : cloud.Neighbors[i])
  {
    sum += Gauss(Difference(cloud.Normals[i], cloud.Normals[j], true), sigma);
  }
  return sum / static_cast<double>(cloud.Neighbors[i].size());
}

std::vector<std::vector<int>> Clusters(const std::vector<Point>& normals, const Point& side,
  const Parameters& parameters)
{
  const bool axes = parameters.Unoriented;
  Point mean(0.0, 0.0, 0.0);
  for (const Point& n : normals)
  {
    mean += Facing(n, side, axes);
  }
  mean.normalize();
  std::vector<std::vector<int>> clusters;
  std::vector<Point> centres;
  for (int count = 1; count <= parameters.MaximumBundles; ++count)
  {
    centres = { mean };
    if (count > 1)
    {
      centres = { FarthestFrom({ mean }, normals, axes) };
    }
    while (static_cast<int>(centres.size()) < count)
    {
      centres.push_back(FarthestFrom(centres, normals, axes));
    }
    std::vector<int> of(normals.size(), 0);
    for (int round = 0; round < 10; ++round)
    {
      for (std::size_t k = 0; k < normals.size(); ++k)
      {
        of[k] = MostLike(normals[k], centres, axes);
      }
      for (int c = 0; c < count; ++c)
      {
        Point sum(0.0, 0.0, 0.0);
        for (std::size_t k = 0; k < normals.size(); ++k)
        {
          if (of[k] == c)
          {
            sum += Facing(normals[k], centres[c], axes);
          }
        }
        if (sum.norm() > 1e-12)
        {
          centres[c] = sum.normalized();
        }
      }
    }
    double widest = 0.0;
    clusters.assign(count, {});
    for (std::size_t k = 0; k < normals.size(); ++k)
    {
      clusters[of[k]].push_back(static_cast<int>(k));
      const double cosine = std::min(1.0, Like(normals[k], centres[of[k]], axes));
      widest = std::max(widest, std::acos(cosine));
    }
    if (widest < parameters.BundleAngle)
    {
      break;
    }
  }
  std::vector<std::vector<int>> full;
  std::vector<Point> middles;
  double variance = 0.0;
  for (std::size_t c = 0; c < clusters.size(); ++c)
  {
    for (const int k : clusters[c])
    {
      variance += std::pow(Difference(normals[k], centres[c], axes), 2) / normals.size();
    }
    if (!clusters[c].empty())
    {
      full.push_back(clusters[c]);
      middles.push_back(centres[c]);
    }
  }
  double nearest = 2.0;
  for (std::size_t a = 1; a < middles.size(); ++a)
  {
    for (std::size_t b = 0; b < a; ++b)
    {
      nearest = std::min(nearest, Difference(middles[a], middles[b], axes));
    }
  }
  if (nearest < parameters.BundleSeparation * std::sqrt(variance))
  {
    full.resize(1); // of which nothing but the number matters
  }
  return full;
}

std::vector<Point> Skeleton(const std::vector<Point>& cloud, double h)
{
  const int count = static_cast<int>(cloud.size());
  const int picked = std::min(count, std::max(50, count / 2));
  std::vector<Point> x;
  for (int i = 0; i < picked; ++i)
  {
    x.push_back(cloud[static_cast<std::size_t>(i) * count / picked]);
  }
  for (int step = 0; step < 30; ++step)
  {
    std::vector<Point> next;
    for (int i = 0; i < picked; ++i)
    {
      Point median(0.0, 0.0, 0.0);
      double alphas = 0.0;
      for (const Point& q : cloud)
      {
        const double r = (x[i] - q).norm();
        if (r <= h)
        {
          const double alpha = Gauss(r, h / 2.0) / std::max(r, h / 10.0);
          median += alpha * q;
          alphas += alpha;
        }
      }
      Point away(0.0, 0.0, 0.0);
      double betas = 0.0;
      Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
      for (int k = 0; k < picked; ++k)
      {
        const double r = (x[i] - x[k]).norm();
        if (k != i && r <= h)
        {
          const double beta = Gauss(r, h / 2.0) / std::pow(std::max(r, h / 10.0), 2);
          away += beta * (x[i] - x[k]);
          betas += beta;
          covariance += Gauss(r, h / 2.0) * (x[i] - x[k]) * (x[i] - x[k]).transpose();
        }
      }
      Point place = alphas > 0.0 ? Point(median / alphas) : x[i];
      if (covariance.trace() > 0.0)
      {
        const Point values =
          Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvalues();
        place += 0.35 * values[2] / values.sum() * away / betas;
      }
      next.push_back(place);
    }
    x = next;
  }
  return x;
}

namespace
{

std::vector<bool> Features(const Cloud& cloud, const Parameters& parameters)
{
  const int count = static_cast<int>(cloud.Positions.size());
  std::vector<bool> features;
  std::vector<Point> candidates;
  for (int i = 0; i < count; ++i)
  {
    features.push_back(Score(cloud, i, parameters.CandidateScale) < parameters.CandidateThreshold);
    if (features[i])
    {
      candidates.push_back(cloud.Positions[i]);
    }
  }
  if (parameters.SkeletonRadius > 0.0)
  {
    const std::vector<Point> skeleton = Skeleton(candidates, parameters.SkeletonRadius);
    for (int i = 0; i < count; ++i)
    {
      bool near = false;
      for (const Point& x : skeleton)
      {
        near = near || (x - cloud.Positions[i]).norm() <= parameters.SkeletonRadius / 2.0;
      }
      features[i] = features[i] && near;
    }
  }
  return features;
}

/// The normals of the planes of these neighbours that pass near p_i. One cluster: its own.
std::vector<Point> Planes(const Cloud& cloud, int i, const std::vector<int>& around,
  const Parameters& parameters)
{
  if (around.empty())
  {
    return {};
  }
  std::vector<Point> normals;
  for (const int j : around)
  {
    normals.push_back(cloud.Normals[j]);
  }
  const std::vector<std::vector<int>> clusters = Clusters(normals, cloud.Normals[i], parameters);
  if (clusters.size() == 1)
  {
    return { cloud.Normals[i] };
  }
  std::vector<Point> planes;
  for (const std::vector<int>& cluster : clusters)
  {
    // Where members without orientation face does not matter as long as they face one way.
    Point side = normals[cluster[0]];
    Point sum(0.0, 0.0, 0.0);
    Point centre(0.0, 0.0, 0.0);
    double weights = 0.0;
    for (const int k : cluster)
    {
      const Point& p = cloud.Positions[around[k]];
      const double w = Gauss((p - cloud.Positions[i]).norm(), parameters.SpatialScale);
      sum += w * Facing(normals[k], side, parameters.Unoriented);
      centre += w * p;
      weights += w;
    }
    const Point n = sum.normalized();
    const double height = std::abs(n.dot(centre / weights - cloud.Positions[i]));
    if (parameters.BundleReach == 0.0 || height <= parameters.BundleReach)
    {
      planes.push_back(n);
    }
  }
  return planes;
}

std::vector<Point> Bundle(const Cloud& cloud, int i, const std::vector<bool>& features,
  const Parameters& parameters)
{
  if (!features[i])
  {
    return { cloud.Normals[i] };
  }
  std::vector<int> all;
  std::vector<int> flat;
  for (const int j : cloud.Neighbors[i])
  {
    if (HasNormal(cloud.Normals[j]))
    {
      all.push_back(j);
      if (!features[j])
      {
        flat.push_back(j);
      }
    }
  }
  std::vector<Point> planes;
  if (flat.size() >= 4)
  {
    planes = Planes(cloud, i, flat, parameters);
  }
  if (planes.empty())
  {
    planes = Planes(cloud, i, all, parameters);
  }
  return planes.empty() ? std::vector<Point>{ cloud.Normals[i] } : planes;
}

}

std::vector<std::vector<Point>> FirstBundles(const Cloud& cloud, const Parameters& parameters)
{
  const std::vector<bool> features = Features(cloud, parameters);
  std::vector<std::vector<Point>> bundles;
  for (int i = 0; i < static_cast<int>(cloud.Positions.size()); ++i)
  {
    bundles.push_back(Bundle(cloud, i, features, parameters));
  }
  return bundles;
}

}
