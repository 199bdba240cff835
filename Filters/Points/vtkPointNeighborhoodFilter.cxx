// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPointNeighborhoodFilter.h"

#include "Automatic/OpenSettings.h"
#include "Points/PointMethods.h"

namespace sd = SurfaceDenoising;

static_assert(static_cast<int>(sd::PointNeighborhood::Radius) ==
    static_cast<int>(vtkPointNeighborhoodFilter::BALL),
  "The neighborhoods of the filter are those of the core.");

vtkPointNeighborhoodFilter::vtkPointNeighborhoodFilter(const sd::PointDenoisingSettings& defaults)
  : vtkPointDenoisingFilter(defaults)
{
  this->vtkPointNeighborhoodFilter::TakeSettings(this->Defaults());
}

vtkPointNeighborhoodFilter::vtkPointNeighborhoodFilter(sd::PointMethod method)
  : vtkPointNeighborhoodFilter(sd::SettingsOf(method))
{
}

vtkPointNeighborhoodFilter::~vtkPointNeighborhoodFilter() = default;

void vtkPointNeighborhoodFilter::TakeSettings(const sd::PointDenoisingSettings& settings)
{
  this->Superclass::TakeSettings(settings);
  this->Neighborhood = static_cast<int>(settings.Neighborhood.Kind);
  this->NumberOfNeighbors = settings.Neighborhood.Count;
  this->Radius = settings.Neighborhood.Radius;
  this->MaximumNumberOfNeighbors = settings.Neighborhood.MaximumCount;
  this->RenewNeighborhood = settings.RenewNeighborhood;
  this->LocalScale = settings.LocalScale;
}

void vtkPointNeighborhoodFilter::Configure(sd::PointDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  settings.Neighborhood.Kind = static_cast<sd::PointNeighborhood>(this->Neighborhood);
  if (this->Neighborhood == NEAREST)
  {
    this->Open->Take("NumberOfNeighbors", AtLeastThree(this->NumberOfNeighbors),
      settings.Neighborhood.Count, 6);
  }
  else
  {
    // Larger balls take minutes.
    this->Open->TakeRadius("Radius", this->Radius, settings.Neighborhood.Radius, 8.0);
  }
  settings.Neighborhood.MaximumCount = this->MaximumNumberOfNeighbors;
  settings.RenewNeighborhood = this->RenewNeighborhood;
  settings.LocalScale = this->LocalScale;
}

void vtkPointNeighborhoodFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Neighborhood: " << this->Neighborhood << "\n";
  os << indent << "NumberOfNeighbors: " << this->NumberOfNeighbors << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "MaximumNumberOfNeighbors: " << this->MaximumNumberOfNeighbors << "\n";
  os << indent << "RenewNeighborhood: " << this->RenewNeighborhood << "\n";
  os << indent << "LocalScale: " << this->LocalScale << "\n";
}
