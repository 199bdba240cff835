// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkOneStageFilter.h"

#include "PreparedMesh.h"
#include "SurfaceWork.h"

#include <cmath>

vtkOneStageFilter::vtkOneStageFilter() = default;
vtkOneStageFilter::~vtkOneStageFilter() = default;

vtkMeshDenoisingFilter::Outcome vtkOneStageFilter::Denoise(SurfaceDenoising::SurfaceWork& work)
{
  SurfaceDenoising::PreparedMesh prepared(work.View.Mesh);
  if (!prepared.Prepare(work.Exec))
  {
    return STOPPED;
  }
  this->TakeFacts(prepared.Facts(), &work);
  const Outcome outcome = this->Move(prepared, work);
  prepared.Finish();
  return outcome;
}

bool vtkOneStageFilter::CheckPositive(const char* name, double value)
{
  if (value > 0.0 && std::isfinite(value))
  {
    return true;
  }
  vtkErrorMacro(<< name << " must be positive, not " << value << ".");
  return false;
}

void vtkOneStageFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FixBoundary: " << this->FixBoundary << "\n";
}
