// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkNormalDiffusionFilter.h"

#include "Methods.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkNormalDiffusionFilter);

vtkNormalDiffusionFilter::vtkNormalDiffusionFilter()
  : vtkFaceNormalFilter(sd::Method::NormalDiffusion)
{
  const sd::MeshDenoisingSettings& defaults = this->Defaults();
  this->RangeScale = this->RangeScaleOf(defaults.NormScale);
  this->Neighborhood = static_cast<int>(defaults.Neighborhood);
  this->IncludeOwn = defaults.IncludeOwn;
}

vtkNormalDiffusionFilter::~vtkNormalDiffusionFilter() = default;

double vtkNormalDiffusionFilter::RangeUnit() const
{
  return vtkMath::RadiansFromDegrees(1.0) * std::sqrt(0.5);
}

void vtkNormalDiffusionFilter::Configure(sd::MeshDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  this->TakeRangeScale(this->RangeScale, settings.NormScale);
  settings.Neighborhood = static_cast<sd::FaceNeighborhood>(this->Neighborhood);
  settings.IncludeOwn = this->IncludeOwn;
}

void vtkNormalDiffusionFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RangeScale: " << this->RangeScale << "\n";
  os << indent << "Neighborhood: " << this->Neighborhood << "\n";
  os << indent << "IncludeOwn: " << this->IncludeOwn << "\n";
}
