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

/// Whether what a chain makes of a mesh serves as a truth, see PlausibleSurfaces.
enum class TruthUse
{
  Never,
  IfWhite,      ///< not where what it removes is more than white noise
  WithoutFolds, ///< not where noise folds faces over, which the chain leaves so
  Always
};

struct CandidateChain
{
  const char* Purpose; ///< what it is for, for people
  SurfaceType Type;
  TruthUse Truth = TruthUse::Never;
  bool ForFolds = false; ///< not worth a trial where hardly a face is folded over
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
