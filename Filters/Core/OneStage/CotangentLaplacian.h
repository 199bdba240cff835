// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file CotangentLaplacian.h
 * @brief The Laplace operator of a triangle mesh and its area per vertex.
 *
 *   (L p)_v = sum_j w_vj (p_v - p_j),   w_vj = 1/2 sum cot(angles opposite to the edge v j)
 *
 * which is the gradient of the area of the mesh. An edge may have any number of faces. L is
 * symmetric and positive semi-definite also on meshes with obtuse triangles and slivers: the area
 * by which a triangle's cotangents are divided has a floor relative to the squares of its edges,
 * which leaves each triangle a positive semi-definite contribution (clamped cotangents would not).
 */

#ifndef SurfaceDenoising_CotangentLaplacian_h
#define SurfaceDenoising_CotangentLaplacian_h

#include "../TriangleMesh.h"

namespace SurfaceDenoising
{

class CotangentLaplacian
{
public:
  /// The mesh and its stars must outlive the operator.
  CotangentLaplacian(const TriangleMesh& mesh, const CompressedRows& stars, Execution& execution);

  /// Weights and masses of the mesh with its present positions.
  void Update(Execution& execution);

  /// A third of the area of the faces around each vertex.
  const Buffer<double>& Masses() const { return this->Mass; }

  /// sum_j w_vj, the diagonal of L.
  const Buffer<double>& Diagonal() const { return this->WeightSum; }

  /// (L x)_v
  Vec3 Apply(const Buffer<Vec3>& x, std::size_t v) const
  {
    const Vec3 centre = x[v];
    Vec3 sum(0.0, 0.0, 0.0);
    for (std::uint64_t k = this->Rings.Offsets[v]; k < this->Rings.Offsets[v + 1]; ++k)
    {
      sum += this->Weights[k] * (centre - x[this->Rings.Ids[k]]);
    }
    return sum;
  }

private:
  void UpdateFaces(Execution& execution);

  const TriangleMesh& Mesh;
  const CompressedRows& Stars;
  CompressedRows Rings;
  Buffer<double> Weights; ///< w_vj for the entries of the rings
  Buffer<double> WeightSum;
  Buffer<double> Mass;
  Buffer<double> FaceAreas;
  Buffer<Vec3> HalfCotangents; ///< of the angle at each corner
};

}

#endif
