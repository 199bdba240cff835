// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkMovingLeastSquaresFilter.h"

#include "Points/PointMethods.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkMovingLeastSquaresFilter);

vtkMovingLeastSquaresFilter::vtkMovingLeastSquaresFilter()
  : vtkPointNeighborhoodFilter(sd::PointMethod::MovingLeastSquares)
{
  const auto& operation = std::get<sd::MovingLeastSquaresSettings>(this->Defaults().Operator);
  this->Degree = operation.Degree;
  this->Bandwidth = operation.Bandwidth;
  this->NumberOfPlaneFits = operation.PlaneRounds;
}

vtkMovingLeastSquaresFilter::~vtkMovingLeastSquaresFilter() = default;

void vtkMovingLeastSquaresFilter::Configure(sd::PointDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  auto& operation = std::get<sd::MovingLeastSquaresSettings>(settings.Operator);
  operation.Degree = this->Degree;
  operation.Bandwidth = this->Bandwidth;
  operation.PlaneRounds = this->NumberOfPlaneFits;
}

void vtkMovingLeastSquaresFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Degree: " << this->Degree << "\n";
  os << indent << "Bandwidth: " << this->Bandwidth << "\n";
  os << indent << "NumberOfPlaneFits: " << this->NumberOfPlaneFits << "\n";
}
