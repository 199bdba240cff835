// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkVotingTensorPointFilter
 * @brief   voting tensors, feature classes and restricted quadric update
 *
 * S. K. Yadav, U. Reitebuch, M. Skrodzki, E. Zimmermann, K. Polthier, "Constraint-based point set
 * denoising using normal voting tensor and restricted quadratic error metrics", Computers and
 * Graphics 74, 2018. An iteration turns the normal of every point towards the main directions of
 * the tensor of the normals around it that are within AngleThreshold, sorts points into faces,
 * edges and corners by how those neighbours are spread out, and moves them: those of faces by a
 * small step along the normal, those of edges and corners to where the planes of their neighbours
 * meet. "FeatureClass" tells what a point was taken for.
 *
 * On models with curved faces the published update throws points near edges away: planes of other
 * faces in the neighbourhood draw as much as those that meet at the edge, and the planes around a
 * curved edge all pass on its convex side, where points creep with every iteration. PlaneScale, on
 * by default, lets only planes count that pass near the point; 0 is what the paper has. Its other
 * numbers are balls of 7.5 spacings, 50 iterations with steps of 0.1, own heights, an angle of
 * 25.84 degrees and a limit of 3 spacings; those make facets of curved surfaces. The defaults are
 * balls of 3, 8 iterations with steps of 0.3, 36.87 degrees and a limit of 1.5: on the points of
 * Fandisk with noise of 0.3, the mean distance is 0.99e-3 of the diagonal, on those of Nicola with
 * 0.2 it is 0.51e-3.
 *
 * With AsReleased the filter computes exactly what the authors' program does, slips included:
 * points move one after the other, the result depends on their order and on the size of the model.
 * All settings that have no counterpart there are ignored; NumberOfOuterIterations, AngleThreshold,
 * EigenvalueThreshold, Damping and Step count, and MaximumDisplacement does in units of the mean
 * distance of the 12 nearest points (0: 2 of them, as the program). The numbers of the program,
 * which are not the defaults here, are 50 iterations, an AngleThreshold of acos(0.9), that
 * is 25.841932763 degrees, an EigenvalueThreshold of 0.25, Damping 3, Step 0.1 and
 * MaximumDisplacement 0. Points that are not finite are left out. KEPT in "Status" are those that
 * no iteration moved.
 */

#ifndef vtkVotingTensorPointFilter_h
#define vtkVotingTensorPointFilter_h

#include "vtkPointNeighborhoodFilter.h"

class VTKSURFACEDENOISINGPOINTS_EXPORT vtkVotingTensorPointFilter
  : public vtkPointNeighborhoodFilter
{
public:
  static vtkVotingTensorPointFilter* New();
  vtkTypeMacro(vtkVotingTensorPointFilter, vtkPointNeighborhoodFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Which heights points of faces move by.
  enum HeightModes
  {
    OWN_HEIGHT =
      0, ///< distances of the neighbours from the plane of the point: pulls curved surfaces inwards
    BALANCED_HEIGHT = 1 ///< the mean of both: leaves a sphere alone
  };

  ///@{
  /// Normals within this angle are similar, in degrees. Default 36.87 (a cosine of 0.8). 0: from
  /// the data.
  vtkSetClampMacro(AngleThreshold, double, 0.0, 180.0);
  vtkGetMacro(AngleThreshold, double);
  ///@}

  ///@{
  /// tau: eigenvalues above this count, of the tensor over their sum, of the spread over their
  /// length; in [0, 1]. Default 0.25.
  vtkSetClampMacro(EigenvalueThreshold, double, 0.0, 1.0);
  vtkGetMacro(EigenvalueThreshold, double);
  ///@}

  ///@{
  /// How much of the old normal stays in an iteration. Default 3: a quarter step.
  vtkSetClampMacro(Damping, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Damping, double);
  ///@}

  ///@{
  /// Length of the steps of points, in (0, 1]. Default 0.3.
  vtkSetClampMacro(Step, double, 0.001, 1.0);
  vtkGetMacro(Step, double);
  ///@}

  ///@{
  /// The guard: planes count at edges and corners by exp(-(h / PlaneScale)^2) of their distance
  /// h from the point, in spacings. 0: all alike, as in the paper. Default 0.7.
  vtkSetClampMacro(PlaneScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(PlaneScale, double);
  ///@}

  ///@{
  /// Which heights points of faces move by, one of HeightModes. Default BALANCED_HEIGHT.
  vtkSetClampMacro(HeightMode, int, OWN_HEIGHT, BALANCED_HEIGHT);
  vtkGetMacro(HeightMode, int);
  void SetHeightModeToOwnHeight() { this->SetHeightMode(OWN_HEIGHT); }
  void SetHeightModeToBalancedHeight() { this->SetHeightMode(BALANCED_HEIGHT); }
  ///@}

  ///@{
  /// sigma of exp(-(|n_i - n_j| / sigma)^2) in the steps of points of faces, a chord. Default
  /// 0.35. 0: from the data.
  vtkSetClampMacro(NormalScale, double, 0.0, 2.0);
  vtkGetMacro(NormalScale, double);
  ///@}

  ///@{
  /// sigma of exp(-(d / sigma)^2) in the steps of points, in spacings. Default 1.5. 0: from the
  /// data.
  vtkSetClampMacro(SpatialScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SpatialScale, double);
  ///@}

  ///@{
  /// Directions that the planes at an edge or corner hardly determine, with an eigenvalue below
  /// this share of the largest, are left alone. Default 0.05.
  vtkSetClampMacro(EigenvalueCut, double, 0.0, 1.0);
  vtkGetMacro(EigenvalueCut, double);
  ///@}

  ///@{
  /// Treat n and -n as the same normal: for normals whose signs mean nothing. Sheets closer than
  /// the neighbourhood are then taken for one. Default off: normals are oriented.
  vtkSetMacro(UnorientedNormals, bool);
  vtkGetMacro(UnorientedNormals, bool);
  vtkBooleanMacro(UnorientedNormals, bool);
  ///@}

  ///@{
  /// Compute what the authors' program does, to reproduce published results. Default off.
  vtkSetMacro(AsReleased, bool);
  vtkGetMacro(AsReleased, bool);
  vtkBooleanMacro(AsReleased, bool);
  ///@}

protected:
  vtkVotingTensorPointFilter();
  ~vtkVotingTensorPointFilter() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void Configure(SurfaceDenoising::PointDenoisingSettings& settings) override;
  bool TellsClasses() const override { return true; }
  bool Denoise(SurfaceDenoising::PointView& view,
    const SurfaceDenoising::PointDenoisingSettings& settings,
    SurfaceDenoising::PointDenoisingReport& report,
    SurfaceDenoising::Execution& execution) override;

  double AngleThreshold;
  double EigenvalueThreshold;
  double Damping;
  double Step;
  double PlaneScale;
  int HeightMode;
  double NormalScale;
  double SpatialScale;
  double EigenvalueCut;
  bool UnorientedNormals;
  bool AsReleased = false;

private:
  vtkVotingTensorPointFilter(const vtkVotingTensorPointFilter&) = delete;
  void operator=(const vtkVotingTensorPointFilter&) = delete;
};

#endif
