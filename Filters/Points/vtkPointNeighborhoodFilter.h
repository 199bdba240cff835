// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkPointNeighborhoodFilter
 * @brief   base of point filters that look at the neighbours of every point
 *
 * Neighbours are a number of nearest points, or the points in a ball. The point itself is not among
 * them; whether it counts is a matter of the method.
 */

#ifndef vtkPointNeighborhoodFilter_h
#define vtkPointNeighborhoodFilter_h

#include "vtkPointDenoisingFilter.h"

class VTKSURFACEDENOISINGPOINTS_EXPORT vtkPointNeighborhoodFilter : public vtkPointDenoisingFilter
{
public:
  vtkTypeMacro(vtkPointNeighborhoodFilter, vtkPointDenoisingFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What the neighbours of a point are.
  enum Neighborhoods
  {
    NEAREST = 0, ///< a number of nearest points
    BALL = 1     ///< the points in a ball
  };

  ///@{
  /// What the neighbours of a point are, one of Neighborhoods. The default is that of the
  /// method.
  vtkSetClampMacro(Neighborhood, int, NEAREST, BALL);
  vtkGetMacro(Neighborhood, int);
  void SetNeighborhoodToNearest() { this->SetNeighborhood(NEAREST); }
  void SetNeighborhoodToBall() { this->SetNeighborhood(BALL); }
  ///@}

  ///@{
  /// How many nearest points are the neighbours of a point, at least 3. The default is that of
  /// the method; 0: from the data.
  vtkSetClampMacro(NumberOfNeighbors, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfNeighbors, int);
  ///@}

  ///@{
  /// The radius of BALL in mean spacings. A radius r holds about pi r^2 points of a surface. The
  /// default is that of the method; 0: from the data.
  vtkSetClampMacro(Radius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /// Of more points in a ball, so many nearest ones count, at least 3. The default is that of
  /// the method.
  vtkSetClampMacro(MaximumNumberOfNeighbors, int, 3, VTK_INT_MAX);
  vtkGetMacro(MaximumNumberOfNeighbors, int);
  ///@}

  ///@{
  /// Look for neighbours again before every outer iteration but the first. The default is that
  /// of the method.
  vtkSetMacro(RenewNeighborhood, bool);
  vtkGetMacro(RenewNeighborhood, bool);
  vtkBooleanMacro(RenewNeighborhood, bool);
  ///@}

  ///@{
  /// Measure the lengths of the method (not the radius of balls) in the spacing around each
  /// point instead of the mean spacing: for strongly uneven density. Default off.
  vtkSetMacro(LocalScale, bool);
  vtkGetMacro(LocalScale, bool);
  vtkBooleanMacro(LocalScale, bool);
  ///@}

protected:
  explicit vtkPointNeighborhoodFilter(const SurfaceDenoising::PointDenoisingSettings& defaults);
  explicit vtkPointNeighborhoodFilter(SurfaceDenoising::PointMethod method);
  ~vtkPointNeighborhoodFilter() override;

  void Configure(SurfaceDenoising::PointDenoisingSettings& settings) override;
  void TakeSettings(const SurfaceDenoising::PointDenoisingSettings& settings) override;

  int Neighborhood;
  int NumberOfNeighbors;
  double Radius;
  int MaximumNumberOfNeighbors;
  bool RenewNeighborhood;
  bool LocalScale;

private:
  vtkPointNeighborhoodFilter(const vtkPointNeighborhoodFilter&) = delete;
  void operator=(const vtkPointNeighborhoodFilter&) = delete;
};

#endif
