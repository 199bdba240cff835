// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkMovingRobustPCAFilter.h"

#include "Automatic/OpenSettings.h"
#include "Points/PointMethods.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkMovingRobustPCAFilter);

vtkMovingRobustPCAFilter::vtkMovingRobustPCAFilter()
  : vtkPointNeighborhoodFilter(sd::PointMethod::MovingRobustPCA)
{
  const auto& operation = std::get<sd::MovingRobustPCASettings>(this->Defaults().Operator);
  this->NormalAngle = Rounded(vtkMath::DegreesFromRadians(operation.NormalAngle));
  this->DataFidelity = operation.Fidelity;
  this->NumberOfRobustFits = operation.Rounds;
}

vtkMovingRobustPCAFilter::~vtkMovingRobustPCAFilter() = default;

void vtkMovingRobustPCAFilter::Configure(sd::PointDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  auto& operation = std::get<sd::MovingRobustPCASettings>(settings.Operator);
  const double degree = vtkMath::RadiansFromDegrees(1.0);
  this->Open->Take("NormalAngle", this->NormalAngle, operation.NormalAngle, degree, degree);
  operation.Fidelity = this->DataFidelity;
  operation.Rounds = this->NumberOfRobustFits;
}

void vtkMovingRobustPCAFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NormalAngle: " << this->NormalAngle << "\n";
  os << indent << "DataFidelity: " << this->DataFidelity << "\n";
  os << indent << "NumberOfRobustFits: " << this->NumberOfRobustFits << "\n";
}
