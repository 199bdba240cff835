// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file TextbookPlaneInternals.h
 * @brief What the formulas of TextbookPlanePoints.h have in common.
 */

#ifndef TextbookPlaneInternals_h
#define TextbookPlaneInternals_h

#include "TextbookPlanePoints.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace PlaneTextbook
{

using Matrix = Eigen::Matrix3d;
using Eigensolver = Eigen::SelfAdjointEigenSolver<Matrix>;

inline double Angle(const Vector& n, const Vector& m)
{
  return std::atan2(n.cross(m).norm(), std::abs(n.dot(m)));
}

inline double Square(double x) { return x * x; }

inline double Gauss(double x, double sigma) { return std::exp(-Square(x / sigma)); }

/// The point and its neighbours.
inline std::vector<int> WithOwn(int i, const std::vector<int>& row)
{
  std::vector<int> all(1, i);
  all.insert(all.end(), row.begin(), row.end());
  return all;
}

inline double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

/// Eigenvalues of sum w n n^T over their sum, ascending.
inline Vector TensorValues(const Vectors& normals, const std::vector<int>& members,
  const std::vector<double>& weights)
{
  Matrix tensor = Matrix::Zero();
  for (std::size_t k = 0; k < members.size(); ++k)
  {
    tensor += weights[k] * normals[members[k]] * normals[members[k]].transpose();
  }
  return Eigensolver(tensor / tensor.trace()).eigenvalues();
}

inline Vector OnSideOf(const Vector& n, const Vector& other)
{
  return n.dot(other) < 0.0 ? Vector(-n) : n;
}

}

#endif
