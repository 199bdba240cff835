// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file Textbook.h
 * @brief Denoising as a textbook would print it: the oracle of the tests and the yardstick of the
 * benchmark.
 *
 * It shares no code with the core. Every formula is written down again, as in the papers and in the
 * simplest form: sets and maps for neighbourhoods, weights from scratch in every sweep, one thread.
 * It knows neither seams nor turned faces; give it meshes without them.
 */

#ifndef Textbook_h
#define Textbook_h

#include <array>
#include <vector>

namespace Textbook
{

using Vector = std::array<double, 3>;
using Face = std::array<int, 3>;

struct Mesh
{
  std::vector<Vector> Points;
  std::vector<Face> Faces;
};

enum class Norm
{
  L2,
  TruncatedL2,
  L1,
  TruncatedL1,
  Huber,
  Lorentzian,
  Gaussian,
  Tukey,
  Box,
  Centin
};

enum class Argument
{
  Chord,
  Angle,
  DirectionalCurvature
};

enum class Neighborhood
{
  EdgeAdjacent,
  VertexSharing,
  Radius
};

enum class Data
{
  Previous,
  Original
};

enum class Update
{
  FaceMean,
  ConstantStep,
  AreaWeighted,
  IntegralFit
};

struct Settings
{
  Neighborhood Faces = Neighborhood::VertexSharing;
  double Radius = 2.0; ///< in mean distances of adjacent centroids

  Norm WeightNorm = Norm::Gaussian;
  double Scale = 0.35; ///< of the norm; per mean distance of adjacent centroids for curvatures
  Argument Compared = Argument::Chord;
  double SpatialScale = 1.0; ///< in mean distances of adjacent centroids; 0: no spatial kernel
  bool AreaWeighted = true;
  bool IncludeOwn = false;
  Data Averaged = Data::Previous;

  int OuterIterations = 1;
  int NormalIterations = 20;
  int VertexIterations = 10;
  Update VertexUpdate = Update::FaceMean;
  bool FreeBoundary = false;
};

/// The weight g(x) of a norm with the given scale.
double Weight(Norm norm, double scale, double x);

/// Neighbours of every face, without the face itself.
using Neighbors = std::vector<std::vector<int>>;
Neighbors FacesAtEdges(const Mesh& mesh);
Neighbors FacesAtPoints(const Mesh& mesh);
/// Connected faces with centroids within the radius, a length, reached through such faces.
Neighbors FacesWithin(const Mesh& mesh, double radius);

/// True for the ends of edges that have one face only.
std::vector<bool> BoundaryPoints(const Mesh& mesh);
double MeanEdgeLength(const Mesh& mesh);
/// Mean distance between the centroids of faces that share an edge.
double MeanCentroidDistance(const Mesh& mesh);

/**
 * Moves the points and returns the filtered normals. If margins is given, it gets per face how
 * close a comparison of the face came to the scale of the norm, the least |x - scale| / scale:
 * where a norm jumps, rounding decides there.
 */
std::vector<Vector> Denoise(Mesh& mesh, const Settings& settings,
  std::vector<double>* margins = nullptr);

/// Moves the points count times towards the target normals; zero vectors are no targets.
void UpdatePoints(Mesh& mesh, const std::vector<Vector>& targets, Update update, bool freeBoundary,
  int count);

}

#endif
