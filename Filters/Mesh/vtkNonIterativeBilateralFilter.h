// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkNonIterativeBilateralFilter
 * @brief   moves points once, to robust means of what the faces around them predict
 *
 * T. R. Jones, F. Durand, M. Desbrun, "Non-iterative, feature-preserving mesh smoothing", ACM TOG
 * 22(3), 943-949, 2003. A face f with centroid c_f, area A_f and smoothed normal m_f predicts the
 * position P_f(p) = p - m_f (m_f . (p - c_f)) on its plane, and
 *
 *   p <- sum_f A_f K(|c_f - p|, s_f) K(|P_f(p) - p|, s_g) P_f(p)
 *      / sum_f A_f K(|c_f - p|, s_f) K(|P_f(p) - p|, s_g)
 *
 * with Gaussians K(x, s) = exp(-x^2 / (2 s^2)), over the faces with centroids within 2 s_f that are
 * reached through faces that share a point. The normals m_f are those of a mollified surface, whose
 * points are means of the same centroids with the weights A_f K(|c_f - p|, s_f / 2).
 *
 * In robust terms: a Gaussian error norm on distances from planes, with a spatial Gaussian.
 *
 * A method of one stage, there for comparison. It rounds edges where s_g is larger than their
 * height over the surroundings, and leaves waves wider than s_f. Points with no face within 2 s_f
 * stay.
 *
 * Differs from the paper: faces count only if they are connected to the point within the radius,
 * which keeps the two sides of a thin wall apart.
 */

#ifndef vtkNonIterativeBilateralFilter_h
#define vtkNonIterativeBilateralFilter_h

#include "vtkOneStageFilter.h"

class VTKSURFACEDENOISINGMESH_EXPORT vtkNonIterativeBilateralFilter : public vtkOneStageFilter
{
public:
  static vtkNonIterativeBilateralFilter* New();
  vtkTypeMacro(vtkNonIterativeBilateralFilter, vtkOneStageFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The spatial scale s_f in mean edge lengths. Default 1; 1.5 to 3 for strong noise, up to 4. At
   * most 10: time grows with the square. 0: from the data.
   */
  vtkSetClampMacro(SpatialScale, double, 0.0, 10.0);
  vtkGetMacro(SpatialScale, double);
  ///@}

  ///@{
  /// The range scale s_g in mean edge lengths. Default 1; from 0.1, which keeps small steps, to 2.
  /// 0: from the data.
  vtkSetClampMacro(RangeScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(RangeScale, double);
  ///@}

protected:
  vtkNonIterativeBilateralFilter();
  ~vtkNonIterativeBilateralFilter() override;

  Method Configure() override;

  double SpatialScale = 1.0;
  double RangeScale = 1.0;

private:
  vtkNonIterativeBilateralFilter(const vtkNonIterativeBilateralFilter&) = delete;
  void operator=(const vtkNonIterativeBilateralFilter&) = delete;
};

#endif
