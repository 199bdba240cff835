// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkRobustPointNormalFilter
 * @brief   any combination of norm, argument, kernel, guidance and update on point sets
 *
 * The composer for point sets. Normals are filtered with the weights w_ij = f(|p_i - p_j|) g(x_ij)
 * of a spatial Gaussian f and an error norm with the weight function g, applied to an argument
 * x_ij,
 *
 * - AVERAGE: n_i <- normalise( sum_j w_ij n_j );
 * - DIFFUSION: n_i <- normalise( n_i + t / F_i sum_j w_ij (n_j - n_i) ), F_i = sum_j f_ij;
 * - VOTING_TENSOR: n_i <- normalise( 3 n_i + sum_k b_k (e_k . n_i) e_k ), with the eigenvectors e_k
 *   and binary eigenvalues b_k of sum_j w_ij n_j n_j^T;
 * - PLANE_NORMAL: n_i <- the normal of the plane through the weighted points;
 *
 * with or without guidance, and then the points move to fit, see vtkPointFittingFilter. The
 * defaults are a Gaussian of the chord, normals of robust plane fits and gradient steps: better
 * than most published methods on smooth and sharp objects.
 *
 * S. K. Yadav, M. Skrodzki, E. Zimmermann, K. Polthier, "Surface Denoising based on Normal
 * Filtering in a Robust Statistics Framework".
 */

#ifndef vtkRobustPointNormalFilter_h
#define vtkRobustPointNormalFilter_h

#include "vtkPointFittingFilter.h"

