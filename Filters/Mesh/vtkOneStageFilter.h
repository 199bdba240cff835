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
 * influence or a bounded one. A scale or step that is negative or infinite is an
 * error.
 */

#ifndef vtkOneStageFilter_h
#define vtkOneStageFilter_h

#include "vtkMeshDenoisingFilter.h"

namespace SurfaceDenoising
{
class Execution;
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

  /// What a subclass does to a prepared mesh. Returns false if the execution asked to stop.
  using Method = std::function<bool(SurfaceDenoising::PreparedMesh&, SurfaceDenoising::Execution&)>;

  /// The method with the settings of the subclass, which takes them from its properties; no
  /// function after an error.
  virtual Method Configure() = 0;

  /// After the method was run on the input, subclasses that have something to tell do so.
  virtual void Tell(SurfaceDenoising::SurfaceWork& work);

  /// True for finite numbers that are not negative; else an error that names the setting.
  bool CheckScale(const char* name, double value);

  bool FixBoundary = true;

private:
  vtkOneStageFilter(const vtkOneStageFilter&) = delete;
  void operator=(const vtkOneStageFilter&) = delete;
};

#endif
