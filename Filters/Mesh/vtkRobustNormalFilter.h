// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkRobustNormalFilter
 * @brief   composes a normal filter from error norm, argument, kernel, neighbourhood and operator
 *
 *   w_ij = a_j  f(|c_i - c_j|)  g(x_ij),   for example  n_i <- normalise( sum_{j in N(i)} w_ij n_j
 * )
 *
 * Every part can be chosen: the weight function g of any error norm; what it is applied to, x_ij;
 * the guidance that x_ij looks at; a spatial kernel f; face weights a_j; the neighbourhood N(i),
 * with or without the face itself; the scale of the norm, given or from the data; whether the
 * weights average, diffuse or make one linear system for all normals; which normals are averaged;
 * and how points move. Most published methods are such compositions (see Preset), and most
 * compositions have never been tried.
 *
 * What to expect of the norms (see the survey that vtkFaceNormalFilter cites): norms with a cut-off
 * (truncated L2 and L1, Tukey) leave an edge alone once its angle is beyond their scale; a Gaussian
 * nearly does; Lorentzian and Centin-Signoroni round edges slowly; L1 and Huber round them in the
 * end; L2, the mean, at once. A scale below the noise stalls: count NumberOfUnfilteredFaces.
 */

#ifndef vtkRobustNormalFilter_h
#define vtkRobustNormalFilter_h

#include "vtkFaceNormalFilter.h"

