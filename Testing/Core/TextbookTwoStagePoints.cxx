// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextbookTwoStagePoints.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace TextbookPoints
{

std::vector<std::vector<int>> Nearest(const std::vector<Vector>& points, int count)
{
  std::vector<std::vector<int>> rows;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    std::vector<std::pair<double, int>> others;
    for (std::size_t j = 0; j < points.size(); ++j)
    {
      if (j != i)
      {
        others.emplace_back((points[j] - points[i]).norm(), static_cast<int>(j));
      }
    }
    std::sort(others.begin(), others.end());
    rows.emplace_back();
    for (int k = 0; k < count; ++k)
    {
      rows.back().push_back(others[static_cast<std::size_t>(k)].second);
    }
  }
  return rows;
}

double Spacing(const std::vector<Vector>& points)
{
  const std::vector<std::vector<int>> rows = Nearest(points, 16);
  std::vector<double> spacings;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double r = (points[static_cast<std::size_t>(rows[i][15])] - points[i]).norm();
    spacings.push_back(r * std::sqrt(3.14159265358979323846 / 16.0));
  }
  std::sort(spacings.begin(), spacings.end());
  const std::size_t half = spacings.size() / 2;
  return spacings.size() % 2 == 1 ? spacings[half] : 0.5 * (spacings[half - 1] + spacings[half]);
}

double Difference(Measure measure, double distance, const Vector& p, const Vector& m,
  const Vector& q, Vector n, bool unoriented)
{
  if (unoriented && m.dot(n) < 0.0)
  {
    n = -n;
  }
  const double angle = std::atan2(m.cross(n).norm(), m.dot(n));
  distance = std::max(distance, 1e-13);
  switch (measure)
  {
    case Measure::Chord:
      return (m - n).norm();
    case Measure::Angle:
      return angle;
    case Measure::Curvature:
      return angle / distance;
    case Measure::Gradient:
      return (m - n).norm() / distance;
    case Measure::Height:
      return std::abs(m.dot(q - p));
  }
  return 0.0;
}

namespace
{

double Spatial(const Stage& stage, double d)
{
  return stage.SpatialSigma > 0.0
    ? std::exp(-d * d / (2.0 * stage.SpatialSigma * stage.SpatialSigma))
    : 1.0;
}

std::vector<int> WithOwn(const std::vector<int>& row, std::size_t i, bool own)
{
  std::vector<int> all = row;
  if (own)
  {
    all.push_back(static_cast<int>(i));
  }
  return all;
}

}

void FilterNormals(Cloud& cloud, const std::vector<std::vector<int>>& neighbors, const Stage& stage,
  int iterations, bool rolling, bool original, bool unoriented)
{
  const std::vector<Vector> start = cloud.Normals;
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    std::vector<Vector> filtered;
    for (std::size_t i = 0; i < cloud.Points.size(); ++i)
    {
      const std::vector<Vector>& data = rolling || original ? start : cloud.Normals;
      Vector sum = Vector::Zero();
      for (const int k : WithOwn(neighbors[i], i, stage.Own))
      {
        const std::size_t j = static_cast<std::size_t>(k);
        const Vector& compared = original && !rolling ? start[j] : cloud.Normals[j];
        const double d = (cloud.Points[i] - cloud.Points[j]).norm();
        const double x = Difference(stage.Argument, d, cloud.Points[i], cloud.Normals[i],
          cloud.Points[j], compared, unoriented);
        const double g = rolling && iteration == 0 ? 1.0 : stage.Weight(x);
        const double f = Spatial(stage, d);
        const double sign = unoriented && data[i].dot(data[j]) < 0.0 ? -1.0 : 1.0;
        sum += f * g * sign * data[j];
      }
      filtered.push_back(sum.normalized());
    }
    cloud.Normals = filtered;
  }
}

void FitNormals(Cloud& cloud, const std::vector<std::vector<int>>& neighbors, const Stage& stage)
{
  std::vector<Vector> fitted;
  for (std::size_t i = 0; i < cloud.Points.size(); ++i)
  {
    Vector centre = Vector::Zero();
    double total = 0.0;
    const std::vector<int> row = WithOwn(neighbors[i], i, stage.Own);
    auto weight = [&](int j)
    {
      const Vector& q = cloud.Points[static_cast<std::size_t>(j)];
      return Spatial(stage, (cloud.Points[i] - q).norm());
    };
    for (const int j : row)
    {
      centre += weight(j) * cloud.Points[static_cast<std::size_t>(j)];
      total += weight(j);
    }
    centre /= total;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const int j : row)
    {
      const Vector e = cloud.Points[static_cast<std::size_t>(j)] - centre;
      covariance += weight(j) * e * e.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
    const Vector n = solver.eigenvectors().col(0);
    fitted.push_back(n.dot(cloud.Normals[i]) < 0.0 ? Vector(-n) : n);
  }
  cloud.Normals = fitted;
}

void MovePoints(Cloud& cloud, const std::vector<std::vector<int>>& neighbors, const Stage& stage,
  Step step, double length, double cut, int iterations, bool unoriented)
{
  const std::vector<Vector> start = cloud.Points;
  const std::vector<Vector>& normals = cloud.Normals;
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    std::vector<Vector> moved;
    for (std::size_t i = 0; i < start.size(); ++i)
    {
      const Vector& p = cloud.Points[i];
      const Vector& n = normals[i];
      double total = 0.0;
      Vector sum = Vector::Zero();
      Eigen::Matrix3d quadric = Eigen::Matrix3d::Zero();
      for (const int k : WithOwn(neighbors[i], i, stage.Own))
      {
        const std::size_t j = static_cast<std::size_t>(k);
        const Vector e = cloud.Points[j] - p;
        const Vector m = unoriented && n.dot(normals[j]) < 0.0 ? Vector(-normals[j]) : normals[j];
        const double d = (start[i] - start[j]).norm();
        const double w = Spatial(stage, d) *
          stage.Weight(Difference(stage.Argument, d, p, n, cloud.Points[j], m, unoriented));
        total += w;
        switch (step)
        {
          case Step::Own:
            sum += w * n.dot(e) * n;
            break;
          case Step::Neighbor:
            sum += w * m.dot(e) * n;
            break;
          case Step::Balanced:
            sum += w * 0.5 * (n.dot(e) + m.dot(e)) * n;
            break;
          case Step::Gradient:
            sum += w / 3.0 * (n * n.dot(e) + m * m.dot(e));
            break;
          case Step::Quadric:
            sum += w * m * m.dot(e);
            quadric += w * m * m.transpose();
            break;
        }
      }
      if (step == Step::Quadric)
      {
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(quadric);
        Vector z = Vector::Zero();
        for (int a = 0; a < 3; ++a)
        {
          if (solver.eigenvalues()[a] >= cut * solver.eigenvalues()[2])
          {
            const Vector v = solver.eigenvectors().col(a);
            z += v.dot(sum) / solver.eigenvalues()[a] * v;
          }
        }
        moved.push_back(p + length * z);
      }
      else
      {
        moved.push_back(p + length * sum / total);
      }
    }
    cloud.Points = moved;
  }
}

}
