// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file VotingTensor.h
 * @brief Normals from the tensor of the normals around them, with eigenvalues made binary.
 *
 *   T_i = sum_j w_ij n_j n_j^T / sum_j w_ij,   n_i' = normalise( d n_i + sum_k b_k (e_k . n_i) e_k
 * )
 *
 * with the weights of the normal filter and the eigenvectors e_k of T_i. The eigenvalues, divided
 * by their Euclidean length or their sum, count as 1 from the threshold on and as 0 below it, the
 * largest always as 1: one on a face, two at an edge, three at a corner. S. K. Yadav, U. Reitebuch,
 * K. Polthier, "Mesh denoising based on normal voting tensor and binary optimization", IEEE TVCG
 * 24(8), 2018.
 */

#ifndef SurfaceDenoising_VotingTensor_h
#define SurfaceDenoising_VotingTensor_h

#include "NormalFilter.h"

namespace SurfaceDenoising
{

/// What eigenvalues are divided by before they are compared with the threshold.
enum class EigenvalueUnit : int
{
  Length, ///< their Euclidean length
  Trace   ///< their sum
};

struct VotingTensorSettings
{
  double Threshold = 0.3; ///< of the eigenvalues, in [0, 1]
  double Damping = 3.0;   ///< d, how much of the old normal stays
  /// Votes are turned along the circular arc from site to site (Page et al.), so that a smooth
  /// curved patch votes as one.
  bool RotateVotes = false;
  EigenvalueUnit Unit = EigenvalueUnit::Length;
};

/**
 * One step for all sites. A site whose own normal is zero takes the weighted mean. Returns the
 * number of sites that kept their normal because no neighbour had weight.
 */
std::size_t VoteOnNormals(const NormalFilter& filter, const NormalFilter::Fields& fields,
  const Buffer<Vec3>& positions, const VotingTensorSettings& settings, Buffer<Vec3>& filtered,
  Execution& execution);

}

#endif
