// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDenoiseSurface.h"

#include "Automatic/AutomaticCloud.h"
#include "Automatic/AutomaticMesh.h"
#include "Automatic/SurfaceChange.h"
#include "DenoisingReport.h"
#include "PointAdapter.h"
#include "SMPExecution.h"
#include "SurfaceAdapter.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

namespace sd = SurfaceDenoising;

static_assert(static_cast<int>(sd::SurfaceType::Curved) == vtkDenoiseSurface::CURVED,
  "The surface types of the filter are those of the core.");

vtkStandardNewMacro(vtkDenoiseSurface);

vtkDenoiseSurface::vtkDenoiseSurface() = default;
vtkDenoiseSurface::~vtkDenoiseSurface() = default;

namespace
{

/// Where the vertices of a mesh went, as a point array.
void AddDisplacements(const sd::Buffer<sd::Vec3>& before, const sd::Buffer<sd::Vec3>& after,
  vtkPolyData* output, sd::Execution& execution)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("Displacement");
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(after.size()));
  double* values = array->GetPointer(0);
  execution.For(after.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t v = begin; v < end; ++v)
      {
        const sd::Vec3 d = after[v] - before[v];
        const bool finite = d.allFinite(); // points without polygons need not be
        for (int axis = 0; axis < 3; ++axis)
        {
          values[3 * v + axis] = finite ? d[axis] : 0.0;
        }
      }
    });
  output->GetPointData()->AddArray(array);
}

void PassThrough(vtkPolyData* input, bool cloud, vtkPolyData* output)
{
  sd::AddedArrays added{ { "Displacement" }, {}, { "DenoisingReport", "DenoisingChoice" } };
  if (cloud)
  {
    added.OfPoints.insert(added.OfPoints.end(), { "Status", "FeatureClass" });
  }
  sd::PassUnchanged(input, added, output);
}

std::string NamesOf(const std::vector<sd::Method>& methods)
{
  std::string names;
  for (const sd::Method method : methods)
  {
    names += (names.empty() ? "" : ", then ") +
      std::string(sd::Methods()[static_cast<std::size_t>(method)].Name);
  }
  return names.empty() ? "None" : names;
}

}

int vtkDenoiseSurface::RequestData(vtkInformation*, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->ForgetReport();
  if (input->GetNumberOfPoints() == 0)
  {
    PassThrough(input, false, output);
    return 1;
  }
  const bool cloud = this->PointsOnly || !sd::HasPolygons(input);
  bool good = false;
  sd::RunOnThreads(this->NumberOfThreads,
    [&] { good = cloud ? this->DenoiseCloud(input, output) : this->DenoiseMesh(input, output); });
  return good ? 1 : 0;
}

bool vtkDenoiseSurface::DenoiseMesh(vtkPolyData* input, vtkPolyData* output)
{
  const sd::AutomaticSettings settings(this->Strength,
    static_cast<sd::SurfaceType>(this->SurfaceType));
  sd::SMPExecution execution(this);
  sd::MeshView view;
  std::string error;
  if (!sd::ReadSurface(input, view, error, execution))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  const sd::Buffer<sd::Vec3> before = view.Mesh.Positions;
  sd::AutomaticReport found;
  if (!sd::DenoiseAutomatically(view.Mesh, settings, found, execution))
  {
    PassThrough(input, false, output); // nobody wants half a result
    return true;
  }
  const auto points = sd::MovedPoints(input, view.Centre, view.Mesh.Positions, execution);
  sd::PassSurface(input, points, output);
  AddDisplacements(before, view.Mesh.Positions, output, execution);

  const double edge = found.Last.MeanEdgeLength;
  this->NoiseLevel = found.Plan.Noise.Level;
  this->NumberOfOutliers = static_cast<vtkIdType>(found.RepairedVertices);
  this->ChosenMethods = NamesOf(found.Plan.Methods);
  this->Explain(found.Plan.Reason, found.RepairedVertices);
  sd::DenoisingReport report;
  report.Add("Mean Edge Length", edge);
  report.Add("Noise In Edge Lengths", this->NoiseLevel);
  report.Add("Noise Of Normals", found.Plan.Noise.NormalAngle);
  report.Add("Expected Error", found.Plan.ExpectedError);
  report.Add("Repaired Spikes", this->NumberOfOutliers);
  report.Add("Seconds Of Choosing", found.PlanSeconds);
  report.Add("Seconds Of Denoising", found.DenoiseSeconds);
  this->TakeChange(
    sd::MeasureChange(view.Mesh, before, edge > 0.0 ? edge : 1.0, this->FeatureAngle, execution),
    report);
  report.Add("Volume Change", this->VolumeChange);
  report.Add("Feature Edges Before", this->NumberOfFeatureEdgesBefore);
  report.Add("Feature Edges After", this->NumberOfFeatureEdgesAfter);
  report.Add("Flipped Faces", this->NumberOfFlippedFaces);
  report.WriteTo(output);
  this->WriteChoice(output);
  return true;
}

