// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkRollingPointNormalFilter.h"

#include "Automatic/OpenSettings.h"
#include "Points/PointMethods.h"

#include "vtkObjectFactory.h"

#include <cmath>

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkRollingPointNormalFilter);

namespace
{

/// exp(-x^2 / s^2), as the paper writes it, is the exp(-x^2 / (2 sigma^2)) of the core with s =
/// sqrt(2) sigma.
const double ScaleOfSigma = std::sqrt(2.0);

}

vtkRollingPointNormalFilter::vtkRollingPointNormalFilter()
  : vtkPointNeighborhoodFilter(sd::PointMethod::RollingPointNormal)
{
  const auto& operation = std::get<sd::TwoStageSettings>(this->Defaults().Operator);
  this->RangeScale = Rounded(operation.Normals.NormScale * ScaleOfSigma);
  this->SpatialScale = Rounded(operation.Normals.SpatialScale * ScaleOfSigma);
  this->NumberOfRolls = operation.NormalIterations;
  this->NumberOfPointIterations = operation.PointIterations;
  this->UnorientedNormals = operation.Unoriented;
}

vtkRollingPointNormalFilter::~vtkRollingPointNormalFilter() = default;

void vtkRollingPointNormalFilter::Configure(sd::PointDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  auto& operation = std::get<sd::TwoStageSettings>(settings.Operator);
  this->Open->Take("NumberOfRolls", this->NumberOfRolls, operation.NormalIterations);
  this->Open->Take("NumberOfPointIterations", this->NumberOfPointIterations,
    operation.PointIterations);
  this->Open->Take("RangeScale", this->RangeScale, operation.Normals.NormScale, 1.0 / ScaleOfSigma,
    0.01 / ScaleOfSigma);
  this->Open->Tie(operation.Normals.NormScale, operation.Points.NormScale);
  this->Open->Take("SpatialScale", this->SpatialScale, operation.Normals.SpatialScale,
    1.0 / ScaleOfSigma, 0.1 / ScaleOfSigma);
  this->Open->Tie(operation.Normals.SpatialScale, operation.Points.SpatialScale);
  operation.Unoriented = this->UnorientedNormals;
}

void vtkRollingPointNormalFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RangeScale: " << this->RangeScale << "\n";
  os << indent << "SpatialScale: " << this->SpatialScale << "\n";
  os << indent << "NumberOfRolls: " << this->NumberOfRolls << "\n";
  os << indent << "NumberOfPointIterations: " << this->NumberOfPointIterations << "\n";
  os << indent << "UnorientedNormals: " << this->UnorientedNormals << "\n";
}
