// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RobustQuadric.h"

#include <Eigen/Cholesky>

#include <cmath>
#include <limits>

namespace SurfaceDenoising
{

namespace
{

constexpr int Reweightings = 6;

}

void RobustQuadric::Start(const Vec3& up, double scale)
{
  this->Up = up;
  this->X = up.unitOrthogonal();
  this->Y = up.cross(this->X);
  this->Scale = scale;
  this->Rows.clear();
  this->Values.clear();
}

void RobustQuadric::Add(const Vec3& offset)
{
  const Vec3 d = offset / this->Scale;
  const double a = d.dot(this->X);
  const double b = d.dot(this->Y);
  this->Rows.push_back({ 1.0, a, b, a * a, a * b, b * b });
  this->Values.push_back(d.dot(this->Up));
}

double RobustQuadric::Height()
{
  const std::size_t count = this->Rows.size();
  if (count < LeastPoints)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  this->Weights.assign(count, 1.0);
  Eigen::Matrix<double, 6, 1> terms;
  for (int step = 0; step < Reweightings; ++step)
  {
    // Plain sums: this is where the time goes.
    double sums[6][6] = {};
    double right[6] = {};
    for (std::size_t k = 0; k < count; ++k)
    {
      const Row& row = this->Rows[k];
      for (int i = 0; i < 6; ++i)
      {
        const double weighted = this->Weights[k] * row[i];
        right[i] += weighted * this->Values[k];
        for (int j = 0; j <= i; ++j)
        {
          sums[i][j] += weighted * row[j];
        }
      }
    }
    Eigen::Matrix<double, 6, 6> matrix;
    for (int i = 0; i < 6; ++i)
    {
      for (int j = 0; j <= i; ++j)
      {
        matrix(i, j) = matrix(j, i) = sums[i][j];
      }
      // Points on a few lines do not determine all terms.
      matrix(i, i) += 1e-9 * double(count);
    }
    terms = matrix.ldlt().solve(Eigen::Map<const Eigen::Matrix<double, 6, 1>>(right));
    for (std::size_t k = 0; k < count; ++k)
    {
      double value = 0.0;
      for (int i = 0; i < 6; ++i)
      {
        value += terms[i] * this->Rows[k][i];
      }
      this->Weights[k] = 1.0 / std::max(0.01, std::abs(this->Values[k] - value));
    }
  }
  return terms[0] * this->Scale;
}

}
