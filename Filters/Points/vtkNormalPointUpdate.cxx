// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkNormalPointUpdate.h"

#include "Automatic/OpenSettings.h"
#include "Points/PointMethods.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkNormalPointUpdate);

vtkNormalPointUpdate::vtkNormalPointUpdate()
  : vtkPointFittingFilter(sd::ComposedPoints())
{
  this->NormalSource = INPUT;
}

vtkNormalPointUpdate::~vtkNormalPointUpdate() = default;

void vtkNormalPointUpdate::Configure(sd::PointDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  std::get<sd::TwoStageSettings>(settings.Operator).NormalIterations = 0;
}

void vtkNormalPointUpdate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
