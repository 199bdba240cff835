// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkRobustImplicitMLSFilter.h"

#include "Automatic/OpenSettings.h"
#include "Points/PointMethods.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkRobustImplicitMLSFilter);

vtkRobustImplicitMLSFilter::vtkRobustImplicitMLSFilter()
  : vtkPointDenoisingFilter(sd::PointMethod::RobustImplicitMLS)
{
  const auto& operation = std::get<sd::RobustImplicitMLSSettings>(this->Defaults().Operator);
  this->FilterScale = operation.FilterScale;
  this->NormalScale = operation.NormalScale;
  this->ResidualScale = operation.ResidualScale;
  this->MaximumNumberOfFits = operation.MaximumFits;
  this->MaximumNumberOfProjections = operation.MaximumProjections;
  this->UnorientedNormals = operation.Unoriented;
}

vtkRobustImplicitMLSFilter::~vtkRobustImplicitMLSFilter() = default;

void vtkRobustImplicitMLSFilter::Configure(sd::PointDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  auto& operation = std::get<sd::RobustImplicitMLSSettings>(settings.Operator);
  this->Open->Take("FilterScale", this->FilterScale, operation.FilterScale, 1.0, 0.5);
  this->Open->Take("NormalScale", this->NormalScale, operation.NormalScale, 1.0, 0.01);
  operation.ResidualScale = this->ResidualScale;
  operation.MaximumFits = this->MaximumNumberOfFits;
  operation.MaximumProjections = this->MaximumNumberOfProjections;
  operation.Unoriented = this->UnorientedNormals;
}

void vtkRobustImplicitMLSFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FilterScale: " << this->FilterScale << "\n";
  os << indent << "NormalScale: " << this->NormalScale << "\n";
  os << indent << "ResidualScale: " << this->ResidualScale << "\n";
  os << indent << "MaximumNumberOfFits: " << this->MaximumNumberOfFits << "\n";
  os << indent << "MaximumNumberOfProjections: " << this->MaximumNumberOfProjections << "\n";
  os << indent << "UnorientedNormals: " << this->UnorientedNormals << "\n";
}
