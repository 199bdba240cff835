// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file SpikeScores.h
 * @brief How far vertices are off the surface around them, and off what is usual there.
 *
 * The height of a vertex is the smaller of two distances, of surfaces that do not know the vertex:
 *
 * - the 15% quantile of the distances from the planes of the faces that touch its ring but not the
 *   vertex. A vertex of a sharp edge or corner lies in the planes of its sides.
 * - the distance from a quadric that is fitted to the vertices within two rings, with the sum of
 *   the absolute residuals as the error (iteratively reweighted), so that some spikes among them do
 *   not matter. A vertex of a coarse or strongly curved surface lies on it.
 *
 * A spike is far off both, compared with what is usual within two rings (ImpulseSearch.h).
 */

#ifndef SurfaceDenoising_SpikeScores_h
#define SurfaceDenoising_SpikeScores_h

#include "../TriangleMesh.h"
#include "ImpulseSearch.h"

namespace SurfaceDenoising
{

/// The vertices within two rings of every vertex without itself. Paths through vertices of more
/// than 400 others do not count: around those, everything would be near everything.
CompressedRows VerticesNearby(const CompressedRows& rings, Execution& execution);

/// Vertices marked with 1 have scores as all others, but take no part in those of the others.
SpikeScores ScoreSpikes(const TriangleMesh& mesh, const CompressedRows& stars,
  const CompressedRows& rings, const CompressedRows& nearby, const EdgeCensus& edges,
  const Buffer<unsigned char>& marks, Execution& execution);

}

#endif
