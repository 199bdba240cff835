// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkFeatureAwarePointFilter
 * @brief   trilateral filter with the likelihood of points and the intensity of features
 *
 * J. Li, "Feature-Preserving Denoising of Point-Sampled Surfaces", 2009; method (c) of the survey.
 * Normals are averaged with Gaussians of the distance and of the angle, whose width at every point
 * is the standard deviation of the angles around it. Points move along their normal by the mean
 * height of their neighbours, weighted by a Gaussian of the distance, by one of the height, which
 * is narrower the more the normals around vary (features), and by the likelihood of the neighbour,
 * a Gaussian of its distance from the plane of its surroundings (outliers attract nobody). The
 * survey gives the parts; how they combine is reconstructed.
 *
 * Needs no oriented normals. All widths are those of the surroundings, so that LocalScale has no
 * effect.
 */

#ifndef vtkFeatureAwarePointFilter_h
#define vtkFeatureAwarePointFilter_h

#include "vtkPointNeighborhoodFilter.h"

class VTKSURFACEDENOISINGPOINTS_EXPORT vtkFeatureAwarePointFilter
  : public vtkPointNeighborhoodFilter
{
public:
  static vtkFeatureAwarePointFilter* New();
  vtkTypeMacro(vtkFeatureAwarePointFilter, vtkPointNeighborhoodFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Which heights points move by.
  enum HeightModes
  {
    OWN_HEIGHT =
      0, ///< distances of the neighbours from the plane of the point: pulls curved surfaces inwards
    NEIGHBOR_HEIGHT =
      1, ///< distances of the point from the planes of its neighbours: pushes them outwards
    BALANCED_HEIGHT = 2 ///< the mean of both: leaves a sphere alone
  };

  ///@{
  /// beta, in [0, 1]: how much the Gaussian of heights narrows at features. Default 0.5.
  vtkSetClampMacro(FeatureSharpening, double, 0.0, 1.0);
  vtkGetMacro(FeatureSharpening, double);
  ///@}

  ///@{
  /// Which heights points move by, one of HeightModes. Default BALANCED_HEIGHT.
  vtkSetClampMacro(HeightMode, int, OWN_HEIGHT, BALANCED_HEIGHT);
  vtkGetMacro(HeightMode, int);
  void SetHeightModeToOwnHeight() { this->SetHeightMode(OWN_HEIGHT); }
  void SetHeightModeToNeighborHeight() { this->SetHeightMode(NEIGHBOR_HEIGHT); }
  void SetHeightModeToBalancedHeight() { this->SetHeightMode(BALANCED_HEIGHT); }
  ///@}

  ///@{
  /// The Gaussian of angles is at least that wide, in degrees. Default 2.
  vtkSetClampMacro(LeastAngle, double, 0.01, 90.0);
  vtkGetMacro(LeastAngle, double);
  ///@}

  ///@{
  /// Let unlikely points count less in the mean of normals too. Default off.
  vtkSetMacro(LikelihoodInNormals, bool);
  vtkGetMacro(LikelihoodInNormals, bool);
  vtkBooleanMacro(LikelihoodInNormals, bool);
  ///@}

protected:
  vtkFeatureAwarePointFilter();
  ~vtkFeatureAwarePointFilter() override;

  void Configure(SurfaceDenoising::PointDenoisingSettings& settings) override;

  double FeatureSharpening;
  int HeightMode;
  double LeastAngle;
  bool LikelihoodInNormals;

private:
  vtkFeatureAwarePointFilter(const vtkFeatureAwarePointFilter&) = delete;
  void operator=(const vtkFeatureAwarePointFilter&) = delete;
};

#endif
