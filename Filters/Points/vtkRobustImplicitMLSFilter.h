// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkRobustImplicitMLSFilter
 * @brief   projects points onto the zero set of a robust implicit function
 *
 * A. C. Oztireli, G. Guennebaud, M. Gross, "Feature Preserving Point Set Surfaces based on
 * Non-Linear Kernel Regression", Computer Graphics Forum 28(2), 2009. Around a place x, the
 * function is a weighted mean of the distances of x from the planes of the samples near it,
 *
 *   f(x) = sum_j alpha_j phi_j(x) n_j . (x - p_j) / sum_j alpha_j phi_j(x),
 *   phi_j(x) = (1 - |x - p_j|^2 / h_j^2)^4 inside the ball of radius h_j, 0 outside,
 *   alpha_j = exp(-((f_j - f) / (sigma_r h_j))^2) exp(-(|n_j - grad f| / sigma_n)^2),
 *
 * refitted with its own value and gradient a few times, and points walk along its gradient to where
 * it is zero. h_j is local: FilterScale times the spacing around sample j (1.13 r_16 sqrt(pi /
 * 16)).
 *
 * Normals of samples are not filtered: the method is better at positions than at normals, and wants
 * good normals to begin with.
 */

#ifndef vtkRobustImplicitMLSFilter_h
#define vtkRobustImplicitMLSFilter_h

#include "vtkPointDenoisingFilter.h"

class VTKSURFACEDENOISINGPOINTS_EXPORT vtkRobustImplicitMLSFilter : public vtkPointDenoisingFilter
{
public:
  static vtkRobustImplicitMLSFilter* New();
  vtkTypeMacro(vtkRobustImplicitMLSFilter, vtkPointDenoisingFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Radius of the balls around samples over 2 r_16 / sqrt(16), about 1.13 spacings. Useful are
  /// 1.4 to 4, default 3: larger is smoother. 0: from the data.
  vtkSetClampMacro(FilterScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(FilterScale, double);
  ///@}

  ///@{
  /// sigma_n, the difference of normals that counts, as a chord: 0.5 (sharp) to 1.5 (smooth).
  /// Default 0.75. 0: from the data.
  vtkSetClampMacro(NormalScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(NormalScale, double);
  ///@}

  ///@{
  /// sigma_r over the radius of the sample: planes that are farther from the result count less.
  /// 0: residuals do not count. Default 0.5.
  vtkSetClampMacro(ResidualScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ResidualScale, double);
  ///@}

  ///@{
  /// How often the function is refitted at a place, at most. 1: not robust. Default 3.
  vtkSetClampMacro(MaximumNumberOfFits, int, 1, VTK_INT_MAX);
  vtkGetMacro(MaximumNumberOfFits, int);
  ///@}

  ///@{
  /// Steps of a point towards the zero set, at most. Default 15.
  vtkSetClampMacro(MaximumNumberOfProjections, int, 1, VTK_INT_MAX);
  vtkGetMacro(MaximumNumberOfProjections, int);
  ///@}

  ///@{
  /// Treat n and -n as the same normal: for normals whose signs mean nothing. Sheets closer than
  /// the neighbourhood are then taken for one. Default off: normals are oriented.
  vtkSetMacro(UnorientedNormals, bool);
  vtkGetMacro(UnorientedNormals, bool);
  vtkBooleanMacro(UnorientedNormals, bool);
  ///@}

protected:
  vtkRobustImplicitMLSFilter();
  ~vtkRobustImplicitMLSFilter() override;

  void Configure(SurfaceDenoising::PointDenoisingSettings& settings) override;

  double FilterScale;
  double NormalScale;
  double ResidualScale;
  int MaximumNumberOfFits;
  int MaximumNumberOfProjections;
  bool UnorientedNormals;

private:
  vtkRobustImplicitMLSFilter(const vtkRobustImplicitMLSFilter&) = delete;
  void operator=(const vtkRobustImplicitMLSFilter&) = delete;
};

#endif
