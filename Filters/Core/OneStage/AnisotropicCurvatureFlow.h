// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file AnisotropicCurvatureFlow.h
 * @brief Mean curvature flow that slows down at edges.
 *
 * K. Hildebrandt, K. Polthier, "Anisotropic filtering of non-linear surface features", Computer
 * Graphics Forum 23(3), 2004. An edge e between faces with normals n1, n2 at the angle phi has the
 * mean curvature H_e = 2 |e| sin(phi / 2), negative if concave, and the normal N_e = (n1 + n2) /
 * |n1 + n2|. The vertices move by
 *
 *   p_v -= dt (3 / area(v)) 1/2 sum_{e at v} w(H_e) H_e N_e
 *   w(H) = 1 if |H| <= lambda, else lambda^2 / (10 (lambda - |H|)^2 + lambda^2)
 *
 * where area(v) is that of the faces around v. With w = 1 the sum is the gradient of the area.
 *
 * The flow shrinks objects. Prescribed mean curvature takes from the sum HA what a smooth surface
 * would have: f V with the gradient V of the volume (a third of the area vectors around v; on
 * features, |V| times the direction of HA plus its mean over the neighbours that are features) and
 * f = HA . V / |V|^2, averaged over v and its neighbours, on features over features only. A vertex
 * is a feature if one of its edges has a weight below 1. Borders have no curvature to average.
 */

#ifndef SurfaceDenoising_AnisotropicCurvatureFlow_h
#define SurfaceDenoising_AnisotropicCurvatureFlow_h

#include "../PreparedMesh.h"

#include <vector>

namespace SurfaceDenoising
{

/// w(H) of edges with the curvature H; lambda is infinite for w = 1.
double AnisotropicWeight(double curvature, double lambda);

/// An edge at a vertex.
struct CurvatureSpoke
{
  Index Vertex;
  Vec3 NormalDifference; ///< n_in - n_out: of the faces that run to the centre, and from it
  double Curvature;      ///< |H_e|
  bool Flat;             ///< a face has no normal, so that there is no angle
};

/**
 * 1/2 sum w(H_e) H_e N_e over the edges at vertex v. Since a normal is perpendicular to the edges
 * of its face, H_e N_e is (n_in - n_out) x e with e pointing away from v, which has the sign of
 * convex and concave edges and is small when faces are almost coplanar. It gives edges with any
 * number of faces a meaning; at an edge of one face it is the pull of the border. Edges of
 * degenerate faces (normal 0) count as flat. The edges are left in spokes.
 */
Vec3 AnisotropicCurvature(const TriangleMesh& mesh, Span<Index> star,
  const Buffer<Vec3>& faceNormals, Index v, double lambda, std::vector<CurvatureSpoke>& spokes);

struct AnisotropicCurvatureFlowSettings
{
  int Steps = 10;
  double TimeStep = 0.1;      ///< dt in squared mean edge lengths
  double EdgeThreshold = 0.5; ///< lambda in mean edge lengths; infinite: w = 1
  /**
   * What dt (3 / area(v)) is cut to, which only matters where triangles are much smaller than the
   * average. At more than about 0.25 the flow becomes unstable there. The paper has no limit.
   */
  double MaximumRate = 0.25;
  bool PrescribeCurvature = false; ///< smooth the curvature instead of reducing it
  bool FixBoundary = true;         ///< or borders contract
};

/**
 * Moves the vertices of a mesh that has been prepared. Returns false if the execution stops. Mean
 * edge lengths are those before each step: with the noise, edges and threshold get smaller.
 */
bool FlowByAnisotropicCurvature(PreparedMesh& prepared,
  const AnisotropicCurvatureFlowSettings& settings, Execution& execution);

}

#endif
