// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file CloudSample.h
 * @brief Parts that stand for a cloud, to try methods on.
 */

#ifndef SurfaceDenoising_CloudSample_h
#define SurfaceDenoising_CloudSample_h

#include "Automatic/CloudNoise.h"
#include "Points/PointDenoising.h"

namespace SurfaceDenoising
{

/// What is in it, and where, follows from the distances of the points from their mean, so that it
/// does not depend on how the cloud is turned.
class CloudSample
{
public:
  /**
   * Takes so many parts of 800 points, of which the inner 450 are judged, or all points if there
   * are not more; of clouds in rows (CloudNoise.h) half as many parts of twice the size. All points
   * must be finite. Normals, one per point or none, are those that methods may start from. The
   * deviation is that of the noise along the normal, a length; of the noise only the spacing and
   * the widening count.
   */
  CloudSample(const Buffer<Vec3>& points, const Buffer<Vec3>& normals, const CloudNoise& noise,
    double deviation, std::size_t parts, Execution& execution);

  /// False if there are so few points to judge that what is seen of them means little.
  bool IsMeaningful() const { return this->Judged.size() >= 50; }

  /// What a method makes of the sample with its points at these positions. Empty if the execution
  /// asked to stop.
  Buffer<Vec3> Denoise(const PointDenoisingSettings& settings, Buffer<Vec3> positions,
    Execution& execution) const;

  Buffer<Vec3> Positions;
  Buffer<Vec3> Normals;    ///< that came with the points, if any
  Buffer<Vec3> Directions; ///< normals of planes, with signs that look random
  Buffer<Index> Judged;    ///< points to judge, in an order that looks random
};

}

#endif
