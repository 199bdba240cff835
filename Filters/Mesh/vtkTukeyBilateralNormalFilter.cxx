// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTukeyBilateralNormalFilter.h"

#include "Methods.h"
#include "ReleasedTukeyBilateral.h"
#include "SurfaceWork.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkTukeyBilateralNormalFilter);

vtkTukeyBilateralNormalFilter::vtkTukeyBilateralNormalFilter()
  : vtkFaceNormalFilter(sd::Method::TukeyBilateralNormal)
{
  const sd::MeshDenoisingSettings& defaults = this->Defaults();
  this->RangeScale = this->RangeScaleOf(defaults.NormScale);
  this->SpatialScale = defaults.SpatialScale;
  this->Radius = defaults.Radius;
}

vtkTukeyBilateralNormalFilter::~vtkTukeyBilateralNormalFilter() = default;

void vtkTukeyBilateralNormalFilter::Configure(sd::MeshDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  settings.NormScale = this->NormScaleOf(this->RangeScale);
  settings.SpatialScale = this->SpatialScale;
  settings.Radius = this->Radius;
}

vtkMeshDenoisingFilter::Outcome vtkTukeyBilateralNormalFilter::Denoise(sd::SurfaceWork& work)
{
  if (!this->AsReleased)
  {
    return this->Superclass::Denoise(work);
  }
  sd::MeshFacts facts;
  const bool finished = sd::DenoiseAsReleased(work.View.Mesh, work.FaceNormals,
    { this->RangeScale, this->Relaxation, this->NumberOfOuterIterations }, facts, work.Exec);
  this->TakeFacts(facts, &work);
  return finished ? FINISHED : STOPPED;
}

void vtkTukeyBilateralNormalFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RangeScale: " << this->RangeScale << "\n";
  os << indent << "SpatialScale: " << this->SpatialScale << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "AsReleased: " << this->AsReleased << "\n";
}
