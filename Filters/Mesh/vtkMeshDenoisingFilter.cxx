// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkMeshDenoisingFilter.h"

#include "Automatic/MeshTuning.h"
#include "Automatic/ProgressShare.h"
#include "PreparedMesh.h"
#include "SMPExecution.h"
#include "SurfaceWork.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"

namespace sd = SurfaceDenoising;

vtkMeshDenoisingFilter::vtkMeshDenoisingFilter()
  : Open(new sd::OpenSettings)
{
}

vtkMeshDenoisingFilter::~vtkMeshDenoisingFilter() = default;

int vtkMeshDenoisingFilter::RequestData(vtkInformation*, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->ForgetReport();
  if (input->GetNumberOfPoints() == 0)
  {
    this->PassThrough(input, output);
    return 1;
  }
  bool good = false;
  sd::RunOnThreads(this->NumberOfThreads, [&] { good = this->Process(input, output); });
  return good ? 1 : 0;
}

bool vtkMeshDenoisingFilter::Process(vtkPolyData* input, vtkPolyData* output)
{
  sd::SMPExecution execution(this);
  sd::SurfaceWork work{ input, execution, {}, {}, {} };
  std::string error;
  if (!sd::ReadSurface(input, work.View, error, execution))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  if (work.View.Mesh.NumberOfFaces() == 0)
  {
    vtkWarningMacro(<< "The input has no polygons; it passes through unchanged.");
    this->PassThrough(input, output);
    return true;
  }
  switch (this->Denoise(work))
  {
    case FAILED:
      return false;
    case STOPPED:
      // Nobody wants half a result.
      this->PassThrough(input, output);
      return true;
    case FINISHED:
      break;
  }

  const auto points = sd::MovedPoints(input, work.View.Centre, work.View.Mesh.Positions, execution);
  sd::PassSurface(input, points, output);
  if (!work.FaceNormals.empty())
  {
    output->GetCellData()->AddArray(
      sd::CellVectors(input, work.View, work.FaceNormals, "FilteredNormals", execution));
  }
  work.Report.WriteTo(output);
  return true;
}

void vtkMeshDenoisingFilter::PassThrough(vtkPolyData* input, vtkPolyData* output) const
{
  sd::AddedArrays added{ {}, {}, { "DenoisingReport" } };
  if (this->FiltersNormals())
  {
    added.OfCells.push_back("FilteredNormals");
  }
  sd::PassUnchanged(input, added, output);
}

double vtkMeshDenoisingFilter::GetChosenValue(const char* property) const
{
  return this->Open->Chosen(property ? property : "");
}

vtkMeshDenoisingFilter::Outcome vtkMeshDenoisingFilter::ChooseSettings(sd::SurfaceWork& work,
  const sd::MeshOperation& move, bool& noisy)
{
  sd::MeshTuningReport report;
  sd::ProgressShare share(work.Exec, 0.0, 0.5);
  if (!sd::TuneForMesh(work.View.Mesh, *this->Open, move, report, share))
  {
    return STOPPED;
  }
  noisy = !report.NoNoiseFound;
  if (!noisy)
  {
    vtkWarningMacro(<< "The surface has no noise to choose settings for; it passes through "
                       "unchanged. Set them to filter it all the same.");
  }
  work.Report.Add("Noise In Edge Lengths", report.Noise.Level);
  work.Report.Add("Seconds Of Choosing", report.Seconds);
  for (const sd::OpenSetting& setting : this->Open->All())
  {
    work.Report.Add("Chosen " + setting.Name, setting.Chosen);
  }
  return FINISHED;
}

void vtkMeshDenoisingFilter::ForgetReport()
{
  this->Open->Clear();
  this->TakeFacts(sd::MeshFacts(), nullptr);
}

void vtkMeshDenoisingFilter::TakeFacts(const sd::MeshFacts& facts, sd::SurfaceWork* work)
{
  this->MeanEdgeLength = facts.MeanEdgeLength;
  this->NumberOfDegenerateFaces = static_cast<vtkIdType>(facts.DegenerateFaces);
  this->NumberOfBoundaryEdges = static_cast<vtkIdType>(facts.BoundaryEdges);
  this->NumberOfNonManifoldEdges = static_cast<vtkIdType>(facts.NonManifoldEdges);
  this->NumberOfSeamPoints = static_cast<vtkIdType>(facts.SeamVertices);
  this->NumberOfTurnedFaces = static_cast<vtkIdType>(facts.TurnedFaces);
  if (work)
  {
    work->Report.Add("Mean Edge Length", facts.MeanEdgeLength);
    work->Report.Add("Degenerate Faces", facts.DegenerateFaces);
    work->Report.Add("Boundary Edges", facts.BoundaryEdges);
    work->Report.Add("Non Manifold Edges", facts.NonManifoldEdges);
    work->Report.Add("Seam Points", facts.SeamVertices);
    work->Report.Add("Turned Faces", facts.TurnedFaces);
  }
}

void vtkMeshDenoisingFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "MeanEdgeLength: " << this->MeanEdgeLength << "\n";
  os << indent << "NumberOfDegenerateFaces: " << this->NumberOfDegenerateFaces << "\n";
  os << indent << "NumberOfBoundaryEdges: " << this->NumberOfBoundaryEdges << "\n";
  os << indent << "NumberOfNonManifoldEdges: " << this->NumberOfNonManifoldEdges << "\n";
  os << indent << "NumberOfSeamPoints: " << this->NumberOfSeamPoints << "\n";
  os << indent << "NumberOfTurnedFaces: " << this->NumberOfTurnedFaces << "\n";
}
