// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SymmetricEigen.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Jacobi>

namespace SurfaceDenoising
{

/// The closed form is three times as fast as the iteration, but its vectors are orthogonal to eight
/// digits only. With that mended, a sweep of rotations brings the other digits.
Eigensystem Decompose(const Mat3& matrix)
{
  Eigen::SelfAdjointEigenSolver<Mat3> solver;
  solver.computeDirect(matrix);
  Mat3 vectors = solver.eigenvectors();
  const Vec3 first = vectors.col(2).normalized();
  const Vec3 second = (vectors.col(1) - first.dot(vectors.col(1)) * first).normalized();
  vectors << second.cross(first), second, first;
  Mat3 nearlyDiagonal = vectors.transpose() * matrix * vectors;
  for (const auto& pair : { std::make_pair(0, 1), std::make_pair(0, 2), std::make_pair(1, 2) })
  {
    Eigen::JacobiRotation<double> rotation;
    if (rotation.makeJacobi(nearlyDiagonal, pair.first, pair.second))
    {
      nearlyDiagonal.applyOnTheLeft(pair.first, pair.second, rotation.adjoint());
      nearlyDiagonal.applyOnTheRight(pair.first, pair.second, rotation);
      vectors.applyOnTheRight(pair.first, pair.second, rotation);
    }
  }
  return { nearlyDiagonal.diagonal(), vectors };
}

namespace
{

/// The adjugate of a - shift, a symmetric matrix: about that shift^-1 apart from a factor, and
/// finite where the shift is an eigenvalue; it then projects onto the vector.
inline Mat3 ShiftedAdjugate(const Mat3& a, double shift)
{
  const double x = a(0, 0) - shift;
  const double y = a(1, 1) - shift;
  const double z = a(2, 2) - shift;
  const double p = a(1, 0);
  const double q = a(2, 0);
  const double r = a(2, 1);
  const double xy = q * r - p * z;
  const double xz = p * r - q * y;
  const double yz = p * q - r * x;
  Mat3 adjugate;
  adjugate << y * z - r * r, xy, xz, xy, x * z - q * q, yz, xz, yz, x * y - p * p;
  return adjugate;
}

}

/// Newton's method finds the smallest root of the characteristic polynomial from below; the largest
/// column of the adjugate then is the vector to many digits, and a Rayleigh quotient iteration,
/// which triples their number, brings the others.
LeastAxis FindLeastAxis(const Mat3& matrix)
{
  constexpr double separation = 1e-4;
  constexpr double accuracy = 2e-15;
  const double trace = matrix.trace();
  if (!(trace > 1e-60 && trace < 1e60) && trace > 0.0 && std::isfinite(trace))
  {
    // Products of three are no numbers.
    const LeastAxis system = FindLeastAxis(matrix / trace);
    return { system.Values * trace, system.Vector };
  }
  const double p = matrix(1, 0);
  const double q = matrix(2, 0);
  const double r = matrix(2, 1);
  const double minors = matrix(0, 0) * matrix(1, 1) - p * p +
    (matrix(0, 0) * matrix(2, 2) - q * q) + (matrix(1, 1) * matrix(2, 2) - r * r);
  const double determinant = matrix(0, 0) * (matrix(1, 1) * matrix(2, 2) - r * r) +
    p * (q * r - p * matrix(2, 2)) + q * (p * r - q * matrix(1, 1));
  double root = 0.0;
  for (int step = 0; step < 5; ++step)
  {
    const double slope = (3.0 * root - 2.0 * trace) * root + minors;
    const double value = ((root - trace) * root + minors) * root - determinant;
    const double change = value / slope;
    root -= change;
    if (!(std::abs(change) > 1e-7 * trace))
    {
      break;
    }
  }
  const Mat3 adjugate = ShiftedAdjugate(matrix, root);
  Eigen::Index largest;
  adjugate.diagonal().cwiseAbs().maxCoeff(&largest);
  Vec3 vector = adjugate.col(largest).normalized();
  for (int step = 0; step < 2; ++step)
  {
    const Vec3 image = matrix * vector;
    const double value = vector.dot(image);
    const double rest = trace - value;
    const double product = minors - value * rest;
    const double last = 0.5 * (rest + std::sqrt(std::max(0.0, rest * rest - 4.0 * product)));
    const double middle = rest - last;
    if (!(middle - value > separation * trace))
    {
      break;
    }
    if ((image - value * vector).squaredNorm() <= accuracy * accuracy * trace * trace)
    {
      return { Vec3(value, middle, last), vector };
    }
    vector = (ShiftedAdjugate(matrix, value) * vector).normalized();
  }
  const Eigensystem system = Decompose(matrix);
  return { system.Values, system.Vectors.col(0) };
}

}
