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
 * Looks for spikes (see FindSpikes). If they are impulsive noise, they are moved to the middle of
 * their neighbours, and from there to fit the robustly filtered normals around them; all other
 * vertices keep their positions to the bit. What the largest spikes have hidden is looked for
 * again, three times in all. repaired is the number of vertices that were moved. The mesh has no
 * seams. Returns false if the execution asked to stop.
 */
bool RepairSpikes(TriangleMesh& mesh, const CompressedRows& stars, const EdgeCensus& edges,
  std::size_t& repaired, Execution& execution);

}

#endif
