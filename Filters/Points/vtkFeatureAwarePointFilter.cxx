// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkFeatureAwarePointFilter.h"

#include "Points/PointMethods.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkFeatureAwarePointFilter);

static_assert(static_cast<int>(sd::PointScheme::BalancedHeight) ==
    static_cast<int>(vtkFeatureAwarePointFilter::BALANCED_HEIGHT),
  "The height modes of the filter are those of the core.");

vtkFeatureAwarePointFilter::vtkFeatureAwarePointFilter()
  : vtkPointNeighborhoodFilter(sd::PointMethod::FeatureAwarePoint)
{
  const auto& operation = std::get<sd::LikelihoodPointsSettings>(this->Defaults().Operator);
  this->FeatureSharpening = operation.FeatureSharpening;
  this->HeightMode = static_cast<int>(operation.Scheme);
  this->LeastAngle = Rounded(vtkMath::DegreesFromRadians(operation.LeastAngle));
  this->LikelihoodInNormals = operation.LikelihoodInNormals;
}

vtkFeatureAwarePointFilter::~vtkFeatureAwarePointFilter() = default;

void vtkFeatureAwarePointFilter::Configure(sd::PointDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  auto& operation = std::get<sd::LikelihoodPointsSettings>(settings.Operator);
  operation.FeatureSharpening = this->FeatureSharpening;
  operation.Scheme = static_cast<sd::PointScheme>(this->HeightMode);
  operation.LeastAngle = vtkMath::RadiansFromDegrees(this->LeastAngle);
  operation.LikelihoodInNormals = this->LikelihoodInNormals;
}

void vtkFeatureAwarePointFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FeatureSharpening: " << this->FeatureSharpening << "\n";
  os << indent << "HeightMode: " << this->HeightMode << "\n";
  os << indent << "LeastAngle: " << this->LeastAngle << "\n";
  os << indent << "LikelihoodInNormals: " << this->LikelihoodInNormals << "\n";
}
