// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkFaceNormalFilter
 * @brief   base of all methods that filter face normals
 *
 * Most methods of this family replace the normal of a face by a robust mean of the normals around
 * it,
 *
 *   n_i <- normalise( sum_j  A_j f(|c_i - c_j|) g(x_ij) n_j ),
 *
 * with an error norm whose weight function is g, an argument x_ij that says how much the normals
 * differ, a spatial kernel f and face areas A_j, and then moves the points to fit (see
 * vtkNormalFittingFilter). A subclass says which, in Configure.
 *
 * The two stages can be pipeline steps of their own: switch UpdateVertices off to get the filtered
 * normals as cell array "FilteredNormals" on the input's points, and let vtkNormalVertexUpdate move
 * the points. To start from other normals than those of the faces, say from a learned predictor,
 * name a cell array with SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS,
 * name). Without such an array, and with one of another association, it is an error.
 *
 * S. K. Yadav, M. Skrodzki, E. Zimmermann, K. Polthier, "Surface Denoising based on Normal
 * Filtering in a Robust Statistics Framework".
 */

#ifndef vtkFaceNormalFilter_h
#define vtkFaceNormalFilter_h

#include "vtkNormalFittingFilter.h"

namespace SurfaceDenoising
{
enum class Method : int;
}

class VTKSURFACEDENOISINGMESH_EXPORT vtkFaceNormalFilter : public vtkNormalFittingFilter
{
public:
  vtkTypeMacro(vtkFaceNormalFilter, vtkNormalFittingFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Which faces are averaged.
  enum Neighborhoods
  {
    EDGE_ADJACENT = 0,  ///< those that share an edge, 3 on a closed mesh
    VERTEX_SHARING = 1, ///< those that share a point, about 12
    RADIUS = 2,         ///< faces with centroids within a radius, connected across points there
    EDGE_RADIUS = 3     ///< faces with centroids within a radius, connected across edges there
  };

  /// Which normals are averaged when normal iterations follow one another.
  enum DataSources
  {
    PREVIOUS = 0, ///< those of the iteration before, as published filters do
    ORIGINAL =
      1 ///< those the iterations started from; only the centre moves: the M-estimate itself
  };

  ///@{
  /**
   * How often the stages take turns: every outer iteration looks at the surface anew, filters the
   * normals, and moves the points. The default is that of the paper of a method: 1 is the schedule
   * "normals first". More remove more noise. 0: from the data; -1: none, nothing is done.
   */
  vtkSetClampMacro(NumberOfOuterIterations, int, -1, VTK_INT_MAX);
  vtkGetMacro(NumberOfOuterIterations, int);
  ///@}

  ///@{
  /**
   * Number of normal iterations per outer iteration. The default is that of the paper of a method,
   * 20 for schedules "normals first": more noise needs more. 0: from the data; -1: none, normals
   * stay.
   */
  vtkSetClampMacro(NumberOfNormalIterations, int, -1, VTK_INT_MAX);
  vtkGetMacro(NumberOfNormalIterations, int);
  ///@}

  ///@{
  /**
   * End the iterations of both stages as soon as the normals are as far from those of the input as
   * the noise that the surface has turned them (root mean square angle, told from medians): the
   * numbers of iterations are then the most there may be. A surface without noise passes through
   * with a warning. Default off.
   */
  vtkSetMacro(StopAtNoise, bool);
  vtkGetMacro(StopAtNoise, bool);
  vtkBooleanMacro(StopAtNoise, bool);
  ///@}

  ///@{
  /// Move the points (default) or only filter the normals, which then go on from one outer
  /// iteration to the next.
  vtkSetMacro(UpdateVertices, bool);
  vtkGetMacro(UpdateVertices, bool);
  vtkBooleanMacro(UpdateVertices, bool);
  ///@}

  ///@{
  /**
   * What the last execution used and did: the scale of the norm, given or from the data, in the
   * units of the subclass, and the number of triangles that kept their normal in the last iteration
   * because no neighbour had any weight.
   */
  vtkGetMacro(UsedRangeScale, double);
  vtkGetMacro(NumberOfUnfilteredFaces, vtkIdType);
  ///@}

protected:
  /// Defaults are those of a method in the table of methods.
  explicit vtkFaceNormalFilter(SurfaceDenoising::Method method);
  ~vtkFaceNormalFilter() override;

  Outcome Denoise(SurfaceDenoising::SurfaceWork& work) override;
  void Configure(SurfaceDenoising::MeshDenoisingSettings& settings) override;
  void TakeReport(const SurfaceDenoising::MeshDenoisingReport& report) override;

  /// The settings of the method.
  virtual const SurfaceDenoising::MeshDenoisingSettings& Defaults() const;

  /// What a range scale of the class is multiplied by to become the scale of the norm.
  virtual double RangeUnit() const;

  /// Rounded to what people write.
  double RangeScaleOf(double normScale) const;

  /// The scale of the norm for the property "RangeScale"; 0: from the data.
  void TakeRangeScale(double rangeScale, double& normScale);

  /// The radius of neighbourhoods for the property "Radius"; 0: from the data, at most 6.
  void TakeRadius(double property, double& radius);

  /// Sets iterations, vertex scheme and limits to those of the settings.
  void TakeSchedule(const SurfaceDenoising::MeshDenoisingSettings& settings);

  int NumberOfOuterIterations;
  int NumberOfNormalIterations;
  bool StopAtNoise = false;
  bool UpdateVertices = true;
  double UsedRangeScale = 0.0;
  vtkIdType NumberOfUnfilteredFaces = 0;

private:
  vtkFaceNormalFilter(const vtkFaceNormalFilter&) = delete;
  void operator=(const vtkFaceNormalFilter&) = delete;

  const SurfaceDenoising::Method Row;
  double Residual =
    0.0; ///< at which the iterations of this execution end, radians; 0: never, -1: at once
};

#endif
