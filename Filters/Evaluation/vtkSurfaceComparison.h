// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceComparison
 * @brief Measures how far a surface is from the ground truth.
 *
 * Input port 0 takes the result to be judged, port 1 the reference. Output port 0 is the result
 * with
 * - the cell array "NormalAngleError", in degrees: angle between the normals of corresponding
 * faces; NaN for cells that are no faces and for faces without area;
 * - the point array "Distance": distance of each point to the reference surface.
 *
 * Output port 1 is a vtkTable of one row with a column for each quantity below. The same values are
 * in the field data of output port 0, one array per quantity, and can be read with the Get methods.
 * What is not defined for the given inputs is NaN.
 *
 * @par Faces
 * Polygons and strips are cut into triangles, and it is these triangles that are called faces
 * below. A cell of several faces shows the area-weighted mean of their errors. Faces without area
 * have no normal and are left out wherever normals or areas are needed.
 *
 * @par Corresponding faces
 * If both inputs have equally many points and the same polygons and strips, faces correspond by
 * number and both inputs are triangulated alike. Otherwise, a face of the result corresponds to the
 * face of the reference nearest to its centroid. SameConnectivity tells which of the two was done.
 *
 * @par Distances
 * are exact distances to the faces of the other surface, not to its points. Lengths are in the
 * units of the coordinates; those called relative are divided by ReferenceDiagonal.
 *
 * @par Point sets
 * A result without polygons is measured by the distances of its points; what needs faces is NaN. If
 * there are polygons, only the points that they use count (but "Distance" is there for all).
 *
 * @par What is refused
 * A missing or empty input, a reference without a face of positive area, and a face with a point
 * that does not exist or is not finite raise an error. Points outside faces that are not finite
 * have no distance (NaN) and do not count.
 *
 * @warning
 * The surface distance is taken to the whole other surface: on thin walls a point may be measured
 * against the wrong side, and the nearest face may be on the wrong side likewise.
 *
 * @par References
 * X. Sun, P. L. Rosin, R. R. Martin, F. C. Langbein: Fast and effective feature-preserving mesh
 * denoising, IEEE TVCG 13(5), 2007 (PositionError).
 *
 * @sa
 * vtkSurfaceNoise vtkHausdorffDistancePointSetFilter
 */

#ifndef vtkSurfaceComparison_h
#define vtkSurfaceComparison_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkSurfaceDenoisingEvaluationModule.h" // For export macro

class vtkTable;

