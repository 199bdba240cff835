// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file FaceOrientation.h
 * @brief One sense of rotation for all faces that can have one.
 */

#ifndef SurfaceDenoising_FaceOrientation_h
#define SurfaceDenoising_FaceOrientation_h

#include "TriangleMesh.h"

namespace SurfaceDenoising
{

/**
 * Normals of neighbouring faces can only be averaged if the faces run the same way round. Turns
 * faces so that the two faces of every manifold edge do, as far as the surface allows it (a Moebius
 * strip does not). In every connected part the sense of the majority of faces stays. Returns a flag
 * per face: 1 if it was turned.
 */
Buffer<unsigned char> OrientFaces(TriangleMesh& mesh, const CompressedRows& stars);

}

#endif
