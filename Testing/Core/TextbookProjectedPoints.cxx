// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextbookProjectedPoints.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace Textbook
{

namespace
{

/// Numbers of the k points nearest to point i, without itself, nearest first.
std::vector<int> Nearest(const std::vector<Point>& points, int i, int k)
{
  std::vector<std::pair<double, int>> others;
  for (int j = 0; j < int(points.size()); ++j)
  {
    if (j != i)
    {
      others.push_back({ (points[j] - points[i]).norm(), j });
    }
  }
  std::sort(others.begin(), others.end());
  std::vector<int> nearest;
  for (int n = 0; n < std::min(k, int(others.size())); ++n)
  {
    nearest.push_back(others[n].second);
  }
  return nearest;
}

}

Cloud MovingLeastSquares(const Cloud& cloud, int neighbors, double h, int degree, int planeRounds)
{
  Cloud result = cloud;
  for (int i = 0; i < int(cloud.Points.size()); ++i)
  {
    const Point x = cloud.Points[i];
    std::vector<int> patch = Nearest(cloud.Points, i, neighbors);
    const double width = h > 0.0 ? h : (cloud.Points[patch.back()] - x).norm() / 2.0;
    patch.push_back(i);

    Point q = x;
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    for (int round = 0; round < planeRounds; ++round)
    {
      double total = 0.0;
      Point c(0.0, 0.0, 0.0);
      for (const int j : patch)
      {
        const double w = std::exp(-(cloud.Points[j] - q).squaredNorm() / (width * width));
        c += w * (cloud.Points[j] - x);
        total += w;
      }
      c = x + c / total;
      Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
      for (const int j : patch)
      {
        const double w = std::exp(-(cloud.Points[j] - q).squaredNorm() / (width * width));
        covariance += w * (cloud.Points[j] - c) * (cloud.Points[j] - c).transpose();
      }
      axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors();
      const Point n = axes.col(0);
      const Point before = q;
      q = x - (x - c).dot(n) * n;
      if ((q - before).norm() < 1e-6 * width)
      {
        break;
      }
    }
    const Point n = axes.col(0);
    const Point u = axes.col(1);
    const Point v = axes.col(2);

    Point place = q;
    Point normal = n;
    const int coefficients = degree == 2 ? 6 : degree == 1 ? 3 : 0;
    if (coefficients > 0)
    {
      Eigen::MatrixXd matrix(patch.size(), 6);
      Eigen::VectorXd heights(patch.size());
      for (int row = 0; row < int(patch.size()); ++row)
      {
        const Point e = cloud.Points[patch[row]] - q;
        const double a = u.dot(e) / width;
        const double b = v.dot(e) / width;
        const double root = std::exp(-0.5 * e.squaredNorm() / (width * width));
        matrix.row(row) << root, root * a, root * b, root * a * a, root * a * b, root * b * b;
        heights[row] = root * n.dot(e);
      }
      const Eigen::VectorXd g =
        matrix.leftCols(coefficients).eval().colPivHouseholderQr().solve(heights);
      place = q + g[0] * n;
      normal = (n - g[1] / width * u - g[2] / width * v).normalized();
    }
    result.Points[i] = place;
    result.Normals[i] = normal.dot(cloud.Normals[i]) < 0.0 ? Point(-normal) : normal;
  }
  return result;
}

Cloud RobustImplicit(const Cloud& cloud, const std::vector<Point>& spacings,
  const ImplicitParameters& parameters)
{
  const int count = int(cloud.Points.size());
  std::vector<double> rho;
  for (int j = 0; j < count; ++j)
  {
    const double last = (spacings[Nearest(spacings, j, 16).back()] - spacings[j]).norm();
    rho.push_back(2.0 * std::sqrt(last * last / 16.0));
  }
  Cloud result = cloud;
  for (int i = 0; i < count; ++i)
  {
    Point x = cloud.Points[i];
    Point direction = cloud.Normals[i];
    bool lost = false;
    for (int projection = 0; projection < parameters.Projections; ++projection)
    {
      double f = 0.0;
      Point g(0.0, 0.0, 0.0);
      for (int m = 0; m < parameters.Fits; ++m)
      {
        double weights = 0.0;
        double values = 0.0;
        Point gradients(0.0, 0.0, 0.0);
        Point slopes(0.0, 0.0, 0.0);
        Point normals(0.0, 0.0, 0.0);
        for (int j = 0; j < count; ++j)
        {
          const double h = parameters.FilterScale * rho[j];
          const Point e = x - cloud.Points[j];
          if (!(e.norm() < h))
          {
            continue;
          }
          Point n = cloud.Normals[j];
          if (parameters.Unoriented && n.dot(cloud.Normals[i]) < 0.0)
          {
            n = -n;
          }
          const double rest = 1.0 - e.squaredNorm() / (h * h);
          const double phi = std::pow(rest, 4);
          const Point slope = -8.0 / (h * h) * std::pow(rest, 3) * e;
          const double height = n.dot(e);
          double alpha = 1.0;
          if (m > 0)
          {
            alpha = std::exp(-std::pow((n - g).norm() / parameters.SigmaN, 2));
            if (parameters.SigmaR > 0.0)
            {
              alpha *= std::exp(-std::pow((height - f) / (parameters.SigmaR * h), 2));
            }
          }
          weights += alpha * phi;
          values += alpha * phi * height;
          gradients += alpha * height * slope;
          slopes += alpha * slope;
          normals += alpha * phi * n;
        }
        if (weights == 0.0)
        {
          lost = true;
          break;
        }
        f = values / weights;
        const Point before = g;
        g = (gradients - f * slopes + normals) / weights;
        if (m > 0 && (g - before).squaredNorm() < 1e-3)
        {
          break;
        }
      }
      if (lost)
      {
        break;
      }
      direction = g.normalized();
      x -= f * direction;
      if (std::abs(f) < 1e-4 * rho[i])
      {
        break;
      }
    }
    if (!lost)
    {
      result.Points[i] = x;
      result.Normals[i] = direction;
    }
  }
  return result;
}

}
