// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkMeanCurvatureFlowFilter
 * @brief   smoothing by implicit mean curvature flow
 *
 * M. Desbrun, M. Meyer, P. Schroeder, A. Barr, "Implicit fairing of irregular meshes using
 * diffusion and curvature flow", SIGGRAPH 1999, 317-324. In each iteration the positions P become
 * P' with
 *
 *   (M + dt L) P' = M P,    (L p)_v = sum_j 1/2 (cot alpha_vj + cot beta_vj) (p_v - p_j)
 *
 * where M is a third of the area of the faces around each point and alpha, beta are the angles
 * opposite to the edge: the flow dp/dt = -2 H n, which reduces the area of the surface. The step is
 * implicit and stable for any dt. The systems are solved by conjugate gradients to ten digits of
 * the displacements.
 *
 * A method of one stage, there for comparison: what it takes for noise includes all edges and
 * details, and objects shrink. Volume can be restored, roundness cannot.
 *
 * Differs from the paper: time is six times faster, since the area of a point is a third of its
 * faces, not twice their whole. Cotangents of angles below about a hundredth of a degree are
 * limited.
 */

#ifndef vtkMeanCurvatureFlowFilter_h
#define vtkMeanCurvatureFlowFilter_h

#include "vtkOneStageFilter.h"

class VTKSURFACEDENOISINGMESH_EXPORT vtkMeanCurvatureFlowFilter : public vtkOneStageFilter
{
public:
  static vtkMeanCurvatureFlowFilter* New();
  vtkTypeMacro(vtkMeanCurvatureFlowFilter, vtkOneStageFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Number of steps. Default 3. What counts is about the product with TimeStep; more and smaller
  /// steps follow the flow more closely. 0: from the data; -1: none.
  vtkSetClampMacro(NumberOfIterations, int, -1, VTK_INT_MAX);
  vtkGetMacro(NumberOfIterations, int);
  ///@}

  ///@{
  /**
   * The time dt of a step in squared mean edge lengths of the input. Default 0.2; features narrower
   * than about sqrt(dt) edge lengths go. 0: from the data.
   */
  vtkSetClampMacro(TimeStep, double, 0.0, 1e6);
  vtkGetMacro(TimeStep, double);
  ///@}

  ///@{
  /**
   * Scale the surface after each step, about the mean of its points, to the volume that it had.
   * Default off. For closed surfaces; others get a warning and keep what the flow makes of them.
   * Several components are scaled together.
   */
  vtkSetMacro(RestoreVolume, bool);
  vtkGetMacro(RestoreVolume, bool);
  vtkBooleanMacro(RestoreVolume, bool);
  ///@}

protected:
  vtkMeanCurvatureFlowFilter();
  ~vtkMeanCurvatureFlowFilter() override;

  Method Configure() override;
  void Tell(SurfaceDenoising::SurfaceWork& work) override;

  int NumberOfIterations = 3;
  double TimeStep = 0.2;
  bool RestoreVolume = false;

private:
  vtkMeanCurvatureFlowFilter(const vtkMeanCurvatureFlowFilter&) = delete;
  void operator=(const vtkMeanCurvatureFlowFilter&) = delete;

  ///@{
  /// Of the last run of the method.
  int SolverIterations = 0;
  bool VolumeKept = true;
  ///@}
};

#endif
