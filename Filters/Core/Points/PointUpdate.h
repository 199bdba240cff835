// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PointUpdate.h
 * @brief Points move to fit normals: the second stage on point sets.
 *
 * With the weights w_ij of a NormalFilter, W_i = sum_j w_ij, e_ij = p_j - p_i, and the signs s_ij
 * that make n_i and s_ij n_j meet at an acute angle if normals have no orientation (else 1):
 *
 *   OwnHeight       p_i += t n_i / W_i  sum_j w_ij (n_i . e_ij)
 *   NeighborHeight  p_i += t n_i / W_i  sum_j w_ij (s_ij n_j . e_ij)
 *   BalancedHeight  p_i += t n_i / W_i  sum_j w_ij (n_i . e_ij + s_ij n_j . e_ij) / 2
 *   Gradient        p_i += t / (3 W_i)  sum_j w_ij (n_i (n_i . e_ij) + n_j (n_j . e_ij))
 *   QuadricFit      p_i += t A^+ b,     A = sum_j w_ij n_j n_j^T,  b = sum_j w_ij n_j (n_j . e_ij)
 *
 * where QuadricFit may be done in the cross-section of a line: the parts of n_j along the line are
 * left out, and the point stays where it is along it.
 *
 * A filter that includes the site itself adds w_ii to W_i and the own plane to A. Own heights pull
 * curved surfaces inwards and those of neighbours push them outwards by the same
 * amount, so that balanced ones leave a sphere alone. The gradient is a step down the distances of
 * points from one another's planes.
 */

#ifndef SurfaceDenoising_PointUpdate_h
#define SurfaceDenoising_PointUpdate_h

#include "NormalFilter.h"
#include "PointSet.h"

namespace SurfaceDenoising
{

/// Part of the saved state of user interfaces: add new ones at the end.
enum class PointScheme : int
{
  OwnHeight,
  NeighborHeight,
  BalancedHeight,
  Gradient,
  QuadricFit
};

struct PointUpdateSettings
{
  PointScheme Scheme = PointScheme::Gradient;
  double Step = 1.0;       ///< t; stable in (0, 1]
  bool Unoriented = false; ///< see above
  /// QuadricFit: eigenvalues of A below this times the largest are none, and the point does not
  /// move along their vectors.
  double EigenvalueCut = 0.05;
  /// QuadricFit: unit vectors of the lines across which to fit, zero where there is none; per site.
  const Buffer<Vec3>* Lines = nullptr;
};

/**
 * The displacements of one step for every site of the filter: of zero where there is no weight, or
 * no normal for the schemes that need one. Returns the number of these sites. If ranks are wanted:
 * how many eigenvalues counted in QuadricFit, that is, whether there is a plane, a line or a point
 * where planes meet.
 */
std::size_t ComputeDisplacements(const NormalFilter& weights, const NormalFilter::Fields& fields,
  const Buffer<Vec3>& positions, const PointUpdateSettings& settings, Buffer<Vec3>& displacements,
  Execution& execution, Buffer<unsigned char>* ranks = nullptr);

/// What is known of x in A x = b with a symmetric positive semidefinite A.
struct TruncatedSolution
{
  Vec3 X = Vec3(0.0, 0.0, 0.0); ///< A^+ b
  int Rank = 0;                 ///< eigenvalues that counted
};

/// Eigenvalues below cut (or 1e-12) times the largest are none.
TruncatedSolution SolveWithRank(const Mat3& a, const Vec3& b, double cut);

/// A^+ b of it.
inline Vec3 SolveTruncated(const Mat3& a, const Vec3& b, double cut)
{
  return SolveWithRank(a, b, cut).X;
}

/**
 * Moves the points to these places. A point whose place is not finite, or farther than
 * points.MaximumDisplacement (if that is above 0) from where it started, stays and is marked as
 * kept.
 */
void MoveTo(const Buffer<Vec3>& places, PointSet& points, Execution& execution);

/// The same with displacements, which become the places.
void MoveBy(Buffer<Vec3>& displacements, PointSet& points, Execution& execution);

/// Gives these normals to the points that are not marked as kept.
void TurnTo(const Buffer<Vec3>& normals, PointSet& points, Execution& execution);

}

#endif
