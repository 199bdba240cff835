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

#include "Automatic/CloudNoise.h"
#include "Points/PointDenoising.h"

namespace SurfaceDenoising
{

class CloudRisk
{
public:
  /**
   * Takes samples of the points: so many parts of 800, of which the inner 450 are judged, or all
   * points if there are not more; of clouds in rows (CloudNoise.h) half as many parts of twice the
   * size. They and the signs h_i follow from the distances of the points from their mean, so that
   * they do not depend on how the cloud is turned. All points must be finite. The deviation is a
   * length; of the noise only the spacing and the widening count.
   */
  CloudRisk(const Buffer<Vec3>& points, const CloudNoise& noise, double deviation,
    std::size_t parts, Execution& execution)
    : CloudRisk(points, {}, noise, deviation, parts, execution)
  {
  }

  /// The same with normals that methods may start from, one per point or none.
  CloudRisk(const Buffer<Vec3>& points, const Buffer<Vec3>& normals, const CloudNoise& noise,
    double deviation, std::size_t parts, Execution& execution);

  /// False if there are so few points to judge that risks mean little.
  bool IsMeaningful() const { return this->Judged >= 50; }

  std::size_t NumberOfPoints() const { return this->Sample.size(); }

  /// R over sigma^2: the share of the squared noise that the method leaves. Below 0 for what is
  /// better than the estimate can tell. NaN if nothing can be judged or the execution asked to
  /// stop.
  double Of(const PointDenoisingSettings& settings, Execution& execution) const;

private:
  Buffer<Vec3> Run(const PointDenoisingSettings& settings, Buffer<Vec3> positions,
    Execution& execution) const;

  double Deviation;
  double Step; ///< e
  Buffer<Vec3> Sample;
  Buffer<Vec3> Normals;    ///< that came with the points, if any
  Buffer<Vec3> Directions; ///< h_i n_i; zero for points that are not judged
  std::size_t Judged = 0;
};

}

#endif
