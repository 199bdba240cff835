// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkFaceNormalFilter.h"

#include "MeshDenoising.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"

static_assert(static_cast<int>(SurfaceDenoising::FaceNeighborhood::Radius) ==
    static_cast<int>(vtkFaceNormalFilter::RADIUS),
  "The neighbourhoods of the filter are those of the core.");

vtkFaceNormalFilter::vtkFaceNormalFilter() = default;
vtkFaceNormalFilter::~vtkFaceNormalFilter() = default;

void vtkFaceNormalFilter::Configure(SurfaceDenoising::MeshDenoisingSettings& settings)
{
  settings.NormalIterations = this->NumberOfNormalIterations;
  if (!this->UpdateVertices)
  {
    settings.VertexIterations = 0;
  }
}

vtkDataArray* vtkFaceNormalFilter::FindStartNormals(vtkInformationVector** inputVector,
  bool& needed)
{
  vtkInformation* chosen = this->GetInputArrayInformation(0);
  const char* name =
    chosen->Has(vtkDataObject::FIELD_NAME()) ? chosen->Get(vtkDataObject::FIELD_NAME()) : "";
  // "None" is how ParaView says that nothing was chosen.
  needed = name[0] != '\0' && std::string(name) != "None";
  return needed ? this->GetInputArrayToProcess(0, inputVector) : nullptr;
}

void vtkFaceNormalFilter::TakeReport(const SurfaceDenoising::MeshDenoisingReport& report)
{
  this->Superclass::TakeReport(report);
  this->UsedRangeScale = report.NormScale;
  this->NumberOfUnfilteredFaces = static_cast<vtkIdType>(report.UnfilteredFaces);
}

void vtkFaceNormalFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfNormalIterations: " << this->NumberOfNormalIterations << "\n";
  os << indent << "UpdateVertices: " << this->UpdateVertices << "\n";
  os << indent << "UsedRangeScale: " << this->UsedRangeScale << "\n";
  os << indent << "NumberOfUnfilteredFaces: " << this->NumberOfUnfilteredFaces << "\n";
}
