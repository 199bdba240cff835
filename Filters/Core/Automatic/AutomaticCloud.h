// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file AutomaticCloud.h
 * @brief Denoises a cloud without a setting: measures the noise, chooses the method, handles
 * outliers.
 *
 * 1. EstimateNoise tells the noise level and the outliers.
 * 2. A dozen candidates and as many more if the noise is strong (CloudCandidates.h), from a sharp
 *    filter of few neighbours to a smooth one of many, are tried on samples of the cloud: all on
 *    2400 points, those that are not far behind on 8000. The one with the least estimated risk
 *    (CloudRisk.h) suits, or none if none is better than leaving the points alone. What it removes
 *    tells the noise better: the choice is made once more with that, of 0.8 to 1.2 times the first
 *    noise. Up to six with a risk R of at most r + 0.15 (1 - r), where r is the least, are tried on
 *    surfaces that the best three made (CloudTrials.h). The one with the least distances is chosen:
 *    with the least sum of their logarithm and 0.15 log(R + 0.05). Points in rows (CloudNoise.h)
 *    take twice as many candidates, and no trials.
 * 3. It runs on all points but the outliers, which so have no say in the fits of their neighbours.
 * 4. Outliers up to ten spacings from the surface of the nearest denoised points (SurfaceStep.h) go
 *    there. Those that are farther away stay where they are, marked as kept: they are no part of
 *    this surface.
 *
 * Trying takes some seconds whatever the size: small clouds take many times as long as the chosen
 * method alone, a cloud of 200 thousand points two to four times as long, larger ones less. Clouds
 * in rows take several times as long: half a minute and more if the noise is strong.
 */

#ifndef SurfaceDenoising_AutomaticCloud_h
#define SurfaceDenoising_AutomaticCloud_h

#include "Automatic/AutomaticSettings.h"
#include "Automatic/CloudNoise.h"
#include "Points/PointDenoising.h"

#include <string>

namespace SurfaceDenoising
{

struct CloudChoice
{
  bool Nothing = true;             ///< leave the points alone
  std::string Method = "None";     ///< its name, as in PointMethods, or that of the composer
  std::string Reason;              ///< a sentence for people
  PointDenoisingSettings Settings; ///< if there is something to do
  double Remaining = 1.0; ///< root of the share of the squared noise that should be left, in [0, 1]
};

/**
 * What to do with points (all finite) that have this noise, times the strength. Depends neither on
 * the order of the points nor on the number of threads. If the execution asks to stop, the choice
 * is of no use.
 */
CloudChoice ChooseForCloud(const Buffer<Vec3>& points, const CloudNoise& noise, double strength,
  SurfaceType type, Execution& execution);

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
