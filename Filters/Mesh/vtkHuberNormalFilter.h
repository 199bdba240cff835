// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkHuberNormalFilter
 * @brief   Huber's minimax norm on face normals
 *
 * P. Huber, "Robust Statistics", 1981. Nobody seems to have tried the norm on face normals:
 *
 *   n_i <- normalise( sum_j  A_j  f(|c_i - c_j|)  min(1, s / |n_i - n_j|)  n_j )
 *
 * over the faces that share a point and the face itself. Its influence is bounded, so that a stray
 * normal does little harm, but never falls: the energy is convex, the result does not depend on the
 * start, and edges get round in the end. Take few iterations with a small scale, or DataSource
 * ORIGINAL: always the normals at the start are averaged then, which is the M-estimate itself and
 * converges.
 *
 * Good as a first stage before a filter that keeps edges, or for smooth objects.
 */

#ifndef vtkHuberNormalFilter_h
#define vtkHuberNormalFilter_h

#include "vtkFaceNormalFilter.h"

class VTKSURFACEDENOISINGMESH_EXPORT vtkHuberNormalFilter : public vtkFaceNormalFilter
{
public:
  static vtkHuberNormalFilter* New();
  vtkTypeMacro(vtkHuberNormalFilter, vtkFaceNormalFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The scale s as a chord length of unit normals. Default 0.1; useful are 0.05 to 0.2. 0: from the
   * data.
   */
  vtkSetClampMacro(RangeScale, double, 0.0, 2.0);
  vtkGetMacro(RangeScale, double);
  ///@}

  ///@{
  /// Sigma of a spatial Gaussian f in mean distances of adjacent centroids; 0: from the data; -1,
  /// the default: none.
  vtkSetClampMacro(SpatialScale, double, -1.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SpatialScale, double);
  ///@}

  ///@{
  /// Which normals are averaged, one of DataSources. Default PREVIOUS.
  vtkSetClampMacro(DataSource, int, PREVIOUS, ORIGINAL);
  vtkGetMacro(DataSource, int);
  void SetDataSourceToPrevious() { this->SetDataSource(PREVIOUS); }
  void SetDataSourceToOriginal() { this->SetDataSource(ORIGINAL); }
  ///@}

protected:
  vtkHuberNormalFilter();
  ~vtkHuberNormalFilter() override;

  void Configure(SurfaceDenoising::MeshDenoisingSettings& settings) override;

  double RangeScale;
  double SpatialScale;
  int DataSource;

private:
  vtkHuberNormalFilter(const vtkHuberNormalFilter&) = delete;
  void operator=(const vtkHuberNormalFilter&) = delete;
};

#endif
