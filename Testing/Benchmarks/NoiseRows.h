// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file NoiseRows.h
 * @brief The kinds of noise that automatic denoising is put to.
 */

#ifndef NoiseRows_h
#define NoiseRows_h

#include "Noise.h"
#include "TriangleMesh.h"

#include <vector>

struct NoiseRow
{
  const char* Name;
  SurfaceDenoising::NoiseKind Kind;
  double Deviation; ///< in mean edge lengths
  bool AlongNormals;
};

const std::vector<NoiseRow>& NoiseRows();

/// The mesh with this noise; impulses move a fifth of the vertices.
SurfaceDenoising::TriangleMesh WithNoise(const SurfaceDenoising::TriangleMesh& clean,
  const NoiseRow& row);

#endif
