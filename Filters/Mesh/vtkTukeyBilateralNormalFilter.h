// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkTukeyBilateralNormalFilter
 * @brief   bilateral filtering of face normals with Tukey's norm
 *
 * S. K. Yadav, U. Reitebuch, K. Polthier, "Robust and high fidelity mesh denoising", IEEE TVCG
 * 25(6), 2304-2310, 2019:
 *
 *   n_i <- normalise( sum_j  A_j  exp(-|c_i - c_j|^2 / (2 d_i^2))  g(|n_i - n_j|)  n_j ),
 *   g(x) = (1 - (x / s)^2)^2 up to s, then 0,
 *
 * over the faces within a radius that are connected across edges, without the face itself; d_i is
 * the face's own mean distance to its adjacent ones. Then one step fits the points and evens out
 * the edges around them (VertexScheme EDGE_WEIGHTED), and both are repeated. Faces do not fold
 * over, and triangles become better than they were. Beyond s a normal has no influence at all:
 * exact edges stay exact. A scale below the noise stalls, see NumberOfUnfilteredFaces.
 *
 * In robust terms: Tukey's biweight on the chord between normals, with a spatial Gaussian.
 *
 * AsReleased reproduces the program that the authors released, with its slips, and so the published
 * results: the weight is (1 - x^2)^2, cut at s; normals lag one iteration behind; the tangential
 * part of the relaxation is that of the last point of the mesh; a face without similar neighbours
 * gets the normal (0, 0, 1). Results then depend on order, size and orientation of the model.
 *
 * Differs from the authors' program otherwise: open borders stay unless BoundaryHandling says
 * otherwise and are never relaxed, and face flips are prevented unless PreventFlips is switched
 * off.
 */

#ifndef vtkTukeyBilateralNormalFilter_h
#define vtkTukeyBilateralNormalFilter_h

#include "vtkFaceNormalFilter.h"

class VTKSURFACEDENOISINGMESH_EXPORT vtkTukeyBilateralNormalFilter : public vtkFaceNormalFilter
{
public:
  static vtkTukeyBilateralNormalFilter* New();
  vtkTypeMacro(vtkTukeyBilateralNormalFilter, vtkFaceNormalFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The scale s as a chord length of unit normals. Default 0.35; from 0.2 to 1, twice that of a
   * Gaussian. 0: from the data.
   */
  vtkSetClampMacro(RangeScale, double, 0.0, 2.0);
  vtkGetMacro(RangeScale, double);
  ///@}

  ///@{
  /// Sigma of the spatial Gaussian in d_i. Default 1; 0: from the data; -1: none.
  vtkSetClampMacro(SpatialScale, double, -1.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SpatialScale, double);
  ///@}

  ///@{
  /// How far neighbours are, in mean distances of adjacent centroids. Default 2, about 12 faces; 0:
  /// from the data. Where there are more than 400, those count that are the fewest faces
  /// away.
  vtkSetClampMacro(Radius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Compute what the released program does. Only RangeScale, Relaxation, NumberOfOuterIterations
   * and NumberOfThreads matter then: it starts from the normals of the faces, whatever array is
   * chosen, and moves the points, whatever UpdateVertices says. Default off.
   */
  vtkSetMacro(AsReleased, bool);
  vtkGetMacro(AsReleased, bool);
  vtkBooleanMacro(AsReleased, bool);
  ///@}

protected:
  vtkTukeyBilateralNormalFilter();
  ~vtkTukeyBilateralNormalFilter() override;

  void Configure(SurfaceDenoising::MeshDenoisingSettings& settings) override;
  Outcome Denoise(SurfaceDenoising::SurfaceWork& work) override;

  double RangeScale;
  double SpatialScale;
  double Radius;
  bool AsReleased = false;

private:
  vtkTukeyBilateralNormalFilter(const vtkTukeyBilateralNormalFilter&) = delete;
  void operator=(const vtkTukeyBilateralNormalFilter&) = delete;
};

#endif
