// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file Spikes.h
 * @brief Vertices of a mesh far off the surface around them, and whether they are noise.
 */

#ifndef SurfaceDenoising_Spikes_h
#define SurfaceDenoising_Spikes_h

#include "../TriangleMesh.h"

namespace SurfaceDenoising
{

/// Marks spikes with 1, as FindSpikes of ImpulseSearch.h does with the heights of SpikeScores.h and
/// the mean edge length as unit. Vertices at boundaries are never marked.
Buffer<unsigned char> FindSpikes(const TriangleMesh& mesh, const CompressedRows& stars,
  Execution& execution);

/// Likewise FindImpulses, with a share of 11% very far off: true if the mesh may have impulsive
/// noise, and then marks the vertices that it would have moved. RepairSpikes says whether it is
/// likely. If the execution asks to stop, what comes back is of no use.
bool FindImpulses(const TriangleMesh& mesh, const CompressedRows& stars,
  Buffer<unsigned char>& marks, Execution& execution);

}

#endif