class VTKSURFACEDENOISINGMESH_EXPORT vtkRobustNormalFilter : public vtkFaceNormalFilter
{
public:
  static vtkRobustNormalFilter* New();
  vtkTypeMacro(vtkRobustNormalFilter, vtkFaceNormalFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Error norms with their weight functions; s is the range scale.
  enum Norms
  {
    L2 = 0,           ///< 1
    TRUNCATED_L2 = 1, ///< 1 up to s, then 0
    L1 = 2,           ///< 1 / x, held at 1 / s below s
    TRUNCATED_L1 = 3, ///< 1 / x up to s, then 0; held at 20 below 0.05
    HUBER = 4,        ///< 1 up to s, then s / x
    LORENTZIAN = 5,   ///< 1 / (1 + x^2 / (2 s^2))
    GAUSSIAN = 6,     ///< exp(-x^2 / (2 s^2))
    TUKEY = 7,        ///< (1 - (x / s)^2)^2 up to s, then 0
    BOX = 8,          ///< 1 up to s, then 0.1
    CENTIN = 9        ///< 1 up to s, then s^2 / ((x - s)^2 + s^2)
  };

  /// What the norm is applied to. Curvatures are relative to CurvatureUnit.
  enum Arguments
  {
    CHORD = 0,                 ///< |n_i - n_j|, in [0, 2]
    ANGLE = 1,                 ///< angle between n_i and n_j in degrees
    DIRECTIONAL_CURVATURE = 2, ///< angle per centroid distance, in degrees per unit
    NORMAL_GRADIENT = 3,       ///< |n_i - n_j| per centroid distance, per unit
    FACE_CURVATURE = 4 ///< mean curvature of each face, times unit; a pair has the mean weight of
                       ///< its faces
  };

  /// The length that curvatures are relative to.
  enum CurvatureUnits
  {
    CENTROID_DISTANCE = 0, ///< mean distance of adjacent centroids
    EDGE_LENGTH = 1        ///< mean edge length
  };

  /// What the norm looks at.
  enum Guidances
  {
    NO_GUIDANCE = 0,  ///< the normals themselves
    PATCH = 1,        ///< mean normals of the most consistent patches, see vtkGuidedNormalFilter
    VECTOR_MEDIAN = 2 ///< from the median around the face to the normals around it, see
                      ///< vtkFuzzyVectorMedianNormalFilter
  };

  /// What is made of the weights.
  enum Operators
  {
    AVERAGE = 0,     ///< n_i <- normalise( sum_j w_ij n_j )
    DIFFUSION = 1,   ///< n_i <- normalise( n_i + t sum_j w_ij (n_j - n_i) / sum_j a_j f_ij )
    GLOBAL_SOLVE = 2 ///< all normals at once, see vtkBilateralNormalFilter
  };

  /// The fixed weight a_j of a neighbour.
  enum FaceWeightings
  {
    UNIFORM = 0, ///< 1
    AREA = 1,    ///< its area
    COUPLING = 2 ///< length of the common edge over distance of the centroids; no edge, no weight
  };

  /// Published methods as compositions.
  enum Presets
  {
    CUSTOM = 0,
    NORMAL_DIFFUSION = 1,           ///< Belyaev, Ohtake 2001
    MEAN_NORMAL = 2,                ///< Yagou, Ohtake, Belyaev 2002
    HUBER_NORMAL = 3,               ///< Huber 1981
    FUZZY_VECTOR_MEDIAN = 4,        ///< Shen, Barner 2004
    CURVATURE_NORMAL_DIFFUSION = 5, ///< Tasdizen, Whitaker, Burchard, Osher 2002
    GEOMETRIC_FIDELITY = 6,         ///< Centin, Signoroni 2018
    BILATERAL_NORMAL = 7,           ///< Zheng, Fu, Au, Tai 2011, local
    GLOBAL_BILATERAL_NORMAL = 8,    ///< Zheng, Fu, Au, Tai 2011, global
    GUIDED_NORMAL = 9,              ///< Zhang, Deng, Zhang, Bouaziz, Liu 2015
    TUKEY_BILATERAL_NORMAL = 10,    ///< Yadav, Reitebuch, Polthier 2018
    THRESHOLDED_COSINE = 11 ///< Sun, Rosin, Martin, Langbein 2007: the weight max(0, n_i . n_j -
                            ///< T)^2 is Tukey's with scale sqrt(2 (1 - T)); here T = 0.5
  };

  /// Where the range scale comes from.
  enum ScaleSources
  {
    GIVEN = 0, ///< RangeScale
    DATA_MAD =
      1, ///< 1.4826 median |x - median x| over adjacent faces, the estimate of the literature
    DATA_RAYLEIGH =
      2, ///< median x / 1.1774, unbiased if x is the length of a two-dimensional Gaussian vector
    DATA_HALF_NORMAL = 3 ///< 1.4826 median x
  };

  ///@{
  /**
   * A published method with the numbers of its paper, one of Presets. Unless it is CUSTOM, the
   * default, it takes the place of all settings of this class, of the iterations, of VertexScheme,
   * Relaxation and MaximumDisplacement.
   */
  vtkSetClampMacro(Preset, int, CUSTOM, THRESHOLDED_COSINE);
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
  ///@}

  /// The number of norms, and their names in the order of Norms; null for another number.
  static int GetNumberOfNorms();
  static const char* GetNormName(int norm);

  ///@{
  /// What the norm is applied to, one of Arguments. Default CHORD.
  vtkSetClampMacro(Argument, int, CHORD, FACE_CURVATURE);
  vtkGetMacro(Argument, int);
  void SetArgumentToChord() { this->SetArgument(CHORD); }
  void SetArgumentToAngle() { this->SetArgument(ANGLE); }
  void SetArgumentToDirectionalCurvature() { this->SetArgument(DIRECTIONAL_CURVATURE); }
  void SetArgumentToNormalGradient() { this->SetArgument(NORMAL_GRADIENT); }
  void SetArgumentToFaceCurvature() { this->SetArgument(FACE_CURVATURE); }
  ///@}

  ///@{
  /// What curvatures are relative to, one of CurvatureUnits. Default CENTROID_DISTANCE.
  vtkSetClampMacro(CurvatureUnit, int, CENTROID_DISTANCE, EDGE_LENGTH);
  vtkGetMacro(CurvatureUnit, int);
  void SetCurvatureUnitToCentroidDistance() { this->SetCurvatureUnit(CENTROID_DISTANCE); }
  void SetCurvatureUnitToEdgeLength() { this->SetCurvatureUnit(EDGE_LENGTH); }
  ///@}

  ///@{
  /// What the norm looks at, one of Guidances. Default NO_GUIDANCE.
  vtkSetClampMacro(Guidance, int, NO_GUIDANCE, VECTOR_MEDIAN);
  vtkGetMacro(Guidance, int);
  void SetGuidanceToNoGuidance() { this->SetGuidance(NO_GUIDANCE); }
  void SetGuidanceToPatch() { this->SetGuidance(PATCH); }
  void SetGuidanceToVectorMedian() { this->SetGuidance(VECTOR_MEDIAN); }
  ///@}

  ///@{
  /**
   * What is made of the weights, one of Operators. Default AVERAGE. An average with FACE_CURVATURE
   * and without the face itself is an error: the weight of the face would cancel.
   */
  vtkSetClampMacro(Operator, int, AVERAGE, GLOBAL_SOLVE);
  vtkGetMacro(Operator, int);
  void SetOperatorToAverage() { this->SetOperator(AVERAGE); }
  void SetOperatorToDiffusion() { this->SetOperator(DIFFUSION); }
  void SetOperatorToGlobalSolve() { this->SetOperator(GLOBAL_SOLVE); }
  ///@}

  ///@{
  /// The length t of a step of DIFFUSION, in [0, 1]. Default 0.5.
  vtkSetClampMacro(StepLength, double, 0.0, 1.0);
  vtkGetMacro(StepLength, double);
  ///@}

  ///@{
  /// Only the part of the diffusion across the normal counts. Default off.
  vtkSetMacro(TangentialFlux, bool);
  vtkGetMacro(TangentialFlux, bool);
  vtkBooleanMacro(TangentialFlux, bool);
  ///@}

  ///@{
  /// The weight of the input in GLOBAL_SOLVE, in [1e-9, 1]. Default 0.01: the smaller, the
  /// smoother.
  vtkSetClampMacro(Fidelity, double, 1e-9, 1.0);
  vtkGetMacro(Fidelity, double);
  ///@}

  ///@{
  /// Weigh the energies of GLOBAL_SOLVE with face areas. Default on.
  vtkSetMacro(AreaEnergy, bool);
  vtkGetMacro(AreaEnergy, bool);
  vtkBooleanMacro(AreaEnergy, bool);
  ///@}

  ///@{
  /**
   * Where the scale comes from, one of ScaleSources. From the data, it is such that differences
   * above their robust standard deviation count as outliers: Tukey sqrt(5), Lorentzian and
   * Centin-Signoroni 1 / sqrt(2), others 1 standard deviation. Data without any noise pass through
   * with a warning. Default DATA_MAD.
   */
  vtkSetClampMacro(ScaleSource, int, GIVEN, DATA_HALF_NORMAL);
  vtkGetMacro(ScaleSource, int);
  void SetScaleSourceToGiven() { this->SetScaleSource(GIVEN); }
  void SetScaleSourceToDataMAD() { this->SetScaleSource(DATA_MAD); }
  void SetScaleSourceToDataRayleigh() { this->SetScaleSource(DATA_RAYLEIGH); }
  void SetScaleSourceToDataHalfNormal() { this->SetScaleSource(DATA_HALF_NORMAL); }
  ///@}

  ///@{
  /**
   * The scale of the norm in units of the argument, if it is GIVEN. Default 0.35; 0: the one with
   * the smallest expected error. Must not be negative.
   * For chords, norms with a cut-off want 0.7 to 1.1, a Gaussian 0.35, Lorentzian and
   * Centin-Signoroni 0.2, L1 0.05.
   */
  vtkSetMacro(RangeScale, double);
  vtkGetMacro(RangeScale, double);
  ///@}

  ///@{
  /// Sigma of the spatial Gaussian in mean distances of adjacent centroids. Default 1; 0: from the
  /// data; -1: no spatial kernel.
  vtkSetClampMacro(SpatialScale, double, -1.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SpatialScale, double);
  ///@}

  ///@{
  /// Measure SpatialScale in each face's own mean distance to its adjacent ones. Default off.
  vtkSetMacro(LocalSpatialScale, bool);
  vtkGetMacro(LocalSpatialScale, bool);
  vtkBooleanMacro(LocalSpatialScale, bool);
  ///@}

  ///@{
  /// The fixed weights of neighbours, one of FaceWeightings. Default AREA.
  vtkSetClampMacro(FaceWeighting, int, UNIFORM, COUPLING);
  vtkGetMacro(FaceWeighting, int);
  void SetFaceWeightingToUniform() { this->SetFaceWeighting(UNIFORM); }
  void SetFaceWeightingToArea() { this->SetFaceWeighting(AREA); }
  void SetFaceWeightingToCoupling() { this->SetFaceWeighting(COUPLING); }
  ///@}

  ///@{
  /// Count the face itself among its neighbours. Default on.
  vtkSetMacro(IncludeOwn, bool);
  vtkGetMacro(IncludeOwn, bool);
  vtkBooleanMacro(IncludeOwn, bool);
  ///@}

  ///@{
  /// The neighbourhood, one of Neighborhoods. Default VERTEX_SHARING.
  vtkSetClampMacro(Neighborhood, int, EDGE_ADJACENT, EDGE_RADIUS);
  vtkGetMacro(Neighborhood, int);
  void SetNeighborhoodToEdgeAdjacent() { this->SetNeighborhood(EDGE_ADJACENT); }
  void SetNeighborhoodToVertexSharing() { this->SetNeighborhood(VERTEX_SHARING); }
  void SetNeighborhoodToRadius() { this->SetNeighborhood(RADIUS); }
  void SetNeighborhoodToEdgeRadius() { this->SetNeighborhood(EDGE_RADIUS); }
  ///@}

  ///@{
  /// The radius of RADIUS and EDGE_RADIUS in mean distances of adjacent centroids. Default 2: about
  /// 12 faces; 0: from the data, at most 6. Where there are more than 400, those count that are the
  /// fewest faces away.
  vtkSetClampMacro(Radius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /// Look for the neighbours within the radius again in every outer iteration. Default on.
  vtkSetMacro(RenewNeighborhood, bool);
  vtkGetMacro(RenewNeighborhood, bool);
  vtkBooleanMacro(RenewNeighborhood, bool);
  ///@}

  ///@{
  /// Which normals are averaged, one of DataSources. Default PREVIOUS.
  vtkSetClampMacro(DataSource, int, PREVIOUS, ORIGINAL);
  vtkGetMacro(DataSource, int);
  void SetDataSourceToPrevious() { this->SetDataSource(PREVIOUS); }
  void SetDataSourceToOriginal() { this->SetDataSource(ORIGINAL); }
  ///@}

protected:
  vtkRobustNormalFilter();
  ~vtkRobustNormalFilter() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void Configure(SurfaceDenoising::MeshDenoisingSettings& settings) override;
  double RangeUnit() const override;

  int Preset = CUSTOM;
  int Norm = GAUSSIAN;
  int Argument = CHORD;
  int CurvatureUnit = CENTROID_DISTANCE;
  int Guidance = NO_GUIDANCE;
  int ScaleSource = DATA_MAD;
  double RangeScale = 0.35;
  double SpatialScale = 1.0;
  bool LocalSpatialScale = false;
  int FaceWeighting = AREA;
  bool IncludeOwn = true;
  int Neighborhood = VERTEX_SHARING;
  double Radius = 2.0;
  bool RenewNeighborhood = true;
  int DataSource = PREVIOUS;
  int Operator = AVERAGE;
  double StepLength = 0.5;
  bool TangentialFlux = false;
  double Fidelity = 0.01;
  bool AreaEnergy = true;

private:
  vtkRobustNormalFilter(const vtkRobustNormalFilter&) = delete;
  void operator=(const vtkRobustNormalFilter&) = delete;
};

#endif
