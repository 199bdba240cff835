// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file TunedClouds.h
 * @brief Methods for points with a choice of parameters each, of which the best for a cloud is what
 * a patient user may find by hand.
 */

#ifndef TunedClouds_h
#define TunedClouds_h

#include "Points/PointDenoising.h"

#include <string>
#include <vector>

struct TunedCloud
{
  std::string Name; ///< the method and the parameters that are not its defaults
  SurfaceDenoising::PointDenoisingSettings Settings;
};

std::vector<TunedCloud> TunedClouds();

#endif
