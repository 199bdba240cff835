// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file SpikeRepair.h
 * @brief Puts vertices that impulsive noise has moved back, and no others.
 */

#ifndef SurfaceDenoising_SpikeRepair_h
#define SurfaceDenoising_SpikeRepair_h

#include "../TriangleMesh.h"

namespace SurfaceDenoising
{

/**
 * Looks for impulsive noise (see FindImpulses). The vertices that it has moved go to the middle of
 * their neighbours, and from there to where they fit the robustly filtered normals around them; all
 * other vertices keep their positions to the bit.
 *
 * That is right where it misses less than the noise. So it is tried on some of the others near
 * them, which are in place, as if they were spikes too. If spikes have not moved along the normals
 * 3 times as far as these do (90% quantiles), all stays as it was.
 *
 * repaired is the number of vertices that were moved. The mesh has no seams. Returns false if the
 * execution asked to stop.
 */
bool RepairSpikes(TriangleMesh& mesh, const CompressedRows& stars, const EdgeCensus& edges,
  std::size_t& repaired, Execution& execution);

}

#endif
