// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file AutomaticCloud.h
 * @brief Denoises a cloud without a setting: measures the noise, chooses the method, handles
 * outliers.
 *
 * 1. EstimateNoise tells the noise level and the outliers.
 * 2. Of two dozen methods the one that promises the least error is chosen (CloudChoice.h).
 * 3. It runs on all points but the outliers, which so have no say in the fits of their neighbours.
 * 4. Outliers up to ten spacings from the surface of the nearest denoised points (SurfaceStep.h) go
 *    there. Those that are farther away stay where they are, marked as kept: they are no part of
 *    this surface.
 *
 * Trying takes some seconds whatever the size: small clouds take many times as long as the chosen
 * method alone, a cloud of 200 thousand points five times as long, one of 800 thousand two to three
 * times. Clouds in rows take several times as long: half a minute and more if the noise is strong.
 */

#ifndef SurfaceDenoising_AutomaticCloud_h
#define SurfaceDenoising_AutomaticCloud_h

#include "Automatic/CloudChoice.h"
#include "Points/PointDenoising.h"

namespace SurfaceDenoising
{

struct AutomaticCloudReport
{
  CloudNoise Noise; ///< as measured, without the strength
  CloudChoice Choice;
  PointDenoisingReport Denoising;
  std::size_t Pulled = 0;       ///< outliers that went to the surface
  std::size_t LeftOutliers = 0; ///< outliers that stayed
};

/**
 * Denoises the cloud in place as DenoisePoints does: new positions and normals; statuses. Without
 * noise and outliers it stays as it is, without statuses if it has none. Where normals are given,
 * those of the result are on the same side; they are not relied on otherwise. Returns false if the
 * execution asked to stop; the cloud is unchanged then.
 */
bool DenoiseAutomatically(PointCloud& cloud, const AutomaticSettings& settings,
  AutomaticCloudReport& report, Execution& execution);

}

#endif
