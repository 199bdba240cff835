// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file Spikes.h
 * @brief Vertices far off the surface around them, and whether they are noise.
 */

#ifndef SurfaceDenoising_Spikes_h
#define SurfaceDenoising_Spikes_h

#include "../TriangleMesh.h"

namespace SurfaceDenoising
{

/**
 * Marks vertices that stick out of the surface around them with 1. The planes of the faces that
 * touch the ring of a vertex but not the vertex miss it by some distances, of which the 15%
 * quantile counts: a vertex of a sharp edge or corner lies in the planes of its sides, a spike in
 * none. It is a spike if that distance is above 4 medians (or as many as given) and above least
 * mean edge lengths.
 */
Buffer<unsigned char> FindSpikes(const TriangleMesh& mesh, const CompressedRows& stars,
  Execution& execution, double least = 0.1, double medians = 4.0);

/**
 * True if the spikes are impulsive noise: at least 2.2% of the vertices, and scattered. A neighbour
 * of a spike is one in at most a share of 0.03 + 2 p, p that of all vertices; narrow ridges, which
 * look like spikes, are rows of them. A tenth of them must be above 8 medians as well: bends of
 * coarse meshes are all alike.
 */
bool AreImpulses(const TriangleMesh& mesh, const CompressedRows& stars,
  const Buffer<unsigned char>& spikes, Execution& execution);

}

#endif
