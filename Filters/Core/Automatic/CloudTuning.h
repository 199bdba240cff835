// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file CloudTuning.h
 * @brief Chooses the settings of a method for a point set.
 *
 * Values are the better the smaller the expected distance of the points from the surface
 * (CloudRisk.h) under the noise that they have (CloudNoise.h), on some parts of the cloud.
 */

#ifndef SurfaceDenoising_CloudTuning_h
#define SurfaceDenoising_CloudTuning_h

#include "../Points/PointDenoising.h"
#include "OpenSettings.h"

namespace SurfaceDenoising
{

struct CloudTuningReport
{
  double Spacing = 0.0;   ///< s, a length
  double Deviation = 0.0; ///< of the noise, a length
  /// There is no noise that a choice could be made for: settings hold what they started with.
  bool NoNoiseFound = false;
  double Seconds = 0.0;
};

/// The spacing and the noise of a cloud. Returns false if the execution asked to stop.
bool MeasureNoise(const PointCloud& cloud, CloudTuningReport& report, Execution& execution);

/**
 * Gives open settings, which are among the settings given, the best values for the cloud, and keeps
 * them as chosen ones. Points that are not finite and outliers are left out. Normals of the cloud
 * count if the settings say so. Returns false if the execution asked to stop.
 */
bool TuneForCloud(const PointCloud& cloud, OpenSettings& open,
  const PointDenoisingSettings& settings, CloudTuningReport& report, Execution& execution);

}

#endif
