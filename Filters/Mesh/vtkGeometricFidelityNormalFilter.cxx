// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGeometricFidelityNormalFilter.h"

#include "Methods.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkGeometricFidelityNormalFilter);

vtkGeometricFidelityNormalFilter::vtkGeometricFidelityNormalFilter()
  : vtkFaceNormalFilter(sd::Method::GeometricFidelity)
{
  const sd::MeshDenoisingSettings& defaults = this->Defaults();
  this->RangeScale = this->RangeScaleOf(defaults.NormScale);
  this->StepLength = defaults.StepLength;
}

vtkGeometricFidelityNormalFilter::~vtkGeometricFidelityNormalFilter() = default;

void vtkGeometricFidelityNormalFilter::Configure(sd::MeshDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  this->TakeRangeScale(this->RangeScale, settings.NormScale);
  settings.StepLength = this->StepLength;
  settings.Vertices.InputPull = this->FidelityWeight;
  if (this->CurvatureType == EDGE)
  {
    settings.Argument = sd::NormalArgument::DirectionalCurvature;
  }
}

void vtkGeometricFidelityNormalFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RangeScale: " << this->RangeScale << "\n";
  os << indent << "CurvatureType: " << this->CurvatureType << "\n";
  os << indent << "StepLength: " << this->StepLength << "\n";
  os << indent << "FidelityWeight: " << this->FidelityWeight << "\n";
}
