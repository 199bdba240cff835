// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file FaceFilter.h
 * @brief The first stage on a triangle mesh: every way there is to filter face normals.
 *
 * A way is a neighbourhood, the weights of the normal filter, a guidance that the weights look at,
 * and an operator that makes new normals of the weights. Lengths are in d, the mean distance
 * between the centroids of edge-adjacent faces, unless said otherwise.
 */

#ifndef SurfaceDenoising_FaceFilter_h
#define SurfaceDenoising_FaceFilter_h

#include "GlobalSolve.h"
#include "NormalFilter.h"
#include "NormalMedian.h"
#include "PatchGuidance.h"
#include "RobustScale.h"
#include "VotingTensor.h"

namespace SurfaceDenoising
{

enum class FaceNeighborhood : int
{
  EdgeAdjacent,  ///< faces that share an edge
  VertexSharing, ///< faces that share a vertex
  Radius,        ///< faces with centroids in a ball, connected across vertices there
  EdgeRadius     ///< faces with centroids in a ball, connected across edges there
};

/// Which normals are averaged when normal iterations follow one another.
enum class NormalData : int
{
  Previous, ///< those of the iteration before: diffusion, as all published filters do
  Original  ///< those the iterations started from, only the centre moves: the M-estimate itself
};

/// What the error norm compares.
enum class NormalGuidance : int
{
  None,  ///< the normals of a face and its neighbour
  Patch, ///< their guidance normals, see PatchGuidance.h
  Median ///< the directional median around the face and the normal of the neighbour
};

/// What is made of the weights.
enum class NormalOperator : int
{
  Average,      ///< their mean
  Diffusion,    ///< a step towards the neighbours, see NormalFilter.h
  GlobalSolve,  ///< all normals at once, see GlobalSolve.h
  Median,       ///< a median instead of weights, see NormalMedian.h
  VotingTensor, ///< the tensor of the normals, see VotingTensor.h
};

/// What the scale of a norm is relative to, if the argument is a curvature; of the present
/// positions.
enum class CurvatureUnit : int
{
  CentroidDistance, ///< d
  EdgeLength        ///< l, the mean edge length
};

struct FaceFilterSettings
{
  FaceNeighborhood Neighborhood = FaceNeighborhood::VertexSharing;
  double Radius = 2.0;           ///< of the neighbourhoods in a ball, in d
  bool RenewNeighborhood = true; ///< look for neighbours in a ball again after the vertices moved

  NormId Norm = NormId::Gaussian;
  /// Scale of the norm in units of the argument (chord length, radians, curvature times unit); 0:
  /// from the data.
  double NormScale = 0.35;
  ScaleEstimator Estimator = ScaleEstimator::MedianAbsoluteDeviation; ///< how, if from the data
  NormalArgument Argument = NormalArgument::Chord;                    ///< no length (IsLength)
  CurvatureUnit Unit = CurvatureUnit::CentroidDistance;
  double SpatialScale = 1.0;      ///< sigma of the spatial Gaussian in d; 0: no spatial kernel
  bool LocalSpatialScale = false; ///< in the mean distance of each face to its edge-adjacent ones
  SiteWeight Weighting = SiteWeight::Area;
  bool IncludeOwn = false;
  NormalData Data = NormalData::Previous;
  NormalGuidance Guidance = NormalGuidance::None;

  NormalOperator Operator = NormalOperator::Average;
  double StepLength = 0.5;     ///< of Diffusion
  bool TangentialFlux = false; ///< of Diffusion
  GlobalSolveSettings Global;
  MedianKind Median = MedianKind::Angular;
  MedianRepetitions Repetitions;
  VotingTensorSettings Tensor;

  int NormalIterations = 20; ///< per outer iteration
};

/// What the filter chose and did.
struct FaceFilterReport
{
  double MeanCentroidDistance = 0.0; ///< d of the input
  double NormScale = 0.0;            ///< used, in units of the argument
  bool NoNoiseFound = false; ///< the scale from the data is zero: normals were left as they are
  std::size_t UnfilteredFaces = 0;  ///< kept their normal in the last iteration
  std::size_t SolverIterations = 0; ///< of GlobalSolve, in all iterations
  int NormalIterations = 0;         ///< done, in all outer iterations
};

class FaceFilter
{
public:
  /// Everything must outlive the filter. meanEdgeLength is l.
  FaceFilter(const TriangleMesh& mesh, const CompressedRows& stars,
    const Buffer<unsigned char>& boundary, double meanEdgeLength,
    const FaceFilterSettings& settings, FaceFilterReport& report);

  /**
   * Looks at the mesh as it is now. normals get those of the faces, unless they hold normals to
   * start from already. Looks for neighbours and for the scale of the norm if that is due. Returns
   * false if the execution asked to stop, which is asked with the fraction that is done.
   */
  bool Renew(Buffer<Vec3>& normals, Execution& execution, double done);

  /// Whether normals are filtered enough.
  using Verdict = std::function<bool(const Buffer<Vec3>& normals)>;

  /**
   * All normal iterations, or until the verdict, if there is one, is that it is enough. Returns
   * false if the execution asked to stop; progress is reported from first to last.
   */
  bool Run(Buffer<Vec3>& normals, const Verdict& enough, Execution& execution, double first,
    double last);

private:
  double ScaleUnit(Execution& execution) const;
  void ChooseScale(const Buffer<Vec3>& normals);
  void FindNeighbors(Execution& execution);
  void SetGeometry(NormalFilter& filter, Execution& execution);
  /// Whether EdgeAdjacent is needed for longer than to look at the mesh.
  bool KeepsAdjacency() const;
  const NeighborGraph& Graph() const;
  bool Iterate(const NormalFilter& filter, const Buffer<Vec3>& normals,
    const Buffer<Vec3>& original, Buffer<Vec3>& filtered, Execution& execution, double first,
    double last);

  const TriangleMesh& Mesh;
  const CompressedRows& Stars;
  const Buffer<unsigned char>& Boundary;
  double EdgeLength;
  const FaceFilterSettings& Settings;
  FaceFilterReport& Report;

  /// Whether loops over the faces can take longer than one wants to wait for a stop. Smaller meshes
  /// are done with before it pays to cut loops in pieces.
  bool IsLarge() const { return this->Mesh.NumberOfFaces() > 1000000; }

  bool Renewed = false;
  FaceGeometry Geometry;
  Buffer<double> Curvatures;   ///< of the faces, if they are what the norm is applied to
  double Distance = 0.0;       ///< d of the present positions
  double Unit = 1.0;           ///< what scales of the norm are divided by
  NeighborGraph VertexSharing; ///< if the neighbourhood or the guidance needs it
  NeighborGraph EdgeAdjacent;  ///< to look at the mesh, and if the iterations need it
  NeighborGraph Ball;          ///< the neighbourhood, if it is one in a ball
  std::unique_ptr<PatchGuidance> Patches;
  Buffer<Vec3> Guide;
};

}

#endif
