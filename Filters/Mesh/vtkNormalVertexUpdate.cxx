// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkNormalVertexUpdate.h"

#include "MeshDenoising.h"

#include "vtkDataObject.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkNormalVertexUpdate);

vtkNormalVertexUpdate::vtkNormalVertexUpdate()
{
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "FilteredNormals");
}

vtkNormalVertexUpdate::~vtkNormalVertexUpdate() = default;

void vtkNormalVertexUpdate::Configure(SurfaceDenoising::MeshDenoisingSettings& settings)
{
  settings.NormalIterations = 0;
  settings.VertexIterations = std::max(0, this->NumberOfVertexIterations);
  if (this->NumberOfVertexIterations == 0)
  {
    settings.VertexIterations = 200;
    settings.Vertices.Rest = 0.01;
  }
}

void vtkNormalVertexUpdate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
