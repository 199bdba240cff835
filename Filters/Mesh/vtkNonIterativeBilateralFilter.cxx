// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkNonIterativeBilateralFilter.h"

#include "Automatic/OpenSettings.h"
#include "OneStage/NonIterativeBilateral.h"
#include "PreparedMesh.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkNonIterativeBilateralFilter);

vtkNonIterativeBilateralFilter::vtkNonIterativeBilateralFilter() = default;
vtkNonIterativeBilateralFilter::~vtkNonIterativeBilateralFilter() = default;

vtkOneStageFilter::Method vtkNonIterativeBilateralFilter::Configure()
{
  if (!this->CheckScale("SpatialScale", this->SpatialScale) ||
    !this->CheckScale("RangeScale", this->RangeScale))
  {
    return nullptr;
  }
  const auto settings = std::make_shared<sd::NonIterativeBilateralSettings>();
  this->Open->TakeRadius("SpatialScale", this->SpatialScale, settings->SpatialScale, 4.0);
  this->Open->Take("RangeScale", this->RangeScale, settings->RangeScale);
  settings->FixBoundary = this->FixBoundary;
  return [settings](sd::PreparedMesh& prepared, sd::Execution& execution)
  { return sd::FilterVerticesByPrediction(prepared, *settings, execution); };
}

void vtkNonIterativeBilateralFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SpatialScale: " << this->SpatialScale << "\n";
  os << indent << "RangeScale: " << this->RangeScale << "\n";
}
