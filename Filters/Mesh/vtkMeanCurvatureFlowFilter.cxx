// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkMeanCurvatureFlowFilter.h"

#include "OneStage/MeanCurvatureFlow.h"
#include "SurfaceWork.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkMeanCurvatureFlowFilter);

vtkMeanCurvatureFlowFilter::vtkMeanCurvatureFlowFilter() = default;
vtkMeanCurvatureFlowFilter::~vtkMeanCurvatureFlowFilter() = default;

vtkMeshDenoisingFilter::Outcome vtkMeanCurvatureFlowFilter::Move(sd::PreparedMesh& prepared,
  sd::SurfaceWork& work)
{
  if (!this->CheckPositive("TimeStep", this->TimeStep))
  {
    return FAILED;
  }
  sd::MeanCurvatureFlowSettings settings;
  settings.Steps = this->NumberOfIterations;
  settings.TimeStep = this->TimeStep;
  settings.RestoreVolume = this->RestoreVolume;
  settings.FixBoundary = this->FixBoundary;
  sd::MeanCurvatureFlowReport report;
  if (!sd::FlowByMeanCurvature(prepared, settings, report, work.Exec))
  {
    return STOPPED;
  }
  if (this->RestoreVolume && this->NumberOfIterations > 0 && !report.VolumeRestored)
  {
    vtkWarningMacro(<< "The surface is not closed or lost its volume; the volume is not restored.");
  }
  work.Report.Add("Solver Iterations", report.SolverIterations);
  return FINISHED;
}

void vtkMeanCurvatureFlowFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfIterations: " << this->NumberOfIterations << "\n";
  os << indent << "TimeStep: " << this->TimeStep << "\n";
  os << indent << "RestoreVolume: " << this->RestoreVolume << "\n";
}
