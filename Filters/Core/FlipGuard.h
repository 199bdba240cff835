// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file FlipGuard.h
 * @brief Shortens displacements that would turn faces over.
 */

#ifndef SurfaceDenoising_FlipGuard_h
#define SurfaceDenoising_FlipGuard_h

#include "TriangleMesh.h"

namespace SurfaceDenoising
{

/**
 * A face fails if its moved normal is more than 80 degrees from the target normal, or its area
 * falls below 1e-8 scale^2, and that is worse than before the step. The displacements of the
 * vertices of failing faces are halved up to five times and then cancelled, until no face fails.
 * Vertices are treated alike whatever their order.
 *
 * Returns the number of vertices whose displacement was shortened. scale is the mean edge length; a
 * target of zero accepts any orientation.
 */
std::size_t PreventFlips(const TriangleMesh& topology, const CompressedRows& stars, double scale,
  const Buffer<Vec3>& targets, const Buffer<Vec3>& positions, Buffer<Vec3>& moved,
  Execution& execution);

}

#endif
