// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkGuidedPointNormalFilter
 * @brief   guided filter with several normals at feature points
 *
 * Y. Zheng, G. Li, S. Wu, Y. Liu, Y. Gao, "Guided point cloud denoising via sharp feature
 * skeletons", The Visual Computer 33, 2017. Points whose normals differ from those around are
 * candidates for features. A feature point gets two normals at edges and three at corners, from
 * clusters of the normals around it. All normals are filtered by a Gaussian of the distance and one
 * of the difference of guidance normals, those of the most consistent patches nearby; a point with
 * several normals then moves onto several planes, that is, onto the edge or the corner. The output
 * normal of such a point is the mean of its normals, and "FeatureClass" tells how many there were.
 * The structure is the paper's; details are reconstructed.
 */

#ifndef vtkGuidedPointNormalFilter_h
#define vtkGuidedPointNormalFilter_h

#include "vtkPointNeighborhoodFilter.h"

class VTKSURFACEDENOISINGPOINTS_EXPORT vtkGuidedPointNormalFilter
  : public vtkPointNeighborhoodFilter
{
public:
  static vtkGuidedPointNormalFilter* New();
  vtkTypeMacro(vtkGuidedPointNormalFilter, vtkPointNeighborhoodFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// sigma of exp(-(|G_i - G_j| / sigma)^2) with the guidance normals G, a chord. Default 0.35. 0:
  /// from the data.
  vtkSetClampMacro(RangeScale, double, 0.0, 2.0);
  vtkGetMacro(RangeScale, double);
  ///@}

  ///@{
  /// sigma_d of exp(-(d / sigma_d)^2) in spacings. Default 1.5. 0: from the data.
  vtkSetClampMacro(SpatialScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SpatialScale, double);
  ///@}

  ///@{
  /// How often normals are filtered. Default 5. 0: from the data; -1: none.
  vtkSetClampMacro(NumberOfNormalIterations, int, -1, VTK_INT_MAX);
  vtkGetMacro(NumberOfNormalIterations, int);
  ///@}

  ///@{
  /// How often points move, after the normals were filtered. Default 10. 0: from the data; -1:
  /// none.
  vtkSetClampMacro(NumberOfPointIterations, int, -1, VTK_INT_MAX);
  vtkGetMacro(NumberOfPointIterations, int);
  ///@}

  ///@{
  /// Points are candidates if the mean of exp(-(|n_i - n_j| / CandidateScale)^2) over their
  /// neighbours is below this, in [0, 1]. Default 0.6.
  vtkSetClampMacro(CandidateThreshold, double, 0.0, 1.0);
  vtkGetMacro(CandidateThreshold, double);
  ///@}

  ///@{
  /// See CandidateThreshold; a chord. Default 0.3.
  vtkSetClampMacro(CandidateScale, double, 0.01, 2.0);
  vtkGetMacro(CandidateScale, double);
  ///@}

  ///@{
  /// Of the candidates, take those near their L1-medial skeleton alone. Default off.
  vtkSetMacro(UseSkeleton, bool);
  vtkGetMacro(UseSkeleton, bool);
  vtkBooleanMacro(UseSkeleton, bool);
  ///@}

  ///@{
  /// Width of the kernel of the skeleton in spacings. Default 3.
  vtkSetClampMacro(SkeletonRadius, double, 0.5, VTK_DOUBLE_MAX);
  vtkGetMacro(SkeletonRadius, double);
  ///@}

  ///@{
  /// A cluster is divided if a member is farther from its mean, in degrees. Default 25.
  vtkSetClampMacro(BundleAngle, double, 1.0, 90.0);
  vtkGetMacro(BundleAngle, double);
  ///@}

  ///@{
  /// Normals of a feature point, at most: 1 (no bundles) to 3. Default 3.
  vtkSetClampMacro(MaximumNumberOfNormals, int, 1, 3);
  vtkGetMacro(MaximumNumberOfNormals, int);
  ///@}

  ///@{
  /// Neighbours that make a patch, and whose patches may guide. Default 6.
  vtkSetClampMacro(NumberOfPatchNeighbors, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfPatchNeighbors, int);
  ///@}

  ///@{
  /// Point i may be guided by the patch of its neighbour j if n_i . n_j is at least this: the
  /// cosine of the angle between them, in [-1, 1]; -1: by any. Default 0.9, 26 degrees.
  vtkSetClampMacro(PatchAgreement, double, -1.0, 1.0);
  vtkGetMacro(PatchAgreement, double);
  ///@}

  ///@{
  /// Neighbour a of point j belongs to the patch of j if n_j . n_a is at least this: the cosine of
  /// the angle between them, in [-1, 1]; -1: all do. Patches end at edges that bend more. Default
  /// 0.9.
  vtkSetClampMacro(MemberAgreement, double, -1.0, 1.0);
  vtkGetMacro(MemberAgreement, double);
  ///@}

  ///@{
  /// How far a point may be from the planes of its normals, in spacings; 0: any distance. Default
  /// 0.75.
  vtkSetClampMacro(BundleReach, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(BundleReach, double);
  ///@}

  ///@{
  /// Weight of points with several normals when others move, in [0, 1]. Default 0.1: they do not
  /// pull faces down to the edge.
  vtkSetClampMacro(FeaturePull, double, 0.0, 1.0);
  vtkGetMacro(FeaturePull, double);
  ///@}

  ///@{
  /// Treat n and -n as the same normal: for normals whose signs mean nothing. Sheets closer than
  /// the neighbourhood are then taken for one. Default off: normals are oriented.
  vtkSetMacro(UnorientedNormals, bool);
  vtkGetMacro(UnorientedNormals, bool);
  vtkBooleanMacro(UnorientedNormals, bool);
  ///@}

protected:
  vtkGuidedPointNormalFilter();
  ~vtkGuidedPointNormalFilter() override;

  void Configure(SurfaceDenoising::PointDenoisingSettings& settings) override;
  bool TellsClasses() const override { return true; }

  double RangeScale;
  double SpatialScale;
  int NumberOfNormalIterations;
  int NumberOfPointIterations;
  double CandidateThreshold;
  double CandidateScale;
  bool UseSkeleton;
  double SkeletonRadius;
  double BundleAngle;
  int MaximumNumberOfNormals;
  int NumberOfPatchNeighbors;
  double PatchAgreement;
  double MemberAgreement;
  double BundleReach;
  double FeaturePull;
  bool UnorientedNormals;

private:
  vtkGuidedPointNormalFilter(const vtkGuidedPointNormalFilter&) = delete;
  void operator=(const vtkGuidedPointNormalFilter&) = delete;
};

#endif
