// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file CloudRisk.h
 * @brief What error a method would leave on a cloud, without knowing the surface.
 *
 * Stein's unbiased risk estimate (C. Stein 1981; by Monte Carlo: S. Ramani, T. Blu, M. Unser 2008):
 * with normally distributed noise of deviation sigma along the normals n_i and steps d_i = n_i .
 * (x_i' - x_i) of a method, the expected squared distance of x_i' from the surface is
 *
 *   R = mean d_i^2 + sigma^2 (2 D - 1),   D = mean of the derivative of n_i . x_i' by n_i . x_i
 *
 * Methods that tell faces apart jump, and have no derivative that a small change would find. So
 * they are run on points moved by e h_i n_i and by -e h_i n_i, with signs h_i and e = sigma / 2,
 * and D = mean of h_i n_i . (x_i+' - x_i-') / 2 e; d_i^2 is the mean of both, from x_i. That is the
 * risk with an eighth more noise. (T. Pang, H. Zheng, Y. Quan, H. Ji 2021 do the same with normally
 * distributed h_i.) Leaving the points alone has R = sigma^2; what smooths
 * too little has a large D, what smooths too much large steps. Sharp or smooth, rough or fine: the
 * method with the least R suits, and nothing needs to be known of the surface.
 *
 * It is enough to do that on a few parts of a cloud.
 */

#ifndef SurfaceDenoising_CloudRisk_h
#define SurfaceDenoising_CloudRisk_h

#include "Automatic/CloudSample.h"

#include <algorithm>
#include <cmath>

namespace SurfaceDenoising
{

/// What the risk of a method is made of.
struct StepStatistics
{
  double Squares;    ///< mean d_i^2, an area. NaN if unknown
  double Derivative; ///< D

  /// R over the square of this deviation, a length: the share of the squared noise that is left.
  /// Below 0 for what is better than the estimate can tell.
  double Risk(double deviation) const
  {
    return this->Squares / (deviation * deviation) + 2.0 * this->Derivative - 1.0;
  }

  /// The deviation of the noise if nothing but noise is removed: a linear method that does that has
  /// mean d_i^2 = sigma^2 (1 - D). More if surface is removed, too.
  double RemovedNoise() const
  {
    return std::sqrt(this->Squares / (1.0 - std::clamp(this->Derivative, 0.0, 0.8)));
  }
};

class CloudRisk
{
public:
  /// On such a sample of the points, see there, under noise of this deviation, a length.
  CloudRisk(const Buffer<Vec3>& points, const CloudNoise& noise, double deviation,
    std::size_t parts, Execution& execution)
    : CloudRisk(points, {}, noise, deviation, parts, execution)
  {
  }

  CloudRisk(const Buffer<Vec3>& points, const Buffer<Vec3>& normals, const CloudNoise& noise,
    double deviation, std::size_t parts, Execution& execution);

  const CloudSample& GetSample() const { return this->Sample; }

  /// The steps of a method. NaN if nothing can be judged or the execution asked to stop.
  StepStatistics StepsOf(const PointDenoisingSettings& settings, Execution& execution) const;

  /// Its risk under noise of the deviation.
  double Of(const PointDenoisingSettings& settings, Execution& execution) const
  {
    return this->StepsOf(settings, execution).Risk(this->Deviation);
  }

private:
  CloudSample Sample;
  double Deviation;
  double Step; ///< e
};

}

#endif
