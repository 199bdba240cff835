// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTensorPointFilter.h"

#include "Automatic/OpenSettings.h"
#include "Points/PointMethods.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkTensorPointFilter);

vtkTensorPointFilter::vtkTensorPointFilter()
  : vtkPointNeighborhoodFilter(sd::PointMethod::TensorPoint)
{
  const auto& operation = std::get<sd::TensorRegionsSettings>(this->Defaults().Operator);
  this->Range = operation.Range;
  this->BendFactor = operation.BendFactor;
  this->FeatureThreshold = operation.FeatureThreshold;
  this->FeatureContrast = operation.FeatureContrast;
  this->RegionThreshold = operation.RegionThreshold;
  this->MinimumRegionSize = operation.LeastMembers;
  this->QuadricAtFeatures = operation.QuadricAtFeatures;
}

vtkTensorPointFilter::~vtkTensorPointFilter() = default;

void vtkTensorPointFilter::Configure(sd::PointDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  auto& operation = std::get<sd::TensorRegionsSettings>(settings.Operator);
  this->Open->Take("Range", this->Range, operation.Range, 1.0, 0.1);
  operation.BendFactor = this->BendFactor;
  operation.FeatureThreshold = this->FeatureThreshold;
  operation.FeatureContrast = this->FeatureContrast;
  operation.RegionThreshold = this->RegionThreshold;
  operation.LeastMembers = this->MinimumRegionSize;
  operation.QuadricAtFeatures = this->QuadricAtFeatures;
}

void vtkTensorPointFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Range: " << this->Range << "\n";
  os << indent << "BendFactor: " << this->BendFactor << "\n";
  os << indent << "FeatureThreshold: " << this->FeatureThreshold << "\n";
  os << indent << "FeatureContrast: " << this->FeatureContrast << "\n";
  os << indent << "RegionThreshold: " << this->RegionThreshold << "\n";
  os << indent << "MinimumRegionSize: " << this->MinimumRegionSize << "\n";
  os << indent << "QuadricAtFeatures: " << this->QuadricAtFeatures << "\n";
}
