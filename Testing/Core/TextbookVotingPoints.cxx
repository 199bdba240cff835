// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextbookVotingPoints.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <cmath>

namespace VotingTextbook
{

namespace
{

using Matrix = Eigen::Matrix3d;

struct Neighborhood
{
  const Cloud& Of;
  const Vectors& Normals;
  const std::vector<int>& Row;
  const Parameters& P;
  std::size_t I;

  Vector To(int j) const { return this->Of.Points[j] - this->Of.Points[this->I]; }

  bool IsSimilar(int j) const
  {
    const double cosine = this->Normals[this->I].dot(this->Normals[j]);
    return (this->P.Unoriented ? std::abs(cosine) : cosine) > this->P.Cosine;
  }

  /// The normal of j on the side of that of the point.
  Vector NormalOf(int j) const
  {
    const Vector& n = this->Normals[j];
    return this->P.Unoriented && n.dot(this->Normals[this->I]) < 0.0 ? Vector(-n) : n;
  }
};

Vector FilteredNormal(const Neighborhood& around)
{
  Matrix tensor = Matrix::Zero();
  double count = 0.0;
  for (const int j : around.Row)
  {
    if (around.IsSimilar(j))
    {
      tensor += around.Normals[j] * around.Normals[j].transpose();
      count += 1.0;
    }
  }
  const Vector& n = around.Normals[around.I];
  if (count == 0.0)
  {
    return n;
  }
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(tensor / count);
  Matrix binary = Matrix::Zero();
  for (int k = 0; k < 3; ++k)
  {
    if (k == 2 || solver.eigenvalues()[k] >= around.P.Tau)
    {
      const Vector e = solver.eigenvectors().col(k);
      binary += e * e.transpose();
    }
  }
  return (around.P.Damping * n + binary * n).normalized();
}

/// The class, and the direction of an edge.
int Classify(const Neighborhood& around, Vector& direction)
{
  Vectors similar = { Vector::Zero() };
  for (const int j : around.Row)
  {
    if (around.IsSimilar(j))
    {
      similar.push_back(around.To(j));
    }
  }
  Vector centre = Vector::Zero();
  for (const Vector& p : similar)
  {
    centre += p / static_cast<double>(similar.size());
  }
  Matrix covariance = Matrix::Zero();
  for (const Vector& p : similar)
  {
    covariance += (p - centre) * (p - centre).transpose() / static_cast<double>(similar.size());
  }
  if (covariance.trace() == 0.0)
  {
    return -1;
  }
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(covariance);
  const Vector mu = solver.eigenvalues() / solver.eigenvalues().norm(); // ascending
  direction = solver.eigenvectors().col(2);
  const double tau = around.P.Tau;
  if (mu[2] > tau && mu[1] < tau && mu[0] < tau)
  {
    return 1;
  }
  return mu[2] > tau && mu[1] > tau && mu[0] < tau ? 0 : 2;
}

Vector FlatStep(const Neighborhood& around)
{
  const Vector& n = around.Normals[around.I];
  const double s = around.Of.Spacings[around.I];
  double sum = 0.0;
  double total = 0.0;
  for (const int j : around.Row)
  {
    const Vector e = around.To(j);
    const Vector m = around.NormalOf(j);
    const double weight = std::exp(-(n - m).squaredNorm() / std::pow(around.P.SigmaN, 2)) *
      std::exp(-e.squaredNorm() / std::pow(around.P.SigmaD * s, 2));
    sum += weight * (around.P.Balanced ? 0.5 * (n.dot(e) + m.dot(e)) : n.dot(e));
    total += weight;
  }
  return total > 0.0 ? Vector(around.P.Alpha * sum / total * n) : Vector(Vector::Zero());
}

/// To the intersection of planes in the space of the columns of axes.
template <int Dimensions>
Vector ToIntersection(const Neighborhood& around, const Eigen::Matrix<double, 3, Dimensions>& axes,
  int& rank)
{
  using Square = Eigen::Matrix<double, Dimensions, Dimensions>;
  using Short = Eigen::Matrix<double, Dimensions, 1>;
  const double s = around.Of.Spacings[around.I];
  Square a = Square::Zero();
  Short b = Short::Zero();
  for (const int j : around.Row)
  {
    const Vector e = around.To(j);
    const Vector& n = around.Normals[j];
    double weight = 1.0;
    if (around.P.SigmaP > 0.0)
    {
      weight = std::exp(-e.squaredNorm() / std::pow(around.P.SigmaD * s, 2)) *
        std::exp(-std::pow(n.dot(e) / (around.P.SigmaP * s), 2));
    }
    const Short m = axes.transpose() * n;
    const Short q = axes.transpose() * e;
    a += weight * m * m.transpose();
    b += weight * m * m.dot(q);
  }
  const Eigen::SelfAdjointEigenSolver<Square> solver(a);
  const double largest = solver.eigenvalues()[Dimensions - 1];
  Short x = Short::Zero();
  rank = 0;
  for (int k = 0; k < Dimensions; ++k)
  {
    const double value = solver.eigenvalues()[k];
    if (value > 0.0 && value >= around.P.Cut * largest)
    {
      const Short v = solver.eigenvectors().col(k);
      x += v.dot(b) / value * v;
      ++rank;
    }
  }
  return axes * x;
}

Vector FeatureStep(const Neighborhood& around, int kind, const Vector& direction)
{
  int rank = 0;
  Vector step;
  if (kind == 1)
  {
    const Vector u = direction.unitOrthogonal();
    Eigen::Matrix<double, 3, 2> axes;
    axes << u, direction.cross(u);
    step = ToIntersection<2>(around, axes, rank);
  }
  else
  {
    step = ToIntersection<3>(around, Matrix::Identity(), rank);
  }
  if (around.P.SigmaP > 0.0)
  {
    return rank < 2 ? FlatStep(around) : Vector(around.P.Alpha * step);
  }
  return step;
}

}

std::vector<int> Iterate(Cloud& cloud, const std::vector<std::vector<int>>& rows,
  const Parameters& parameters)
{
  const Vectors before = cloud.Normals;
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    cloud.Normals[i] = FilteredNormal({ cloud, before, rows[i], parameters, i });
  }
  std::vector<int> classes(rows.size());
  Vectors places = cloud.Points;
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const Neighborhood around{ cloud, cloud.Normals, rows[i], parameters, i };
    Vector direction;
    classes[i] = Classify(around, direction);
    if (classes[i] >= 0)
    {
      const Vector place = cloud.Points[i] +
        (classes[i] == 0 ? FlatStep(around) : FeatureStep(around, classes[i], direction));
      if (parameters.Limit == 0.0 || (place - cloud.Start[i]).norm() <= parameters.Limit)
      {
        (parameters.InPlace ? cloud.Points : places)[i] = place;
      }
    }
  }
  if (!parameters.InPlace)
  {
    cloud.Points = places;
  }
  return classes;
}

}
