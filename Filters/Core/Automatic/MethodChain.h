// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file MethodChain.h
 * @brief Methods one after the other.
 */

#ifndef SurfaceDenoising_MethodChain_h
#define SurfaceDenoising_MethodChain_h

#include "../MeshDenoising.h"

#include <vector>

namespace SurfaceDenoising
{

using MethodChain = std::vector<MeshDenoisingSettings>;

/// Runs all of them on the mesh; their facts of the last are in the report. Returns false if the
/// execution asked to stop.
bool RunChain(TriangleMesh& mesh, const MethodChain& chain, Buffer<Vec3>& normals,
  MeshDenoisingReport& report, Execution& execution);

/// The same for whom the mesh is enough.
bool RunChain(TriangleMesh& mesh, const MethodChain& chain, Execution& execution);

}

#endif
