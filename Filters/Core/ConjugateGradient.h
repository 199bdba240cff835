// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file ConjugateGradient.h
 * @brief Solves A X = B for a symmetric positive definite matrix and three right-hand sides.
 *
 * The matrix is a function that multiplies. The columns (x, y, z) share the products, which are
 * what takes time, and are three separate solves otherwise: each has its own step lengths and stops
 * on its own. Jacobi preconditioner. Sums are ordered, so that results have the same bits on any
 * number of threads.
 */

#ifndef SurfaceDenoising_ConjugateGradient_h
#define SurfaceDenoising_ConjugateGradient_h

#include "Execution.h"
#include "Types.h"

#include <cmath>

namespace SurfaceDenoising
{

struct ConjugateGradientResult
{
  int Iterations = 0;
  /// |B - A X| of each column, relative to the larger of |B| and |B - A X| at the start.
  Vec3 Residuals = Vec3(0.0, 0.0, 0.0);
  bool Converged = false; ///< all residuals are within the tolerance
  bool Stopped = false;   ///< by the execution; x is somewhere on the way
};

/// Sums that a sweep collects, per column.
struct ConjugateGradientSums
{
  Vec3 Squares = Vec3(0.0, 0.0, 0.0);        ///< r . r
  Vec3 Preconditioned = Vec3(0.0, 0.0, 0.0); ///< r . r / diagonal

  ConjugateGradientSums& operator+=(const ConjugateGradientSums& other)
  {
    this->Squares += other.Squares;
    this->Preconditioned += other.Preconditioned;
    return *this;
  }
};

/**
 * Improves x, the start, until every column has a relative residual of at most tolerance.
 *
 * apply(p, ap) writes A p into ap. diagonal is that of A, with 0 in the rows whose x is to stay as
 * it is: the other rows are solved with these values given, so that fixed vertices need no matrix
 * of their own. Columns that meet a direction without positive energy, rounding errors or a matrix
 * that is not positive definite, end where they are. Progress is reported from first to last.
 */
template <typename Apply>
ConjugateGradientResult SolveConjugateGradient(Apply apply, const Buffer<double>& diagonal,
  const Buffer<Vec3>& rhs, Buffer<Vec3>& x, double tolerance, int maximumIterations,
  Execution& execution, double first, double last)
{
  const std::size_t count = rhs.size();
  Buffer<Vec3> residual(count);
  Buffer<Vec3> direction(count);
  Buffer<Vec3> product(count);
  auto inverse = [&diagonal](std::size_t i) { return diagonal[i] > 0.0 ? 1.0 / diagonal[i] : 0.0; };
  auto collect = [](const Vec3& r, double inverse) {
    return ConjugateGradientSums{ r.cwiseAbs2(), inverse * r.cwiseAbs2() };
  };

  apply(x, product);
  const Vec3 rhsSquares = OrderedSum(execution, count, Vec3(0.0, 0.0, 0.0),
    [&](std::size_t i) { return Vec3((diagonal[i] > 0.0 ? 1.0 : 0.0) * rhs[i].cwiseAbs2()); });
  ConjugateGradientSums sums = OrderedSum(execution, count, ConjugateGradientSums(),
    [&](std::size_t i)
    {
      const double d = inverse(i);
      residual[i] = d > 0.0 ? Vec3(rhs[i] - product[i]) : Vec3(0.0, 0.0, 0.0);
      direction[i] = d * residual[i];
      return collect(residual[i], d);
    });
  const Vec3 reference = rhsSquares.cwiseMax(sums.Squares).cwiseSqrt();

  ConjugateGradientResult result;
  std::array<bool, 3> active = { true, true, true };
  double done = 0.0;
  for (;; ++result.Iterations)
  {
    result.Converged = true;
    for (int c = 0; c < 3; ++c)
    {
      result.Residuals[c] = reference[c] > 0.0 ? std::sqrt(sums.Squares[c]) / reference[c] : 0.0;
      const bool good = result.Residuals[c] <= tolerance;
      result.Converged = result.Converged && good;
      active[c] = active[c] && !good;
    }
    if (result.Iterations >= maximumIterations || !(active[0] || active[1] || active[2]))
    {
      return result;
    }
    // Residuals fall about geometrically, not monotonically.
    const double fall = std::log(result.Residuals.maxCoeff()) / std::log(tolerance);
    done = std::max({ done, std::min(fall, 1.0), double(result.Iterations) / maximumIterations });
    if (!execution.Proceed(first + (last - first) * done))
    {
      result.Stopped = true;
      return result;
    }

    apply(direction, product);
    const Vec3 energy = OrderedSum(execution, count, Vec3(0.0, 0.0, 0.0),
      [&](std::size_t i) { return Vec3(direction[i].cwiseProduct(product[i])); });
    Vec3 step(0.0, 0.0, 0.0); // of finished columns
    for (int c = 0; c < 3; ++c)
    {
      const double length = sums.Preconditioned[c] / energy[c];
      active[c] = active[c] && energy[c] > 0.0 && std::isfinite(length);
      step[c] = active[c] ? length : 0.0;
    }
    const ConjugateGradientSums next = OrderedSum(execution, count, ConjugateGradientSums(),
      [&](std::size_t i)
      {
        const double d = inverse(i);
        x[i] += step.cwiseProduct(direction[i]);
        residual[i] -= (d > 0.0 ? 1.0 : 0.0) * step.cwiseProduct(product[i]);
        return collect(residual[i], d);
      });
    Vec3 turn(0.0, 0.0, 0.0);
    for (int c = 0; c < 3; ++c)
    {
      turn[c] = active[c] ? next.Preconditioned[c] / sums.Preconditioned[c] : 0.0;
    }
    sums = next;
    execution.For(count,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          direction[i] = inverse(i) * residual[i] + turn.cwiseProduct(direction[i]);
        }
      });
  }
}

}

#endif
