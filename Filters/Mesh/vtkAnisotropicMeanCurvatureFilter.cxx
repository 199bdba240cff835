// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkAnisotropicMeanCurvatureFilter.h"

#include "OneStage/AnisotropicCurvatureFlow.h"
#include "SurfaceWork.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkAnisotropicMeanCurvatureFilter);

vtkAnisotropicMeanCurvatureFilter::vtkAnisotropicMeanCurvatureFilter() = default;
vtkAnisotropicMeanCurvatureFilter::~vtkAnisotropicMeanCurvatureFilter() = default;

vtkMeshDenoisingFilter::Outcome vtkAnisotropicMeanCurvatureFilter::Move(sd::PreparedMesh& prepared,
  sd::SurfaceWork& work)
{
  if (!this->CheckPositive("TimeStep", this->TimeStep) ||
    !this->CheckPositive("EdgeThreshold", this->EdgeThreshold))
  {
    return FAILED;
  }
  sd::AnisotropicCurvatureFlowSettings settings;
  settings.Steps = this->NumberOfIterations;
  settings.TimeStep = this->TimeStep;
  settings.EdgeThreshold = this->EdgeThreshold;
  settings.PrescribeCurvature = this->PrescribeCurvature;
  settings.FixBoundary = this->FixBoundary;
  return sd::FlowByAnisotropicCurvature(prepared, settings, work.Exec) ? FINISHED : STOPPED;
}

void vtkAnisotropicMeanCurvatureFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfIterations: " << this->NumberOfIterations << "\n";
  os << indent << "TimeStep: " << this->TimeStep << "\n";
  os << indent << "EdgeThreshold: " << this->EdgeThreshold << "\n";
  os << indent << "PrescribeCurvature: " << this->PrescribeCurvature << "\n";
}
