// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file CandidateChains.h
 * @brief The chains of methods that the automatic choice is made from.
 */

#ifndef SurfaceDenoising_CandidateChains_h
#define SurfaceDenoising_CandidateChains_h

#include "../Methods.h"
#include "AutomaticSettings.h"
#include "MethodChain.h"

namespace SurfaceDenoising
{

struct CandidateChain
{
  const char* Purpose; ///< what it is for, for people
  SurfaceType Type;
  bool MakesTruth = false; ///< its results serve as truths, see PlausibleSurfaces
  std::vector<Method> Methods;
  MethodChain Steps;
};

/// All of them, from weak to strong for each kind of surface. A new one is added here.
const std::vector<CandidateChain>& CandidateChains();

/// A chain that leaves no more than the shape at large.
MethodChain PilotChain();

/// Quick chains that see a surface differently, to tell surfaces apart.
const std::vector<MethodChain>& ProbeChains();

}

#endif
