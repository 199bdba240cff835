// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file MeanCurvatureFlow.h
 * @brief Implicit fairing: vertices follow the mean curvature, in steps of any size.
 *
 * M. Desbrun, M. Meyer, P. Schroeder, A. Barr, "Implicit fairing of irregular meshes using
 * diffusion and curvature flow", SIGGRAPH 1999. A step solves
 *
 *   (M + dt L) P' = M P
 *
 * with the cotangent Laplacian L (see CotangentLaplacian.h) and the areas M of the vertices, a
 * third of the faces around them, both of the surface before the step. That is the flow dp/dt = -2
 * H n.
 */

#ifndef SurfaceDenoising_MeanCurvatureFlow_h
#define SurfaceDenoising_MeanCurvatureFlow_h

#include "../PreparedMesh.h"

namespace SurfaceDenoising
{

struct MeanCurvatureFlowSettings
{
  int Steps = 3;
  double TimeStep = 0.2; ///< of one step, in squared mean edge lengths of the input; positive
  /**
   * After each step, scale the surface about the mean of its vertices to the volume it had. Only
   * for closed surfaces.
   */
  bool RestoreVolume = false;
  bool FixBoundary = true; ///< or borders contract
};

struct MeanCurvatureFlowReport
{
  int SolverIterations = 0;    ///< of conjugate gradients, in all steps
  bool VolumeRestored = false; ///< false also if the surface has no volume
};

/// Moves the vertices of a mesh that has been prepared. Returns false if the execution stops.
bool FlowByMeanCurvature(PreparedMesh& prepared, const MeanCurvatureFlowSettings& settings,
  MeanCurvatureFlowReport& report, Execution& execution);

}

#endif
