// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkBilateralNormalFilter.h"

#include "MeshDenoising.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBilateralNormalFilter);

vtkBilateralNormalFilter::vtkBilateralNormalFilter() = default;
vtkBilateralNormalFilter::~vtkBilateralNormalFilter() = default;

void vtkBilateralNormalFilter::Configure(SurfaceDenoising::MeshDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  settings.Norm = SurfaceDenoising::NormId::Gaussian;
  settings.NormScale = this->RangeScale;
  settings.Argument = SurfaceDenoising::NormalArgument::Chord;
  settings.SpatialScale = this->SpatialScale;
  settings.IncludeOwn = false;
  settings.Neighborhood = static_cast<SurfaceDenoising::FaceNeighborhood>(this->Neighborhood);
}

void vtkBilateralNormalFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RangeScale: " << this->RangeScale << "\n";
  os << indent << "SpatialScale: " << this->SpatialScale << "\n";
  os << indent << "Neighborhood: " << this->Neighborhood << "\n";
}
