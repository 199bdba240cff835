// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGuidedNormalFilter.h"

#include "Methods.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkGuidedNormalFilter);

vtkGuidedNormalFilter::vtkGuidedNormalFilter()
  : vtkFaceNormalFilter(sd::Method::GuidedNormal)
{
  const sd::MeshDenoisingSettings& defaults = this->Defaults();
  this->RangeScale = this->RangeScaleOf(defaults.NormScale);
  this->SpatialScale = defaults.SpatialScale;
  this->Radius = defaults.Radius;
}

vtkGuidedNormalFilter::~vtkGuidedNormalFilter() = default;

void vtkGuidedNormalFilter::Configure(sd::MeshDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  settings.NormScale = this->NormScaleOf(this->RangeScale);
  settings.SpatialScale = this->SpatialScale;
  settings.Radius = this->Radius;
}

void vtkGuidedNormalFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RangeScale: " << this->RangeScale << "\n";
  os << indent << "SpatialScale: " << this->SpatialScale << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
}
