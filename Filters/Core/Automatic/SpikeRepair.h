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
 * After that, the surface at these vertices must be about as smooth as it is beside them: the mean
 * angle between faces must have lost at least half of what it was above that of the edges around
 * which nothing has changed. Otherwise all goes back as it was: these vertices were no spikes.
 *
 * repaired is the number of vertices that were moved. The mesh has no seams. Returns false if the
 * execution asked to stop.
 */
bool RepairSpikes(TriangleMesh& mesh, const CompressedRows& stars, const EdgeCensus& edges,
  std::size_t& repaired, Execution& execution);

}

#endif
