// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkRobustNormalFilter.h"

#include "Automatic/OpenSettings.h"
#include "Methods.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkRobustNormalFilter);

static_assert(sd::NumberOfNorms == vtkRobustNormalFilter::CENTIN + 1,
  "The norms of the filter are those of the core.");
static_assert(static_cast<int>(sd::NormalArgument::SiteCurvature) ==
    static_cast<int>(vtkRobustNormalFilter::FACE_CURVATURE),
  "The arguments of the filter are those of the core.");
static_assert(static_cast<int>(sd::NormalGuidance::Median) ==
    static_cast<int>(vtkRobustNormalFilter::VECTOR_MEDIAN),
  "The guidances of the filter are those of the core.");
static_assert(static_cast<int>(sd::NormalOperator::GlobalSolve) ==
    static_cast<int>(vtkRobustNormalFilter::GLOBAL_SOLVE),
  "The operators of the filter are those of the core.");
static_assert(static_cast<int>(sd::SiteWeight::Coupling) ==
    static_cast<int>(vtkRobustNormalFilter::COUPLING),
  "The face weightings of the filter are those of the core.");

namespace
{

/// The methods that are compositions, in the order of the presets after CUSTOM.
const std::vector<const sd::MethodRow*>& Compositions()
{
  static const std::vector<const sd::MethodRow*> rows = []
  {
    std::vector<const sd::MethodRow*> composed;
    for (const sd::MethodRow& row : sd::Methods())
    {
      if (row.Composed)
      {
        composed.push_back(&row);
      }
    }
    return composed;
  }();
  return rows;
}

/// Null for CUSTOM and for numbers that are no preset.
const sd::MethodRow* FindPreset(int preset)
{
  const std::vector<const sd::MethodRow*>& rows = Compositions();
  const bool exists = preset > 0 && preset <= static_cast<int>(rows.size());
  return exists ? rows[static_cast<std::size_t>(preset) - 1] : nullptr;
}

}

vtkRobustNormalFilter::vtkRobustNormalFilter()
  : vtkFaceNormalFilter(sd::Method::BilateralNormal)
{
}

vtkRobustNormalFilter::~vtkRobustNormalFilter() = default;

int vtkRobustNormalFilter::GetNumberOfNorms() { return sd::NumberOfNorms; }

const char* vtkRobustNormalFilter::GetNormName(int norm)
{
  return norm >= 0 && norm < sd::NumberOfNorms
    ? sd::NameOf(sd::MakeErrorNorm(static_cast<sd::NormId>(norm), 1.0))
    : nullptr;
}

int vtkRobustNormalFilter::GetNumberOfPresets()
{
  return static_cast<int>(Compositions().size()) + 1;
}

const char* vtkRobustNormalFilter::GetPresetName(int preset)
{
  const sd::MethodRow* row = FindPreset(preset);
  return row ? row->Name : (preset == CUSTOM ? "Custom" : nullptr);
}

void vtkRobustNormalFilter::CopyPreset(int preset)
{
  const sd::MethodRow* row = FindPreset(preset);
  if (!row)
  {
    return;
  }
  const sd::MeshDenoisingSettings& settings = row->Settings;
  this->TakeSchedule(settings);
  this->Preset = CUSTOM;
  this->Norm = static_cast<int>(settings.Norm);
  this->Argument = static_cast<int>(settings.Argument);
  this->CurvatureUnit = static_cast<int>(settings.Unit);
  this->Guidance = static_cast<int>(settings.Guidance);
  this->ScaleSource = GIVEN;
  this->RangeScale = settings.NormScale / this->RangeUnit();
  this->SpatialScale = sd::OpenSettings::SpatialProperty(settings.SpatialScale);
  this->LocalSpatialScale = settings.LocalSpatialScale;
  this->FaceWeighting = static_cast<int>(settings.Weighting);
  this->IncludeOwn = settings.IncludeOwn;
  this->Neighborhood = static_cast<int>(settings.Neighborhood);
  this->Radius = settings.Radius;
  this->RenewNeighborhood = settings.RenewNeighborhood;
  this->DataSource = static_cast<int>(settings.Data);
  this->Operator = static_cast<int>(settings.Operator);
  this->StepLength = settings.StepLength;
  this->TangentialFlux = settings.TangentialFlux;
  this->Fidelity = settings.Global.Fidelity;
  this->AreaEnergy = settings.Global.AreaEnergy;
  this->Modified();
}

/// Radians per degree if the argument is an angle, else 1.
double vtkRobustNormalFilter::RangeUnit() const
{
  const sd::MethodRow* row = FindPreset(this->Preset);
  const int argument = row ? static_cast<int>(row->Settings.Argument) : this->Argument;
  const bool angle = argument == ANGLE || argument == DIRECTIONAL_CURVATURE;
  return angle ? vtkMath::RadiansFromDegrees(1.0) : 1.0;
}

