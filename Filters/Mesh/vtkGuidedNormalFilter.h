// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkGuidedNormalFilter
 * @brief   guided filtering of face normals
 *
 * W. Zhang, B. Deng, J. Zhang, S. Bouaziz, L. Liu, "Guided mesh normal filtering", Computer
 * Graphics Forum 34(7), 23-34, 2015:
 *
 *   n_i <- normalise( sum_j  A_j  exp(-|c_i - c_j|^2 / (2 s_d^2))  exp(-|G_i - G_j|^2 / (2 s^2))
 * n_j )
 *
 * over the faces within a radius and the face itself. What is compared are not the noisy normals
 * but guidance normals G: of all patches of faces around a point-sharing neighbour that contain the
 * face, G is the mean normal of the one that is flattest, or whose roughness is not all in one
 * edge. Ten steps then move the points, and all is repeated. The best choice for sharp objects with
 * strong noise; on curved ones it can invent edges.
 *
 * In robust terms: a bilateral filter whose differences are those of a guidance.
 *
 * Differs from the authors' program: open borders stay unless BoundaryHandling says otherwise, and
 * face flips are prevented unless PreventFlips is switched off.
 */

#ifndef vtkGuidedNormalFilter_h
#define vtkGuidedNormalFilter_h

#include "vtkFaceNormalFilter.h"

class VTKSURFACEDENOISINGMESH_EXPORT vtkGuidedNormalFilter : public vtkFaceNormalFilter
{
public:
  static vtkGuidedNormalFilter* New();
  vtkTypeMacro(vtkGuidedNormalFilter, vtkFaceNormalFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The scale s as a chord length of unit normals. Default 0.35; from 0.2 to 0.6. 0: from the data.
   */
  vtkSetClampMacro(RangeScale, double, 0.0, 2.0);
  vtkGetMacro(RangeScale, double);
  ///@}

  ///@{
  /// Sigma s_d of the spatial Gaussian in mean distances of adjacent centroids. Default 1; 0: from
  /// the data; -1: none.
  vtkSetClampMacro(SpatialScale, double, -1.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SpatialScale, double);
  ///@}

  ///@{
  /**
   * How far neighbours are, in mean distances of adjacent centroids of the input. Default 2, about
   * 12 faces; 0: from the data. Where there are more than 400, those
   * count that are the fewest faces away.
   */
  vtkSetClampMacro(Radius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Radius, double);
  ///@}

protected:
  vtkGuidedNormalFilter();
  ~vtkGuidedNormalFilter() override;

  void Configure(SurfaceDenoising::MeshDenoisingSettings& settings) override;

  double RangeScale;
  double SpatialScale;
  double Radius;

private:
  vtkGuidedNormalFilter(const vtkGuidedNormalFilter&) = delete;
  void operator=(const vtkGuidedNormalFilter&) = delete;
};

#endif
