// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkPointFittingFilter
 * @brief   base of filters that fit points to normals by robust weights
 *
 * The second stage of two-stage filters for point sets: points p_i move in steps, with the weights
 *
 *   w_ij = f(|p_i - p_j|) g(x_ij)
 *
 * of a spatial Gaussian f and an error norm with the weight function g, applied to how much the
 * point and its neighbour differ. Weights that gate across edges keep the faces on either side
 * flat. Distances are those before the first step.
 */

#ifndef vtkPointFittingFilter_h
#define vtkPointFittingFilter_h

#include "vtkPointNeighborhoodFilter.h"

namespace SurfaceDenoising
{
enum class NormalArgument : int;
}

class VTKSURFACEDENOISINGPOINTS_EXPORT vtkPointFittingFilter : public vtkPointNeighborhoodFilter
{
public:
  vtkTypeMacro(vtkPointFittingFilter, vtkPointNeighborhoodFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How points move, by steps of t = PositionStep.
  enum PositionSchemes
  {
    OWN_HEIGHT = 0, ///< p_i += t n_i mean_j n_i . e_ij, with e_ij = p_j - p_i and weighted means:
                    ///< shrinks curved surfaces
    NEIGHBOR_HEIGHT = 1, ///< p_i += t n_i mean_j n_j . e_ij: inflates them
    BALANCED_HEIGHT = 2, ///< the mean of both: leaves a sphere alone
    GRADIENT = 3, ///< p_i += t / 3 mean_j (n_i (n_i . e_ij) + n_j (n_j . e_ij)): down the distances
                  ///< from all planes
    QUADRIC_FIT = 4 ///< to the place nearest to the planes of all neighbours
  };

  /// Error norms, see Core/ErrorNorm.h; with their weight for a difference x at the scale s.
  enum Norms
  {
    L2 = 0,
    TRUNCATED_L2 = 1,
    L1 = 2,
    TRUNCATED_L1 = 3,
    HUBER = 4,
    LORENTZIAN = 5,
    GAUSSIAN = 6,
    TUKEY = 7,
    BOX = 8,
    CENTIN = 9
  };

  /// What a norm is applied to.
  enum Arguments
  {
    CHORD = 0,                 ///< distance of the tips of the unit normals, 0 to 2
    ANGLE = 1,                 ///< between the normals, in degrees
    DIRECTIONAL_CURVATURE = 2, ///< angle over distance, degrees per spacing
    NORMAL_GRADIENT = 3,       ///< chord over distance, per spacing
    HEIGHT = 4,                ///< of the neighbour over the plane of the point, in spacings
    BENT_ARC = 5 ///< length and bend of the way to the neighbour (Park et al. 2013), in spacings
  };

  ///@{
  /// Number of steps that move the points, per outer iteration. Default 5. 0: from the data;
  /// -1: none, the points stay.
  vtkSetClampMacro(NumberOfPointIterations, int, -1, VTK_INT_MAX);
  vtkGetMacro(NumberOfPointIterations, int);
  ///@}

  ///@{
  /// How points move, one of PositionSchemes. Default GRADIENT.
  vtkSetClampMacro(PositionScheme, int, OWN_HEIGHT, QUADRIC_FIT);
  vtkGetMacro(PositionScheme, int);
  void SetPositionSchemeToOwnHeight() { this->SetPositionScheme(OWN_HEIGHT); }
  void SetPositionSchemeToNeighborHeight() { this->SetPositionScheme(NEIGHBOR_HEIGHT); }
  void SetPositionSchemeToBalancedHeight() { this->SetPositionScheme(BALANCED_HEIGHT); }
  void SetPositionSchemeToGradient() { this->SetPositionScheme(GRADIENT); }
  void SetPositionSchemeToQuadricFit() { this->SetPositionScheme(QUADRIC_FIT); }
  ///@}

  ///@{
  /// t, the length of a step, in [0, 1]. Default 1.
  vtkSetClampMacro(PositionStep, double, 0.0, 1.0);
  vtkGetMacro(PositionStep, double);
  ///@}

  ///@{
  /// The error norm that gates neighbours, one of Norms. Default GAUSSIAN; L2: none.
  vtkSetClampMacro(PositionNorm, int, L2, CENTIN);
  vtkGetMacro(PositionNorm, int);
  void SetPositionNormToL2() { this->SetPositionNorm(L2); }
  void SetPositionNormToTruncatedL2() { this->SetPositionNorm(TRUNCATED_L2); }
  void SetPositionNormToL1() { this->SetPositionNorm(L1); }
  void SetPositionNormToTruncatedL1() { this->SetPositionNorm(TRUNCATED_L1); }
  void SetPositionNormToHuber() { this->SetPositionNorm(HUBER); }
  void SetPositionNormToLorentzian() { this->SetPositionNorm(LORENTZIAN); }
  void SetPositionNormToGaussian() { this->SetPositionNorm(GAUSSIAN); }
  void SetPositionNormToTukey() { this->SetPositionNorm(TUKEY); }
  void SetPositionNormToBox() { this->SetPositionNorm(BOX); }
  void SetPositionNormToCentin() { this->SetPositionNorm(CENTIN); }
  ///@}

  /// The number of norms, and their names in the order of Norms; null for another number.
  static int GetNumberOfNorms();
  static const char* GetNormName(int norm);

  ///@{
  /// What the norm of the update is applied to, one of Arguments. Default CHORD.
  vtkSetClampMacro(PositionArgument, int, CHORD, BENT_ARC);
  vtkGetMacro(PositionArgument, int);
  void SetPositionArgumentToChord() { this->SetPositionArgument(CHORD); }
  void SetPositionArgumentToAngle() { this->SetPositionArgument(ANGLE); }
  void SetPositionArgumentToDirectionalCurvature()
  {
    this->SetPositionArgument(DIRECTIONAL_CURVATURE);
  }
  void SetPositionArgumentToNormalGradient() { this->SetPositionArgument(NORMAL_GRADIENT); }
  void SetPositionArgumentToHeight() { this->SetPositionArgument(HEIGHT); }
  void SetPositionArgumentToBentArc() { this->SetPositionArgument(BENT_ARC); }
  ///@}

  ///@{
  /// The scale of the norm of the update in units of its argument. Default 0.2. 0: from the data.
  vtkSetClampMacro(PositionRangeScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(PositionRangeScale, double);
  ///@}

  ///@{
  /// Sigma of the spatial Gaussian of the update in spacings. Default 1.5. 0: from the data; -1:
  /// none.
  vtkSetClampMacro(PositionSpatialScale, double, -1.0, VTK_DOUBLE_MAX);
  vtkGetMacro(PositionSpatialScale, double);
  ///@}

  ///@{
  /// Count the point itself, which damps the steps. Default off.
  vtkSetMacro(PositionIncludeOwn, bool);
  vtkGetMacro(PositionIncludeOwn, bool);
  vtkBooleanMacro(PositionIncludeOwn, bool);
  ///@}

  ///@{
  /// For QUADRIC_FIT: directions whose eigenvalue is below this share of the largest are left
  /// alone. Default 0.05.
  vtkSetClampMacro(EigenvalueCut, double, 0.0, 1.0);
  vtkGetMacro(EigenvalueCut, double);
  ///@}

  ///@{
  /// Let neighbours count by the area around them, the square of their spacing, so that dense
  /// parts do not outvote sparse ones. Default off.
  vtkSetMacro(DensityWeights, bool);
  vtkGetMacro(DensityWeights, bool);
  vtkBooleanMacro(DensityWeights, bool);
  ///@}

  ///@{
  /// Treat n and -n as the same normal: for normals whose signs mean nothing. Sheets closer than
  /// the neighbourhood are then taken for one. Default off: normals are oriented.
  vtkSetMacro(UnorientedNormals, bool);
  vtkGetMacro(UnorientedNormals, bool);
  vtkBooleanMacro(UnorientedNormals, bool);
  ///@}

protected:
  explicit vtkPointFittingFilter(const SurfaceDenoising::PointDenoisingSettings& defaults);
  explicit vtkPointFittingFilter(SurfaceDenoising::PointMethod method);
  ~vtkPointFittingFilter() override;

  ///@{
  /// From one of Arguments to that of the core, and back.
  static SurfaceDenoising::NormalArgument CoreArgument(int argument);
  static int FilterArgument(SurfaceDenoising::NormalArgument argument);
  ///@}

  /// What a range scale is multiplied by: radians per degree if the argument is an angle, else 1.
  static double RangeUnit(int argument);

  void Configure(SurfaceDenoising::PointDenoisingSettings& settings) override;
  void TakeSettings(const SurfaceDenoising::PointDenoisingSettings& settings) override;

  int NumberOfPointIterations;
  int PositionScheme;
  double PositionStep;
  int PositionNorm;
  int PositionArgument;
  double PositionRangeScale;
  double PositionSpatialScale;
  bool PositionIncludeOwn;
  double EigenvalueCut;
  bool DensityWeights;
  bool UnorientedNormals;

private:
  vtkPointFittingFilter(const vtkPointFittingFilter&) = delete;
  void operator=(const vtkPointFittingFilter&) = delete;
};

#endif
