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
 * Looks for impulsive noise (see FindImpulses of Spikes.h). The vertices that it has moved go to
 * the middle of their neighbours, and from there to where they fit the robustly filtered normals
 * around them; all other vertices keep their positions to the bit.
 *
 * That is right where it misses less than the noise. So it is tried on some of the others near
 * them, which are in place, as if they were spikes too. Details of the shape are missed as much
 * where they look like spikes as where they do not: spikes that move no farther along the normals
 * than the upper quartile of the others within three rings of them are taken for details and stay.
 * Then all is done once more with the rest. Nothing is changed at all unless
 *
 * - spikes move 3 times as far along the normals as the others do (90% quantiles), with or
 *   without those that were taken for details,
 * - and the faces of the rest turn twice as much as those of the others (means).
 *
 * repaired is the number of vertices that were moved. The mesh has no seams. Turned, moved, scaled
 * and renumbered meshes are repaired alike, to rounding. Returns false if the execution asked to
 * stop.
 */
bool RepairSpikes(TriangleMesh& mesh, const CompressedRows& stars, const EdgeCensus& edges,
  std::size_t& repaired, Execution& execution);

}

#endif
