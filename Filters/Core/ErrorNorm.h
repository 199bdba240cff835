// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file ErrorNorm.h
 * @brief All robust error norms, one struct each. A new norm is added here and nowhere else.
 *
 * An M-estimate minimises the sum of rho(x). Its influence function is psi = rho' and its weight
 * function g = psi / x. A norm is written once, as the weight of the squared argument,
 * WeightOfSquare(x^2): most norms need no root, and a filter has the square at hand. It is free of
 * branches, so that compilers vectorise it. Rho and Psi state the other two functions in closed
 * form; the tests hold the three together. All norms are scaled to g(0) = 1 wherever g(0) is
 * finite.
 *
 * x >= 0 has the unit of the argument that the filter uses (chord length of unit normals in [0, 2],
 * angle in radians, ...). Scale is the norm's sigma or threshold T in the same unit and must be
 * positive.
 *
 * The list follows Table 1 of S. K. Yadav, M. Skrodzki, E. Zimmermann, K. Polthier, "Surface
 * Denoising based on Normal Filtering in a Robust Statistics Framework". Where the rows of the
 * table disagree by constant factors the versions here are made consistent (psi = rho', g = psi /
 * x, g(0) = 1).
 */

#ifndef SurfaceDenoising_ErrorNorm_h
#define SurfaceDenoising_ErrorNorm_h