bool vtkDenoiseSurface::DenoiseCloud(vtkPolyData* input, vtkPolyData* output)
{
  const sd::AutomaticSettings settings(this->Strength,
    static_cast<sd::SurfaceType>(this->SurfaceType));
  sd::SMPExecution execution(this);
  vtkDataArray* normals = sd::GivenNormals(input, !sd::HasPolygons(input));
  sd::PointView view;
  std::string error;
  if (!sd::ReadPoints(input, normals, view, error, execution))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  if (!normals)
  {
    view.Cloud.Normals = sd::NormalsOfFaces(input, execution);
  }
  const sd::Buffer<sd::Vec3> before = view.Cloud.Positions;
  sd::AutomaticCloudReport found;
  if (!sd::DenoiseAutomatically(view.Cloud, settings, found, execution))
  {
    PassThrough(input, true, output);
    return true;
  }
  if (view.Cloud.Status.size() != before.size())
  {
    // There was nothing to do, but the output has normals and statuses in any case.
    sd::PointDenoisingSettings normalsOnly;
    normalsOnly.OuterIterations = 0;
    if (!sd::DenoisePoints(view.Cloud, normalsOnly, found.Denoising, execution))
    {
      PassThrough(input, true, output);
      return true;
    }
  }
  sd::PassPoints(input, view, output, execution);
  if (view.Cloud.Classes.empty())
  {
    output->GetPointData()->RemoveArray("FeatureClass"); // of a filter before
  }

  this->NoiseLevel = found.Noise.Level();
  this->NumberOfOutliers = static_cast<vtkIdType>(found.Noise.Far + found.Noise.Off);
  this->ChosenMethods = found.Choice.Method;
  this->Explain(found.Choice.Reason, found.Pulled);
  sd::DenoisingReport report;
  report.Add("Mean Spacing", found.Noise.Spacing);
  report.Add("Noise In Spacings", this->NoiseLevel);
  report.Add("Expected Error", found.Choice.Remaining);
  report.Add("Outliers", this->NumberOfOutliers);
  report.Add("Outliers Pulled", found.Pulled);
  report.Add("Points Not Finite", found.Denoising.NotFinite);
  report.Add("Kept Points", found.Denoising.Kept);
  const double spacing = found.Noise.Spacing;
  this->TakeChange(
    sd::MeasureChange(view.Cloud.Positions, before, spacing > 0.0 ? spacing : 1.0, execution),
    report);
  report.WriteTo(output);
  this->WriteChoice(output);
  return true;
}

void vtkDenoiseSurface::ForgetReport()
{
  this->NoiseLevel = 0.0;
  this->NumberOfOutliers = 0;
  this->ChosenMethods = "None";
  this->Reason.clear();
  this->MeanDisplacement = 0.0;
  this->MaximumDisplacement = 0.0;
  this->VolumeChange = 0.0;
  this->NumberOfFeatureEdgesBefore = 0;
  this->NumberOfFeatureEdgesAfter = 0;
  this->NumberOfFlippedFaces = 0;
}

void vtkDenoiseSurface::Explain(const std::string& reason, std::size_t putBack)
{
  this->Reason = putBack > 0
    ? std::to_string(putBack) + " single points off the surface were put back. " + reason
    : reason;
}

void vtkDenoiseSurface::TakeChange(const sd::SurfaceChange& change, sd::DenoisingReport& report)
{
  this->MeanDisplacement = change.MeanDisplacement;
  this->MaximumDisplacement = change.MaximumDisplacement;
  this->VolumeChange = change.VolumeChange;
  this->NumberOfFeatureEdgesBefore = static_cast<vtkIdType>(change.FeatureEdgesBefore);
  this->NumberOfFeatureEdgesAfter = static_cast<vtkIdType>(change.FeatureEdgesAfter);
  this->NumberOfFlippedFaces = static_cast<vtkIdType>(change.FlippedFaces);
  report.Add("Mean Displacement", change.MeanDisplacement);
  report.Add("RMS Displacement", change.RootMeanSquareDisplacement);
  report.Add("Maximum Displacement", change.MaximumDisplacement);
}

void vtkDenoiseSurface::WriteChoice(vtkPolyData* output) const
{
  vtkNew<vtkStringArray> choice;
  choice->SetName("DenoisingChoice");
  choice->InsertNextValue(this->ChosenMethods);
  choice->InsertNextValue(this->Reason);
  output->GetFieldData()->AddArray(choice);
}

void vtkDenoiseSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Strength: " << this->Strength << "\n";
  os << indent << "SurfaceType: " << this->SurfaceType << "\n";
  os << indent << "PointsOnly: " << this->PointsOnly << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "NoiseLevel: " << this->NoiseLevel << "\n";
  os << indent << "NumberOfOutliers: " << this->NumberOfOutliers << "\n";
  os << indent << "ChosenMethods: " << this->ChosenMethods << "\n";
  os << indent << "Reason: " << this->Reason << "\n";
  os << indent << "MeanDisplacement: " << this->MeanDisplacement << "\n";
  os << indent << "MaximumDisplacement: " << this->MaximumDisplacement << "\n";
  os << indent << "VolumeChange: " << this->VolumeChange << "\n";
  os << indent << "NumberOfFeatureEdgesBefore: " << this->NumberOfFeatureEdgesBefore << "\n";
  os << indent << "NumberOfFeatureEdgesAfter: " << this->NumberOfFeatureEdgesAfter << "\n";
  os << indent << "NumberOfFlippedFaces: " << this->NumberOfFlippedFaces << "\n";
}
