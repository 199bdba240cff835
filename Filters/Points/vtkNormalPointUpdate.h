// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkNormalPointUpdate
 * @brief   moves points to fit given normals
 *
 * The second stage alone: give it points with filtered normals, of another filter or of a learned
 * predictor. The normals are those of the input (NormalSource INPUT) and stay as they are. See
 * vtkPointFittingFilter for the steps.
 */

#ifndef vtkNormalPointUpdate_h
#define vtkNormalPointUpdate_h

#include "vtkPointFittingFilter.h"

class VTKSURFACEDENOISINGPOINTS_EXPORT vtkNormalPointUpdate : public vtkPointFittingFilter
{
public:
  static vtkNormalPointUpdate* New();
  vtkTypeMacro(vtkNormalPointUpdate, vtkPointFittingFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkNormalPointUpdate();
  ~vtkNormalPointUpdate() override;

  void Configure(SurfaceDenoising::PointDenoisingSettings& settings) override;

private:
  vtkNormalPointUpdate(const vtkNormalPointUpdate&) = delete;
  void operator=(const vtkNormalPointUpdate&) = delete;
};

#endif
