// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkBilateralVertexFilter.h"

#include "Automatic/OpenSettings.h"
#include "OneStage/BilateralVertices.h"
#include "PreparedMesh.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkBilateralVertexFilter);

vtkBilateralVertexFilter::vtkBilateralVertexFilter() = default;
vtkBilateralVertexFilter::~vtkBilateralVertexFilter() = default;

vtkOneStageFilter::Method vtkBilateralVertexFilter::Configure()
{
  if (!this->CheckScale("SpatialScale", this->SpatialScale) ||
    !this->CheckScale("RangeScale", this->RangeScale))
  {
    return nullptr;
  }
  const auto settings = std::make_shared<sd::BilateralVerticesSettings>();
  this->Open->Take("NumberOfIterations", this->NumberOfIterations, settings->Iterations);
  this->Open->TakeRadius("SpatialScale", this->SpatialScale, settings->SpatialScale, 3.0);
  this->Open->Take("RangeScale", this->RangeScale, settings->RangeScale);
  settings->FixBoundary = this->FixBoundary;
  return [settings](sd::PreparedMesh& prepared, sd::Execution& execution)
  { return sd::FilterVerticesBilaterally(prepared, *settings, execution); };
}

void vtkBilateralVertexFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfIterations: " << this->NumberOfIterations << "\n";
  os << indent << "SpatialScale: " << this->SpatialScale << "\n";
  os << indent << "RangeScale: " << this->RangeScale << "\n";
}
