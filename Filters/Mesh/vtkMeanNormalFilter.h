// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkMeanNormalFilter
 * @brief   mean filtering of face normals
 *
 * H. Yagou, Y. Ohtake, A. Belyaev, "Mesh smoothing via mean and median filtering applied to face
 * normals", Geometric Modeling and Processing 2002, 124-131:
 *
 *   n_i <- normalise( sum_j A_j n_j )
 *
 * over the faces that share a point, then one step moves each point by the mean of its distances to
 * the planes of the faces around it, weighted by their areas, and both are repeated. Every edge
 * gets round: this is the method that robust ones are compared with, and one for smooth objects.
 *
 * In robust terms: the L2 norm.
 *
 * Reconstructed: descriptions differ in whether the face itself counts; here it does by default.
 */

#ifndef vtkMeanNormalFilter_h
#define vtkMeanNormalFilter_h

#include "vtkFaceNormalFilter.h"

class VTKSURFACEDENOISINGMESH_EXPORT vtkMeanNormalFilter : public vtkFaceNormalFilter
{
public:
  static vtkMeanNormalFilter* New();
  vtkTypeMacro(vtkMeanNormalFilter, vtkFaceNormalFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Count the face itself among its neighbours. Default on.
  vtkSetMacro(IncludeOwn, bool);
  vtkGetMacro(IncludeOwn, bool);
  vtkBooleanMacro(IncludeOwn, bool);
  ///@}

protected:
  vtkMeanNormalFilter();
  ~vtkMeanNormalFilter() override;

  void Configure(SurfaceDenoising::MeshDenoisingSettings& settings) override;

  bool IncludeOwn;

private:
  vtkMeanNormalFilter(const vtkMeanNormalFilter&) = delete;
  void operator=(const vtkMeanNormalFilter&) = delete;
};

#endif