#include "Types.h"
#include "Vectorize.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace SurfaceDenoising
{

/// What the theory says of a norm; the tests check each statement on the functions themselves.
struct NormProperties
{
  bool BoundedInfluence; ///< psi stays below a constant: a single outlier cannot dominate
  bool Monotone;         ///< psi never decreases: the energy is convex, no local minima
  bool Redescending;     ///< psi returns to 0 for large x: outliers lose their influence
  bool BoundedNorm;      ///< rho stays below a constant
};

/// rho = x^2 / 2: the mean. Every outlier pulls with its full weight.
struct L2Norm
{
  static constexpr const char* Name = "L2";
  static constexpr NormProperties Properties{ false, true, false, false };

  double Scale;

  double CutOff() const { return std::numeric_limits<double>::infinity(); }
  double Rho(double x) const { return 0.5 * x * x; }
  double Psi(double x) const { return x; }
  double WeightOfSquare(double) const { return 1.0; }
};

/// rho = min(x^2, T^2) / 2: the mean of what lies within T. (The survey's sigma of this row is
/// T^2.)
struct TruncatedL2Norm
{
  static constexpr const char* Name = "Truncated L2";
  static constexpr NormProperties Properties{ true, false, true, true };

  double Scale;

  double CutOff() const { return this->Scale; }
  double Rho(double x) const { return 0.5 * std::min(x * x, this->Scale * this->Scale); }
  double Psi(double x) const { return x <= this->Scale ? x : 0.0; }
  double WeightOfSquare(double xx) const { return xx <= this->Scale * this->Scale ? 1.0 : 0.0; }
};

/**
 * rho = x: the median. g = 1 / x is infinite at 0, where a site would freeze on its own value, so
 * that it is held at 1 / Scale below Scale (this is Huber's norm divided by Scale): choose Scale
 * small, 0.05 say.
 */
struct L1Norm
{
  static constexpr const char* Name = "L1";
  static constexpr NormProperties Properties{ true, true, false, false };

  double Scale;

  double CutOff() const { return std::numeric_limits<double>::infinity(); }
  double Rho(double x) const
  {
    const double s = this->Scale;
    return x <= s ? 0.5 * x * x / s : x - 0.5 * s;
  }
  double Psi(double x) const { return x <= this->Scale ? x / this->Scale : 1.0; }
  double WeightOfSquare(double xx) const
  {
    return 1.0 / std::sqrt(std::max(xx, this->Scale * this->Scale));
  }
};

/// rho = min(x, T): as L1 up to T, nothing beyond. g is held at 1 / Regularization below
/// Regularization.
struct TruncatedL1Norm
{
  static constexpr const char* Name = "Truncated L1";
  static constexpr NormProperties Properties{ true, false, true, true };

  double Scale;
  double Regularization = 0.05; ///< where 1 / x is cut, at most Scale

  double CutOff() const { return this->Scale; }
  double Rho(double x) const { return L1Norm{ this->Delta() }.Rho(std::min(x, this->Scale)); }
  double Psi(double x) const { return x <= this->Scale ? L1Norm{ this->Delta() }.Psi(x) : 0.0; }
  double WeightOfSquare(double xx) const
  {
    const double g = 1.0 / std::sqrt(std::max(xx, this->Delta() * this->Delta()));
    return xx <= this->Scale * this->Scale ? g : 0.0;
  }

private:
  double Delta() const { return std::min(this->Regularization, this->Scale); }
};

/// Huber's minimax: quadratic up to sigma, linear beyond. Monotone, so edges are rounded in the
/// end.
struct HuberNorm
{
  static constexpr const char* Name = "Huber";
  static constexpr NormProperties Properties{ true, true, false, false };

  double Scale;

  double CutOff() const { return std::numeric_limits<double>::infinity(); }
  double Rho(double x) const
  {
    const double s = this->Scale;
    return x <= s ? 0.5 * x * x : s * x - 0.5 * s * s;
  }
  double Psi(double x) const { return std::min(x, this->Scale); }
  double WeightOfSquare(double xx) const
  {
    const double s = this->Scale;
    return s / std::sqrt(std::max(xx, s * s));
  }
};

/// g = 1 / (1 + x^2 / (2 sigma^2)): influence falls as 1 / x, never to zero.
struct LorentzianNorm
{
  static constexpr const char* Name = "Lorentzian";
  static constexpr NormProperties Properties{ true, false, true, false };

  double Scale;

  double CutOff() const { return std::numeric_limits<double>::infinity(); }
  double Rho(double x) const
  {
    const double ss = this->Scale * this->Scale;
    return ss * std::log1p(0.5 * x * x / ss);
  }
  double Psi(double x) const { return x * this->WeightOfSquare(x * x); }
  double WeightOfSquare(double xx) const
  {
    const double two = 2.0 * this->Scale * this->Scale;
    return two / (two + xx);
  }
};

/**
 * g = exp(-x^2 / (2 sigma^2)): the range kernel of the bilateral filters. The other Gaussian of the
 * literature, exp(-x^2 / sigma^2), is this one with sigma / sqrt(2).
 */
struct GaussianNorm
{
  static constexpr const char* Name = "Gaussian";
  static constexpr NormProperties Properties{ true, false, true, true };

  double Scale;

  double CutOff() const { return std::numeric_limits<double>::infinity(); }
  double Rho(double x) const
  {
    const double ss = this->Scale * this->Scale;
    return -ss * std::expm1(-0.5 * x * x / ss);
  }
  double Psi(double x) const { return x * this->WeightOfSquare(x * x); }
  double WeightOfSquare(double xx) const
  {
    return ExpOfNegative(xx * (-0.5 / (this->Scale * this->Scale)));
  }
};

/// Tukey's biweight, g = (1 - (x / sigma)^2)^2 up to sigma and zero beyond.
struct TukeyNorm
{
  static constexpr const char* Name = "Tukey";
  static constexpr NormProperties Properties{ true, false, true, true };

  double Scale;

  double CutOff() const { return this->Scale; }
  double Rho(double x) const
  {
    const double ss = this->Scale * this->Scale;
    const double u = std::max(0.0, 1.0 - x * x / ss);
    return ss / 6.0 * (1.0 - u * u * u);
  }
  double Psi(double x) const
  {
    const double u = std::max(0.0, 1.0 - x * x / (this->Scale * this->Scale));
    return x * u * u;
  }
  double WeightOfSquare(double xx) const
  {
    const double u = std::max(0.0, 1.0 - xx / (this->Scale * this->Scale));
    return u * u;
  }
};

/**
 * g = 1 up to sigma and Beta beyond. S. K. Yadav, U. Reitebuch, K. Polthier, "Mesh denoising based
 * on normal voting tensor and binary optimization", IEEE TVCG 24(8), 2018, with Beta = 0.1.
 * Influence grows without bound, but slowly: at the sizes that differences of normals have it acts
 * as a truncated mean.
 */
struct BoxNorm
{
  static constexpr const char* Name = "Box";
  static constexpr NormProperties Properties{ false, false, false, false };

  double Scale;
  double Beta = 0.1; ///< weight beyond Scale, in [0, 1]

  double CutOff() const { return std::numeric_limits<double>::infinity(); }
  double Rho(double x) const
  {
    const double ss = this->Scale * this->Scale;
    return x <= this->Scale ? 0.5 * x * x : 0.5 * (this->Beta * x * x + (1.0 - this->Beta) * ss);
  }
  double Psi(double x) const { return x <= this->Scale ? x : this->Beta * x; }
  double WeightOfSquare(double xx) const
  {
    return xx <= this->Scale * this->Scale ? 1.0 : this->Beta;
  }
};

/**
 * g = 1 up to sigma and sigma^2 / ((x - sigma)^2 + sigma^2) beyond. M. Centin, A. Signoroni, "Mesh
 * denoising with (geo)metric fidelity", IEEE TVCG 24(8), 2018.
 */
struct CentinNorm
{
  static constexpr const char* Name = "Centin Signoroni";
  static constexpr NormProperties Properties{ true, false, true, false };

  double Scale;

  double CutOff() const { return std::numeric_limits<double>::infinity(); }
  double Rho(double x) const
  {
    const double s = this->Scale;
    const double t = (std::max(x, s) - s) / s;
    const double inner = std::min(x, s);
    return 0.5 * inner * inner + s * s * (0.5 * std::log1p(t * t) + std::atan(t));
  }
  double Psi(double x) const { return x * this->WeightOfSquare(x * x); }
  double WeightOfSquare(double xx) const
  {
    const double s = this->Scale;
    const double t = std::sqrt(std::max(xx, s * s)) - s;
    return s * s / (t * t + s * s);
  }
};

/**
 * The list that everything else follows: the enumeration below, the menus and the tests. Its order
 * is part of the saved state of user interfaces: add new norms at the end.
 */
using ErrorNorm = std::variant<L2Norm, TruncatedL2Norm, L1Norm, TruncatedL1Norm, HuberNorm,
  LorentzianNorm, GaussianNorm, TukeyNorm, BoxNorm, CentinNorm>;

enum class NormId : int
{
  L2,
  TruncatedL2,
  L1,
  TruncatedL1,
  Huber,
  Lorentzian,
  Gaussian,
  Tukey,
  Box,
  Centin
};

constexpr int NumberOfNorms = static_cast<int>(std::variant_size_v<ErrorNorm>);

/// The norm with the given scale. An id outside the list is an L2 norm.
ErrorNorm MakeErrorNorm(NormId id, double scale);

const char* NameOf(const ErrorNorm& norm);
NormProperties PropertiesOf(const ErrorNorm& norm);

/// x beyond which g is exactly 0, infinite if there is none.
double CutOff(const ErrorNorm& norm);
double Rho(const ErrorNorm& norm, double x);
double Psi(const ErrorNorm& norm, double x);
double Weight(const ErrorNorm& norm, double x);

}

#endif
