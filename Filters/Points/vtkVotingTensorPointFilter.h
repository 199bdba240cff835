// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkVotingTensorPointFilter
 * @brief   voting tensors, feature classes and restricted quadric update
 *
 * TODO
 */

#ifndef vtkVotingTensorPointFilter_h
#define vtkVotingTensorPointFilter_h

#include "vtkPointNeighborhoodFilter.h"

class VTKSURFACEDENOISINGPOINTS_EXPORT vtkVotingTensorPointFilter
  : public vtkPointNeighborhoodFilter
{
public:
  static vtkVotingTensorPointFilter* New();
  vtkTypeMacro(vtkVotingTensorPointFilter, vtkPointNeighborhoodFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkVotingTensorPointFilter();
  ~vtkVotingTensorPointFilter() override;

private:
  vtkVotingTensorPointFilter(const vtkVotingTensorPointFilter&) = delete;
  void operator=(const vtkVotingTensorPointFilter&) = delete;
};

#endif
