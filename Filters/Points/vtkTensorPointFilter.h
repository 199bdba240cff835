// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkTensorPointFilter
 * @brief   fits planes to the part of the neighbourhood that lies on one face
 *
 * M. K. Park, S. J. Lee, I. Y. Jang, Y. Y. Lee, K. H. Lee, "Feature-aware filtering for point-set
 * surface denoising", Computers and Graphics 37(6), 2013. The tensor of the normals around a point,
 * weighted by exp(-(s^2 + c kappa^2) / sigma^2) with the arc length s and the curvature kappa of
 * the way to the neighbour, tells features. A feature point joins the face whose plane it is
 * closest to, its region are the neighbours along that face, and normal and position come from fits
 * to the region. The weights are the paper's; the later stages are reconstructed.
 *
 * Needs no oriented normals.
 */

#ifndef vtkTensorPointFilter_h
#define vtkTensorPointFilter_h

#include "vtkPointNeighborhoodFilter.h"

class VTKSURFACEDENOISINGPOINTS_EXPORT vtkTensorPointFilter : public vtkPointNeighborhoodFilter
{
public:
  static vtkTensorPointFilter* New();
  vtkTypeMacro(vtkTensorPointFilter, vtkPointNeighborhoodFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// sigma in spacings. Default 4. 0: from the data.
  vtkSetClampMacro(Range, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Range, double);
  ///@}

  ///@{
  /// c over the fourth power of the spacing: what bends cost beside lengths. Default 11.198431.
  vtkSetClampMacro(BendFactor, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(BendFactor, double);
  ///@}

  ///@{
  /// Feature points have a tensor with 1.5 (l2 + l3) above this, in [0, 1]. Default 0.1; more
  /// noise wants more.
  vtkSetClampMacro(FeatureThreshold, double, 0.0, 1.0);
  vtkGetMacro(FeatureThreshold, double);
  ///@}

  ///@{
  /// How many times what a quarter of the neighbours are below a feature point must be; 0: the
  /// threshold alone tells. Default 1.5: points of smooth bends are no features.
  vtkSetClampMacro(FeatureContrast, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(FeatureContrast, double);
  ///@}

  ///@{
  /// Weight of the members of a region, at least, in [0, 1]. Default 0.6.
  vtkSetClampMacro(RegionThreshold, double, 0.0, 1.0);
  vtkGetMacro(RegionThreshold, double);
  ///@}

  ///@{
  /// Members of a region, at least 3. Default 5.
  vtkSetClampMacro(MinimumRegionSize, int, 3, VTK_INT_MAX);
  vtkGetMacro(MinimumRegionSize, int);
  ///@}

  ///@{
  /// Move feature points to where the planes of all neighbours meet. Default off.
  vtkSetMacro(QuadricAtFeatures, bool);
  vtkGetMacro(QuadricAtFeatures, bool);
  vtkBooleanMacro(QuadricAtFeatures, bool);
  ///@}

protected:
  vtkTensorPointFilter();
  ~vtkTensorPointFilter() override;

  void Configure(SurfaceDenoising::PointDenoisingSettings& settings) override;
  bool TellsClasses() const override { return true; }

  double Range;
  double BendFactor;
  double FeatureThreshold;
  double FeatureContrast;
  double RegionThreshold;
  int MinimumRegionSize;
  bool QuadricAtFeatures;

private:
  vtkTensorPointFilter(const vtkTensorPointFilter&) = delete;
  void operator=(const vtkTensorPointFilter&) = delete;
};

#endif
