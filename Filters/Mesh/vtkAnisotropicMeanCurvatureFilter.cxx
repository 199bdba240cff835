// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkAnisotropicMeanCurvatureFilter.h"

#include "Automatic/OpenSettings.h"
#include "OneStage/AnisotropicCurvatureFlow.h"
#include "PreparedMesh.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkAnisotropicMeanCurvatureFilter);

vtkAnisotropicMeanCurvatureFilter::vtkAnisotropicMeanCurvatureFilter() = default;
vtkAnisotropicMeanCurvatureFilter::~vtkAnisotropicMeanCurvatureFilter() = default;

vtkOneStageFilter::Method vtkAnisotropicMeanCurvatureFilter::Configure()
{
  if (!this->CheckScale("TimeStep", this->TimeStep) ||
    !this->CheckScale("EdgeThreshold", this->EdgeThreshold))
  {
    return nullptr;
  }
  const auto settings = std::make_shared<sd::AnisotropicCurvatureFlowSettings>();
  this->Open->Take("NumberOfIterations", this->NumberOfIterations, settings->Steps);
  this->Open->Take("TimeStep", this->TimeStep, settings->TimeStep);
  this->Open->Take("EdgeThreshold", this->EdgeThreshold, settings->EdgeThreshold);
  settings->PrescribeCurvature = this->PrescribeCurvature;
  settings->FixBoundary = this->FixBoundary;
  return [settings](sd::PreparedMesh& prepared, sd::Execution& execution)
  { return sd::FlowByAnisotropicCurvature(prepared, *settings, execution); };
}

void vtkAnisotropicMeanCurvatureFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfIterations: " << this->NumberOfIterations << "\n";
  os << indent << "TimeStep: " << this->TimeStep << "\n";
  os << indent << "EdgeThreshold: " << this->EdgeThreshold << "\n";
  os << indent << "PrescribeCurvature: " << this->PrescribeCurvature << "\n";
}
