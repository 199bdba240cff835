// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file MeshDenoising.h
 * @brief The two stages on a triangle mesh: filter the face normals, then move the vertices to fit
 * them.
 *
 * Lengths are relative to the mesh, so that the same settings serve a ring and a cathedral: d, the
 * mean distance between the centroids of edge-adjacent faces, for what concerns normals, and l, the
 * mean edge length, for what concerns vertices.
 */

#ifndef SurfaceDenoising_MeshDenoising_h
#define SurfaceDenoising_MeshDenoising_h

#include "FaceFilter.h"
#include "PreparedMesh.h"
#include "VertexUpdate.h"

namespace SurfaceDenoising
{

struct MeshDenoisingSettings : FaceFilterSettings
{
  /// One outer iteration is the schedule "normals first"; more alternate between the two stages.
  int OuterIterations = 1;
  int VertexIterations = 10;     ///< per outer iteration; 0 leaves the vertices alone
  VertexUpdateSettings Vertices; ///< MaximumDisplacement in l
  /**
   * Iterations of both stages end once the normals are that far from those at the start: root mean
   * square angle in radians, told from the median, so that edges that get sharper do not count. 0:
   * never.
   */
  double Residual = 0.0;
};

/// What happened.
struct MeshDenoisingReport
  : MeshFacts
  , FaceFilterReport
{
  std::size_t GuardedVertices = 0; ///< displacements shortened to prevent flips, in all iterations
  int OuterIterations = 0;         ///< done
  int VertexIterations = 0;        ///< done, in all outer iterations
  double SetupSeconds = 0.0;
  double NormalSeconds = 0.0;
  double VertexSeconds = 0.0;
};

/**
 * Denoises the mesh in place. If normals has an entry per face, the first outer iteration starts
 * from these normals (unit or zero vectors) instead of those of the faces. On return normals holds
 * the filtered normals. Faces are turned to one orientation for the work and turned back
 * afterwards: normals always belong to the faces as they came.
 *
 * Returns false if the execution asked to stop; mesh and normals then hold an unfinished state.
 */
bool DenoiseMesh(TriangleMesh& mesh, Buffer<Vec3>& normals, const MeshDenoisingSettings& settings,
  MeshDenoisingReport& report, Execution& execution);

}

#endif
