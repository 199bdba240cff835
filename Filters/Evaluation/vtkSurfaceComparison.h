// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceComparison
 * @brief Measures how far a surface or a point cloud is from the ground truth.
 *
 * Input port 0 takes the result to be judged, port 1 the reference. Output port 0 is the result
 * with
 * - the cell array "NormalAngleError", in degrees: angle between the normals of corresponding
 * faces; NaN for cells that are no faces and for faces without area;
 * - the point array "Distance": distance of each point to the reference;
 * - the point array "PointNormalAngleError", in degrees, if there are point normals to compare.
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
 * are exact distances to the faces of the other surface, not to its points, except where point sets
 * are spoken of. Lengths are in the units of the coordinates; those called relative are divided by
 * ReferenceDiagonal.
 *
 * @par Point clouds
 * A result without polygons and strips is a point cloud; so is a reference without any, or without
 * a face of positive area. All points of a cloud count; of a surface only those that its polygons
 * use (but the point arrays have values for all). Distances to a reference that is a cloud are
 * those to its nearest point. What needs faces that are not there is NaN; so are the distances of a
 * reference to the faces of a result that is a cloud (HausdorffFromReference, HausdorffDistance).
 *
 * @par Nearest faces of points
 * Outside an edge or corner of the reference, all faces that meet there are equally near to a
 * point. It is near features if one of them is, and its normal is compared with the one that fits
 * best. Points of the reference that lie on boundaries at the same place are one point here.
 *
 * @par What is refused
 * A missing or empty input, a reference without a point that is finite, and a face with a point
 * that does not exist or is not finite raise an error. Points outside faces that are not finite (or
 * beyond 1e100) have no distance (NaN) and do not count.
 *
 * @warning
 * The surface distance is taken to the whole other surface: on thin walls a point may be measured
 * against the wrong side, and the nearest face may be on the wrong side likewise.
 *
 * @par References
 * X. Sun, P. L. Rosin, R. R. Martin, F. C. Langbein: Fast and effective feature-preserving mesh
 * denoising, IEEE TVCG 13(5), 2007 (PositionError). J. A. Baerentzen, H. Aanaes: Signed distance
 * computation using the angle weighted pseudonormal, IEEE TVCG 11(3), 2005 (MeanSignedDistance).
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
   * 1 if faces correspond by number, 0 if by nearest face, or not at all because there is a point
   * cloud. UncomparedFaces is the number of faces without area, in the result or in the reference,
   * whose normals could not be compared; NaN for point clouds.
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
  /// Number of faces that are turned over: more than 90 degrees from the corresponding face. NaN
  /// for point clouds.
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
  /**
   * Plain mean, root mean square and maximum of the distances d_i of the points of the result to
   * the reference: sum d_i / n, sqrt(sum d_i^2 / n), max d_i. The relative ones are NaN if the
   * reference is a single point.
   */
  vtkGetMacro(MeanDistance, double);
  vtkGetMacro(RMSDistance, double);
  vtkGetMacro(MaximumDistance, double);
  vtkGetMacro(RelativeMeanDistance, double);
  vtkGetMacro(RelativeRMSDistance, double);
  vtkGetMacro(RelativeMaximumDistance, double);
  ///@}

  ///@{
  /**
   * Mean of s_i d_i with the side s_i = 1 outside the reference surface and -1 inside, by the
   * angle-weighted pseudonormal of the nearest face, edge or vertex: a result that shrank has a
   * negative mean. Of an open surface, outside is where its normals point to. NaN if the reference
   * is a cloud, or if faces that share an edge disagree on what is outside.
   */
  vtkGetMacro(MeanSignedDistance, double);
  ///@}

  ///@{
  /**
   * Number of points of the result whose nearest face of the reference is within FeatureRings of
   * its feature edges, mean of their distances to the reference, and mean over all other points. A
   * mean over no points is NaN, and all are if the reference is a cloud. Unlike FeatureFaces, these
   * need neither the same connectivity nor faces of the result.
   */
  vtkGetMacro(FeaturePoints, double);
  vtkGetMacro(FeatureDistance, double);
  vtkGetMacro(SmoothDistance, double);
  ///@}

  ///@{
  /**
   * Distances between point sets: the points X of the result and Y of the reference, whether they
   * are surfaces or clouds. With d(p, S) the distance of p to the nearest point of S:
   * - ChamferDistance = (mean_x d(x, Y) + mean_y d(y, X)) / 2,
   * - SquaredChamferDistance = mean_x d(x, Y)^2 + mean_y d(y, X)^2, in squared units,
   * - PointHausdorffToReference = max_x d(x, Y), PointHausdorffFromReference = max_y d(y, X), and
   * PointHausdorffDistance the larger of the two.
   */
  vtkGetMacro(ChamferDistance, double);
  vtkGetMacro(SquaredChamferDistance, double);
  vtkGetMacro(PointHausdorffToReference, double);
  vtkGetMacro(PointHausdorffFromReference, double);
  vtkGetMacro(PointHausdorffDistance, double);
  ///@}

  ///@{
  /**
   * How unevenly the points lie: standard deviation (of the population) / mean of the distances of
   * each point to the nearest other one; 0 is even. NaN for fewer than two points, or if each point
   * has another one at its place.
   */
  vtkGetMacro(SpacingVariation, double);
  vtkGetMacro(ReferenceSpacingVariation, double);
  ///@}

  ///@{
  /**
   * Angles theta = atan2(|n x m|, |n.m|), from 0 to 90 degrees, between the normal n of a point of
   * the result and the normal m of the nearest face of the reference (of the nearest point, if the
   * reference is a cloud): the sign does not matter. Mean, root mean square, share of the angles
   * below 10 degrees, from 0 to 1, and number of normals that point the other way, n.m < 0. Normals
   * of points are the active ones, of any length, or of a cloud the array "Normals" if none are
   * active. Points whose normal is zero or not finite are left out. All are NaN without normals.
   */
  vtkGetMacro(MeanPointNormalAngle, double);
  vtkGetMacro(RMSPointNormalAngle, double);
  vtkGetMacro(SharePointNormalsWithin10, double);
  vtkGetMacro(FlippedPointNormals, double);
  ///@}

  ///@{
  /**
   * Largest distance from the result to the reference, from the reference to the result, and the
   * larger of the two. Surfaces are sampled at their vertices and at the centroids of their faces.
   * NaN from the reference to a result without faces; see PointHausdorffDistance for that.
   */
  vtkGetMacro(HausdorffToReference, double);
  vtkGetMacro(HausdorffFromReference, double);
  vtkGetMacro(HausdorffDistance, double);
  vtkGetMacro(RelativeHausdorffDistance, double);
  ///@}

  ///@{
  /// Diagonal of the bounding box of the faces of the reference, or of its points if it is a cloud.
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
  double RMSDistance;
  double MaximumDistance;
  double RelativeRMSDistance;
  double RelativeMaximumDistance;
  double MeanSignedDistance;
  double FeaturePoints;
  double FeatureDistance;
  double SmoothDistance;
  double ChamferDistance;
  double SquaredChamferDistance;
  double PointHausdorffToReference;
  double PointHausdorffFromReference;
  double PointHausdorffDistance;
  double SpacingVariation;
  double ReferenceSpacingVariation;
  double MeanPointNormalAngle;
  double RMSPointNormalAngle;
  double SharePointNormalsWithin10;
  double FlippedPointNormals;

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
  bool MeasurePointSets(Work& work);
  void CompareNormals(Work& work);
  void CompareFeatures(Work& work);
  void MeasureSides(Work& work);
  void ComparePointNormals(Work& work);
  void CompareShapes(Work& work);
};

#endif
