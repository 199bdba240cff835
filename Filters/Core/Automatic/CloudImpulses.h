// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file CloudImpulses.h
 * @brief Points that impulsive noise has moved off the surface.
 *
 * As for meshes (SpikeScores.h), the height of a point is the smaller of two distances, of surfaces
 * that do not know it: the 15% quantile of the distances from the planes of its 20 nearest others,
 * with the normals of robust fits, and the distance from the robust quadric through these.
 */

#ifndef SurfaceDenoising_CloudImpulses_h
#define SurfaceDenoising_CloudImpulses_h

#include "ImpulseSearch.h"
#include "Types.h"

namespace SurfaceDenoising
{

/**
 * True if the cloud has impulsive noise (ImpulseSearch.h), and then marks the points that it has
 * moved with 1. They must be 2.5 times as far from the surface of the others (SurfaceStep.h), on
 * average, as the others beside them: or moving them there would do more harm than good. The graph
 * has at least 20 nearest others of every point, if there are as many. All points must be finite.
 * If the execution asks to stop, what comes back is of no use.
 */
bool FindImpulses(const Buffer<Vec3>& points, const CompressedRows& nearest, double spacing,
  Buffer<unsigned char>& marks, Execution& execution);

}

#endif
