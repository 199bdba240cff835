// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MovingLeastSquares.h"

#include "InterruptedExecution.h"
#include "NormalFilter.h"
#include "PointUpdate.h"
#include "Vectorize.h"

#include <Eigen/Cholesky>

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// Weights are computed for a multiple of the widest vector.
constexpr std::size_t Lanes = 8;

constexpr std::size_t RoundUp(std::size_t count) { return (count + Lanes - 1) / Lanes * Lanes; }

/// w_j = exp(-|p_j - q|^2 / h^2); w has room for RoundUp(count).
SURFACEDENOISING_VECTORIZED
void Weigh(const Vec3* points, std::size_t count, const Vec3& q, double inverseSquare, double* w)
{
  const double x = q[0];
  const double y = q[1];
  const double z = q[2];
  for (std::size_t j = 0; j < count; ++j)
  {
    const double dx = points[j][0] - x;
    const double dy = points[j][1] - y;
    const double dz = points[j][2] - z;
    w[j] = -(dx * dx + dy * dy + dz * dz) * inverseSquare;
  }
  const std::size_t end = RoundUp(count);
  for (std::size_t j = count; j < end; ++j)
  {
    w[j] = 0.0;
  }
  for (std::size_t j = 0; j < end; ++j)
  {
    w[j] = ExpOfNegative(w[j]);
  }
}

/// A plane with axes at the foot; a, b and heights are in units of h.
struct Frame
{
  Vec3 Foot;
  Vec3 U;
  Vec3 V;
  Vec3 N;
  double InverseH;
};

/// How many coefficients a polynomial of a degree in two variables has.
constexpr int Coefficients(int degree) { return (degree + 1) * (degree + 2) / 2; }

/**
 * The first coefficients of the weighted least squares polynomial over the frame, in the order 1,
 * a, b, a^2, a b, b^2. False if the points do not determine it.
 *
 * Normal equations square the condition of the problem. In units of h and with a unit diagonal, the
 * smallest pivot tells how much is lost: around a point it is about 1e-2, and down to the limit
 * half of the digits are left. Below, the points lie on a conic section in all but rounding.
 */
template <int Degree>
bool FitPolynomial(const std::vector<Vec3>& around, const double* weights, const Frame& frame,
  Vec3& first)
{
  constexpr int size = Coefficients(Degree);
  constexpr double smallestPivot = 1e-8;
  using Matrix = Eigen::Matrix<double, size, size>;
  using Vector = Eigen::Matrix<double, size, 1>;
  if (around.size() <= size)
  {
    return false;
  }
  std::array<double, size*(size + 1) / 2> sums = {};
  std::array<double, size> right = {};
  for (std::size_t j = 0; j < around.size(); ++j)
  {
    const Vec3 e = frame.InverseH * (around[j] - frame.Foot);
    const double a = frame.U.dot(e);
    const double b = frame.V.dot(e);
    const double height = frame.N.dot(e);
    const double terms[6] = { 1.0, a, b, a * a, a * b, b * b };
    int entry = 0;
    for (int k = 0; k < size; ++k)
    {
      const double weighted = weights[j] * terms[k];
      right[k] += weighted * height;
      for (int l = 0; l <= k; ++l)
      {
        sums[entry++] += weighted * terms[l];
      }
    }
  }
  Vector scale;
  for (int k = 0; k < size; ++k)
  {
    const double square = sums[(k + 1) * (k + 2) / 2 - 1];
    if (!(square > NormalFilter::NoWeight))
    {
      return false;
    }
    scale[k] = 1.0 / std::sqrt(square);
  }
  Matrix matrix;
  Vector solution;
  for (int k = 0, entry = 0; k < size; ++k)
  {
    for (int l = 0; l <= k; ++l, ++entry)
    {
      matrix(k, l) = matrix(l, k) = scale[k] * scale[l] * sums[entry];
    }
    solution[k] = scale[k] * right[k];
  }
  const Eigen::LDLT<Matrix> factors(matrix);
  if (!(factors.vectorD().minCoeff() > smallestPivot))
  {
    return false;
  }
  solution = factors.solve(solution);
  first = scale.template head<3>().cwiseProduct(solution.template head<3>());
  return first.allFinite();
}

}

