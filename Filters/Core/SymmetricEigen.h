// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file SymmetricEigen.h
 * @brief Eigenvalues and eigenvectors of a symmetric matrix, fast and to all digits.
 */

#ifndef SurfaceDenoising_SymmetricEigen_h
#define SurfaceDenoising_SymmetricEigen_h

#include "Types.h"

namespace SurfaceDenoising
{

struct Eigensystem
{
  Vec3 Values;  ///< ascending
  Mat3 Vectors; ///< an orthonormal column for each
};

/// The matrix must be finite; only its lower half is read.
Eigensystem Decompose(const Mat3& matrix);

struct LeastAxis
{
  Vec3 Values; ///< ascending; the last two to half of the digits where they are nearly equal
  Vec3 Vector; ///< of the first
};

/**
 * The same for a positive semidefinite matrix of which only the vector of the smallest eigenvalue
 * is needed, four times as fast. Where that value is not well separated, Decompose has the word.
 * Both halves of the matrix are read.
 */
LeastAxis FindLeastAxis(const Mat3& matrix);

}

#endif
