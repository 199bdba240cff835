// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file Spikes.h
 * @brief Vertices far off the surface around them, and whether they are noise.
 *
 * Noise that reaches some vertices and leaves the others alone has heavy tails, and what it does to
 * a vertex says nothing about the vertices beside it. Gaussian noise has no such tails. Features,
 * the steps of voxels among them, stick out in rows and patterns: near one there are more of them
 * than by chance.
 */

#ifndef SurfaceDenoising_Spikes_h
#define SurfaceDenoising_Spikes_h

#include "../TriangleMesh.h"

namespace SurfaceDenoising
{

/**
 * Marks vertices that stick out of the surface around them with 1: their height (SpikeScores.h) is
 * above 4 times what is usual around them and above 0.05 mean edge lengths. Vertices at boundaries
 * are never marked.
 */
Buffer<unsigned char> FindSpikes(const TriangleMesh& mesh, const CompressedRows& stars,
  Execution& execution);

/**
 * True if the mesh has impulsive noise, and then marks the vertices that it has moved. Spikes as of
 * FindSpikes are looked for again without those found before, which hide smaller ones and let the
 * vertices beside them look like spikes: twice above 3 times what is usual, twice above 2.5 times.
 *
 * Noise is impulsive if
 * - spikes are at least 1% of the vertices inside, and 15% of them are above 8 times what is usual
 *   (of Gaussian noise, hardly any is);
 * - and, in the second round, no more vertices beside spikes are spikes than if they were chosen at
 *   random, but for a factor of 1.4 and a standard deviation of chance. The same of vertices in the
 *   second rings.
 *
 * If the execution asks to stop, what comes back is of no use.
 */
bool FindImpulses(const TriangleMesh& mesh, const CompressedRows& stars,
  Buffer<unsigned char>& marks, Execution& execution);

}

#endif
