// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkRobustNormalFilter.h"

#include "MeshDenoising.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkRobustNormalFilter);

static_assert(sd::NumberOfNorms == vtkRobustNormalFilter::CENTIN + 1,
  "The norms of the filter are those of the core.");
static_assert(static_cast<int>(sd::NormalArgument::DirectionalCurvature) ==
    static_cast<int>(vtkRobustNormalFilter::DIRECTIONAL_CURVATURE),
  "The arguments of the filter are those of the core.");

vtkRobustNormalFilter::vtkRobustNormalFilter() = default;
vtkRobustNormalFilter::~vtkRobustNormalFilter() = default;

int vtkRobustNormalFilter::GetNumberOfNorms() { return sd::NumberOfNorms; }

const char* vtkRobustNormalFilter::GetNormName(int norm)
{
  return norm >= 0 && norm < sd::NumberOfNorms
    ? sd::NameOf(sd::MakeErrorNorm(static_cast<sd::NormId>(norm), 1.0))
    : nullptr;
}

double vtkRobustNormalFilter::ArgumentUnit() const
{
  return this->Argument == CHORD ? 1.0 : vtkMath::RadiansFromDegrees(1.0);
}

int vtkRobustNormalFilter::RequestData(vtkInformation* request, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  if (this->ScaleSource == GIVEN && !(this->RangeScale > 0.0))
  {
    vtkErrorMacro(<< "The range scale must be positive; it is " << this->RangeScale << ".");
    return 0;
  }
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

void vtkRobustNormalFilter::Configure(sd::MeshDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  settings.Norm = static_cast<sd::NormId>(this->Norm);
  settings.Argument = static_cast<sd::NormalArgument>(this->Argument);
  settings.NormScale = 0.0;
  switch (this->ScaleSource)
  {
    case DATA_MAD:
      settings.Estimator = sd::ScaleEstimator::MedianAbsoluteDeviation;
      break;
    case DATA_RAYLEIGH:
      settings.Estimator = sd::ScaleEstimator::Rayleigh;
      break;
    case DATA_HALF_NORMAL:
      settings.Estimator = sd::ScaleEstimator::HalfNormal;
      break;
    default:
      settings.NormScale = this->RangeScale * this->ArgumentUnit();
  }
  settings.SpatialScale = this->SpatialScale;
  settings.Weighting = this->AreaWeighting ? sd::SiteWeight::Area : sd::SiteWeight::Uniform;
  settings.IncludeOwn = this->IncludeOwn;
  settings.Neighborhood = static_cast<sd::FaceNeighborhood>(this->Neighborhood);
  settings.Radius = this->Radius;
  settings.Data = static_cast<sd::NormalData>(this->DataSource);
  settings.OuterIterations = this->Schedule == ALTERNATING ? this->NumberOfOuterIterations : 1;
}

void vtkRobustNormalFilter::TakeReport(const sd::MeshDenoisingReport& report)
{
  this->Superclass::TakeReport(report);
  this->UsedRangeScale = report.NormScale / this->ArgumentUnit();
}

void vtkRobustNormalFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Norm: " << vtkRobustNormalFilter::GetNormName(this->Norm) << "\n";
  os << indent << "Argument: " << this->Argument << "\n";
  os << indent << "ScaleSource: " << this->ScaleSource << "\n";
  os << indent << "RangeScale: " << this->RangeScale << "\n";
  os << indent << "SpatialScale: " << this->SpatialScale << "\n";
  os << indent << "AreaWeighting: " << this->AreaWeighting << "\n";
  os << indent << "IncludeOwn: " << this->IncludeOwn << "\n";
  os << indent << "Neighborhood: " << this->Neighborhood << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "DataSource: " << this->DataSource << "\n";
  os << indent << "Schedule: " << this->Schedule << "\n";
  os << indent << "NumberOfOuterIterations: " << this->NumberOfOuterIterations << "\n";
}
