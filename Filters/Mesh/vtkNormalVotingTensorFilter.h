// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkNormalVotingTensorFilter
 * @brief   normal voting tensor with binary eigenvalues
 *
 * S. K. Yadav, U. Reitebuch, K. Polthier, "Mesh denoising based on normal voting tensor and binary
 * optimization", IEEE TVCG 24(8), 2366-2379, 2018. The faces j within a radius vote,
 *
 *   T_i = sum_j w_ij A_j n_j n_j^T / sum_j w_ij A_j,   w_ij = 1 if angle(n_i, n_j) < s, else 0.1.
 *
 * The eigenvalues of T_i, divided by their Euclidean length, become 1 from TensorThreshold on and 0
 * below it (the largest is always 1): one 1 on a face, two at an edge, three at a corner. With the
 * eigenvectors e_k and these binary values b_k
 *
 *   n_i <- normalise( d n_i + sum_k b_k (e_k . n_i) e_k )
 *
 * with the Damping d; one step then moves the points, and all is repeated. Slow and safe; removes
 * long ripples; weak on strong noise.
 *
 * In robust terms: a box norm on the angle, and a projection in place of the mean.
 *
 * Reconstructed: the area factor, that the face itself votes, and the length of the eigenvalues.
 * The vertex step has the factor 1/3 without which it diverges.
 */

#ifndef vtkNormalVotingTensorFilter_h
#define vtkNormalVotingTensorFilter_h

#include "vtkFaceNormalFilter.h"

class VTKSURFACEDENOISINGMESH_EXPORT vtkNormalVotingTensorFilter : public vtkFaceNormalFilter
{
public:
  static vtkNormalVotingTensorFilter* New();
  vtkTypeMacro(vtkNormalVotingTensorFilter, vtkFaceNormalFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The angle s in degrees from which votes count a tenth. Default 46. 0: from the data.
   */
  vtkSetClampMacro(RangeScale, double, 0.0, 180.0);
  vtkGetMacro(RangeScale, double);
  ///@}

  ///@{
  /**
   * How far votes reach, in mean distances of adjacent centroids. Default 2, about 12 faces; 3 and
   * 4 see more at the cost of time. 0: from the data. Where there are more than 400 faces, those
   * vote that are the fewest faces away.
   */
  vtkSetClampMacro(Radius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * From which length on an eigenvalue counts. Default 0.3; from 0.05 for little to 0.4 for a lot
   * of noise: below it, noise is taken for edges.
   */
  vtkSetClampMacro(TensorThreshold, double, 0.0, 1.0);
  vtkGetMacro(TensorThreshold, double);
  ///@}

  ///@{
  /// How much of the old normal stays, d. Default 3.
  vtkSetClampMacro(Damping, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Damping, double);
  ///@}

  ///@{
  /**
   * Turn each vote along the circular arc to its neighbour, so that a smooth curved patch votes as
   * one. Keeps curvature and amplifies noise. Default off.
   */
  vtkSetMacro(RotateVotes, bool);
  vtkGetMacro(RotateVotes, bool);
  vtkBooleanMacro(RotateVotes, bool);
  ///@}

protected:
  vtkNormalVotingTensorFilter();
  ~vtkNormalVotingTensorFilter() override;

  void Configure(SurfaceDenoising::MeshDenoisingSettings& settings) override;
  double RangeUnit() const override;

  double RangeScale;
  double Radius;
  double TensorThreshold;
  double Damping;
  bool RotateVotes;

private:
  vtkNormalVotingTensorFilter(const vtkNormalVotingTensorFilter&) = delete;
  void operator=(const vtkNormalVotingTensorFilter&) = delete;
};

#endif
