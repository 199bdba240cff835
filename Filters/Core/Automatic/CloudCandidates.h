// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file CloudCandidates.h
 * @brief The methods for point sets that the automatic choice is made from, and their settings.
 */

#ifndef SurfaceDenoising_CloudCandidates_h
#define SurfaceDenoising_CloudCandidates_h

#include "../Points/PointDenoising.h"
#include "AutomaticSettings.h"

#include <vector>

namespace SurfaceDenoising
{

/// Something to try, and the noise for which it can be the best, in spacings.
struct CloudCandidate
{
  const char* Method; ///< its name, as in PointMethods, or that of the composer
  const char* Kind;   ///< of surface, for people
  SurfaceType Type;
  double From;
  double To;
  PointDenoisingSettings Settings;
};

/**
 * What to try at this noise level, in spacings, from gentle to strong. Points in rows
 * (CloudNoise.h) take w times as many neighbours, up to 200, for normals; candidates with as many
 * more for everything else, too, follow those with a few.
 */
std::vector<CloudCandidate> CloudCandidatesFor(double level, std::size_t widening,
  const AutomaticSettings& asked);

}

#endif
