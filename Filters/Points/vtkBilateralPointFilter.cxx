// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkBilateralPointFilter.h"

#include "Automatic/OpenSettings.h"
#include "Points/PointMethods.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkBilateralPointFilter);

vtkBilateralPointFilter::vtkBilateralPointFilter()
  : vtkPointNeighborhoodFilter(sd::PointMethod::BilateralPoint)
{
  const auto& operation = std::get<sd::TwoStageSettings>(this->Defaults().Operator);
  this->SpatialScale = operation.Points.SpatialScale;
  this->HeightScale = operation.Points.NormScale;
}

vtkBilateralPointFilter::~vtkBilateralPointFilter() = default;

void vtkBilateralPointFilter::Configure(sd::PointDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  auto& operation = std::get<sd::TwoStageSettings>(settings.Operator);
  this->Open->TakeSpatial("SpatialScale", this->SpatialScale, operation.Points.SpatialScale);
  this->Open->Tie(operation.Points.SpatialScale, operation.Normals.SpatialScale);
  this->Open->Take("HeightScale", this->HeightScale, operation.Points.NormScale, 1.0, 0.001);
  operation.NormalIterations = this->FitNormals ? 1 : 0;
}

void vtkBilateralPointFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SpatialScale: " << this->SpatialScale << "\n";
  os << indent << "HeightScale: " << this->HeightScale << "\n";
  os << indent << "FitNormals: " << this->FitNormals << "\n";
}
