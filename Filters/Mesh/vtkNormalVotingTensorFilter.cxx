// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkNormalVotingTensorFilter.h"

#include "Automatic/OpenSettings.h"
#include "Methods.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkNormalVotingTensorFilter);

vtkNormalVotingTensorFilter::vtkNormalVotingTensorFilter()
  : vtkFaceNormalFilter(sd::Method::NormalVotingTensor)
{
  const sd::MeshDenoisingSettings& defaults = this->Defaults();
  this->RangeScale = this->RangeScaleOf(defaults.NormScale);
  this->Radius = defaults.Radius;
  this->TensorThreshold = defaults.Tensor.Threshold;
  this->Damping = defaults.Tensor.Damping;
  this->RotateVotes = defaults.Tensor.RotateVotes;
}

vtkNormalVotingTensorFilter::~vtkNormalVotingTensorFilter() = default;

double vtkNormalVotingTensorFilter::RangeUnit() const { return vtkMath::RadiansFromDegrees(1.0); }

void vtkNormalVotingTensorFilter::Configure(sd::MeshDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  this->TakeRangeScale(this->RangeScale, settings.NormScale);
  this->TakeRadius(this->Radius, settings.Radius);
  settings.Tensor = { this->TensorThreshold, this->Damping, this->RotateVotes };
}

void vtkNormalVotingTensorFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RangeScale: " << this->RangeScale << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "TensorThreshold: " << this->TensorThreshold << "\n";
  os << indent << "Damping: " << this->Damping << "\n";
  os << indent << "RotateVotes: " << this->RotateVotes << "\n";
}
