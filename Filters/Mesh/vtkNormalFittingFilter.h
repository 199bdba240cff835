// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkNormalFittingFilter
 * @brief   base of all filters that fit the points of a surface to filtered face normals
 *
 * Two-stage denoising filters the face normals of a surface first and then moves its points until
 * the faces have these normals. Edges survive, because normals on either side of an edge need not
 * be mixed, and the object does not shrink, because points only move as far as the normals ask.
 * This class holds the second stage. Subclasses say how the normals are filtered.
 *
 * The output has the filtered normals as the cell array "FilteredNormals" (double, unit length,
 * zero for vertices and lines). Faces without area get the normals of their surroundings and give
 * nothing to them.
 */

#ifndef vtkNormalFittingFilter_h
#define vtkNormalFittingFilter_h

#include "vtkMeshDenoisingFilter.h"

namespace SurfaceDenoising
{
struct MeshDenoisingReport;
struct MeshDenoisingSettings;
}

class VTKSURFACEDENOISINGMESH_EXPORT vtkNormalFittingFilter : public vtkMeshDenoisingFilter
{
public:
  vtkTypeMacro(vtkNormalFittingFilter, vtkMeshDenoisingFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How points are moved to fit the normals m_f of the faces f with centroids c_f.
  enum VertexSchemes
  {
    /// p += mean_f m_f (m_f . (c_f - p)): X. Sun, P. Rosin, R. Martin, F. Langbein 2007; stable for
    /// every valence.
    FACE_MEAN = 0,
    /// p += 1/6 sum_f m_f (m_f . (c_f - p)): G. Taubin 2001, Y. Zheng et al. 2011; for meshes with
    /// at most 9 faces around a point.
    CONSTANT_STEP = 1,
    /// As FACE_MEAN with the mean weighted by face areas: H. Yagou, Y. Ohtake, A. Belyaev 2002.
    AREA_WEIGHTED = 2,
    /// p -= 0.05 grad sum_f A_f |n_f - m_f|^2: Y. Ohtake, A. Belyaev, I. Bogaevski 2001; also evens
    /// out triangles.
    INTEGRAL_FIT = 3,
    /// As FACE_MEAN, plus Relaxation times the way to the mean of the neighbours weighted by edge
    /// lengths, the part along the surface twice; fades by 0.7 per step: S. K. Yadav, U. Reitebuch,
    /// K. Polthier 2018. Evens out triangles and prevents folds; costs a little volume.
    EDGE_WEIGHTED = 4
  };

  /// What the points of open borders do.
  enum BoundaryHandlings
  {
    FIXED = 0, ///< stay
    SLIDE = 1, ///< move along the border and across the surface, not into it
    FREE = 2   ///< move as all others; borders may shrink
  };

  ///@{
  /**
   * Number of steps that move the points, per outer iteration. Default 10, or what the paper of a
   * method says; 20 to 50 follow the normals more closely when they changed a lot. 0: from the data
   * (vtkNormalVertexUpdate: until a step is below a hundredth of the first one); -1: none, the
   * points stay.
   */
  vtkSetClampMacro(NumberOfVertexIterations, int, -1, VTK_INT_MAX);
  vtkGetMacro(NumberOfVertexIterations, int);
  ///@}

  ///@{
  /// How points move, one of VertexSchemes. Default FACE_MEAN, or what the paper of a method says.
  vtkSetClampMacro(VertexScheme, int, FACE_MEAN, EDGE_WEIGHTED);
  vtkGetMacro(VertexScheme, int);
  void SetVertexSchemeToFaceMean() { this->SetVertexScheme(FACE_MEAN); }
  void SetVertexSchemeToConstantStep() { this->SetVertexScheme(CONSTANT_STEP); }
  void SetVertexSchemeToAreaWeighted() { this->SetVertexScheme(AREA_WEIGHTED); }
  void SetVertexSchemeToIntegralFit() { this->SetVertexScheme(INTEGRAL_FIT); }
  void SetVertexSchemeToEdgeWeighted() { this->SetVertexScheme(EDGE_WEIGHTED); }
  ///@}

  ///@{
  /// For EDGE_WEIGHTED: the relaxation of the first step, in [0, 0.5]. Default 0.2.
  vtkSetClampMacro(Relaxation, double, 0.0, 0.5);
  vtkGetMacro(Relaxation, double);
  ///@}

  ///@{
  /// What points on open borders do, one of BoundaryHandlings. Default FIXED.
  vtkSetClampMacro(BoundaryHandling, int, FIXED, FREE);
  vtkGetMacro(BoundaryHandling, int);
  void SetBoundaryHandlingToFixed() { this->SetBoundaryHandling(FIXED); }
  void SetBoundaryHandlingToSlide() { this->SetBoundaryHandling(SLIDE); }
  void SetBoundaryHandlingToFree() { this->SetBoundaryHandling(FREE); }
  ///@}

  ///@{
  /**
   * Shorten steps that would turn a face more than 80 degrees away from its filtered normal or let
   * it collapse, unless the step makes it better. Default on. The published methods do without.
   */
  vtkSetMacro(PreventFlips, bool);
  vtkGetMacro(PreventFlips, bool);
  vtkBooleanMacro(PreventFlips, bool);
  ///@}

  ///@{
  /// How far a point may end up from where it was, in mean edge lengths. Default 0: as far as it
  /// goes.
  vtkSetClampMacro(MaximumDisplacement, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumDisplacement, double);
  ///@}

  ///@{
  /**
   * What the last execution found and did: mean distance between the centroids of faces that share
   * an edge, in the units of the model, and points whose step was shortened to prevent flips,
   * summed over the iterations.
   */
  vtkGetMacro(MeanCentroidDistance, double);
  vtkGetMacro(NumberOfGuardedPoints, vtkIdType);
  ///@}

protected:
  vtkNormalFittingFilter();
  ~vtkNormalFittingFilter() override;

  Outcome Denoise(SurfaceDenoising::SurfaceWork& work) override;
  bool FiltersNormals() const override { return true; }
  void ForgetReport() override;

  /// Subclasses complete the settings of the normal stage.
  virtual void Configure(SurfaceDenoising::MeshDenoisingSettings& settings) = 0;

  /// True if a cell array of normals to start from must have been chosen; without, those of the
  /// faces will do.
  virtual bool NeedsStartNormals() const { return false; }

  /// Subclasses that have more to tell take it from here, after an execution.
  virtual void TakeReport(const SurfaceDenoising::MeshDenoisingReport& report);

  int NumberOfVertexIterations = 10;
  int VertexScheme = FACE_MEAN;
  double Relaxation = 0.2;
  int BoundaryHandling = FIXED;
  bool PreventFlips = true;
  double MaximumDisplacement = 0.0;

  double MeanCentroidDistance = 0.0;
  vtkIdType NumberOfGuardedPoints = 0;

private:
  vtkNormalFittingFilter(const vtkNormalFittingFilter&) = delete;
  void operator=(const vtkNormalFittingFilter&) = delete;
};

#endif
