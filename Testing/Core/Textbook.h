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

/// What a weight looks at; NormalGradient is the chord per distance of the centroids.
enum class Argument
{
  Chord,
  Angle,
  DirectionalCurvature,
  NormalGradient,
  FaceCurvature ///< of both faces, each on its own: the weight is the mean of the two weights
};

/// EdgeRadius grows across shared edges only, Radius also through shared points.
enum class Neighborhood
{
  EdgeAdjacent,
  VertexSharing,
  Radius,
  EdgeRadius
};

/// EdgeCoupling: length of the shared edges per distance of the centroids.
enum class FaceWeight
{
  Uniform,
  Area,
  EdgeCoupling
};

/// The length in whose inverse the scale of a curvature is given.
enum class CurvatureUnit
{
  CentroidDistance, ///< mean over adjacent faces, of the present points
  EdgeLength        ///< mean over the edges of the input
};

/// Whose mean distance to adjacent centroids the spatial kernel has as unit.
enum class SpatialWidth
{
  Global,
  PerFace
};

enum class Data
{
  Previous,
  Original
};

enum class Operator
{
  Average,
  Diffusion,
  GlobalSolve,
  Median,
  VotingTensor
};

/// What the weights look at instead of the normal of the face.
enum class Guidance
{
  None,
  Patch,
  Median
};

enum class MedianKind
{
  Angular,    ///< the neighbour in the middle, sorted by the angle to the own normal
  Directional ///< the normal with the least sum of angles to all others
};

enum class Update
{
  FaceMean,
  ConstantStep,
  AreaWeighted,
  IntegralFit,
  EdgeWeighted
};

struct Settings
{
  Neighborhood Faces = Neighborhood::VertexSharing;
  double Radius = 2.0;           ///< in mean distances of adjacent centroids
  bool RenewNeighborhood = true; ///< grow again in every outer iteration

  Norm WeightNorm = Norm::Gaussian;
  double Scale = 0.35; ///< of the norm; for curvatures in the unit below
  Argument Compared = Argument::Chord;
  CurvatureUnit ScaleUnit = CurvatureUnit::CentroidDistance;
  double SpatialScale = 1.0; ///< in mean distances of adjacent centroids; 0: no spatial kernel
  SpatialWidth Width = SpatialWidth::Global;
  FaceWeight Weighting = FaceWeight::Area;
  bool IncludeOwn = false;
  Data Averaged = Data::Previous;
  Guidance Guide = Guidance::None;

  Operator Step = Operator::Average;
  double StepLength = 0.5;     ///< Diffusion
  bool TangentialFlux = false; ///< Diffusion
  double Fidelity = 0.01;      ///< GlobalSolve; the smaller, the smoother
  bool AreaEnergy = true;      ///< GlobalSolve
  MedianKind Selection = MedianKind::Angular;
  int EdgeRepetitions = 1;   ///< angular median, of neighbours at edges
  int VertexRepetitions = 1; ///< angular median, of the other neighbours
  double TensorThreshold = 0.3;
  double Damping = 3.0; ///< VotingTensor
  bool RotateVotes = false;

  int OuterIterations = 1;
  int NormalIterations = 20;
  int VertexIterations = 10;
  Update VertexUpdate = Update::FaceMean;
  bool FreeBoundary = false;
  double Relaxation = 0.2;          ///< EdgeWeighted; falls to 0.7 of itself with every step
  double InputPull = 0.0;           ///< part of the way back to the input, along the normal
  double MaximumDisplacement = 0.0; ///< in mean edge lengths of the input; 0: no limit

  /// The authors' program for robust and high fidelity denoising as they released it, of which
  /// Scale, Relaxation and OuterIterations are the parameters; nothing else counts then.
  bool AsReleased = false;
};

/// The weight g(x) of a norm with the given scale.
double Weight(Norm norm, double scale, double x);

/// Neighbours of every face, without the face itself.
using Neighbors = std::vector<std::vector<int>>;
Neighbors FacesAtEdges(const Mesh& mesh);
Neighbors FacesAtPoints(const Mesh& mesh);
/// Connected faces with centroids within the radius, a length, reached through such faces.
Neighbors FacesWithin(const Mesh& mesh, double radius);
/// The same, reached across shared edges.
Neighbors FacesWithinAcrossEdges(const Mesh& mesh, double radius);

/// True for the ends of edges that have one face only.
std::vector<bool> BoundaryPoints(const Mesh& mesh);
double MeanEdgeLength(const Mesh& mesh);
/// Mean distance between the centroids of faces that share an edge.
double MeanCentroidDistance(const Mesh& mesh);

/**
 * Moves the points and returns the filtered normals. If margins is given, it gets per face how
 * close a decision about the face was, where rounding may decide: the least |x - scale| / scale of
 * its comparisons, as norms jump there, and the relative lead of a choice over the next best that
 * has another normal.
 */
std::vector<Vector> Denoise(Mesh& mesh, const Settings& settings,
  std::vector<double>* margins = nullptr);

/// The authors' program, see Settings::AsReleased. Returns the filtered normals, too.
std::vector<Vector> DenoiseAsReleased(Mesh& mesh, double sigma, double lambda, int iterations,
  std::vector<double>* margins = nullptr);

/**
 * Moves the points count times towards the target normals; zero vectors are no targets. With an
 * input given, no point goes farther than longest from there, unless that is 0.
 */
void UpdatePoints(Mesh& mesh, const std::vector<Vector>& targets, Update update, bool freeBoundary,
  int count, double relaxation = 0.2, const std::vector<Vector>& input = {}, double longest = 0.0);

/// Moves the points the given part of the way back to the input, along the mean target normal.
void PullToInput(Mesh& mesh, const std::vector<Vector>& targets, bool freeBoundary,
  const std::vector<Vector>& input, double part);

}

#endif
