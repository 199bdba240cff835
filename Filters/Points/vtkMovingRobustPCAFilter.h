// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkMovingRobustPCAFilter
 * @brief   fits robust planes to overlapping neighbourhoods and moves points to where they agree
 *
 * E. Mattei, A. Castrodad, "Point Cloud Denoising via Moving RPCA", Computer Graphics Forum 36(8),
 * 2017. Through every point and its neighbours goes the plane with the least weighted sum of
 * distances, with weights exp(-(theta_ij / sigma)^2) from the angle between normals, signs aside;
 * what lies too far off is an outlier of that plane. A point goes to the mean of its projections
 * onto the planes that trust it. The paper's optimisation is reconstructed: this is the smallest
 * algorithm with the properties that its abstract and the survey name.
 *
 * Needs no oriented normals. The best of the published methods at sharp edges.
 */

#ifndef vtkMovingRobustPCAFilter_h
#define vtkMovingRobustPCAFilter_h

#include "vtkPointNeighborhoodFilter.h"

class VTKSURFACEDENOISINGPOINTS_EXPORT vtkMovingRobustPCAFilter : public vtkPointNeighborhoodFilter
{
public:
  static vtkMovingRobustPCAFilter* New();
  vtkTypeMacro(vtkMovingRobustPCAFilter, vtkPointNeighborhoodFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// sigma, the angle between normals that counts, in degrees: 15 to 30. Default 22.5. 0: from the
  /// data.
  vtkSetClampMacro(NormalAngle, double, 0.0, 180.0);
  vtkGetMacro(NormalAngle, double);
  ///@}

  ///@{
  /// Weight of the point itself beside the planes. Default 0.
  vtkSetClampMacro(DataFidelity, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(DataFidelity, double);
  ///@}

  ///@{
  /// Rounds of the robust fit, at most. Default 10.
  vtkSetClampMacro(NumberOfRobustFits, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfRobustFits, int);
  ///@}

protected:
  vtkMovingRobustPCAFilter();
  ~vtkMovingRobustPCAFilter() override;

  void Configure(SurfaceDenoising::PointDenoisingSettings& settings) override;

  double NormalAngle;
  double DataFidelity;
  int NumberOfRobustFits;

private:
  vtkMovingRobustPCAFilter(const vtkMovingRobustPCAFilter&) = delete;
  void operator=(const vtkMovingRobustPCAFilter&) = delete;
};

#endif
