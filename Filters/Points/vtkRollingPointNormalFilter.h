// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkRollingPointNormalFilter
 * @brief   rolling guidance: small structures vanish, large edges come back
 *
 * Y. Zheng, G. Li, X. Xu, S. Wu, Y. Nie, "Rolling normal filtering for point clouds", CAGD 62,
 * 2018. With the normals n_j at the start, always,
 *
 *   g_i <- normalise( sum_j exp(-(d_ij / sigma_d)^2) exp(-(|g_i - g_j| / sigma)^2) n_j ),
 *
 * first without the second factor, which removes everything smaller than sigma_d, then with it,
 * which brings the edges between large faces back. Points move to fit the normals by gradient steps
 * (U-GRAD of the reconstruction; the paper only says gradient descent).
 */

#ifndef vtkRollingPointNormalFilter_h
#define vtkRollingPointNormalFilter_h

#include "vtkPointNeighborhoodFilter.h"

class VTKSURFACEDENOISINGPOINTS_EXPORT vtkRollingPointNormalFilter
  : public vtkPointNeighborhoodFilter
{
public:
  static vtkRollingPointNormalFilter* New();
  vtkTypeMacro(vtkRollingPointNormalFilter, vtkPointNeighborhoodFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// sigma, the difference of normals that counts, as a chord: 0.1 to 0.5. Default 0.35. 0: from
  /// the data.
  vtkSetClampMacro(RangeScale, double, 0.0, 2.0);
  vtkGetMacro(RangeScale, double);
  ///@}

  ///@{
  /// sigma_d in spacings: what is smaller vanishes. Default 1.55. 0: from the data.
  vtkSetClampMacro(SpatialScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SpatialScale, double);
  ///@}

  ///@{
  /// How often normals are filtered. Settled after 4 to 6; default 4. 0: from the data.
  vtkSetClampMacro(NumberOfRolls, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfRolls, int);
  ///@}

  ///@{
  /// How often points move, after the normals were filtered. Default 10. 0: from the data; -1:
  /// none.
  vtkSetClampMacro(NumberOfPointIterations, int, -1, VTK_INT_MAX);
  vtkGetMacro(NumberOfPointIterations, int);
  ///@}

  ///@{
  /// Treat n and -n as the same normal: for normals whose signs mean nothing. Sheets closer than
  /// the neighbourhood are then taken for one. Default off: normals are oriented.
  vtkSetMacro(UnorientedNormals, bool);
  vtkGetMacro(UnorientedNormals, bool);
  vtkBooleanMacro(UnorientedNormals, bool);
  ///@}

protected:
  vtkRollingPointNormalFilter();
  ~vtkRollingPointNormalFilter() override;

  void Configure(SurfaceDenoising::PointDenoisingSettings& settings) override;

  double RangeScale;
  double SpatialScale;
  int NumberOfRolls;
  int NumberOfPointIterations;
  bool UnorientedNormals;

private:
  vtkRollingPointNormalFilter(const vtkRollingPointNormalFilter&) = delete;
  void operator=(const vtkRollingPointNormalFilter&) = delete;
};

#endif
