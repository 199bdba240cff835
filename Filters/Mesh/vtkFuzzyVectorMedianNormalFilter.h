// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkFuzzyVectorMedianNormalFilter
 * @brief   weighted mean around the vector median of face normals
 *
 * Y. Shen, K. Barner, "Fuzzy vector median-based surface smoothing", IEEE TVCG 10(3), 252-265,
 * 2004:
 *
 *   n_i <- normalise( sum_j  exp(-|n_j - m_i|^2 / s^2)  n_j )
 *
 * over the faces that share a point and the face itself, where m_i is the one of these normals with
 * the least sum of angles to all others. The centre is robust: a face that noise has turned over is
 * overruled by those around it. Then steps move the points, and both are repeated.
 *
 * In robust terms: a Gaussian error norm around a median instead of the own normal.
 *
 * Reconstructed: two programs that are said to be this filter weigh by the angle, or by 1 - n_j .
 * m_i; here it is the chord as in the survey.
 */

#ifndef vtkFuzzyVectorMedianNormalFilter_h
#define vtkFuzzyVectorMedianNormalFilter_h

#include "vtkFaceNormalFilter.h"

class VTKSURFACEDENOISINGMESH_EXPORT vtkFuzzyVectorMedianNormalFilter : public vtkFaceNormalFilter
{
public:
  static vtkFuzzyVectorMedianNormalFilter* New();
  vtkTypeMacro(vtkFuzzyVectorMedianNormalFilter, vtkFaceNormalFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The scale s as a chord length of unit normals. Default 0.35; from 0.2 to 0.6. 0: from the data.
   */
  vtkSetClampMacro(RangeScale, double, 0.0, 2.0);
  vtkGetMacro(RangeScale, double);
  ///@}

  ///@{
  /// Weigh neighbours by their area too. Default off, as in the paper.
  vtkSetMacro(AreaWeighting, bool);
  vtkGetMacro(AreaWeighting, bool);
  vtkBooleanMacro(AreaWeighting, bool);
  ///@}

protected:
  vtkFuzzyVectorMedianNormalFilter();
  ~vtkFuzzyVectorMedianNormalFilter() override;

  void Configure(SurfaceDenoising::MeshDenoisingSettings& settings) override;
  double RangeUnit() const override;

  double RangeScale;
  bool AreaWeighting = false;

private:
  vtkFuzzyVectorMedianNormalFilter(const vtkFuzzyVectorMedianNormalFilter&) = delete;
  void operator=(const vtkFuzzyVectorMedianNormalFilter&) = delete;
};

#endif
