// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkVotingTensorPointFilter.h"

#include "Points/PointMethods.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkVotingTensorPointFilter);

vtkVotingTensorPointFilter::vtkVotingTensorPointFilter()
  : vtkPointNeighborhoodFilter(sd::PointMethod::VotingTensorPoint)
{
  const auto& operation = std::get<sd::VotingTensorPointsSettings>(this->Defaults().Operator);
}

vtkVotingTensorPointFilter::~vtkVotingTensorPointFilter() = default;

void vtkVotingTensorPointFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
