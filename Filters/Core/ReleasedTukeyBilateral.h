// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file ReleasedTukeyBilateral.h
 * @brief What the program computes that S. K. Yadav, U. Reitebuch and K. Polthier released with
 * "Robust and high fidelity mesh denoising" (version 2.00), to reproduce published results.
 *
 * The method is that of the paper, but for four slips of the program:
 * - the weight of two normals with chord x is (1 - x^2)^2 up to the range scale and 0 beyond, where
 *   Tukey's is (1 - (x / scale)^2)^2;
 * - the normals that are filtered lag one iteration behind the positions;
 * - the mean normal that tells the tangential part of a displacement is that of the last vertex,
 * for every vertex, and not normalised;
 * - a face without any similar neighbour gets the normal (0, 0, 1).
 * The result therefore depends on the order of the vertices, and on size and orientation of the
 * model. Boundary vertices move as all others, and a face at the boundary counts a missing
 * neighbour as one at distance 0.
 */

#ifndef SurfaceDenoising_ReleasedTukeyBilateral_h
#define SurfaceDenoising_ReleasedTukeyBilateral_h

#include "PreparedMesh.h"

namespace SurfaceDenoising
{

struct ReleasedTukeyBilateralSettings
{
  double RangeScale = 0.35;
  double Relaxation = 0.2; ///< falls by 0.7 with every iteration
  int Iterations = 100;
};

/**
 * Moves the vertices; normals are those that the last iteration filtered, or those of the faces
 * without one. facts are those of the mesh as it came: nothing is repaired. Returns false if the
 * execution asked to stop.
 */
bool DenoiseAsReleased(TriangleMesh& mesh, Buffer<Vec3>& normals,
  const ReleasedTukeyBilateralSettings& settings, MeshFacts& facts, Execution& execution);

}

#endif
