// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkOneStageFilter.h"

#include "Automatic/OpenSettings.h"
#include "Automatic/ProgressShare.h"
#include "PreparedMesh.h"
#include "SurfaceWork.h"

#include <cmath>

namespace sd = SurfaceDenoising;

vtkOneStageFilter::vtkOneStageFilter() = default;
vtkOneStageFilter::~vtkOneStageFilter() = default;

vtkMeshDenoisingFilter::Outcome vtkOneStageFilter::Denoise(sd::SurfaceWork& work)
{
  const Method method = this->Configure();
  if (!method)
  {
    return FAILED;
  }
  bool noisy = true;
  if (this->Open->Any() &&
    this->ChooseSettings(
      work,
      [&](sd::TriangleMesh& mesh, sd::Execution& execution)
      {
        sd::PreparedMesh trial(mesh);
        const bool finished = trial.Prepare(execution) && method(trial, execution);
        trial.Finish();
        return finished;
      },
      noisy) == STOPPED)
  {
    return STOPPED;
  }
  sd::PreparedMesh prepared(work.View.Mesh);
  if (!prepared.Prepare(work.Exec))
  {
    return STOPPED;
  }
  this->TakeFacts(prepared.Facts(), &work);
  sd::ProgressShare share(work.Exec, this->Open->Any() ? 0.5 : 0.0, 1.0);
  const bool finished = !noisy || method(prepared, share);
  prepared.Finish();
  if (finished && noisy)
  {
    this->Tell(work);
  }
  return finished ? FINISHED : STOPPED;
}

void vtkOneStageFilter::Tell(sd::SurfaceWork&) {}

bool vtkOneStageFilter::CheckScale(const char* name, double value)
{
  if (value >= 0.0 && std::isfinite(value))
  {
    return true;
  }
  vtkErrorMacro(<< name << " must not be negative or infinite; it is " << value << ".");
  return false;
}

void vtkOneStageFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FixBoundary: " << this->FixBoundary << "\n";
}
