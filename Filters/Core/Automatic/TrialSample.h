// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file TrialSample.h
 * @brief A sample of a mesh that noise is added to, and what is measured on it.
 *
 * All measures are of the faces that are not near the rim of their patch, and 0 without any.
 */

#ifndef SurfaceDenoising_TrialSample_h
#define SurfaceDenoising_TrialSample_h

#include "MeshSample.h"
#include "MethodChain.h"

namespace SurfaceDenoising
{

enum class TrialNoise : int
{
  AlongNormals,
  RandomDirections
};

/// Of the distances r of vertices from their places on a surface, along its normals there.
struct TrialResidual
{
  double Size = 0.0; ///< root mean square, a length
  /// How alike r is at both ends of an edge: the sum of 2 r_i r_j over the edges of faces over that
  /// of r_i^2 + r_j^2. From -1 to 1; 0 for white noise.
  double Correlation = 0.0;
};

class TrialSample
{
public:
  /// The sample must outlive this.
  TrialSample(const MeshSample& sample, Execution& execution);

  const TriangleMesh& Mesh() const { return this->Sample.Mesh; }

  /// Faces that count.
  std::size_t Count() const { return this->Faces.size(); }

  double EdgeLength() const { return this->MeanEdgeLength; }

  /// The mean angle between normals of the same faces, in degrees.
  double MeanAngle(const Buffer<Vec3>& a, const Buffer<Vec3>& b, Execution& execution) const;

  /// Quantiles of the angles between the normals of adjacent faces, in degrees.
  std::vector<double> Bends(const Buffer<Vec3>& normals,
    const std::vector<double>& fractions) const;

  /// Share of the pairs of adjacent faces with more than 120 degrees between their normals.
  double FoldedShare(const Buffer<Vec3>& normals) const;

  /// What is left of a mesh over a surface with the same faces.
  TrialResidual Residual(const TriangleMesh& mesh, const TriangleMesh& surface,
    Execution& execution) const;

  /**
   * A surface with the same faces, with its vertices moved along it to where those of the sample
   * are, so that faces have the shapes that they have in the sample, and not those that a method
   * gave them. Where faces would turn over, their vertices go less far, by halves, and at last not
   * at all.
   */
  TriangleMesh Resampled(const TriangleMesh& surface, Execution& execution) const;

  /**
   * Gaussian displacements of deviation 1 for the vertices of a surface with the faces of the
   * sample. They depend on the place of a vertex in the order of distances from the middle alone,
   * and turn with the surface. Those in random directions are 0.9 times as large along the surface.
   */
  Buffer<Vec3> Noise(const TriangleMesh& surface, TrialNoise kind, Execution& execution) const;

private:
  const MeshSample& Sample;
  double MeanEdgeLength;
  Buffer<Index> Faces;
  CompressedRows Stars;   ///< faces of vertices
  NeighborGraph Adjacent; ///< faces across edges
};

/// The unit normals of the faces.
Buffer<Vec3> FaceNormals(const TriangleMesh& mesh, Execution& execution);

/// The mesh with vertices displaced by a multiple of the steps.
TriangleMesh Displaced(const TriangleMesh& mesh, const Buffer<Vec3>& steps, double factor);

}

#endif
