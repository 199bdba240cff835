// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkFuzzyVectorMedianNormalFilter.h"

#include "Methods.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkFuzzyVectorMedianNormalFilter);

vtkFuzzyVectorMedianNormalFilter::vtkFuzzyVectorMedianNormalFilter()
  : vtkFaceNormalFilter(sd::Method::FuzzyVectorMedian)
{
  const sd::MeshDenoisingSettings& defaults = this->Defaults();
  this->RangeScale = this->RangeScaleOf(defaults.NormScale);
}

vtkFuzzyVectorMedianNormalFilter::~vtkFuzzyVectorMedianNormalFilter() = default;

double vtkFuzzyVectorMedianNormalFilter::RangeUnit() const { return std::sqrt(0.5); }

void vtkFuzzyVectorMedianNormalFilter::Configure(sd::MeshDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  this->TakeRangeScale(this->RangeScale, settings.NormScale);
  settings.Weighting = this->AreaWeighting ? sd::SiteWeight::Area : sd::SiteWeight::Uniform;
}

void vtkFuzzyVectorMedianNormalFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RangeScale: " << this->RangeScale << "\n";
  os << indent << "AreaWeighting: " << this->AreaWeighting << "\n";
}
