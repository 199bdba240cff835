// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkMedianNormalFilter.h"

#include "Methods.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkMedianNormalFilter);

vtkMedianNormalFilter::vtkMedianNormalFilter()
  : vtkFaceNormalFilter(sd::Method::MedianNormal)
{
}

vtkMedianNormalFilter::~vtkMedianNormalFilter() = default;

void vtkMedianNormalFilter::Configure(sd::MeshDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  switch (this->MedianType)
  {
    case WEIGHTED:
      settings.Repetitions = { this->EdgeRepetitions, this->VertexRepetitions };
      break;
    case DIRECTIONAL:
      settings.Median = sd::MedianKind::Directional;
      break;
    case GEOMETRIC:
      settings.Operator = sd::NormalOperator::Average;
      settings.Data = sd::NormalData::Original;
      settings.Norm = sd::NormId::L1;
      settings.NormScale = this->Regularization;
      break;
    default:
      break;
  }
}

void vtkMedianNormalFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MedianType: " << this->MedianType << "\n";
  os << indent << "EdgeRepetitions: " << this->EdgeRepetitions << "\n";
  os << indent << "VertexRepetitions: " << this->VertexRepetitions << "\n";
  os << indent << "Regularization: " << this->Regularization << "\n";
}
