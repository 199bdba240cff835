// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkMeshDenoisingFilter.h"

#include "MeshDenoising.h"
#include "SMPExecution.h"
#include "SurfaceAdapter.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace sd = SurfaceDenoising;

static_assert(static_cast<int>(sd::VertexScheme::IntegralFit) ==
    static_cast<int>(vtkMeshDenoisingFilter::INTEGRAL_FIT),
  "The vertex schemes of the filter are those of the core.");
static_assert(static_cast<int>(sd::BoundaryHandling::Free) ==
    static_cast<int>(vtkMeshDenoisingFilter::FREE),
  "The boundary handlings of the filter are those of the core.");

namespace
{

/// The report as one tuple with named components.
void AddReport(const sd::MeshDenoisingReport& report, vtkFieldData* fieldData)
{
  const std::pair<const char*, double> entries[] = {
    { "Mean Edge Length", report.MeanEdgeLength },
    { "Mean Centroid Distance", report.MeanCentroidDistance },
    { "Range Scale", report.NormScale },
    { "Unfiltered Faces", static_cast<double>(report.UnfilteredFaces) },
    { "Guarded Points", static_cast<double>(report.GuardedVertices) },
    { "Degenerate Faces", static_cast<double>(report.DegenerateFaces) },
    { "Boundary Edges", static_cast<double>(report.BoundaryEdges) },
    { "Non Manifold Edges", static_cast<double>(report.NonManifoldEdges) },
    { "Seam Points", static_cast<double>(report.SeamVertices) },
    { "Turned Faces", static_cast<double>(report.TurnedFaces) },
    { "Seconds Of Setup", report.SetupSeconds },
    { "Seconds Of Normal Filtering", report.NormalSeconds },
    { "Seconds Of Vertex Update", report.VertexSeconds },
  };
  constexpr int count = static_cast<int>(sizeof(entries) / sizeof(entries[0]));
  vtkNew<vtkDoubleArray> array;
  array->SetName("DenoisingReport");
  array->SetNumberOfComponents(count);
  array->SetNumberOfTuples(1);
  for (int i = 0; i < count; ++i)
  {
    array->SetComponentName(i, entries[i].first);
    array->SetValue(i, entries[i].second);
  }
  fieldData->AddArray(array);
}

}

vtkMeshDenoisingFilter::vtkMeshDenoisingFilter() = default;
vtkMeshDenoisingFilter::~vtkMeshDenoisingFilter() = default;

int vtkMeshDenoisingFilter::RequestData(vtkInformation*, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->TakeReport(sd::MeshDenoisingReport());
  if (input->GetNumberOfPoints() == 0)
  {
    output->ShallowCopy(input);
    return 1;
  }
  bool needed = false;
  vtkDataArray* startNormals = this->FindStartNormals(inputVector, needed);
  if (needed && !startNormals)
  {
    vtkErrorMacro(<< "The input has no cell array with the normals to start from.");
    return 0;
  }
  bool good = false;
  sd::RunOnThreads(this->NumberOfThreads,
    [&] { good = this->Denoise(input, startNormals, output); });
  return good ? 1 : 0;
}

bool vtkMeshDenoisingFilter::Denoise(vtkPolyData* input, vtkDataArray* startNormals,
  vtkPolyData* output)
{
  sd::SMPExecution execution(this);
  sd::MeshView view;
  std::string error;
  sd::Buffer<sd::Vec3> normals;
  if (!sd::ReadSurface(input, view, error, execution) ||
    (startNormals && !sd::ReadCellVectors(startNormals, input, view, normals, error)))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  if (view.Mesh.NumberOfFaces() == 0)
  {
    vtkWarningMacro(<< "The input has no polygons; it passes through unchanged.");
    output->ShallowCopy(input);
    return true;
  }

  sd::MeshDenoisingSettings settings;
  settings.VertexIterations = this->NumberOfVertexIterations;
  settings.Vertices.Scheme = static_cast<sd::VertexScheme>(this->VertexScheme);
  settings.Vertices.Boundary = static_cast<sd::BoundaryHandling>(this->BoundaryHandling);
  settings.Vertices.PreventFlips = this->PreventFlips;
  settings.Vertices.MaximumDisplacement = this->MaximumDisplacement;
  this->Configure(settings);

  sd::MeshDenoisingReport report;
  const bool finished = sd::DenoiseMesh(view.Mesh, normals, settings, report, execution);
  this->TakeReport(report);
  if (!finished)
  {
    // Nobody wants half a result.
    output->ShallowCopy(input);
    return true;
  }
  if (report.NoNoiseFound)
  {
    vtkWarningMacro(<< "The normals of the surface have no noise to take a scale from; the surface "
                       "passes through unchanged. Set the scale to filter it all the same.");
  }

  const auto points = sd::MovedPoints(input, view, view.Mesh.Positions, execution);
  sd::PassSurface(input, points, output);
  output->GetCellData()->AddArray(
    sd::CellVectors(input, view, normals, "FilteredNormals", execution));
  AddReport(report, output->GetFieldData());
  return true;
}

void vtkMeshDenoisingFilter::TakeReport(const sd::MeshDenoisingReport& report)
{
  this->MeanEdgeLength = report.MeanEdgeLength;
  this->MeanCentroidDistance = report.MeanCentroidDistance;
  this->NumberOfGuardedPoints = static_cast<vtkIdType>(report.GuardedVertices);
  this->NumberOfDegenerateFaces = static_cast<vtkIdType>(report.DegenerateFaces);
  this->NumberOfBoundaryEdges = static_cast<vtkIdType>(report.BoundaryEdges);
  this->NumberOfNonManifoldEdges = static_cast<vtkIdType>(report.NonManifoldEdges);
  this->NumberOfSeamPoints = static_cast<vtkIdType>(report.SeamVertices);
  this->NumberOfTurnedFaces = static_cast<vtkIdType>(report.TurnedFaces);
}

void vtkMeshDenoisingFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfVertexIterations: " << this->NumberOfVertexIterations << "\n";
  os << indent << "VertexScheme: " << this->VertexScheme << "\n";
  os << indent << "BoundaryHandling: " << this->BoundaryHandling << "\n";
  os << indent << "PreventFlips: " << this->PreventFlips << "\n";
  os << indent << "MaximumDisplacement: " << this->MaximumDisplacement << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "MeanEdgeLength: " << this->MeanEdgeLength << "\n";
  os << indent << "MeanCentroidDistance: " << this->MeanCentroidDistance << "\n";
  os << indent << "NumberOfGuardedPoints: " << this->NumberOfGuardedPoints << "\n";
  os << indent << "NumberOfDegenerateFaces: " << this->NumberOfDegenerateFaces << "\n";
  os << indent << "NumberOfBoundaryEdges: " << this->NumberOfBoundaryEdges << "\n";
  os << indent << "NumberOfNonManifoldEdges: " << this->NumberOfNonManifoldEdges << "\n";
  os << indent << "NumberOfSeamPoints: " << this->NumberOfSeamPoints << "\n";
  os << indent << "NumberOfTurnedFaces: " << this->NumberOfTurnedFaces << "\n";
}