MovingFit FitMovingSurface(const std::vector<Vec3>& around, double h, int degree, int planeRounds)
{
  static thread_local std::vector<double> weights;
  const std::size_t count = around.size();
  weights.resize(RoundUp(count));
  MovingFit fit;
  if (!(h > 0.0))
  {
    return fit;
  }
  const double inverseSquare = 1.0 / (h * h);
  Weigh(around.data(), count, fit.Foot, inverseSquare, weights.data());
  for (int round = 0; round < std::max(1, planeRounds); ++round)
  {
    PlaneSum sum;
    std::size_t weighted = 0;
    for (std::size_t j = 0; j < count; ++j)
    {
      sum.Add(around[j], weights[j]);
      weighted += weights[j] > NormalFilter::NoWeight;
    }
    const Plane plane = weighted < 3 ? Plane() : sum.Fit();
    if (plane.Normal.isZero(0.0))
    {
      return fit; // the plane before, or none
    }
    fit.Reference = plane;
    const Vec3 foot = plane.Normal.dot(plane.Centre) * plane.Normal;
    const double moved = (foot - fit.Foot).norm();
    fit.Foot = fit.Place = foot;
    fit.Normal = plane.Normal;
    Weigh(around.data(), count, foot, inverseSquare, weights.data());
    if (moved < 1e-6 * h)
    {
      break;
    }
  }
  Frame frame;
  frame.Foot = fit.Foot;
  frame.N = fit.Normal;
  frame.U = frame.N.unitOrthogonal();
  frame.V = frame.N.cross(frame.U);
  frame.InverseH = 1.0 / h;
  Vec3 first;
  if (degree >= 2 && FitPolynomial<2>(around, weights.data(), frame, first))
  {
    fit.Degree = 2;
  }
  else if (degree >= 1 && FitPolynomial<1>(around, weights.data(), frame, first))
  {
    fit.Degree = 1;
  }
  else
  {
    return fit;
  }
  fit.Place = fit.Foot + h * first[0] * frame.N;
  fit.Normal = (frame.N - first[1] * frame.U - first[2] * frame.V).normalized();
  return fit;
}

namespace
{

class MovingLeastSquares : public PointOperator
{
public:
  explicit MovingLeastSquares(const MovingLeastSquaresSettings& settings)
    : Settings(settings)
  {
  }

  bool Run(PointSet& points, Execution& execution, double first, double last) override
  {
    Buffer<Vec3> places(points.Size());
    Buffer<Vec3> normals(points.Size());
    InterruptedExecution interrupted(execution, first, last);
    interrupted.For(
      points.Size(),
      [&](std::size_t begin, std::size_t end)
      {
        std::vector<Vec3> around; // of the points of a stretch, not of each
        for (std::size_t i = begin; i < end; ++i)
        {
          this->Project(points, i, around, places[i], normals[i]);
        }
      },
      512);
    if (!interrupted.Proceed(last))
    {
      return false;
    }
    MoveTo(places, points, execution);
    TurnTo(normals, points, execution);
    return true;
  }

private:
  void Project(PointSet& points, std::size_t i, std::vector<Vec3>& around, Vec3& place,
    Vec3& normal) const
  {
    const Vec3& x = points.Positions[i];
    around.assign(1, Vec3(0.0, 0.0, 0.0));
    for (const Index j : points.Neighbors.Row(i))
    {
      around.push_back(points.Positions[j] - x);
    }
    const double h = this->Settings.Bandwidth > 0.0 ? this->Settings.Bandwidth * points.SpacingAt(i)
                                                    : 0.5 * around.back().norm();
    const MovingFit fit =
      FitMovingSurface(around, h, this->Settings.Degree, this->Settings.PlaneRounds);
    place = x + fit.Place;
    normal = fit.Normal.dot(points.Normals[i]) < 0.0 ? Vec3(-fit.Normal) : fit.Normal;
    if (normal.isZero(0.0))
    {
      points.Status[i] = PointStatus::Kept;
    }
  }

  MovingLeastSquaresSettings Settings;
};

}

std::unique_ptr<PointOperator> MakeMovingLeastSquares(const MovingLeastSquaresSettings& settings)
{
  return std::make_unique<MovingLeastSquares>(settings);
}

}
