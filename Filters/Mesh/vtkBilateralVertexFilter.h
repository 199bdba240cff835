// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkBilateralVertexFilter
 * @brief   bilateral filtering of points along their normals
 *
 * S. Fleishman, I. Drori, D. Cohen-Or, "Bilateral mesh denoising", ACM TOG 22(3), 950-953, 2003.
 * With the heights h_q = n . (q - p) of the points q around p over its tangent plane, in each
 * iteration
 *
 *   p <- p + n sum_q K(|q - p|, s_c) K(h_q, s_s) h_q / sum_q K(|q - p|, s_c) K(h_q, s_s)
 *
 * with Gaussians K(x, s) = exp(-x^2 / (2 s^2)), over the points within 2 s_c that are reached along
 * edges, p among them. The normal n is that of the faces around p, weighted by area. The scales are
 * taken from the surface around each point: s_c from the shortest edge, s_s from the standard
 * deviation of |h_q|.
 *
 * In robust terms: a Gaussian error norm on heights, with a spatial Gaussian.
 *
 * A method of one stage, there for comparison. Points keep their places along the surface. Objects
 * shrink at edges and corners, the more iterations the more; points at a short edge hardly move.
 *
 * Differs from the paper: there the user chooses the scales, by pointing at a place that is flat;
 * these rules are those of a public implementation.
 */

#ifndef vtkBilateralVertexFilter_h
#define vtkBilateralVertexFilter_h

#include "vtkOneStageFilter.h"

class VTKSURFACEDENOISINGMESH_EXPORT vtkBilateralVertexFilter : public vtkOneStageFilter
{
public:
  static vtkBilateralVertexFilter* New();
  vtkTypeMacro(vtkBilateralVertexFilter, vtkOneStageFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Number of iterations. Default 5; 3 to 10. 0: from the data; -1: none.
  vtkSetClampMacro(NumberOfIterations, int, -1, VTK_INT_MAX);
  vtkGetMacro(NumberOfIterations, int);
  ///@}

  ///@{
  /**
   * The spatial scale s_c in lengths of the shortest edge at the point. Default 1; 2 for much
   * noise. At most 10: time grows with the square. 0: from the data.
   */
  vtkSetClampMacro(SpatialScale, double, 0.0, 10.0);
  vtkGetMacro(SpatialScale, double);
  ///@}

  ///@{
  /// The range scale s_s in standard deviations of the heights around the point. Default 1; 2
  /// smooths faster and rounds edges more. 0: from the data.
  vtkSetClampMacro(RangeScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(RangeScale, double);
  ///@}

protected:
  vtkBilateralVertexFilter();
  ~vtkBilateralVertexFilter() override;

  Method Configure() override;

  int NumberOfIterations = 5;
  double SpatialScale = 1.0;
  double RangeScale = 1.0;

private:
  vtkBilateralVertexFilter(const vtkBilateralVertexFilter&) = delete;
  void operator=(const vtkBilateralVertexFilter&) = delete;
};

#endif
