// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPointDenoisingFilter.h"

#include "Automatic/CloudTuning.h"
#include "Automatic/ProgressShare.h"
#include "ChosenArray.h"
#include "DenoisingReport.h"
#include "PointAdapter.h"
#include "Points/PointMethods.h"
#include "SMPExecution.h"
#include "SurfaceAdapter.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>

namespace sd = SurfaceDenoising;

static_assert(static_cast<int>(sd::NormalSource::RobustFit) ==
    static_cast<int>(vtkPointDenoisingFilter::ROBUST_FIT),
  "The normal sources of the filter are those of the core.");
static_assert(static_cast<int>(sd::NormalOrientation::SpanningTree) ==
    static_cast<int>(vtkPointDenoisingFilter::SPANNING_TREE),
  "The normal orientations of the filter are those of the core.");
static_assert(static_cast<int>(sd::PointStatus::NotFinite) ==
    static_cast<int>(vtkPointDenoisingFilter::NOT_FINITE),
  "The status of points is that of the core.");
static_assert(static_cast<int>(sd::FeatureClass::Corner) ==
    static_cast<int>(vtkPointDenoisingFilter::CORNER),
  "The feature classes are those of the core.");

vtkPointDenoisingFilter::vtkPointDenoisingFilter(const sd::PointDenoisingSettings& defaults)
  : Open(new sd::OpenSettings)
  , Standard(defaults)
{
  this->vtkPointDenoisingFilter::TakeSettings(defaults);
}

vtkPointDenoisingFilter::vtkPointDenoisingFilter(sd::PointMethod method)
  : vtkPointDenoisingFilter(sd::SettingsOf(method))
{
}

vtkPointDenoisingFilter::~vtkPointDenoisingFilter() = default;

double vtkPointDenoisingFilter::Rounded(double value) { return std::round(value * 1e9) / 1e9; }

int vtkPointDenoisingFilter::AtLeastThree(int count) { return count > 0 ? std::max(3, count) : 0; }

void vtkPointDenoisingFilter::TakeSettings(const sd::PointDenoisingSettings& settings)
{
  this->NumberOfNormalNeighbors = settings.Normals.NumberOfNeighbors;
  this->NumberOfOuterIterations = settings.OuterIterations;
  this->MaximumDisplacement = settings.MaximumDisplacement;
}

void vtkPointDenoisingFilter::Configure(sd::PointDenoisingSettings& settings)
{
  settings = this->Defaults();
  settings.Normals.Source = static_cast<sd::NormalSource>(this->NormalSource);
  settings.Normals.Orientation = static_cast<sd::NormalOrientation>(this->NormalOrientation);
  this->Open->Take("NumberOfNormalNeighbors", AtLeastThree(this->NumberOfNormalNeighbors),
    settings.Normals.NumberOfNeighbors, 6);
  this->Open->Take("NumberOfOuterIterations", this->NumberOfOuterIterations,
    settings.OuterIterations);
  settings.MaximumDisplacement = this->MaximumDisplacement;
}

