// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file MeshSample.h
 * @brief Some patches of a large mesh that stand for all of it.
 */

#ifndef SurfaceDenoising_MeshSample_h
#define SurfaceDenoising_MeshSample_h

#include "../TriangleMesh.h"

namespace SurfaceDenoising
{

struct MeshSample
{
  TriangleMesh Mesh;
  Vec3 Middle = Vec3::Zero(); ///< that of the whole mesh
  /// Per vertex of Mesh: its place in the order of distances from the middle of the vertices. A
  /// number that the order of vertices and rigid motions leave as it is, for random numbers.
  Buffer<Index> Keys;
  Buffer<unsigned char> Inner; ///< per face of Mesh: 1 if it is not near the rim of its patch
};

/// The mean of the vertices that have faces; others may be anywhere, or NaN. Zero without faces.
Vec3 MiddleOf(const TriangleMesh& mesh, Execution& execution);

/**
 * The mesh itself if it has at most the given number of faces. Otherwise 6 patches of the faces
 * nearest to a centre, a sixth of that number each. Centres are faces at evenly spaced places in
 * the order of distances from the middle. Faces that several patches share are there once.
 */
MeshSample TakeSample(const TriangleMesh& mesh, std::size_t faces, Execution& execution);

}

#endif
