// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkNormalDiffusionFilter
 * @brief   diffusion of face normals that stops at creases
 *
 * A. Belyaev, Y. Ohtake, "Nonlinear diffusion of normals for crease enhancement", Vision Geometry
 * X, 2001, 42-47:
 *
 *   n_i <- normalise( sum_j  A_j  exp(-(k_ij / s)^2)  n_j ),   k_ij = angle(n_i, n_j) / |c_i -
 * c_j|,
 *
 * over the edge-adjacent faces j and the face itself, then a gradient descent of sum_f A_f |n_f -
 * m_f|^2 fits the points, and both are repeated. k is a directional curvature: the diffusion stops
 * where the surface bends more than s. It sharpens creases; with so few neighbours long ripples
 * remain.
 *
 * In robust terms: a Gaussian error norm on the directional curvature.
 *
 * Reconstructed: descriptions differ in whether the face itself counts and whether areas do; here
 * both, which keeps the scheme from oscillating between neighbouring faces.
 */

#ifndef vtkNormalDiffusionFilter_h
#define vtkNormalDiffusionFilter_h

#include "vtkFaceNormalFilter.h"

class VTKSURFACEDENOISINGMESH_EXPORT vtkNormalDiffusionFilter : public vtkFaceNormalFilter
{
public:
  static vtkNormalDiffusionFilter* New();
  vtkTypeMacro(vtkNormalDiffusionFilter, vtkFaceNormalFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The scale s as the angle in degrees between two faces whose centroids are at the mean distance
   * of adjacent ones. Default 35; from 20 for little noise to 60. 0: from the data.
   */
  vtkSetClampMacro(RangeScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(RangeScale, double);
  ///@}

  ///@{
  /// Which faces are averaged, one of Neighborhoods. Default EDGE_ADJACENT.
  vtkSetClampMacro(Neighborhood, int, EDGE_ADJACENT, VERTEX_SHARING);
  vtkGetMacro(Neighborhood, int);
  void SetNeighborhoodToEdgeAdjacent() { this->SetNeighborhood(EDGE_ADJACENT); }
  void SetNeighborhoodToVertexSharing() { this->SetNeighborhood(VERTEX_SHARING); }
  ///@}

  ///@{
  /// Count the face itself among its neighbours. Default on.
  vtkSetMacro(IncludeOwn, bool);
  vtkGetMacro(IncludeOwn, bool);
  vtkBooleanMacro(IncludeOwn, bool);
  ///@}

protected:
  vtkNormalDiffusionFilter();
  ~vtkNormalDiffusionFilter() override;

  void Configure(SurfaceDenoising::MeshDenoisingSettings& settings) override;
  double RangeUnit() const override;

  double RangeScale;
  int Neighborhood;
  bool IncludeOwn;

private:
  vtkNormalDiffusionFilter(const vtkNormalDiffusionFilter&) = delete;
  void operator=(const vtkNormalDiffusionFilter&) = delete;
};

#endif
