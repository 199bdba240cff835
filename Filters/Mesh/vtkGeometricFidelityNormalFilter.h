// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkGeometricFidelityNormalFilter
 * @brief   diffusion of normals by curvature, true to the input
 *
 * M. Centin, A. Signoroni, "Mesh denoising with (geo)metric fidelity", IEEE TVCG 24(8), 2380-2396,
 * 2018. Normals diffuse where the surface is hardly curved,
 *
 *   n_i <- normalise( n_i + t sum_j A_j (g(x_i) + g(x_j)) / 2 (n_j - n_i) / sum_j A_j ),
 *
 * over the faces that share a point, with g(x) = 1 up to s and s^2 / ((x - s)^2 + s^2) beyond; x is
 * the mean curvature of a face (the mean over its points) times the mean edge length. Then the
 * points move, but none further than MaximumDisplacement from where it was (1 mean edge length by
 * default), and a part of the way back if FidelityWeight says so.
 *
 * CurvatureType EDGE takes the directional curvature between the two faces instead of that of the
 * faces. It tells noise from edges much better and is the choice where keeping features matters
 * most.
 *
 * Reconstructed: of this method only g and x are known from the survey. A weight that belongs to a
 * face cancels in a weighted mean, hence the diffusion; fidelity is taken from the title.
 */

#ifndef vtkGeometricFidelityNormalFilter_h
#define vtkGeometricFidelityNormalFilter_h

#include "vtkFaceNormalFilter.h"

class VTKSURFACEDENOISINGMESH_EXPORT vtkGeometricFidelityNormalFilter : public vtkFaceNormalFilter
{
public:
  static vtkGeometricFidelityNormalFilter* New();
  vtkTypeMacro(vtkGeometricFidelityNormalFilter, vtkFaceNormalFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Whose curvature decides how much diffuses between two faces.
  enum CurvatureTypes
  {
    FACE = 0, ///< that of the two faces
    EDGE = 1  ///< that from one face to the other
  };

  ///@{
  /**
   * The scale s: curvature times mean edge length. Default 0.1, for FACE 0.05 to 0.15, for EDGE 0.1
   * to 0.3. 0: from the data.
   */
  vtkSetClampMacro(RangeScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(RangeScale, double);
  ///@}

  ///@{
  /// Whose curvature counts, one of CurvatureTypes. Default FACE.
  vtkSetClampMacro(CurvatureType, int, FACE, EDGE);
  vtkGetMacro(CurvatureType, int);
  void SetCurvatureTypeToFace() { this->SetCurvatureType(FACE); }
  void SetCurvatureTypeToEdge() { this->SetCurvatureType(EDGE); }
  ///@}

  ///@{
  /// The length t of a diffusion step, in [0, 1]. Default 0.5.
  vtkSetClampMacro(StepLength, double, 0.0, 1.0);
  vtkGetMacro(StepLength, double);
  ///@}

  ///@{
  /**
   * How much of the way along the normal from its input position a point goes back after each outer
   * iteration, in [0, 1]. Default 0; up to 0.1 is sensible.
   */
  vtkSetClampMacro(FidelityWeight, double, 0.0, 1.0);
  vtkGetMacro(FidelityWeight, double);
  ///@}

protected:
  vtkGeometricFidelityNormalFilter();
  ~vtkGeometricFidelityNormalFilter() override;

  void Configure(SurfaceDenoising::MeshDenoisingSettings& settings) override;

  double RangeScale;
  int CurvatureType = FACE;
  double StepLength;
  double FidelityWeight = 0.0;

private:
  vtkGeometricFidelityNormalFilter(const vtkGeometricFidelityNormalFilter&) = delete;
  void operator=(const vtkGeometricFidelityNormalFilter&) = delete;
};

#endif
