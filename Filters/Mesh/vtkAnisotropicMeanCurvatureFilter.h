// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkAnisotropicMeanCurvatureFilter
 * @brief   smoothing by mean curvature flow that slows down at edges
 *
 * K. Hildebrandt, K. Polthier, "Anisotropic filtering of non-linear surface features", Computer
 * Graphics Forum 23(3), 391-400, 2004. An edge e between faces at the angle phi (0 is flat) has the
 * mean curvature H_e = 2 |e| sin(phi / 2), negative if concave, along the mean normal N_e of the
 * two faces. In each iteration the points move by
 *
 *   p <- p - dt (3 / area) HA,    HA = 1/2 sum_{e at p} w(H_e) H_e N_e
 *   w(H) = 1 if |H| <= lambda, else lambda^2 / (10 (lambda - |H|)^2 + lambda^2)
 *
 * with the area of the faces around p. In robust terms, w is the weight function of Centin and
 * Signoroni on the curvature of edges.
 *
 * With PrescribeCurvature the points move by HA - f V instead, where f V is the curvature of the
 * surroundings: its mean over the neighbours, on features over features only, in the direction V of
 * the gradient of the volume. Curvature gets smooth instead of small.
 *
 * A method of one stage, there for comparison: edges and corners last longer than with
 * vtkMeanCurvatureFlowFilter, but the longer it runs, the more objects shrink, corners first. With
 * prescribed curvature they hardly do, and it takes more iterations.
 *
 * Differs from the paper: dt is at most area / 12 at each point, or the flow would be unstable
 * where triangles are small. Prescribed curvature is the projection f = HA . V / |V|^2, plain means
 * take the place of angle-weighted ones, and the signs of f are kept.
 */

#ifndef vtkAnisotropicMeanCurvatureFilter_h
#define vtkAnisotropicMeanCurvatureFilter_h

#include "vtkOneStageFilter.h"

class VTKSURFACEDENOISINGMESH_EXPORT vtkAnisotropicMeanCurvatureFilter : public vtkOneStageFilter
{
public:
  static vtkAnisotropicMeanCurvatureFilter* New();
  vtkTypeMacro(vtkAnisotropicMeanCurvatureFilter, vtkOneStageFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Number of steps. Default 10; 20 to 80 with PrescribeCurvature. 0: from the data; -1:
  /// none.
  vtkSetClampMacro(NumberOfIterations, int, -1, VTK_INT_MAX);
  vtkGetMacro(NumberOfIterations, int);
  ///@}

  ///@{
  /// The time dt of a step in squared mean edge lengths, as they are before the step. Default 0.1;
  /// more hardly makes it faster, because it is cut where the flow would become unstable.
  /// 0: from the data.
  vtkSetClampMacro(TimeStep, double, 0.0, 1e6);
  vtkGetMacro(TimeStep, double);
  ///@}

  ///@{
  /**
   * The curvature lambda above which an edge is a feature, in mean edge lengths, as they are before
   * the step. Default 0.5: 29 degrees on an edge of mean length. 0.3 keeps blunter edges and takes
   * twice the iterations; 1 is 60 degrees, for smooth objects. The larger, the closer to
   * mean curvature flow. 0: from the data.
   */
  vtkSetClampMacro(EdgeThreshold, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(EdgeThreshold, double);
  ///@}

  ///@{
  /// Smooth the curvature instead of reducing it, which keeps the volume. Default off.
  vtkSetMacro(PrescribeCurvature, bool);
  vtkGetMacro(PrescribeCurvature, bool);
  vtkBooleanMacro(PrescribeCurvature, bool);
  ///@}

protected:
  vtkAnisotropicMeanCurvatureFilter();
  ~vtkAnisotropicMeanCurvatureFilter() override;

  Method Configure() override;

  int NumberOfIterations = 10;
  double TimeStep = 0.1;
  double EdgeThreshold = 0.5;
  bool PrescribeCurvature = false;

private:
  vtkAnisotropicMeanCurvatureFilter(const vtkAnisotropicMeanCurvatureFilter&) = delete;
  void operator=(const vtkAnisotropicMeanCurvatureFilter&) = delete;
};

#endif
