// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file NeighborGraph.h
 * @brief Which sites see one another: the neighbourhoods of faces and of points.
 *
 * A graph is made of compressed rows. Row i lists the neighbours of site i, each once and never i
 * itself: whether a site counts among its own neighbours is a matter of the filter. The order
 * within a row is fixed by the mesh or the distances, never by threads.
 */

#ifndef SurfaceDenoising_NeighborGraph_h
#define SurfaceDenoising_NeighborGraph_h

#include "TriangleMesh.h"

namespace SurfaceDenoising
{

using NeighborGraph = CompressedRows;

/// Faces that share an edge. All other faces of a non-manifold edge are neighbours.
NeighborGraph EdgeAdjacentFaces(const TriangleMesh& mesh, const CompressedRows& stars,
  Execution& execution);

/// Vertices of more faces are large fans.
constexpr std::size_t LargestFan = 400;

/**
 * Faces that share a vertex or more, about 12 on a regular mesh. Of a large fan, as CAD programs
 * make them of discs, only faces that share an edge are neighbours, or another vertex: the others
 * are not near one another, and their number would be its square.
 */
NeighborGraph VertexSharingFaces(const TriangleMesh& mesh, const CompressedRows& stars,
  Execution& execution);

/// Balls of more faces are those of meshes whose faces differ a lot in size: of equal faces it
/// takes twelve times their distance.
constexpr std::size_t LargestBall = 400;

/**
 * Faces whose centroid is at most radius away and that are reached through such faces: growth steps
 * from face to face along connections (edge-adjacent or vertex-sharing) and goes on only through
 * faces that were entered. The far side of a thin wall is close but not reached, which is why this
 * is not a ball query. Growth ends with the step in which it has entered more than most faces.
 */
NeighborGraph FacesWithinRadius(const NeighborGraph& connections, const Buffer<Vec3>& centroids,
  double radius, std::size_t most, Execution& execution);

/// For every entry of a graph of faces, the summed lengths of the edges that both faces have.
Buffer<double> SharedEdgeLengths(const TriangleMesh& mesh, const NeighborGraph& graph,
  Execution& execution);

/**
 * The count nearest other points of every point, nearest first; fewer if there are not as many
 * points. Points at the same place are neighbours like any others.
 */
NeighborGraph NearestPoints(const Buffer<Vec3>& points, std::size_t count, Execution& execution);

/// For every face, the mean distance to the centroids of its edge-adjacent faces; 0 if it has none.
Buffer<double> MeanAdjacentDistances(const NeighborGraph& adjacent, const Buffer<Vec3>& centroids,
  Execution& execution);

/// Mean distance between the centroids of edge-adjacent faces; 0 if there are none.
double MeanAdjacentDistance(const NeighborGraph& adjacent, const Buffer<Vec3>& centroids,
  Execution& execution);

}

#endif
