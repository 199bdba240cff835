// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file AutomaticMesh.h
 * @brief Denoises a mesh without being told anything.
 *
 * Spikes of impulsive noise are repaired (SpikeRepair.h) before anything else, and no other vertex
 * is touched for it. The noise of the surface is estimated (SurfaceNoise.h) for the report. Some
 * chains of published methods, weak and strong ones, for flat sides with sharp edges and for
 * organic shapes, are tried on the mesh, or on patches of a large one, and the chain whose normals
 * are expected to have the smallest error (ChainTrials.h) is run. If that error is not certain to
 * be below that of the input, nothing is done; where there are spikes, repaired or not, it must be
 * below 45% of it, as those that are left look like noise.
 */

#ifndef SurfaceDenoising_AutomaticMesh_h
#define SurfaceDenoising_AutomaticMesh_h

#include "../Methods.h"
#include "AutomaticSettings.h"
#include "MethodChain.h"
#include "SurfaceNoise.h"

#include <string>

namespace SurfaceDenoising
{

/// What will be done, and why.
struct AutomaticPlan
{
  SurfaceNoise Noise;
  MethodChain Steps;           ///< settings in the order they run; none: leave the mesh alone
  std::vector<Method> Methods; ///< what each step is called in the table of methods
  std::string Reason;          ///< a sentence for people
  /// The expected mean angle to the true normals after the steps over that of the input, see
  /// ChainTrials.h; 1 without steps.
  double ExpectedError = 1.0;
};

struct AutomaticReport
{
  AutomaticPlan Plan;
  MeshDenoisingReport Last;         ///< of the last step; facts of the mesh also without any
  std::size_t RepairedVertices = 0; ///< spikes of impulsive noise, see SpikeRepair.h
  /// Root mean square of what was removed: displacements along the normals of the result, in mean
  /// edge lengths of the input.
  double Removed = 0.0;
  double PlanSeconds = 0.0;
  double DenoiseSeconds = 0.0;
};

/**
 * Finds the plan for a mesh without seams and with faces that agree on outside (see PreparedMesh).
 * Returns false if the execution asked to stop.
 */
bool PlanDenoising(const TriangleMesh& mesh, const AutomaticSettings& settings, AutomaticPlan& plan,
  Execution& execution);

/**
 * Plans and denoises in place. A mesh that is not noisy, or of fewer than 50 faces, keeps its
 * positions to the bit. Positions must be finite. Returns false if the execution asked to stop; the
 * mesh then holds an unfinished state.
 */
bool DenoiseAutomatically(TriangleMesh& mesh, const AutomaticSettings& settings,
  AutomaticReport& report, Execution& execution);

}

#endif
