// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkCurvatureNormalDiffusionFilter.h"

#include "Methods.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkCurvatureNormalDiffusionFilter);

vtkCurvatureNormalDiffusionFilter::vtkCurvatureNormalDiffusionFilter()
  : vtkFaceNormalFilter(sd::Method::CurvatureNormalDiffusion)
{
  const sd::MeshDenoisingSettings& defaults = this->Defaults();
  this->RangeScale = this->RangeScaleOf(defaults.NormScale);
  this->StepLength = defaults.StepLength;
}

vtkCurvatureNormalDiffusionFilter::~vtkCurvatureNormalDiffusionFilter() = default;

double vtkCurvatureNormalDiffusionFilter::RangeUnit() const { return std::sqrt(0.5); }

void vtkCurvatureNormalDiffusionFilter::Configure(sd::MeshDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  this->TakeRangeScale(this->RangeScale, settings.NormScale);
  settings.StepLength = this->StepLength;
}

void vtkCurvatureNormalDiffusionFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RangeScale: " << this->RangeScale << "\n";
  os << indent << "StepLength: " << this->StepLength << "\n";
}
