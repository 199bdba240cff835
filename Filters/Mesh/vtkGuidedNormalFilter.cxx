// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGuidedNormalFilter.h"

#include "Automatic/OpenSettings.h"
#include "Methods.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkGuidedNormalFilter);

vtkGuidedNormalFilter::vtkGuidedNormalFilter()
  : vtkFaceNormalFilter(sd::Method::GuidedNormal)
{
  const sd::MeshDenoisingSettings& defaults = this->Defaults();
  this->RangeScale = this->RangeScaleOf(defaults.NormScale);
  this->SpatialScale = sd::OpenSettings::SpatialProperty(defaults.SpatialScale);
  this->Radius = defaults.Radius;
}

vtkGuidedNormalFilter::~vtkGuidedNormalFilter() = default;

void vtkGuidedNormalFilter::Configure(sd::MeshDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  this->TakeRangeScale(this->RangeScale, settings.NormScale);
  this->Open->TakeSpatial("SpatialScale", this->SpatialScale, settings.SpatialScale);
  this->TakeRadius(this->Radius, settings.Radius);
}

void vtkGuidedNormalFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RangeScale: " << this->RangeScale << "\n";
  os << indent << "SpatialScale: " << this->SpatialScale << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
}
