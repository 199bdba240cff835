// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkBilateralNormalFilter.h"

#include "Automatic/OpenSettings.h"
#include "Methods.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkBilateralNormalFilter);

vtkBilateralNormalFilter::vtkBilateralNormalFilter()
  : vtkFaceNormalFilter(sd::Method::BilateralNormal)
{
  const sd::MeshDenoisingSettings& defaults = this->Defaults();
  this->RangeScale = this->RangeScaleOf(defaults.NormScale);
  this->SpatialScale = sd::OpenSettings::SpatialProperty(defaults.SpatialScale);
  this->Neighborhood = static_cast<int>(defaults.Neighborhood);
  this->Fidelity = defaults.Global.Fidelity;
  this->AreaEnergy = defaults.Global.AreaEnergy;
}

vtkBilateralNormalFilter::~vtkBilateralNormalFilter() = default;

const sd::MeshDenoisingSettings& vtkBilateralNormalFilter::Defaults() const
{
  return this->Scheme == GLOBAL ? sd::SettingsOf(sd::Method::GlobalBilateralNormal)
                                : this->Superclass::Defaults();
}

void vtkBilateralNormalFilter::Configure(sd::MeshDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  if (this->Scheme == GLOBAL)
  {
    this->Open->Close("NumberOfNormalIterations");
    settings.NormalIterations = this->NumberOfNormalIterations >= 0 ? 1 : 0;
    settings.Global.Fidelity = this->Fidelity;
    settings.Global.AreaEnergy = this->AreaEnergy;
  }
  this->TakeRangeScale(this->RangeScale, settings.NormScale);
  this->Open->TakeSpatial("SpatialScale", this->SpatialScale, settings.SpatialScale);
  settings.Neighborhood = static_cast<sd::FaceNeighborhood>(this->Neighborhood);
}

void vtkBilateralNormalFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scheme: " << this->Scheme << "\n";
  os << indent << "RangeScale: " << this->RangeScale << "\n";
  os << indent << "SpatialScale: " << this->SpatialScale << "\n";
  os << indent << "Neighborhood: " << this->Neighborhood << "\n";
  os << indent << "Fidelity: " << this->Fidelity << "\n";
  os << indent << "AreaEnergy: " << this->AreaEnergy << "\n";
}
