// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkBilateralPointFilter
 * @brief   bilateral filter of heights over fitted planes
 *
 * J. Digne, C. de Franchis, "The Bilateral Filter for Point Clouds", IPOL 7, 2017. A plane is
 * fitted to the neighbours, weighted by exp(-d^2 / (2 sigma_d^2)), and the point moves along its
 * normal by
 *
 *   t = sum_j w_j h_j / sum_j w_j,  w_j = exp(-d_j^2 / (2 sigma_d^2)) exp(-h_j^2 / (2 sigma_h^2))
 *
 * with the heights h_j of the neighbours over the plane through the point; the point itself counts
 * with height 0. Fast, needs no normals, shrinks curved parts a little with every iteration.
 *
 * The radius of the paper is r = l sqrt(20 / N) for N points with a bounding box of longest side l,
 * which depends on the axes; here it is in mean spacings, and sigma_d and sigma_h are a third of it
 * as in the paper. Those who filter sharp objects take a smaller HeightScale.
 */

#ifndef vtkBilateralPointFilter_h
#define vtkBilateralPointFilter_h

#include "vtkPointNeighborhoodFilter.h"

class VTKSURFACEDENOISINGPOINTS_EXPORT vtkBilateralPointFilter : public vtkPointNeighborhoodFilter
{
public:
  static vtkBilateralPointFilter* New();
  vtkTypeMacro(vtkBilateralPointFilter, vtkPointNeighborhoodFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// sigma_d in spacings. Default 1. 0: from the data; -1: none.
  vtkSetClampMacro(SpatialScale, double, -1.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SpatialScale, double);
  ///@}

  ///@{
  /// sigma_h in spacings. Default 1; 0.3 to 0.5 keep features better. 0: from the data.
  vtkSetClampMacro(HeightScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(HeightScale, double);
  ///@}

  ///@{
  /// Fit planes (on, the default), or take the normals to start with (off).
  vtkSetMacro(FitNormals, bool);
  vtkGetMacro(FitNormals, bool);
  vtkBooleanMacro(FitNormals, bool);
  ///@}

protected:
  vtkBilateralPointFilter();
  ~vtkBilateralPointFilter() override;

  void Configure(SurfaceDenoising::PointDenoisingSettings& settings) override;

  double SpatialScale;
  double HeightScale;
  bool FitNormals = true;

private:
  vtkBilateralPointFilter(const vtkBilateralPointFilter&) = delete;
  void operator=(const vtkBilateralPointFilter&) = delete;
};

#endif