class VTKSURFACEDENOISINGPOINTS_EXPORT vtkRobustPointNormalFilter : public vtkPointFittingFilter
{
public:
  static vtkRobustPointNormalFilter* New();
  vtkTypeMacro(vtkRobustPointNormalFilter, vtkPointFittingFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What the norm looks at.
  enum Guidances
  {
    NO_GUIDANCE = 0,   ///< the normals of the point and its neighbour
    PATCH = 1,         ///< the mean normals of their most consistent patches
    VECTOR_MEDIAN = 2, ///< the median around the point, and the normal of the neighbour
    ROLLING = 3        ///< the filtered normals of the iteration before; starts from a plain mean
  };

  /// Which normals are averaged.
  enum DataSources
  {
    PREVIOUS = 0, ///< those of the iteration before
    ORIGINAL = 1  ///< those at the start: the M-estimate itself
  };

  /// What is made of the weights.
  enum Operators
  {
    AVERAGE = 0,
    DIFFUSION = 1,
    VOTING_TENSOR = 2,
    PLANE_NORMAL = 3
  };

  /// Where the range scale comes from.
  enum ScaleSources
  {
    GIVEN = 0,           ///< RangeScale
    DATA_MAD = 1,        ///< 1.4826 median |x - median x| over neighbours
    DATA_RAYLEIGH = 2,   ///< median x / 1.1774
    DATA_HALF_NORMAL = 3 ///< 1.4826 median x
  };

  /// Published methods that are compositions.
  enum Presets
  {
    CUSTOM = 0, ///< the settings of the filter
    BILATERAL_POINT = 1,
    ROLLING_POINT_NORMAL = 2
  };

  ///@{
  /**
   * A published method in place of all settings but those of the normals at the start and of
   * threads, with the numbers of its paper. Default CUSTOM.
   */
  vtkSetClampMacro(Preset, int, CUSTOM, ROLLING_POINT_NORMAL);
  vtkGetMacro(Preset, int);
  ///@}

  /// The number of presets, CUSTOM among them, and their names in the order of Presets; null for
  /// another number.
  static int GetNumberOfPresets();
  static const char* GetPresetName(int preset);

  /**
   * Gives all settings that a preset would take the place of its values, and makes Preset CUSTOM: a
   * published method to vary. Other numbers do nothing.
   */
  void CopyPreset(int preset);

  ///@{
  /// The error norm, one of Norms. Default GAUSSIAN.
  vtkSetClampMacro(Norm, int, L2, CENTIN);
  vtkGetMacro(Norm, int);
  void SetNormToL2() { this->SetNorm(L2); }
  void SetNormToTruncatedL2() { this->SetNorm(TRUNCATED_L2); }
  void SetNormToL1() { this->SetNorm(L1); }
  void SetNormToTruncatedL1() { this->SetNorm(TRUNCATED_L1); }
  void SetNormToHuber() { this->SetNorm(HUBER); }
  void SetNormToLorentzian() { this->SetNorm(LORENTZIAN); }
  void SetNormToGaussian() { this->SetNorm(GAUSSIAN); }
  void SetNormToTukey() { this->SetNorm(TUKEY); }
  void SetNormToBox() { this->SetNorm(BOX); }
  void SetNormToCentin() { this->SetNorm(CENTIN); }
  ///@}

  ///@{
  /// What the norm is applied to, one of Arguments. Default CHORD.
  vtkSetClampMacro(Argument, int, CHORD, BENT_ARC);
  vtkGetMacro(Argument, int);
  void SetArgumentToChord() { this->SetArgument(CHORD); }
  void SetArgumentToAngle() { this->SetArgument(ANGLE); }
  void SetArgumentToDirectionalCurvature() { this->SetArgument(DIRECTIONAL_CURVATURE); }
  void SetArgumentToNormalGradient() { this->SetArgument(NORMAL_GRADIENT); }
  void SetArgumentToHeight() { this->SetArgument(HEIGHT); }
  void SetArgumentToBentArc() { this->SetArgument(BENT_ARC); }
  ///@}

  ///@{
  /**
   * Where the scale comes from, one of ScaleSources. From the differences of neighbouring normals,
   * it is such that those above their robust standard deviation count as outliers: Tukey sqrt(5),
   * Lorentzian and Centin-Signoroni 1 / sqrt(2), others 1 standard deviation. Differences of zero
   * let the points stay, with a warning. Default GIVEN.
   */
  vtkSetClampMacro(ScaleSource, int, GIVEN, DATA_HALF_NORMAL);
  vtkGetMacro(ScaleSource, int);
  void SetScaleSourceToGiven() { this->SetScaleSource(GIVEN); }
  void SetScaleSourceToDataMAD() { this->SetScaleSource(DATA_MAD); }
  void SetScaleSourceToDataRayleigh() { this->SetScaleSource(DATA_RAYLEIGH); }
  void SetScaleSourceToDataHalfNormal() { this->SetScaleSource(DATA_HALF_NORMAL); }
  ///@}

  ///@{
  /// The scale of the norm in units of its argument, if it is GIVEN. Default 0.2; 0: the one with
  /// the smallest expected error.
  vtkSetClampMacro(RangeScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(RangeScale, double);
  ///@}

  ///@{
  /// Sigma of the spatial Gaussian in spacings. Default 1.5. 0: from the data; -1: none.
  vtkSetClampMacro(SpatialScale, double, -1.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SpatialScale, double);
  ///@}

  ///@{
  /// How often normals are filtered, per outer iteration. Default 2; 1 for smooth objects, 10
  /// for sharp ones. 0: from the data; -1: none.
  vtkSetClampMacro(NumberOfNormalIterations, int, -1, VTK_INT_MAX);
  vtkGetMacro(NumberOfNormalIterations, int);
  ///@}

  ///@{
  /// What the norm looks at, one of Guidances. Default NO_GUIDANCE.
  vtkSetClampMacro(Guidance, int, NO_GUIDANCE, ROLLING);
  vtkGetMacro(Guidance, int);
  void SetGuidanceToNoGuidance() { this->SetGuidance(NO_GUIDANCE); }
  void SetGuidanceToPatch() { this->SetGuidance(PATCH); }
  void SetGuidanceToVectorMedian() { this->SetGuidance(VECTOR_MEDIAN); }
  void SetGuidanceToRolling() { this->SetGuidance(ROLLING); }
  ///@}

  ///@{
  /// Neighbours that make a patch, and whose patches may guide, for PATCH: the first of the
  /// neighbourhood. Default 10.
  vtkSetClampMacro(NumberOfPatchNeighbors, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfPatchNeighbors, int);
  ///@}

  ///@{
  /// For PATCH: point i may be guided by the patch of its neighbour j if n_i . n_j is at least
  /// this: the cosine of the angle between them, in [-1, 1]; -1: by any. Default 0.7, 46 degrees.
  vtkSetClampMacro(PatchAgreement, double, -1.0, 1.0);
  vtkGetMacro(PatchAgreement, double);
  ///@}

  ///@{
  /// For PATCH: neighbour a of point j belongs to the patch of j if n_j . n_a is at least this: the
  /// cosine of the angle between them, in [-1, 1]; -1: all do. Patches end at edges that bend more.
  /// Default 0.65, 49 degrees.
  vtkSetClampMacro(MemberAgreement, double, -1.0, 1.0);
  vtkGetMacro(MemberAgreement, double);
  ///@}

  ///@{
  /// Which normals are averaged, one of DataSources. Default PREVIOUS. ROLLING takes those at
  /// the start, always.
  vtkSetClampMacro(DataSource, int, PREVIOUS, ORIGINAL);
  vtkGetMacro(DataSource, int);
  void SetDataSourceToPrevious() { this->SetDataSource(PREVIOUS); }
  void SetDataSourceToOriginal() { this->SetDataSource(ORIGINAL); }
  ///@}

  ///@{
  /// What is made of the weights, one of Operators. Default AVERAGE.
  vtkSetClampMacro(Operator, int, AVERAGE, PLANE_NORMAL);
  vtkGetMacro(Operator, int);
  void SetOperatorToAverage() { this->SetOperator(AVERAGE); }
  void SetOperatorToDiffusion() { this->SetOperator(DIFFUSION); }
  void SetOperatorToVotingTensor() { this->SetOperator(VOTING_TENSOR); }
  void SetOperatorToPlaneNormal() { this->SetOperator(PLANE_NORMAL); }
  ///@}

  ///@{
  /// t of DIFFUSION, in [0, 1]. Default 0.5.
  vtkSetClampMacro(StepLength, double, 0.0, 1.0);
  vtkGetMacro(StepLength, double);
  ///@}

  ///@{
  /// Count the point itself among its neighbours. Default on.
  vtkSetMacro(IncludeOwn, bool);
  vtkGetMacro(IncludeOwn, bool);
  vtkBooleanMacro(IncludeOwn, bool);
  ///@}

protected:
  vtkRobustPointNormalFilter();
  ~vtkRobustPointNormalFilter() override;

  void Configure(SurfaceDenoising::PointDenoisingSettings& settings) override;
  void TakeSettings(const SurfaceDenoising::PointDenoisingSettings& settings) override;

  int Preset = CUSTOM;
  int Norm;
  int Argument;
  int ScaleSource = GIVEN;
  double RangeScale;
  double SpatialScale;
  int NumberOfNormalIterations;
  int Guidance;
  int NumberOfPatchNeighbors;
  double PatchAgreement;
  double MemberAgreement;
  int DataSource;
  int Operator;
  double StepLength;
  bool IncludeOwn;

private:
  vtkRobustPointNormalFilter(const vtkRobustPointNormalFilter&) = delete;
  void operator=(const vtkRobustPointNormalFilter&) = delete;
};

#endif
