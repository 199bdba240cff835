// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file LocalFits.h
 * @brief Polynomials through the neighbours of points, and what is left of the points over them.
 *
 * Around a point, a polynomial z = g(x, y) of degree 2 is fitted to it and its k nearest points in
 * the frame of their plane. The residuals tell the local deviation, sqrt(sum r^2 / (k + 1 - 6)),
 * for three sizes: k = 9 w, 20 w and 40 w with a widening w of 1, 2, 4, 8 or 16.
 *
 * Points in rows, as scanners leave them, lie on a curve if they are few. Their plane is thin then,
 * or it is the plane of the curve, in which noise does not show; and of a row and a point or two
 * beside it the polynomial takes up all noise. Such fits have no say: where the lesser variance in
 * the plane is less than 0.15 times the larger; where the least pivot of the normal equations, in
 * coordinates of unit variance, is less than 0.05 times the number of points (clouds without rows
 * have more almost everywhere); and where the plane is more than 60 degrees from that of 40 w
 * points. If more than a fifth of the points are without the smallest fit, w is too small.
 */

#ifndef SurfaceDenoising_LocalFits_h
#define SurfaceDenoising_LocalFits_h

#include "CompressedRows.h"
#include "Execution.h"
#include "Types.h"

namespace SurfaceDenoising
{

struct LocalFits
{
  static constexpr std::size_t FewNeighbors = 9;
  static constexpr std::size_t SomeNeighbors = 20;
  static constexpr std::size_t ManyNeighbors = 40;
  static constexpr std::size_t Coefficients = 6;
  static constexpr std::size_t MostWidening = 16;

  std::size_t Widening = 1;    ///< w
  Buffer<double> Few;          ///< deviations; negative without a fit
  Buffer<double> Some;         ///< the same
  Buffer<double> Many;         ///< the same
  Buffer<double> Kurtoses;     ///< of the residuals of the smallest fits
  Buffer<double> ManyKurtoses; ///< of those of the largest fits
  /// Of points over the fit of 20 w others, absolute; negative without one.
  Buffer<double> Heights;

  /// Whether four in five points that have a fit of the largest size have one of the smallest.
  bool AreOfSurface() const;

  /**
   * Whether the residuals of the smallest fits may be noise of all points: their kurtosis is at
   * least 2.9 on average, and its lower quartile at least 3 - 3.5 / sqrt(9 w + 1). Of normally
   * distributed noise it is 3, and 2.94 or more was measured whatever the surface. Those of the two
   * sheets of a thin part have fewer extreme values; under noise with heavy tails, only the
   * quartile shows that. Of impulsive noise the average is more than 1.4 above the quartile: some
   * fits have more impulses than others.
   */
  bool AreOfNoise() const;

  /// What residuals are where the surface is smooth.
  struct Residuals
  {
    double Deviation; ///< median of those of the largest fits
    /// Median over the half of the points with less deviation. Without detail 2.8 to 3.2 for
    /// normally distributed noise, 3.4 to 4.1 if its kurtosis is 5.4.
    double Kurtosis;
  };

  /// Of the largest fits, which have enough residuals to show it. 0 and 3 if there are none.
  Residuals ResidualsOfMany() const;

  /// The values of points that have one: those that are not negative.
  static Buffer<double> Known(const Buffer<double>& values);
};

/// Around every point, with w = 1; the graph has the 40 nearest others. Those that are left out are
/// neither neighbours nor fitted. Heights only if they are asked for.
LocalFits FitEverywhere(const Buffer<Vec3>& points, const CompressedRows& nearest,
  const Buffer<unsigned char>& leftOut, bool heights, Execution& execution);

/**
 * Around some thousand of the points, with the least widening above 1 that is enough for the cloud;
 * without heights. False if none is, or if there are not four times as many points as the largest
 * fit has. Which points are fitted does not depend on how the cloud is turned.
 */
bool FitWidely(const Buffer<Vec3>& points, const Buffer<unsigned char>& leftOut, LocalFits& fits,
  Execution& execution);

}

#endif
