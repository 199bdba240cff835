// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkMeanNormalFilter.h"

#include "Methods.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkMeanNormalFilter);

vtkMeanNormalFilter::vtkMeanNormalFilter()
  : vtkFaceNormalFilter(sd::Method::MeanNormal)
{
  const sd::MeshDenoisingSettings& defaults = this->Defaults();
  this->IncludeOwn = defaults.IncludeOwn;
}

vtkMeanNormalFilter::~vtkMeanNormalFilter() = default;

void vtkMeanNormalFilter::Configure(sd::MeshDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  settings.IncludeOwn = this->IncludeOwn;
}

void vtkMeanNormalFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IncludeOwn: " << this->IncludeOwn << "\n";
}
