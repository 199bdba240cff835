// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkMedianNormalFilter
 * @brief   median filtering of face normals
 *
 * H. Yagou, Y. Ohtake, A. Belyaev, "Mesh smoothing via mean and median filtering applied to face
 * normals", Geometric Modeling and Processing 2002, 124-131, and H. Yagou, A. Belyaev, D. Wei,
 * "Mesh median filter for smoothing 3-D polygonal surfaces", Cyber Worlds 2002: a face takes one of
 * the normals around it, namely
 *
 * - ANGULAR: the faces that share a point with it, without itself, are sorted by the angle to its
 * normal, and the one in the middle is taken (of an even number the lower of two);
 * - WEIGHTED: likewise, but faces count as often as EdgeRepetitions and VertexRepetitions say;
 * - DIRECTIONAL: the normal with the least sum of angles to all others, its own among them (P.
 * Trahanias, A. Venetsanopoulos 1993);
 * - GEOMETRIC: not one of them but the point on the sphere with the least sum of chords to all of
 * them, weighted by areas: the L1 estimate. NumberOfNormalIterations then counts the steps of
 * reweighted means that lead there; choose 30.
 *
 * One step then moves the points, and both are repeated. Edges stay; some noise does, too, since
 * nothing is averaged.
 *
 * In robust terms: a truncated L1 norm by the survey's reading of the first two; GEOMETRIC is L1.
 *
 * Reconstructed: the angular selection, and that faces at an edge count twice when weighted.
 */

#ifndef vtkMedianNormalFilter_h
#define vtkMedianNormalFilter_h

#include "vtkFaceNormalFilter.h"

class VTKSURFACEDENOISINGMESH_EXPORT vtkMedianNormalFilter : public vtkFaceNormalFilter
{
public:
  static vtkMedianNormalFilter* New();
  vtkTypeMacro(vtkMedianNormalFilter, vtkFaceNormalFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What the median of normals is.
  enum MedianTypes
  {
    ANGULAR = 0,     ///< the neighbour in the middle by angle
    WEIGHTED = 1,    ///< likewise, with repetitions
    DIRECTIONAL = 2, ///< the normal with the least sum of angles
    GEOMETRIC = 3    ///< the point with the least sum of chords
  };

  ///@{
  /// Which median, one of MedianTypes. Default ANGULAR.
  vtkSetClampMacro(MedianType, int, ANGULAR, GEOMETRIC);
  vtkGetMacro(MedianType, int);
  void SetMedianTypeToAngular() { this->SetMedianType(ANGULAR); }
  void SetMedianTypeToWeighted() { this->SetMedianType(WEIGHTED); }
  void SetMedianTypeToDirectional() { this->SetMedianType(DIRECTIONAL); }
  void SetMedianTypeToGeometric() { this->SetMedianType(GEOMETRIC); }
  ///@}

  ///@{
  /// How often faces count that share an edge, for WEIGHTED. Default 2.
  vtkSetClampMacro(EdgeRepetitions, int, 0, VTK_INT_MAX);
  vtkGetMacro(EdgeRepetitions, int);
  ///@}

  ///@{
  /// How often the other faces count, for WEIGHTED. Default 1.
  vtkSetClampMacro(VertexRepetitions, int, 0, VTK_INT_MAX);
  vtkGetMacro(VertexRepetitions, int);
  ///@}

  ///@{
  /**
   * For GEOMETRIC: chords below this weigh no more than those of this length, in (0, 2]. Default
   * 0.05.
   */
  vtkSetClampMacro(Regularization, double, 1e-6, 2.0);
  vtkGetMacro(Regularization, double);
  ///@}

protected:
  vtkMedianNormalFilter();
  ~vtkMedianNormalFilter() override;

  void Configure(SurfaceDenoising::MeshDenoisingSettings& settings) override;

  int MedianType = ANGULAR;
  int EdgeRepetitions = 2;
  int VertexRepetitions = 1;
  double Regularization = 0.05;

private:
  vtkMedianNormalFilter(const vtkMedianNormalFilter&) = delete;
  void operator=(const vtkMedianNormalFilter&) = delete;
};

#endif
