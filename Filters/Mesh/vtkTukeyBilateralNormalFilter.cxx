// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTukeyBilateralNormalFilter.h"

#include "Automatic/OpenSettings.h"
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
  this->SpatialScale = sd::OpenSettings::SpatialProperty(defaults.SpatialScale);
  this->Radius = defaults.Radius;
}

vtkTukeyBilateralNormalFilter::~vtkTukeyBilateralNormalFilter() = default;

void vtkTukeyBilateralNormalFilter::Configure(sd::MeshDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  this->TakeRangeScale(this->RangeScale, settings.NormScale);
  this->Open->TakeSpatial("SpatialScale", this->SpatialScale, settings.SpatialScale);
  this->TakeRadius(this->Radius, settings.Radius);
}

vtkMeshDenoisingFilter::Outcome vtkTukeyBilateralNormalFilter::Denoise(sd::SurfaceWork& work)
{
  if (!this->AsReleased)
  {
    return this->Superclass::Denoise(work);
  }
  if (!(this->RangeScale > 0.0) || this->NumberOfOuterIterations == 0)
  {
    vtkErrorMacro(<< "The released program takes nothing from the data: RangeScale and "
                     "NumberOfOuterIterations must not be 0.");
    return FAILED;
  }
  sd::MeshFacts facts;
  const bool finished = sd::DenoiseAsReleased(work.View.Mesh, work.FaceNormals,
    { this->RangeScale, this->Relaxation, std::max(0, this->NumberOfOuterIterations) }, facts,
    work.Exec);
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
