// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkOneStageFilter
 * @brief   base of the methods that move points without filtering normals first
 *
 * These are the methods that two-stage denoising (vtkFaceNormalFilter) is compared with. They
 * smooth positions directly, which is simple and fast, but they shrink objects or round their
 * edges, some less than others: each class says what to expect.
 *
 * All points move at the same time, from the positions before the step. Faces without area have no
 * influence or a bounded one. A scale or step that is not a positive number is an error.
 */

#ifndef vtkOneStageFilter_h
#define vtkOneStageFilter_h

#include "vtkMeshDenoisingFilter.h"

namespace SurfaceDenoising
{
class PreparedMesh;
}

class VTKSURFACEDENOISINGMESH_EXPORT vtkOneStageFilter : public vtkMeshDenoisingFilter
{
public:
  vtkTypeMacro(vtkOneStageFilter, vtkMeshDenoisingFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Points on open borders stay where they are. Default on; off, they move as all others, and
  /// borders may contract.
  vtkSetMacro(FixBoundary, bool);
  vtkGetMacro(FixBoundary, bool);
  vtkBooleanMacro(FixBoundary, bool);
  ///@}

protected:
  vtkOneStageFilter();
  ~vtkOneStageFilter() override;

  Outcome Denoise(SurfaceDenoising::SurfaceWork& work) override;

  /// Subclasses move the vertices of the prepared mesh.
  virtual Outcome Move(SurfaceDenoising::PreparedMesh& prepared,
    SurfaceDenoising::SurfaceWork& work) = 0;

  /// True for positive numbers; else an error that names the setting.
  bool CheckPositive(const char* name, double value);

  bool FixBoundary = true;

private:
  vtkOneStageFilter(const vtkOneStageFilter&) = delete;
  void operator=(const vtkOneStageFilter&) = delete;
};

#endif
