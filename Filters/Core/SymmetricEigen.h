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

}

#endif
