// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkBilateralVertexFilter.h"

#include "OneStage/BilateralVertices.h"
#include "SurfaceWork.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkBilateralVertexFilter);

vtkBilateralVertexFilter::vtkBilateralVertexFilter() = default;
vtkBilateralVertexFilter::~vtkBilateralVertexFilter() = default;

vtkMeshDenoisingFilter::Outcome vtkBilateralVertexFilter::Move(sd::PreparedMesh& prepared,
  sd::SurfaceWork& work)
{
  if (!this->CheckPositive("SpatialScale", this->SpatialScale) ||
    !this->CheckPositive("RangeScale", this->RangeScale))
  {
    return FAILED;
  }
  sd::BilateralVerticesSettings settings;
  settings.Iterations = this->NumberOfIterations;
  settings.SpatialScale = this->SpatialScale;
  settings.RangeScale = this->RangeScale;
  settings.FixBoundary = this->FixBoundary;
  return sd::FilterVerticesBilaterally(prepared, settings, work.Exec) ? FINISHED : STOPPED;
}

void vtkBilateralVertexFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfIterations: " << this->NumberOfIterations << "\n";
  os << indent << "SpatialScale: " << this->SpatialScale << "\n";
  os << indent << "RangeScale: " << this->RangeScale << "\n";
}