int vtkRobustNormalFilter::RequestData(vtkInformation* request, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  this->ForgetReport();
  if (this->Preset == CUSTOM && this->ScaleSource == GIVEN && !(this->RangeScale >= 0.0))
  {
    vtkErrorMacro(<< "The range scale must not be negative; it is " << this->RangeScale << ".");
    return 0;
  }
  if (this->Preset == CUSTOM && this->Argument == FACE_CURVATURE && this->Operator == AVERAGE &&
    !this->IncludeOwn)
  {
    vtkErrorMacro(<< "In an average without the face itself its curvature cancels; include it, or "
                     "choose diffusion.");
    return 0;
  }
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

void vtkRobustNormalFilter::Configure(sd::MeshDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  if (const sd::MethodRow* row = FindPreset(this->Preset))
  {
    const sd::VertexUpdateSettings own = settings.Vertices;
    const double residual = settings.Residual;
    const bool none = settings.OuterIterations == 0;
    settings = row->Settings;
    settings.Residual = residual;
    settings.OuterIterations = this->StopAtNoise && none ? 0 : settings.OuterIterations;
    settings.Vertices.Boundary = own.Boundary;
    settings.Vertices.PreventFlips = own.PreventFlips;
    settings.VertexIterations = this->UpdateVertices ? settings.VertexIterations : 0;
    this->Open->Clear(); // the numbers of a preset are its own
    return;
  }
  settings.Norm = static_cast<sd::NormId>(this->Norm);
  settings.Argument = static_cast<sd::NormalArgument>(this->Argument);
  settings.Unit = static_cast<sd::CurvatureUnit>(this->CurvatureUnit);
  settings.Guidance = static_cast<sd::NormalGuidance>(this->Guidance);
  const double start = settings.NormScale;
  settings.NormScale = 0.0;
  switch (this->ScaleSource)
  {
    case DATA_MAD:
      settings.Estimator = sd::ScaleEstimator::MedianAbsoluteDeviation;
      break;
    case DATA_RAYLEIGH:
      settings.Estimator = sd::ScaleEstimator::Rayleigh;
      break;
    case DATA_HALF_NORMAL:
      settings.Estimator = sd::ScaleEstimator::HalfNormal;
      break;
    default:
      settings.NormScale = start;
      this->TakeRangeScale(this->RangeScale, settings.NormScale);
  }
  this->Open->TakeSpatial("SpatialScale", this->SpatialScale, settings.SpatialScale);
  settings.LocalSpatialScale = this->LocalSpatialScale;
  settings.Weighting = static_cast<sd::SiteWeight>(this->FaceWeighting);
  settings.IncludeOwn = this->IncludeOwn;
  settings.Neighborhood = static_cast<sd::FaceNeighborhood>(this->Neighborhood);
  if (this->Neighborhood >= RADIUS)
  {
    this->TakeRadius(this->Radius, settings.Radius);
  }
  settings.RenewNeighborhood = this->RenewNeighborhood;
  settings.Data = static_cast<sd::NormalData>(this->DataSource);
  settings.Operator = static_cast<sd::NormalOperator>(this->Operator);
  settings.StepLength = this->StepLength;
  settings.TangentialFlux = this->TangentialFlux;
  settings.Global.Fidelity = this->Fidelity;
  settings.Global.AreaEnergy = this->AreaEnergy;
}

void vtkRobustNormalFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Preset: " << vtkRobustNormalFilter::GetPresetName(this->Preset) << "\n";
  os << indent << "Norm: " << vtkRobustNormalFilter::GetNormName(this->Norm) << "\n";
  os << indent << "Argument: " << this->Argument << "\n";
  os << indent << "CurvatureUnit: " << this->CurvatureUnit << "\n";
  os << indent << "Guidance: " << this->Guidance << "\n";
  os << indent << "ScaleSource: " << this->ScaleSource << "\n";
  os << indent << "RangeScale: " << this->RangeScale << "\n";
  os << indent << "SpatialScale: " << this->SpatialScale << "\n";
  os << indent << "LocalSpatialScale: " << this->LocalSpatialScale << "\n";
  os << indent << "FaceWeighting: " << this->FaceWeighting << "\n";
  os << indent << "IncludeOwn: " << this->IncludeOwn << "\n";
  os << indent << "Neighborhood: " << this->Neighborhood << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "RenewNeighborhood: " << this->RenewNeighborhood << "\n";
  os << indent << "DataSource: " << this->DataSource << "\n";
  os << indent << "Operator: " << this->Operator << "\n";
  os << indent << "StepLength: " << this->StepLength << "\n";
  os << indent << "TangentialFlux: " << this->TangentialFlux << "\n";
  os << indent << "Fidelity: " << this->Fidelity << "\n";
  os << indent << "AreaEnergy: " << this->AreaEnergy << "\n";
}
