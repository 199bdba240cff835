// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkMeanCurvatureFlowFilter.h"

#include "Automatic/OpenSettings.h"
#include "OneStage/MeanCurvatureFlow.h"
#include "PreparedMesh.h"
#include "SurfaceWork.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkMeanCurvatureFlowFilter);

vtkMeanCurvatureFlowFilter::vtkMeanCurvatureFlowFilter() = default;
vtkMeanCurvatureFlowFilter::~vtkMeanCurvatureFlowFilter() = default;

vtkOneStageFilter::Method vtkMeanCurvatureFlowFilter::Configure()
{
  if (!this->CheckScale("TimeStep", this->TimeStep))
  {
    return nullptr;
  }
  const auto settings = std::make_shared<sd::MeanCurvatureFlowSettings>();
  this->Open->Take("NumberOfIterations", this->NumberOfIterations, settings->Steps);
  this->Open->Take("TimeStep", this->TimeStep, settings->TimeStep);
  settings->RestoreVolume = this->RestoreVolume;
  settings->FixBoundary = this->FixBoundary;
  return [this, settings](sd::PreparedMesh& prepared, sd::Execution& execution)
  {
    sd::MeanCurvatureFlowReport report;
    const bool finished = sd::FlowByMeanCurvature(prepared, *settings, report, execution);
    this->SolverIterations = report.SolverIterations;
    this->VolumeKept = !settings->RestoreVolume || settings->Steps < 1 || report.VolumeRestored;
    return finished;
  };
}

void vtkMeanCurvatureFlowFilter::Tell(sd::SurfaceWork& work)
{
  if (!this->VolumeKept)
  {
    vtkWarningMacro(<< "The surface is not closed or lost its volume; the volume is not restored.");
  }
  work.Report.Add("Solver Iterations", this->SolverIterations);
}

void vtkMeanCurvatureFlowFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfIterations: " << this->NumberOfIterations << "\n";
  os << indent << "TimeStep: " << this->TimeStep << "\n";
  os << indent << "RestoreVolume: " << this->RestoreVolume << "\n";
}
