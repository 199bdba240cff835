// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkNormalFittingFilter.h"

#include "Automatic/OpenSettings.h"
#include "Automatic/ProgressShare.h"
#include "ChosenArray.h"
#include "MeshDenoising.h"
#include "SurfaceWork.h"

#include "vtkDataObject.h"

namespace sd = SurfaceDenoising;

static_assert(static_cast<int>(sd::VertexScheme::EdgeWeighted) ==
    static_cast<int>(vtkNormalFittingFilter::EDGE_WEIGHTED),
  "The vertex schemes of the filter are those of the core.");
static_assert(static_cast<int>(sd::BoundaryHandling::Free) ==
    static_cast<int>(vtkNormalFittingFilter::FREE),
  "The boundary handlings of the filter are those of the core.");

vtkNormalFittingFilter::vtkNormalFittingFilter() = default;
vtkNormalFittingFilter::~vtkNormalFittingFilter() = default;

vtkMeshDenoisingFilter::Outcome vtkNormalFittingFilter::Denoise(sd::SurfaceWork& work)
{
  const sd::ArrayChoice start =
    sd::ChosenArray(this, work.Input, vtkDataObject::FIELD_ASSOCIATION_CELLS);
  if ((start.Made || this->NeedsStartNormals()) && !start.Array)
  {
    vtkErrorMacro(<< "The input has no cell array " << start.Name
                  << " with the normals to start from.");
    return FAILED;
  }
  std::string error;
  if (start.Array &&
    !sd::ReadCellVectors(start.Array, work.Input, work.View, work.FaceNormals, error))
  {
    vtkErrorMacro(<< error);
    return FAILED;
  }

  sd::MeshDenoisingSettings settings;
  settings.Vertices.Scheme = static_cast<sd::VertexScheme>(this->VertexScheme);
  settings.Vertices.Relaxation = this->Relaxation;
  settings.Vertices.Boundary = static_cast<sd::BoundaryHandling>(this->BoundaryHandling);
  settings.Vertices.PreventFlips = this->PreventFlips;
  settings.Vertices.MaximumDisplacement = this->MaximumDisplacement;
  this->Configure(settings);
  bool noisy = true;
  if (this->Open->Any() &&
    this->ChooseSettings(
      work,
      [&](sd::TriangleMesh& mesh, sd::Execution& execution)
      {
        // Normals are judged by the surface that fits them.
        sd::MeshDenoisingSettings trial = settings;
        trial.VertexIterations = std::max(trial.VertexIterations, 1);
        sd::Buffer<sd::Vec3> normals;
        sd::MeshDenoisingReport report;
        return sd::DenoiseMesh(mesh, normals, trial, report, execution);
      },
      noisy) == STOPPED)
  {
    return STOPPED;
  }
  settings.OuterIterations = noisy ? settings.OuterIterations : 0;
  if (settings.Guidance == sd::NormalGuidance::Patch &&
    work.View.Mesh.NumberOfFaces() > sd::NoIndex / 3)
  {
    vtkErrorMacro(<< "The surface has too many triangles for patches; at most " << sd::NoIndex / 3
                  << " can be handled.");
    return FAILED;
  }

  sd::MeshDenoisingReport report;
  sd::ProgressShare share(work.Exec, this->Open->Any() ? 0.5 : 0.0, 1.0);
  const bool finished = sd::DenoiseMesh(work.View.Mesh, work.FaceNormals, settings, report, share);
  this->TakeFacts(report, &work);
  this->TakeReport(report);
  if (!finished)
  {
    return STOPPED;
  }
  if (report.NoNoiseFound && settings.OuterIterations > 0)
  {
    vtkWarningMacro(<< "The normals of the surface have no noise to take a scale from; the surface "
                       "passes through unchanged. Set the scale to filter it all the same.");
  }
  work.Report.Add("Mean Centroid Distance", report.MeanCentroidDistance);
  work.Report.Add("Range Scale", report.NormScale);
  work.Report.Add("Outer Iterations", report.OuterIterations);
  work.Report.Add("Normal Iterations", report.NormalIterations);
  work.Report.Add("Vertex Iterations", report.VertexIterations);
  work.Report.Add("Unfiltered Faces", report.UnfilteredFaces);
  work.Report.Add("Solver Iterations", report.SolverIterations);
  work.Report.Add("Guarded Points", report.GuardedVertices);
  work.Report.Add("Seconds Of Setup", report.SetupSeconds);
  work.Report.Add("Seconds Of Normal Filtering", report.NormalSeconds);
  work.Report.Add("Seconds Of Vertex Update", report.VertexSeconds);
  return FINISHED;
}

void vtkNormalFittingFilter::ForgetReport()
{
  this->Superclass::ForgetReport();
  this->TakeReport(sd::MeshDenoisingReport());
}

void vtkNormalFittingFilter::TakeReport(const sd::MeshDenoisingReport& report)
{
  this->MeanCentroidDistance = report.MeanCentroidDistance;
  this->NumberOfGuardedPoints = static_cast<vtkIdType>(report.GuardedVertices);
}

void vtkNormalFittingFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfVertexIterations: " << this->NumberOfVertexIterations << "\n";
  os << indent << "VertexScheme: " << this->VertexScheme << "\n";
  os << indent << "Relaxation: " << this->Relaxation << "\n";
  os << indent << "BoundaryHandling: " << this->BoundaryHandling << "\n";
  os << indent << "PreventFlips: " << this->PreventFlips << "\n";
  os << indent << "MaximumDisplacement: " << this->MaximumDisplacement << "\n";
  os << indent << "MeanCentroidDistance: " << this->MeanCentroidDistance << "\n";
  os << indent << "NumberOfGuardedPoints: " << this->NumberOfGuardedPoints << "\n";
}
