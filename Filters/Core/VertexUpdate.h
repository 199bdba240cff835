// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file VertexUpdate.h
 * @brief Moves vertices so that the faces fit given normals m_f.
 *
 * Most of the schemes descend the orthogonality energy
 *
 *   E = sum_f sum_{edges (i, j) of f} ( m_f . (p_i - p_j) )^2
 *
 * (G. Taubin 2001; Y. Ohtake, A. Belyaev, I. Bogaevski 2001; X. Sun, P. Rosin, R. Martin, F.
 * Langbein 2007), whose descent direction at vertex v is sum_f m_f (m_f . (c_f - p_v)) over its
 * faces with centroids c_f. They differ by the step. The integral fit of Ohtake, Belyaev and
 * Bogaevski has an energy of its own. The scheme of S. K. Yadav, U. Reitebuch, K. Polthier, "Robust
 * and high fidelity mesh denoising", IEEE TVCG 25(6), 2019, adds lambda (D + D_t) to the step: D
 * leads from the vertex to the mean of its ring weighted by edge lengths, D_t is its part across
 * sum_f A_f m_f, and lambda falls by 0.7 with every step. The ends of boundary edges have no D.
 *
 * Faces with m_f = 0 are ignored. All steps are Jacobi steps: every vertex sees the positions
 * before the step.
 */

#ifndef SurfaceDenoising_VertexUpdate_h
#define SurfaceDenoising_VertexUpdate_h

#include "TriangleMesh.h"

namespace SurfaceDenoising
{

enum class VertexScheme : int
{
  FaceMean,     ///< p += mean_f m_f (m_f . (c_f - p)): Sun et al. 2007. Stable for every valence
  ConstantStep, ///< p += 1/6 sum_f m_f (m_f . (c_f - p)): Taubin 2001, Zheng et al. 2011.
                ///< Oscillates beyond 9 faces, diverges beyond 12
  AreaWeighted, ///< as FaceMean, with the mean weighted by face areas: Yagou et al. 2002
  IntegralFit,  ///< p -= 0.05 grad sum_f A_f |n_f - m_f|^2: Ohtake et al. 2001. Also moves along
                ///< the surface
  EdgeWeighted  ///< as FaceMean, with a fading pull towards evenly long edges: Yadav et al. 2018
};

/// What happens at the ends of boundary edges.
enum class BoundaryHandling : int
{
  Fixed, ///< they stay
  Slide, ///< they move along the boundary and across the surface, not into it
  Free   ///< they move as all others; open borders may shrink
};

struct VertexUpdateSettings
{
  VertexScheme Scheme = VertexScheme::FaceMean;
  BoundaryHandling Boundary = BoundaryHandling::Fixed;
  bool PreventFlips = false; ///< cut steps that turn a face over, see FlipGuard.h
  double MaximumDisplacement =
    0.0;                   ///< how far from its first position a vertex may go, a length; 0: any
  double Relaxation = 0.2; ///< lambda of EdgeWeighted in its first step, in [0, 0.5]
  /// After the steps of a run, the part of its way along the normal that a vertex goes back.
  double InputPull = 0.0;
  /// Stop once the root mean square of a step is below this part of that of the first one; 0:
  /// never.
  double Rest = 0.0;
};

class VertexUpdate
{
public:
  /// Everything must outlive the update. scale is the mean edge length.
  VertexUpdate(const TriangleMesh& topology, const CompressedRows& stars,
    const Buffer<unsigned char>& boundary, double scale, const VertexUpdateSettings& settings);

  /**
   * Moves the vertices count times towards the target normals. Stops early if the execution does
   * not proceed; progress is reported from first to last.
   */
  bool Run(Buffer<Vec3>& positions, const Buffer<Vec3>& targets, int count, Execution& execution,
    double first, double last);

  /// Displacements that were shortened because a face would have turned over, in all steps.
  std::size_t NumberOfGuardedVertices() const { return this->Guarded; }

  /// Steps taken, in all runs.
  int NumberOfSteps() const { return this->Steps; }

private:
  void Step(const Buffer<Vec3>& positions, const Buffer<Vec3>& targets, Buffer<Vec3>& moved,
    Execution& execution);
  void OrthogonalityStep(const Buffer<Vec3>& positions, const Buffer<Vec3>& targets,
    Buffer<Vec3>& moved, Execution& execution);
  void IntegralFitStep(const Buffer<Vec3>& positions, const Buffer<Vec3>& targets,
    Buffer<Vec3>& moved, Execution& execution);
  void SlideBoundary(const Buffer<Vec3>& positions, Buffer<Vec3>& moved, Execution& execution);
  void LimitDisplacement(Buffer<Vec3>& moved, Execution& execution) const;
  Vec3 Relaxed(std::size_t vertex, const Buffer<Vec3>& positions,
    const Buffer<Vec3>& targets) const;
  void ComputeAreas(const Buffer<Vec3>& positions, Execution& execution);
  Vec3 MeanTarget(std::size_t vertex, const Buffer<Vec3>& targets) const;
  void PullBack(Buffer<Vec3>& positions, const Buffer<Vec3>& targets, Execution& execution);

  const TriangleMesh& Topology;
  const CompressedRows& Stars;
  const Buffer<unsigned char>& Boundary;
  double Scale;
  VertexUpdateSettings Settings;
  std::size_t Guarded = 0;
  int Steps = 0;
  double Relaxation; ///< lambda of the next step

  Buffer<Vec3> Start;        ///< first positions, if anything asks for them
  Buffer<double> FaceOffset; ///< m_f . c_f
  Buffer<double> FaceArea;   ///< where it is needed
  Buffer<Vec3> FaceMisfit;   ///< n_f - m_f, for IntegralFit
};

}

#endif
