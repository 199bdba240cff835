// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file CloudTrials.h
 * @brief Which of several methods leaves points nearest to the surface, where risks are alike.
 *
 * The risk (CloudRisk.h) is of squares: a few points far off the surface decide. And it is that
 * under noise that is a little more even than the noise of the cloud. So it hardly tells methods
 * apart that keep most points closer, but give up a few. Trials do: what a method made of a sample
 * is taken for a surface; what it removed, in another order, is added again as noise; and what is
 * left after a method is measured. TrialVerdict.h compares. For meshes see PlausibleSurfaces.h.
 */

#ifndef SurfaceDenoising_CloudTrials_h
#define SurfaceDenoising_CloudTrials_h

#include "Automatic/CloudSample.h"

#include <vector>

namespace SurfaceDenoising
{

class CloudTrials
{
public:
  /// On a sample, which must outlive the trials, of a cloud that has no points in rows
  /// (CloudNoise.h), under noise of this deviation, a length.
  CloudTrials(const CloudSample& sample, double deviation)
    : Sample(sample)
    , Deviation(deviation)
  {
  }

  /// Adds what the method makes of the sample to the surfaces. Returns false if it leaves the
  /// points alone or the execution asks to stop: no surface then.
  bool AddSurface(const PointDenoisingSettings& method, Execution& execution);

  std::size_t NumberOfSurfaces() const { return this->Surfaces.size(); }
  std::size_t NumberOfJudged() const { return this->Sample.Judged.size(); }

  /**
   * The logarithm of the mean distance, in deviations of the noise, that a method leaves between
   * the points to be judged and the tangent planes of their places on a surface. Of no use if the
   * execution asks to stop.
   */
  double LogDistance(std::size_t surface, const PointDenoisingSettings& method,
    Execution& execution) const;

private:
  struct Surface
  {
    Buffer<Vec3> Positions;
    Buffer<Vec3> Normals;
    Buffer<Vec3> Noisy; ///< the positions with noise
  };

  const CloudSample& Sample;
  double Deviation;
  std::vector<Surface> Surfaces;
};

}

#endif
