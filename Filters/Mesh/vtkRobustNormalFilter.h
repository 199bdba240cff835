// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkRobustNormalFilter
 * @brief   composes a normal filter from error norm, argument, spatial kernel and neighbourhood
 *
 *   n_i <- normalise( sum_{j in N(i)}  a_j  f(|c_i - c_j|)  g(x_ij)  n_j )
 *
 * Every part can be chosen: the weight function g of any error norm; what it is applied to, x_ij; a
 * spatial kernel f; face areas a_j; the neighbourhood N(i), with or without the face itself; the
 * scale of the norm, given or from the data; and the schedule. Most published methods are such
 * compositions, and most compositions have never been tried.
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

  /// What the norm is applied to.
  enum Arguments
  {
    CHORD = 0, ///< |n_i - n_j|, in [0, 2]
    ANGLE = 1, ///< angle between n_i and n_j in degrees
    DIRECTIONAL_CURVATURE =
      2 ///< angle per centroid distance, in degrees per mean distance of adjacent centroids
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

  /// Which normals are averaged when normal iterations follow one another.
  enum DataSources
  {
    PREVIOUS = 0, ///< those of the iteration before, as published filters do
    ORIGINAL =
      1 ///< those the iterations started from; only the centre moves: the M-estimate itself
  };

  /// Order of the stages.
  enum Schedules
  {
    NORMALS_FIRST = 0, ///< all normal iterations, then all vertex iterations
    ALTERNATING =
      1 ///< both, with their counts, in every outer iteration; geometry is renewed in between
  };

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
  vtkSetClampMacro(Argument, int, CHORD, DIRECTIONAL_CURVATURE);
  vtkGetMacro(Argument, int);
  void SetArgumentToChord() { this->SetArgument(CHORD); }
  void SetArgumentToAngle() { this->SetArgument(ANGLE); }
  void SetArgumentToDirectionalCurvature() { this->SetArgument(DIRECTIONAL_CURVATURE); }
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
   * The scale of the norm in units of the argument, if it is GIVEN; must be positive. Default 0.35.
   * For chords, norms with a cut-off want 0.7 to 1.1, a Gaussian 0.35, Lorentzian and
   * Centin-Signoroni 0.2, L1 0.05.
   */
  vtkSetMacro(RangeScale, double);
  vtkGetMacro(RangeScale, double);
  ///@}

  ///@{
  /// Sigma of the spatial Gaussian in mean distances of adjacent centroids; 0: no spatial kernel.
  /// Default 1.
  vtkSetClampMacro(SpatialScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SpatialScale, double);
  ///@}

  ///@{
  /// Weigh neighbours by their area. Default on.
  vtkSetMacro(AreaWeighting, bool);
  vtkGetMacro(AreaWeighting, bool);
  vtkBooleanMacro(AreaWeighting, bool);
  ///@}

  ///@{
  /// Count the face itself among its neighbours. Default on.
  vtkSetMacro(IncludeOwn, bool);
  vtkGetMacro(IncludeOwn, bool);
  vtkBooleanMacro(IncludeOwn, bool);
  ///@}

  ///@{
  /// The neighbourhood, one of Neighborhoods. Default VERTEX_SHARING.
  vtkSetClampMacro(Neighborhood, int, EDGE_ADJACENT, RADIUS);
  vtkGetMacro(Neighborhood, int);
  void SetNeighborhoodToEdgeAdjacent() { this->SetNeighborhood(EDGE_ADJACENT); }
  void SetNeighborhoodToVertexSharing() { this->SetNeighborhood(VERTEX_SHARING); }
  void SetNeighborhoodToRadius() { this->SetNeighborhood(RADIUS); }
  ///@}

  ///@{
  /// The radius of the neighbourhood RADIUS in mean distances of adjacent centroids. Default 2:
  /// about 12 faces.
  vtkSetClampMacro(Radius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /// Which normals are averaged, one of DataSources. Default PREVIOUS.
  vtkSetClampMacro(DataSource, int, PREVIOUS, ORIGINAL);
  vtkGetMacro(DataSource, int);
  void SetDataSourceToPrevious() { this->SetDataSource(PREVIOUS); }
  void SetDataSourceToOriginal() { this->SetDataSource(ORIGINAL); }
  ///@}

  ///@{
  /// The schedule, one of Schedules. Default NORMALS_FIRST.
  vtkSetClampMacro(Schedule, int, NORMALS_FIRST, ALTERNATING);
  vtkGetMacro(Schedule, int);
  void SetScheduleToNormalsFirst() { this->SetSchedule(NORMALS_FIRST); }
  void SetScheduleToAlternating() { this->SetSchedule(ALTERNATING); }
  ///@}

  ///@{
  /// Number of outer iterations of the schedule ALTERNATING. Default 10; each has its own normal
  /// and vertex iterations.
  vtkSetClampMacro(NumberOfOuterIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfOuterIterations, int);
  ///@}

protected:
  vtkRobustNormalFilter();
  ~vtkRobustNormalFilter() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void Configure(SurfaceDenoising::MeshDenoisingSettings& settings) override;
  void TakeReport(const SurfaceDenoising::MeshDenoisingReport& report) override;

  int Norm = GAUSSIAN;
  int Argument = CHORD;
  int ScaleSource = DATA_MAD;
  double RangeScale = 0.35;
  double SpatialScale = 1.0;
  bool AreaWeighting = true;
  bool IncludeOwn = true;
  int Neighborhood = VERTEX_SHARING;
  double Radius = 2.0;
  int DataSource = PREVIOUS;
  int Schedule = NORMALS_FIRST;
  int NumberOfOuterIterations = 10;

private:
  vtkRobustNormalFilter(const vtkRobustNormalFilter&) = delete;
  void operator=(const vtkRobustNormalFilter&) = delete;

  /// Radians per degree if the argument is an angle, else 1.
  double ArgumentUnit() const;
};

#endif
