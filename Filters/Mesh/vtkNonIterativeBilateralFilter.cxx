// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkNonIterativeBilateralFilter.h"

#include "OneStage/NonIterativeBilateral.h"
#include "SurfaceWork.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkNonIterativeBilateralFilter);

vtkNonIterativeBilateralFilter::vtkNonIterativeBilateralFilter() = default;
vtkNonIterativeBilateralFilter::~vtkNonIterativeBilateralFilter() = default;

vtkMeshDenoisingFilter::Outcome vtkNonIterativeBilateralFilter::Move(sd::PreparedMesh& prepared,
  sd::SurfaceWork& work)
{
  if (!this->CheckPositive("SpatialScale", this->SpatialScale) ||
    !this->CheckPositive("RangeScale", this->RangeScale))
  {
    return FAILED;
  }
  sd::NonIterativeBilateralSettings settings;
  settings.SpatialScale = this->SpatialScale;
  settings.RangeScale = this->RangeScale;
  settings.FixBoundary = this->FixBoundary;
  return sd::FilterVerticesByPrediction(prepared, settings, work.Exec) ? FINISHED : STOPPED;
}

void vtkNonIterativeBilateralFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SpatialScale: " << this->SpatialScale << "\n";
  os << indent << "RangeScale: " << this->RangeScale << "\n";
}
