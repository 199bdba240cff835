// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkRobustPointNormalFilter.h"

#include "Automatic/OpenSettings.h"
#include "Points/PointMethods.h"

#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkRobustPointNormalFilter);

static_assert(static_cast<int>(sd::PointGuidance::Rolling) ==
    static_cast<int>(vtkRobustPointNormalFilter::ROLLING),
  "The guidances of the filter are those of the core.");

static_assert(static_cast<int>(sd::PointNormalData::Original) ==
    static_cast<int>(vtkRobustPointNormalFilter::ORIGINAL),
  "The data sources of the filter are those of the core.");

static_assert(static_cast<int>(sd::PointNormalOperator::PlaneFit) ==
    static_cast<int>(vtkRobustPointNormalFilter::PLANE_NORMAL),
  "The operators of the filter are those of the core.");

namespace
{

/// The methods that are compositions, in the order of the presets after CUSTOM.
std::vector<const sd::PointMethodRow*> Compositions()
{
  std::vector<const sd::PointMethodRow*> composed;
  for (const sd::PointMethodRow& row : sd::PointMethods())
  {
    if (row.Composed)
    {
      composed.push_back(&row);
    }
  }
  return composed;
}

/// Null for CUSTOM and for numbers that are no preset.
const sd::PointMethodRow* FindPreset(int preset)
{
  const std::vector<const sd::PointMethodRow*> rows = Compositions();
  const bool exists = preset > 0 && preset <= static_cast<int>(rows.size());
  return exists ? rows[static_cast<std::size_t>(preset) - 1] : nullptr;
}

}

vtkRobustPointNormalFilter::vtkRobustPointNormalFilter()
  : vtkPointFittingFilter(sd::ComposedPoints())
{
  this->vtkRobustPointNormalFilter::TakeSettings(this->Defaults());
}

vtkRobustPointNormalFilter::~vtkRobustPointNormalFilter() = default;

void vtkRobustPointNormalFilter::TakeSettings(const sd::PointDenoisingSettings& settings)
{
  this->Superclass::TakeSettings(settings);
  const auto& operation = std::get<sd::TwoStageSettings>(settings.Operator);
  this->Norm = static_cast<int>(operation.Normals.Norm);
  this->Argument = FilterArgument(operation.Normals.Argument);
  this->ScaleSource = GIVEN;
  this->RangeScale = Rounded(operation.Normals.NormScale / RangeUnit(this->Argument));
  this->SpatialScale = sd::OpenSettings::SpatialProperty(operation.Normals.SpatialScale);
  this->NumberOfNormalIterations = operation.NormalIterations;
  this->Guidance = static_cast<int>(operation.Guidance);
  this->NumberOfPatchNeighbors = static_cast<int>(operation.Patch.Neighbors);
  this->PatchAgreement = operation.Patch.Agreement;
  this->MemberAgreement = operation.Patch.MemberAgreement;
  this->DataSource = static_cast<int>(operation.Data);
  this->Operator = static_cast<int>(operation.Operator);
  this->StepLength = operation.StepLength;
  this->IncludeOwn = operation.Normals.IncludeOwn;
}

int vtkRobustPointNormalFilter::GetNumberOfPresets()
{
  return static_cast<int>(Compositions().size()) + 1;
}

const char* vtkRobustPointNormalFilter::GetPresetName(int preset)
{
  const sd::PointMethodRow* row = FindPreset(preset);
  return row ? row->Name : (preset == CUSTOM ? "Custom" : nullptr);
}

void vtkRobustPointNormalFilter::CopyPreset(int preset)
{
  if (const sd::PointMethodRow* row = FindPreset(preset))
  {
    // A preset has no say in the normals to start with.
    sd::PointDenoisingSettings settings = row->Settings;
    settings.Normals.NumberOfNeighbors = this->NumberOfNormalNeighbors;
    this->TakeSettings(settings);
    this->Preset = CUSTOM;
    this->Modified();
  }
}

void vtkRobustPointNormalFilter::Configure(sd::PointDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  if (const sd::PointMethodRow* row = FindPreset(this->Preset))
  {
    const sd::PointNormalSettings normals = settings.Normals;
    settings = row->Settings;
    settings.Normals = normals;
    // The numbers of a preset are its own.
    this->Open->Clear();
    this->Open->Take("NumberOfNormalNeighbors", AtLeastThree(this->NumberOfNormalNeighbors),
      settings.Normals.NumberOfNeighbors, 6);
    return;
  }
  auto& operation = std::get<sd::TwoStageSettings>(settings.Operator);
  operation.Normals.Norm = static_cast<sd::NormId>(this->Norm);
  operation.Normals.Argument = CoreArgument(this->Argument);
  this->Open->Take("NumberOfNormalIterations", this->NumberOfNormalIterations,
    operation.NormalIterations);
  if (this->ScaleSource == GIVEN)
  {
    this->Open->Take("RangeScale", this->RangeScale, operation.Normals.NormScale,
      RangeUnit(this->Argument));
  }
  else
  {
    operation.Normals.NormScale = 0.0;
    operation.Estimator = static_cast<sd::ScaleEstimator>(this->ScaleSource - DATA_MAD);
  }
  this->Open->TakeSpatial("SpatialScale", this->SpatialScale, operation.Normals.SpatialScale);
  operation.Guidance = static_cast<sd::PointGuidance>(this->Guidance);
  operation.Patch.Neighbors = static_cast<std::size_t>(this->NumberOfPatchNeighbors);
  operation.Patch.Agreement = this->PatchAgreement;
  operation.Patch.MemberAgreement = this->MemberAgreement;
  operation.Data = static_cast<sd::PointNormalData>(this->DataSource);
  operation.Operator = static_cast<sd::PointNormalOperator>(this->Operator);
  operation.StepLength = this->StepLength;
  operation.Normals.IncludeOwn = this->IncludeOwn;
}

void vtkRobustPointNormalFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Preset: " << vtkRobustPointNormalFilter::GetPresetName(this->Preset) << "\n";
  os << indent << "Norm: " << vtkPointFittingFilter::GetNormName(this->Norm) << "\n";
  os << indent << "Argument: " << this->Argument << "\n";
  os << indent << "ScaleSource: " << this->ScaleSource << "\n";
  os << indent << "RangeScale: " << this->RangeScale << "\n";
  os << indent << "SpatialScale: " << this->SpatialScale << "\n";
  os << indent << "NumberOfNormalIterations: " << this->NumberOfNormalIterations << "\n";
  os << indent << "Guidance: " << this->Guidance << "\n";
  os << indent << "NumberOfPatchNeighbors: " << this->NumberOfPatchNeighbors << "\n";
  os << indent << "PatchAgreement: " << this->PatchAgreement << "\n";
  os << indent << "MemberAgreement: " << this->MemberAgreement << "\n";
  os << indent << "DataSource: " << this->DataSource << "\n";
  os << indent << "Operator: " << this->Operator << "\n";
  os << indent << "StepLength: " << this->StepLength << "\n";
  os << indent << "IncludeOwn: " << this->IncludeOwn << "\n";
}
