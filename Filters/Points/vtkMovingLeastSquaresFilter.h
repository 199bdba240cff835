// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkMovingLeastSquaresFilter
 * @brief   projects points onto a smooth surface fitted to their neighbours
 *
 * M. Alexa, J. Behr, D. Cohen-Or, S. Fleishman, D. Levin, C. Silva, "Computing and Rendering Point
 * Set Surfaces", IEEE TVCG 9(1), 2003. A plane is fitted to the neighbours, weighted by exp(-d^2 /
 * h^2), where the point falls onto it, until it stays; over the plane a polynomial is fitted with
 * the same weights, and the point goes to its height.
 *
 * The baseline that robust methods are compared with: good on smooth surfaces, rounds edges. Needs
 * no normals; those of the result are the normals of the fit, on the side of those at the start.
 */

#ifndef vtkMovingLeastSquaresFilter_h
#define vtkMovingLeastSquaresFilter_h

#include "vtkPointNeighborhoodFilter.h"

class VTKSURFACEDENOISINGPOINTS_EXPORT vtkMovingLeastSquaresFilter
  : public vtkPointNeighborhoodFilter
{
public:
  static vtkMovingLeastSquaresFilter* New();
  vtkTypeMacro(vtkMovingLeastSquaresFilter, vtkPointNeighborhoodFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Degree of the polynomial, 0 (the plane alone) to 2. Points with too few neighbours get a
  /// lower one. Default 2.
  vtkSetClampMacro(Degree, int, 0, 2);
  vtkGetMacro(Degree, int);
  ///@}

  ///@{
  /// h of the weights exp(-d^2 / h^2), in spacings. 0, the default: half the distance of the
  /// last neighbour.
  vtkSetClampMacro(Bandwidth, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Bandwidth, double);
  ///@}

  ///@{
  /// How often the reference plane is fitted, at most. Default 1.
  vtkSetClampMacro(NumberOfPlaneFits, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfPlaneFits, int);
  ///@}

protected:
  vtkMovingLeastSquaresFilter();
  ~vtkMovingLeastSquaresFilter() override;

  void Configure(SurfaceDenoising::PointDenoisingSettings& settings) override;

  int Degree;
  double Bandwidth;
  int NumberOfPlaneFits;

private:
  vtkMovingLeastSquaresFilter(const vtkMovingLeastSquaresFilter&) = delete;
  void operator=(const vtkMovingLeastSquaresFilter&) = delete;
};

#endif