int vtkPointDenoisingFilter::RequestData(vtkInformation*, vtkInformationVector** inputVector,
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

/// The array of normals, or null. Returns false after an error.
bool vtkPointDenoisingFilter::FindNormals(vtkPolyData* input, vtkDataArray*& normals)
{
  const sd::ArrayChoice chosen =
    sd::ChosenArray(this, input, vtkDataObject::FIELD_ASSOCIATION_POINTS);
  normals = chosen.Made ? chosen.Array : sd::GivenNormals(input, !sd::HasPolygons(input));
  if (chosen.Made && !normals)
  {
    vtkErrorMacro(<< "The input has no point array " << chosen.Name << " with the normals.");
    return false;
  }
  return true;
}

bool vtkPointDenoisingFilter::Process(vtkPolyData* input, vtkPolyData* output)
{
  sd::SMPExecution execution(this);
  vtkDataArray* normals = nullptr;
  sd::PointView view;
  std::string error;
  if (!this->FindNormals(input, normals))
  {
    return false;
  }
  if (!sd::ReadPoints(input, normals, view, error, execution))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  sd::PointDenoisingSettings settings;
  this->Configure(settings);
  if (!normals)
  {
    view.Cloud.Normals = sd::NormalsOfFaces(input, execution);
    if (settings.Normals.Source == sd::NormalSource::Given && view.Cloud.Normals.empty())
    {
      vtkErrorMacro(<< "The input has no point normals, and no polygons to take them from.");
      return false;
    }
    if (settings.Normals.Source == sd::NormalSource::Automatic)
    {
      // Those of noisy polygons are noisy: they tell the side alone.
      settings.Normals.Source = sd::NormalSource::RobustFit;
    }
  }

  sd::PointDenoisingReport report;
  sd::DenoisingReport figures;
  const bool asks = this->Open->Any() || this->StopAtNoise;
  sd::ProgressShare choosing(execution, 0.0, 0.3);
  sd::ProgressShare denoising(execution, asks ? 0.3 : 0.0, 1.0);
  const bool finished = (!asks || this->MeetNoise(view, settings, figures, choosing)) &&
    this->Denoise(view, settings, report, denoising);
  this->TakeReport(report);
  if (!finished)
  {
    // Nobody wants half a result.
    this->PassThrough(input, output);
    return true;
  }
  if (report.NoNoiseFound && settings.OuterIterations > 0)
  {
    vtkWarningMacro(<< "The normals have no noise to take a scale from; the points stay. Set the "
                       "scale to filter them all the same.");
  }
  sd::PassPoints(input, view, output, execution);
  if (view.Cloud.Classes.empty() && this->TellsClasses())
  {
    output->GetPointData()->RemoveArray("FeatureClass"); // of a filter before
  }
  figures.Add("Mean Spacing", report.Spacing);
  figures.Add("Outer Iterations", report.OuterIterations);
  figures.Add("Kept Points", report.Kept);
  figures.Add("Points Not Finite", report.NotFinite);
  figures.Add("Fitted Normals", report.EstimatedNormals);
  figures.Add("Parts", report.Parts);
  figures.Add("Range Scale", report.NormScale);
  figures.Add("Seconds Of Setup", report.SetupSeconds);
  figures.Add("Seconds Of Filtering", report.FilterSeconds);
  figures.WriteTo(output);
  return true;
}

void vtkPointDenoisingFilter::PassThrough(vtkPolyData* input, vtkPolyData* output) const
{
  sd::AddedArrays added{ { "Displacement", "Status" }, {}, { "DenoisingReport" } };
  if (this->TellsClasses())
  {
    added.OfPoints.push_back("FeatureClass");
  }
  sd::PassUnchanged(input, added, output);
}

/// What the settings get from the noise of the points. Returns false if the execution asked to
/// stop.
bool vtkPointDenoisingFilter::MeetNoise(const sd::PointView& view,
  sd::PointDenoisingSettings& settings, sd::DenoisingReport& figures, sd::Execution& execution)
{
  sd::CloudTuningReport found;
  if (!(this->Open->Any() ? sd::TuneForCloud(view.Cloud, *this->Open, settings, found, execution)
                          : sd::MeasureNoise(view.Cloud, found, execution)))
  {
    return false;
  }
  figures.Add("Noise In Spacings", found.Spacing > 0.0 ? found.Deviation / found.Spacing : 0.0);
  figures.Add("Seconds Of Choosing", found.Seconds);
  for (const sd::OpenSetting& setting : this->Open->All())
  {
    figures.Add("Chosen " + setting.Name, setting.Chosen);
  }
  if (found.NoNoiseFound)
  {
    vtkWarningMacro(<< "The points have no noise to choose settings for; they stay. Set them to "
                       "filter them all the same.");
    settings.OuterIterations = 0;
  }
  settings.Residual = this->StopAtNoise ? found.Deviation : 0.0;
  return true;
}

double vtkPointDenoisingFilter::GetChosenValue(const char* property) const
{
  return this->Open->Chosen(property ? property : "");
}

bool vtkPointDenoisingFilter::Denoise(sd::PointView& view,
  const sd::PointDenoisingSettings& settings, sd::PointDenoisingReport& report,
  sd::Execution& execution)
{
  return sd::DenoisePoints(view.Cloud, settings, report, execution);
}

void vtkPointDenoisingFilter::ForgetReport()
{
  this->Open->Clear();
  this->TakeReport(sd::PointDenoisingReport());
}

void vtkPointDenoisingFilter::TakeReport(const sd::PointDenoisingReport& report)
{
  this->MeanSpacing = report.Spacing;
  this->NumberOfKeptPoints = static_cast<vtkIdType>(report.Kept);
  this->NumberOfPointsNotFinite = static_cast<vtkIdType>(report.NotFinite);
  this->NumberOfFittedNormals = static_cast<vtkIdType>(report.EstimatedNormals);
  this->NumberOfParts = static_cast<vtkIdType>(report.Parts);
}

void vtkPointDenoisingFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NormalSource: " << this->NormalSource << "\n";
  os << indent << "NormalOrientation: " << this->NormalOrientation << "\n";
  os << indent << "NumberOfNormalNeighbors: " << this->NumberOfNormalNeighbors << "\n";
  os << indent << "NumberOfOuterIterations: " << this->NumberOfOuterIterations << "\n";
  os << indent << "StopAtNoise: " << this->StopAtNoise << "\n";
  os << indent << "MaximumDisplacement: " << this->MaximumDisplacement << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "MeanSpacing: " << this->MeanSpacing << "\n";
  os << indent << "NumberOfKeptPoints: " << this->NumberOfKeptPoints << "\n";
  os << indent << "NumberOfPointsNotFinite: " << this->NumberOfPointsNotFinite << "\n";
  os << indent << "NumberOfFittedNormals: " << this->NumberOfFittedNormals << "\n";
  os << indent << "NumberOfParts: " << this->NumberOfParts << "\n";
}
