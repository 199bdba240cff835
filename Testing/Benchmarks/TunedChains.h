// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file TunedChains.h
 * @brief Methods with a choice of parameters each, of which the best for a surface is what a
 * patient user may find by hand.
 */

#ifndef TunedChains_h
#define TunedChains_h

#include "Automatic/MethodChain.h"

#include <string>

struct TunedChain
{
  std::string Name; ///< methods with their scale, outer and normal iterations
  SurfaceDenoising::MethodChain Steps;
};

std::vector<TunedChain> TunedChains();

#endif