class VTKSURFACEDENOISINGEVALUATION_EXPORT vtkSurfaceComparison : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceComparison* New();
  vtkTypeMacro(vtkSurfaceComparison, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The ground truth, on input port 1.
  void SetReferenceConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetReferenceData(vtkPolyData* data) { this->SetInputData(1, data); }

  /// The one-row table of output port 1.
  vtkTable* GetTable();

  ///@{
  /**
   * An edge is a feature if the normals of its faces are more than this many degrees apart (0 =
   * flat, as in vtkFeatureEdges), from 0 to 180. Default: 70.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * How many rings of faces around the feature edges of the reference are near features, at least
   * 1. The first ring are the faces that share a point with a feature edge, each further ring the
   * faces that share a point with one of the ring before. Default: 2.
   */
  vtkSetClampMacro(FeatureRings, int, 1, VTK_INT_MAX);
  vtkGetMacro(FeatureRings, int);
  ///@}

  ///@{
  /**
   * 1 if faces correspond by number, 0 if by nearest face. UncomparedFaces is the number of faces
   * without area, in the result or in the reference, whose normals could not be compared.
   */
  vtkGetMacro(SameConnectivity, double);
  vtkGetMacro(UncomparedFaces, double);
  ///@}

  ///@{
  /**
   * Angles between corresponding normals in degrees, over all faces that could be compared: plain
   * mean (called theta or MSAE in the literature), root mean square, median, 95th percentile
   * (linear interpolation between order statistics), maximum, and mean weighted by the areas of the
   * result.
   */
  vtkGetMacro(MeanNormalAngle, double);
  vtkGetMacro(RMSNormalAngle, double);
  vtkGetMacro(MedianNormalAngle, double);
  vtkGetMacro(Percentile95NormalAngle, double);
  vtkGetMacro(MaximumNormalAngle, double);
  vtkGetMacro(AreaWeightedNormalAngle, double);
  ///@}

  ///@{
  /// Number of faces that are turned over: more than 90 degrees from the corresponding face.
  vtkGetMacro(FlippedFaces, double);
  ///@}

  ///@{
  /**
   * E_v = sqrt(sum_v sum_{f at v} A_f d_v^2 / (3 sum_f A_f)) with the distances d_v of the vertices
   * of the result to the reference surface and the areas A_f of the result. The literature states
   * RelativePositionError.
   */
  vtkGetMacro(PositionError, double);
  vtkGetMacro(RelativePositionError, double);
  ///@}

  ///@{
  /// Plain mean of the distances of the vertices to the reference surface.
  vtkGetMacro(MeanDistance, double);
  vtkGetMacro(RelativeMeanDistance, double);
  ///@}

  ///@{
  /**
   * Largest distance from the result to the reference, from the reference to the result, and the
   * larger of the two. Surfaces are sampled at their vertices and at the centroids of their faces.
   */
  vtkGetMacro(HausdorffToReference, double);
  vtkGetMacro(HausdorffFromReference, double);
  vtkGetMacro(HausdorffDistance, double);
  vtkGetMacro(RelativeHausdorffDistance, double);
  ///@}

  ///@{
  /// Diagonal of the bounding box of the faces of the reference.
  vtkGetMacro(ReferenceDiagonal, double);
  ///@}

  ///@{
  /**
   * Enclosed volumes, positive if normals point outwards, and (Volume - ReferenceVolume) /
   * ReferenceVolume. A volume is defined only for a mesh without boundary and non-manifold edges
   * whose faces agree on what is outside; faces must share points.
   */
  vtkGetMacro(Volume, double);
  vtkGetMacro(ReferenceVolume, double);
  vtkGetMacro(RelativeVolumeChange, double);
  ///@}

  ///@{
  /**
   * Feature edges of the reference, how many of them are (found) and are not (missed) feature edges
   * of the result, and feature edges of the result that are none in the reference (invented).
   * Defined for the same connectivity only.
   */
  vtkGetMacro(ReferenceFeatureEdges, double);
  vtkGetMacro(FoundFeatureEdges, double);
  vtkGetMacro(MissedFeatureEdges, double);
  vtkGetMacro(InventedFeatureEdges, double);
  ///@}

  ///@{
  /**
   * Number of faces within FeatureRings of the feature edges of the reference, mean angle between
   * corresponding normals over these faces, and mean over all others, in degrees. A mean over no
   * faces is NaN. Points at the same place are different points. Defined for the same connectivity
   * only.
   */
  vtkGetMacro(FeatureFaces, double);
  vtkGetMacro(FeatureNormalAngle, double);
  vtkGetMacro(SmoothNormalAngle, double);
  ///@}

  ///@{
  /**
   * Mean of circumradius / shortest edge over the faces: 0.577 for equilateral triangles, 0.707 for
   * right isosceles ones, larger for worse ones.
   */
  vtkGetMacro(TriangleQuality, double);
  vtkGetMacro(ReferenceTriangleQuality, double);
  ///@}

protected:
  vtkSurfaceComparison();
  ~vtkSurfaceComparison() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double FeatureAngle = 70.0;
  int FeatureRings = 2;

  double SameConnectivity;
  double UncomparedFaces;
  double MeanNormalAngle;
  double RMSNormalAngle;
  double MedianNormalAngle;
  double Percentile95NormalAngle;
  double MaximumNormalAngle;
  double AreaWeightedNormalAngle;
  double FlippedFaces;
  double PositionError;
  double RelativePositionError;
  double MeanDistance;
  double RelativeMeanDistance;
  double HausdorffToReference;
  double HausdorffFromReference;
  double HausdorffDistance;
  double RelativeHausdorffDistance;
  double ReferenceDiagonal;
  double Volume;
  double ReferenceVolume;
  double RelativeVolumeChange;
  double ReferenceFeatureEdges;
  double FoundFeatureEdges;
  double MissedFeatureEdges;
  double InventedFeatureEdges;
  double FeatureFaces;
  double FeatureNormalAngle;
  double SmoothNormalAngle;
  double TriangleQuality;
  double ReferenceTriangleQuality;

private:
  vtkSurfaceComparison(const vtkSurfaceComparison&) = delete;
  void operator=(const vtkSurfaceComparison&) = delete;

  struct Quantity; // name and place of one of the numbers above
  struct Work;     // both surfaces

  void ForgetQuantities();
  void WriteQuantities(vtkPolyData* output, vtkTable* table) const;

  bool Compare(Work& work);
  bool ReadSurfaces(Work& work);
  bool MeasureDistances(Work& work);
  void CompareNormals(Work& work);
  void CompareFeatures(Work& work);
  void CompareShapes(Work& work);
};

#endif
