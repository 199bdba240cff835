// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RobustQuadric.h"

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
  this->Rows.emplace_back();
  this->Rows.back() << 1.0, a, b, a * a, a * b, b * b;
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
  Row terms = Row::Zero();
  for (int step = 0; step < Reweightings; ++step)
  {
    Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
    Row right = Row::Zero();
    for (std::size_t k = 0; k < count; ++k)
    {
      const Row weighted = this->Weights[k] * this->Rows[k];
      matrix += weighted * this->Rows[k].transpose();
      right += this->Values[k] * weighted;
    }
    // Points on a few lines do not determine all terms.
    matrix.diagonal().array() += 1e-9 * double(count);
    terms = matrix.ldlt().solve(right);
    for (std::size_t k = 0; k < count; ++k)
    {
      const double residual = std::abs(this->Values[k] - terms.dot(this->Rows[k]));
      this->Weights[k] = 1.0 / std::max(0.01, residual);
    }
  }
  return terms[0] * this->Scale;
}

}
