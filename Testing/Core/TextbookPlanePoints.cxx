// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextbookPlaneInternals.h"

#include <limits>

namespace PlaneTextbook
{

Rows Ball(const Vectors& points, double radius, std::size_t limit)
{
  Rows rows;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    std::vector<std::pair<double, int>> others;
    for (std::size_t j = 0; j < points.size(); ++j)
    {
      const double d = (points[j] - points[i]).norm();
      if (j != i && d <= radius)
      {
        others.emplace_back(d, static_cast<int>(j));
      }
    }
    std::sort(others.begin(), others.end());
    rows.emplace_back();
    for (std::size_t k = 0; k < std::min(limit, others.size()); ++k)
    {
      rows.back().push_back(others[k].second);
    }
  }
  return rows;
}

Rows Nearest(const Vectors& points, std::size_t k)
{
  return Ball(points, std::numeric_limits<double>::infinity(), k);
}

Plane FitPlane(const Vectors& points, const std::vector<double>& weights)
{
  double total = 0.0;
  Vector centre(0.0, 0.0, 0.0);
  for (std::size_t j = 0; j < points.size(); ++j)
  {
    total += weights[j];
    centre += weights[j] * points[j];
  }
  centre /= total;
  Matrix covariance = Matrix::Zero();
  for (std::size_t j = 0; j < points.size(); ++j)
  {
    covariance += weights[j] * (points[j] - centre) * (points[j] - centre).transpose();
  }
  return { centre, Eigensolver(covariance / total).eigenvectors().col(0) };
}

Plane FitRobustPlane(const Vectors& points, const std::vector<double>& weights, double epsilon,
  int rounds)
{
  Plane plane = FitPlane(points, weights);
  for (int round = 0; round < rounds; ++round)
  {
    std::vector<double> omega = weights;
    for (std::size_t j = 0; j < points.size(); ++j)
    {
      omega[j] /= std::max(std::abs(plane.Normal.dot(points[j] - plane.Centre)), epsilon);
    }
    const Vector before = plane.Normal;
    plane = FitPlane(points, omega);
    if (1.0 - std::abs(plane.Normal.dot(before)) < 1e-10)
    {
      break;
    }
  }
  return plane;
}

void MovingRobustPCA(Cloud& cloud, const Rows& rows, const RobustPCA& settings)
{
  const int count = static_cast<int>(cloud.Points.size());
  std::vector<double> totals(count, settings.Lambda);
  Vectors sums;
  for (const Vector& p : cloud.Points)
  {
    sums.push_back(settings.Lambda * p);
  }
  std::vector<bool> trusted(count, false);
  Vectors own = cloud.Points;
  Vectors normals = cloud.Normals;
  for (int i = 0; i < count; ++i)
  {
    const std::vector<int> members = WithOwn(i, rows[i]);
    Vectors points;
    std::vector<double> w;
    int heavy = 0;
    for (const int j : members)
    {
      points.push_back(cloud.Points[j]);
      w.push_back(Gauss(Angle(cloud.Normals[i], cloud.Normals[j]), settings.Sigma));
      heavy += w.back() > 1e-3;
    }
    if (heavy < 4)
    {
      w.assign(members.size(), 1.0);
    }
    const double epsilon = settings.Epsilon * cloud.Spacings[i];
    const Plane plane = FitRobustPlane(points, w, epsilon, settings.Rounds);
    normals[i] = OnSideOf(plane.Normal, cloud.Normals[i]);

    std::vector<double> residuals;
    std::vector<double> sizes;
    for (const Vector& p : points)
    {
      residuals.push_back(plane.Normal.dot(p - plane.Centre));
      sizes.push_back(std::abs(residuals.back()));
    }
    const double tau = std::max(3.0 * 1.482602218505602 * Median(sizes), epsilon);
    own[i] = points[0] - residuals[0] * plane.Normal;
    for (std::size_t k = 0; k < members.size(); ++k)
    {
      if (sizes[k] <= tau)
      {
        sums[members[k]] += w[k] * (points[k] - residuals[k] * plane.Normal);
        totals[members[k]] += w[k];
        trusted[members[k]] = true;
      }
    }
  }
  for (int j = 0; j < count; ++j)
  {
    cloud.Points[j] = trusted[j] ? Vector(sums[j] / totals[j]) : own[j];
  }
  cloud.Normals = normals;
}

void Likelihoods(Cloud& cloud, const Rows& rows, const Li& settings)
{
  const int count = static_cast<int>(cloud.Points.size());
  const Vectors points = cloud.Points;
  const Vectors normals = cloud.Normals;
  auto spatial = [&](int i, int j)
  {
    const double r = settings.Radius > 0.0 ? settings.Radius * cloud.Spacings[i]
                                           : (points[rows[i].back()] - points[i]).norm();
    return std::exp(-4.0 * (points[j] - points[i]).squaredNorm() / (r * r));
  };

  std::vector<double> offsets;
  std::vector<double> intensities;
  double scale = 0.0;
  for (int i = 0; i < count; ++i)
  {
    const std::vector<int> members = WithOwn(i, rows[i]);
    Vectors around;
    std::vector<double> w;
    for (const int j : members)
    {
      around.push_back(points[j]);
      w.push_back(spatial(i, j));
    }
    const Plane plane = FitPlane(around, w);
    offsets.push_back(plane.Normal.dot(points[i] - plane.Centre));
    scale += 2.0 * Square(offsets.back()) / count;
    const Vector l = TensorValues(normals, members, w);
    intensities.push_back(1.5 * (l[0] + l[1]));
  }
  std::vector<double> likelihoods;
  for (const double offset : offsets)
  {
    likelihoods.push_back(scale > 0.0 ? std::exp(-offset * offset / scale) : 1.0);
  }

  for (int i = 0; i < count; ++i)
  {
    double mean = 0.0;
    double square = 0.0;
    for (const int j : rows[i])
    {
      mean += Angle(normals[i], normals[j]) / rows[i].size();
    }
    for (const int j : rows[i])
    {
      square += Square(Angle(normals[i], normals[j]) - mean) / rows[i].size();
    }
    const double sigma = std::max(std::sqrt(square), settings.LeastAngle);
    Vector sum(0.0, 0.0, 0.0);
    for (const int j : WithOwn(i, rows[i]))
    {
      const double l = settings.LikelihoodInNormals ? likelihoods[j] : 1.0;
      sum += l * spatial(i, j) * Gauss(Angle(normals[i], normals[j]), sigma) *
        OnSideOf(normals[j], normals[i]);
    }
    cloud.Normals[i] = sum.normalized();
  }

  for (int i = 0; i < count; ++i)
  {
    const Vector& n = cloud.Normals[i];
    double square = 0.0;
    for (const int j : rows[i])
    {
      square += Square(n.dot(points[j] - points[i])) / rows[i].size();
    }
    const double sigma = std::sqrt(square) * (1.0 - settings.Beta * intensities[i]);
    double total = likelihoods[i];
    double sum = 0.0;
    for (const int j : rows[i])
    {
      const Vector e = points[j] - points[i];
      const double own = n.dot(e);
      const double w = likelihoods[j] * spatial(i, j) * Gauss(own, sigma);
      total += w;
      sum += w *
        (settings.OwnShare * own +
          (1.0 - settings.OwnShare) * OnSideOf(cloud.Normals[j], n).dot(e));
    }
    cloud.Points[i] = points[i] + sum / total * n;
  }
}

}
