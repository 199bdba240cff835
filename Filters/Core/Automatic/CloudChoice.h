// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file CloudChoice.h
 * @brief Which method suits a cloud.
 *
 * A dozen candidates and as many more if the noise is strong (CloudCandidates.h), from a sharp
 * filter of few neighbours to a smooth one of many, are tried on samples of the cloud: all on
 * 2400 points, those that are not far behind on 8000. The one with the least estimated risk
 * (CloudRisk.h) suits, or none if none is better than leaving the points alone. What it removes
 * tells the noise better: the choice is made once more with that, of 0.8 to 1.2 times the first
 * noise. Up to five others with a risk of at most r + 0.15 (1 - r), where r is the least, are tried
 * beside the best on surfaces that it and the first two of them made (CloudTrials.h). The one that
 * leaves the least distances is chosen, if it clearly does (TrialVerdict.h). Points in rows
 * (CloudNoise.h) take twice as many candidates, and no trials.
 */

#ifndef SurfaceDenoising_CloudChoice_h
#define SurfaceDenoising_CloudChoice_h

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

}

#endif
