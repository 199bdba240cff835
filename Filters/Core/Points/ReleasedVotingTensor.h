// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file ReleasedVotingTensor.h
 * @brief What the program computes that S. K. Yadav, U. Reitebuch, M. Skrodzki, E. Zimmermann and
 * K. Polthier released with "Constraint-based point set denoising using normal voting tensor and
 * restricted quadratic error metrics", to reproduce published results.
 *
 * The method is that of VotingTensorPoints.h without its guard. What only the program does:
 * - points move one after the other in the order of the input, each seeing where those before it
 *   went, so that the result depends on that order;
 * - the weight of two normals in the update of flat points is exp(-8 |n_i - n_j|^2 / r^2) with a
 *   length r, so that it depends on the size of the model;
 * - a quadric whose determinant is below 1e-10, whatever the size of the model, is the identity;
 *   the solution then is the right-hand side, a place relative to the origin that only the limit
 *   of the displacement rejects;
 * - a normal without any similar one around it becomes zero in the first iteration, and stays zero.
 * Neighbours are those of the noisy points, whatever becomes of these.
 */

#ifndef SurfaceDenoising_ReleasedVotingTensor_h
#define SurfaceDenoising_ReleasedVotingTensor_h

#include "PointSet.h"

namespace SurfaceDenoising
{

/// Lengths follow from h, the mean distance of a point from its nearest neighbours.
struct ReleasedVotingTensorSettings
{
  int Iterations = 50;
  double Similarity = 0.9;           ///< cosine above which normals are similar
  double EigenvalueThreshold = 0.25; ///< of normals and positions
  int NumberOfNeighbors = 12;        ///< nearest ones, for h and the first normals
  double Damping = 3.0;              ///< how much of the old normal stays
  double Step = 0.1;                 ///< of flat points
  double Limit = 2.0;                ///< points stay closer to where they came from, in h
};

struct ReleasedVotingTensorReport
{
  double Spacing = 0.0;         ///< h
  Buffer<FeatureClass> Classes; ///< in the last iteration; flat if there was nothing to tell
  std::size_t Rejected = 0;     ///< places that were too far, in the last iteration
};

/**
 * The normals that the program starts with if there are none: those of the planes through the
 * nearest neighbours, with signs along the spanning tree with the least sum of 1 - |n_i . n_j|,
 * from the highest point on. The program fails if there is a point that the tree does not reach;
 * here every part has a tree of its own. Returns false if the execution asked to stop.
 */
bool ReleasedStartNormals(const Buffer<Vec3>& points, const NeighborGraph& nearest,
  Buffer<Vec3>& normals, Execution& execution, double first, double last);

/**
 * Moves the points, all finite, and filters their normals, those to start with or none. Returns
 * false if the execution asked to stop; points and normals are then what they were.
 */
bool DenoiseAsReleased(Buffer<Vec3>& positions, Buffer<Vec3>& normals,
  const ReleasedVotingTensorSettings& settings, ReleasedVotingTensorReport& report,
  Execution& execution);

}

#endif
