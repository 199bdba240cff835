// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Park's regions.

#include "TextbookPlaneInternals.h"

#include <limits>

namespace PlaneTextbook
{

double ArcWeight(double d, const Vector& n, const Vector& m, double c, double sigma)
{
  const double theta = Angle(n, m);
  const double kappa = 2.0 * std::sin(0.5 * theta) / d;
  const double s = theta < 1e-9 ? d : theta / kappa;
  return std::exp(-(s * s + c * kappa * kappa) / (sigma * sigma));
}

std::vector<int> TensorRegions(Cloud& cloud, const Rows& rows, const Park& settings)
{
  const int count = static_cast<int>(cloud.Points.size());
  const Vectors points = cloud.Points;
  const Vectors normals = cloud.Normals;
  auto weight = [&](int a, int b, double spacing)
  {
    const double d = std::max((points[b] - points[a]).norm(), 0.5 * spacing);
    return ArcWeight(d, normals[a], normals[b], settings.C * std::pow(spacing, 4),
      settings.Sigma * spacing);
  };

  std::vector<int> classes(count, 0);
  std::vector<double> intensities(count);
  for (int i = 0; i < count; ++i)
  {
    const std::vector<int> members = WithOwn(i, rows[i]);
    std::vector<double> w(1, 1.0);
    for (const int j : rows[i])
    {
      w.push_back(weight(i, j, cloud.Spacings[i]));
    }
    const Vector l = TensorValues(normals, members, w);
    intensities[i] = 1.5 * (l[0] + l[1]);
    if (intensities[i] > settings.FeatureThreshold)
    {
      classes[i] = l[0] > l[1] - l[0] ? 2 : 1;
    }
  }
  for (int i = 0; i < count; ++i)
  {
    std::vector<double> around;
    for (const int j : WithOwn(i, rows[i]))
    {
      around.push_back(intensities[j]);
    }
    std::sort(around.begin(), around.end());
    if (intensities[i] < settings.FeatureContrast * around[around.size() / 4])
    {
      classes[i] = 0;
    }
  }

  Rows regions(count);
  for (int i = 0; i < count; ++i)
  {
    const double spacing = cloud.Spacings[i];
    int seed = i;
    double least = std::numeric_limits<double>::infinity();
    for (const int j : rows[i])
    {
      const Vector e = points[j] - points[i];
      const double cost = std::abs(normals[j].dot(e)) + 0.25 * e.norm();
      if (classes[i] != 0 && classes[j] == 0 && cost < least)
      {
        seed = j;
        least = cost;
      }
    }
    std::vector<std::pair<double, int>> ranked;
    for (const int j : WithOwn(i, rows[i]))
    {
      ranked.emplace_back(-weight(seed, j, spacing), j);
    }
    std::stable_sort(ranked.begin(), ranked.end(),
      [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<double> w;
    Vectors around;
    for (std::size_t k = 0; k < ranked.size(); ++k)
    {
      if (-ranked[k].first >= settings.RegionThreshold || k < settings.LeastMembers)
      {
        const int j = ranked[k].second;
        regions[i].push_back(j);
        around.push_back(points[j]);
        w.push_back(Gauss((points[j] - points[i]).norm(), 0.5 * settings.Sigma * spacing));
      }
    }
    cloud.Normals[i] = OnSideOf(FitPlane(around, w).Normal, normals[seed]);
  }

  for (int i = 0; i < count; ++i)
  {
    const Vector& n = cloud.Normals[i];
    double total = 0.0;
    double sum = 0.0;
    for (const int j : regions[i])
    {
      const Vector e = points[j] - points[i];
      const double w = Gauss(e.norm(), 0.5 * settings.Sigma * cloud.Spacings[i]);
      total += w;
      sum += w * 0.5 * (n + OnSideOf(cloud.Normals[j], n)).dot(e);
    }
    cloud.Points[i] = points[i] + sum / total * n;
    if (settings.Quadric && classes[i] != 0)
    {
      Matrix a = Matrix::Zero();
      Vector b(0.0, 0.0, 0.0);
      for (const int j : WithOwn(i, rows[i]))
      {
        const Vector& m = cloud.Normals[j];
        a += m * m.transpose();
        b += m * m.dot(points[j] - points[i]);
      }
      const Eigensolver system(a);
      Vector move(0.0, 0.0, 0.0);
      for (int k = 0; k < 3; ++k)
      {
        if (system.eigenvalues()[k] >= 0.05 * system.eigenvalues()[2])
        {
          const Vector axis = system.eigenvectors().col(k);
          move += axis.dot(b) / system.eigenvalues()[k] * axis;
        }
      }
      if (move.norm() <= cloud.Spacings[i])
      {
        cloud.Points[i] = points[i] + move;
      }
    }
  }
  return classes;
}

}
