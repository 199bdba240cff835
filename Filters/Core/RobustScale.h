// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file RobustScale.h
 * @brief Scale from data: the median, its absolute deviation, and what they say about sigma.
 *
 * M. J. Black, G. Sapiro, D. H. Marimont, D. Heeger, "Robust anisotropic diffusion", IEEE Trans.
 * Image Processing 7(3), 1998: the scale of a norm is chosen so that values larger than the robust
 * standard deviation of the data count as outliers.
 */

#ifndef SurfaceDenoising_RobustScale_h
#define SurfaceDenoising_RobustScale_h

#include "ErrorNorm.h"

namespace SurfaceDenoising
{

/// Makes the median absolute deviation of normally distributed data estimate their standard
/// deviation.
constexpr double MadConsistency = 1.482602218505602;

/// The median of Rayleigh distributed data (lengths of 2D Gaussian vectors) over the standard
/// deviation per axis.
constexpr double RayleighMedian = 1.177410022515475;

/// How a standard deviation is read off data of one sign.
enum class ScaleEstimator : int
{
  MedianAbsoluteDeviation, ///< 1.4826 median |x - median x|: the literature's; low by a third for
                           ///< lengths
  Rayleigh,                ///< median x / 1.1774: right if x is the length of a 2D Gaussian vector
  HalfNormal ///< 1.4826 median x: right if x is the absolute value of a Gaussian number
};

/// The median, for an even count the mean of the middle two; 0 for no values. Reorders the values.
double Median(Buffer<double>& values);

/// The estimated standard deviation; 0 for no values. Reorders or overwrites the values.
double RobustScale(Buffer<double>& values, ScaleEstimator estimator);

/**
 * The scale of a norm for which the influence of a value is largest at x = sigma and falls (or at
 * least stops growing) beyond: Tukey sqrt(5) sigma, Lorentzian and Centin-Signoroni sigma /
 * sqrt(2), the others sigma.
 */
double ScaleForOutlierBoundary(NormId norm, double sigma);

/**
 * The scale of a norm, in standard deviations of Gaussian data, for which the M-estimate of
 * location is 95% as efficient as the mean (Huber 1.345, Tukey 4.685, ...). Infinite for L2; NaN
 * for the L1 norms, whose efficiency is 64% whatever the scale.
 */
double EfficiencyConstant(NormId norm);

}

#endif
