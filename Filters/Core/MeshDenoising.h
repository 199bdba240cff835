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

#include "NormalFilter.h"
#include "PreparedMesh.h"
#include "RobustScale.h"
#include "VertexUpdate.h"

namespace SurfaceDenoising
{

enum class FaceNeighborhood : int
{
  EdgeAdjacent,  ///< faces that share an edge
  VertexSharing, ///< faces that share a vertex
  Radius         ///< connected faces with centroids in a ball, see FacesWithinRadius
};

/// Which normals are averaged when normal iterations follow one another.
enum class NormalData : int
{
  Previous, ///< those of the iteration before: diffusion, as all published filters do
  Original  ///< those the iterations started from, only the centre moves: the M-estimate itself
};

struct MeshDenoisingSettings
{
  FaceNeighborhood Neighborhood = FaceNeighborhood::VertexSharing;
  double Radius = 2.0; ///< of FaceNeighborhood::Radius, in d

  NormId Norm = NormId::Gaussian;
  /// Scale of the norm in units of the argument (chord length, radians, radians per d); 0: from the
  /// data.
  double NormScale = 0.35;
  ScaleEstimator Estimator = ScaleEstimator::MedianAbsoluteDeviation; ///< how, if from the data
  NormalArgument Argument = NormalArgument::Chord;
  double SpatialScale = 1.0; ///< sigma of the spatial Gaussian in d; 0: no spatial kernel
  bool AreaWeighted = true;
  bool IncludeOwn = false;
  NormalData Data = NormalData::Previous;

  /// One outer iteration is the schedule "normals first"; more alternate between the two stages.
  int OuterIterations = 1;
  int NormalIterations = 20; ///< per outer iteration
  int VertexIterations = 10; ///< per outer iteration; 0 leaves the vertices alone

  VertexUpdateSettings Vertices; ///< MaximumDisplacement in l
};

/// What happened.
struct MeshDenoisingReport : MeshFacts
{
  double MeanCentroidDistance = 0.0; ///< d
  double NormScale = 0.0;            ///< used, in units of the argument
  bool NoNoiseFound = false; ///< the scale from the data is zero: normals were left as they are
  std::size_t UnfilteredFaces = 0; ///< kept their normal in the last normal iteration
  std::size_t GuardedVertices = 0; ///< displacements shortened to prevent flips, in all iterations
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
