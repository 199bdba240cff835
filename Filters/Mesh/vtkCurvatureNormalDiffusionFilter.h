// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkCurvatureNormalDiffusionFilter
 * @brief   anisotropic diffusion of the normal map
 *
 * T. Tasdizen, R. Whitaker, P. Burchard, S. Osher, "Geometric surface smoothing via anisotropic
 * diffusion of normals", IEEE Visualization 2002, 125-132, and "Geometric surface processing via
 * normal maps", ACM TOG 22(4), 2003. Two flows of second order take turns. First, on the frozen
 * surface, the normals diffuse,
 *
 *   n_i <- normalise( n_i + t P_i sum_j c_ij exp(-(|n_j - n_i| / (d_ij m))^2) (n_j - n_i) / sum_j
 * c_ij ),
 *
 * where P_i leaves what is across n_i, c_ij is the length of the common edge over the distance d_ij
 * of the centroids, and m the largest gradient of normals that is noise. Then the points descend
 * sum_f A_f |n_f - m_f|^2. Wide support out of many small steps; keeps edges well.
 *
 * In robust terms: a Gaussian error norm on the gradient of the normals.
 *
 * Reconstructed: the paper works on level sets; this is the same flow in finite volumes on faces,
 * with the step normalised for every face.
 */

#ifndef vtkCurvatureNormalDiffusionFilter_h
#define vtkCurvatureNormalDiffusionFilter_h

#include "vtkFaceNormalFilter.h"

class VTKSURFACEDENOISINGMESH_EXPORT vtkCurvatureNormalDiffusionFilter : public vtkFaceNormalFilter
{
public:
  static vtkCurvatureNormalDiffusionFilter* New();
  vtkTypeMacro(vtkCurvatureNormalDiffusionFilter, vtkFaceNormalFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The gradient m: a chord length of unit normals per mean distance of adjacent centroids. Default
   * 0.5; from 0.3 to 0.8. Too small, it stalls. 0: from the data.
   */
  vtkSetClampMacro(RangeScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(RangeScale, double);
  ///@}

  ///@{
  /// The length t of a diffusion step, in [0, 1]. Default 0.5.
  vtkSetClampMacro(StepLength, double, 0.0, 1.0);
  vtkGetMacro(StepLength, double);
  ///@}

protected:
  vtkCurvatureNormalDiffusionFilter();
  ~vtkCurvatureNormalDiffusionFilter() override;

  void Configure(SurfaceDenoising::MeshDenoisingSettings& settings) override;
  double RangeUnit() const override;

  double RangeScale;
  double StepLength;

private:
  vtkCurvatureNormalDiffusionFilter(const vtkCurvatureNormalDiffusionFilter&) = delete;
  void operator=(const vtkCurvatureNormalDiffusionFilter&) = delete;
};

#endif
