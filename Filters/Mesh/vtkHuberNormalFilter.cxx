// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHuberNormalFilter.h"

#include "Automatic/OpenSettings.h"
#include "Methods.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkHuberNormalFilter);

vtkHuberNormalFilter::vtkHuberNormalFilter()
  : vtkFaceNormalFilter(sd::Method::HuberNormal)
{
  const sd::MeshDenoisingSettings& defaults = this->Defaults();
  this->RangeScale = this->RangeScaleOf(defaults.NormScale);
  this->SpatialScale = sd::OpenSettings::SpatialProperty(defaults.SpatialScale);
  this->DataSource = static_cast<int>(defaults.Data);
}

vtkHuberNormalFilter::~vtkHuberNormalFilter() = default;

void vtkHuberNormalFilter::Configure(sd::MeshDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  this->TakeRangeScale(this->RangeScale, settings.NormScale);
  this->Open->TakeSpatial("SpatialScale", this->SpatialScale, settings.SpatialScale);
  settings.Data = static_cast<sd::NormalData>(this->DataSource);
}

void vtkHuberNormalFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RangeScale: " << this->RangeScale << "\n";
  os << indent << "SpatialScale: " << this->SpatialScale << "\n";
  os << indent << "DataSource: " << this->DataSource << "\n";
}
