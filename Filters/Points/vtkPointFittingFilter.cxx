// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPointFittingFilter.h"

#include "Automatic/OpenSettings.h"
#include "Points/PointMethods.h"

#include "vtkMath.h"

#include <algorithm>
#include <array>

namespace sd = SurfaceDenoising;

static_assert(static_cast<int>(sd::PointScheme::QuadricFit) ==
    static_cast<int>(vtkPointFittingFilter::QUADRIC_FIT),
  "The position schemes of the filter are those of the core.");

static_assert(sd::NumberOfNorms == vtkPointFittingFilter::CENTIN + 1,
  "The norms of the filter are those of the core.");

namespace
{

/// Those of the core that points have, in the order of the filter's.
constexpr std::array<sd::NormalArgument, 6> CoreArguments = { sd::NormalArgument::Chord,
  sd::NormalArgument::Angle, sd::NormalArgument::DirectionalCurvature,
  sd::NormalArgument::NormalGradient, sd::NormalArgument::Height, sd::NormalArgument::BentArc };

static_assert(CoreArguments.size() == vtkPointFittingFilter::BENT_ARC + 1,
  "The arguments of the filter are those of the core.");

}

vtkPointFittingFilter::vtkPointFittingFilter(const sd::PointDenoisingSettings& defaults)
  : vtkPointNeighborhoodFilter(defaults)
{
  this->vtkPointFittingFilter::TakeSettings(this->Defaults());
}

vtkPointFittingFilter::vtkPointFittingFilter(sd::PointMethod method)
  : vtkPointFittingFilter(sd::SettingsOf(method))
{
}

vtkPointFittingFilter::~vtkPointFittingFilter() = default;

int vtkPointFittingFilter::GetNumberOfNorms() { return sd::NumberOfNorms; }

const char* vtkPointFittingFilter::GetNormName(int norm)
{
  return norm >= 0 && norm < sd::NumberOfNorms
    ? sd::NameOf(sd::MakeErrorNorm(static_cast<sd::NormId>(norm), 1.0))
    : nullptr;
}

void vtkPointFittingFilter::TakeSettings(const sd::PointDenoisingSettings& settings)
{
  this->Superclass::TakeSettings(settings);
  const auto& operation = std::get<sd::TwoStageSettings>(settings.Operator);
  this->NumberOfPointIterations = operation.PointIterations;
  this->PositionScheme = static_cast<int>(operation.Update.Scheme);
  this->PositionStep = operation.Update.Step;
  this->PositionNorm = static_cast<int>(operation.Points.Norm);
  this->PositionArgument = FilterArgument(operation.Points.Argument);
  this->PositionRangeScale =
    Rounded(operation.Points.NormScale / RangeUnit(this->PositionArgument));
  this->PositionSpatialScale = sd::OpenSettings::SpatialProperty(operation.Points.SpatialScale);
  this->PositionIncludeOwn = operation.Points.IncludeOwn;
  this->EigenvalueCut = operation.Update.EigenvalueCut;
  this->DensityWeights = operation.DensityWeights;
  this->UnorientedNormals = operation.Unoriented;
}

sd::NormalArgument vtkPointFittingFilter::CoreArgument(int argument)
{
  return CoreArguments[static_cast<std::size_t>(argument)];
}

int vtkPointFittingFilter::FilterArgument(sd::NormalArgument argument)
{
  return static_cast<int>(
    std::find(CoreArguments.begin(), CoreArguments.end(), argument) - CoreArguments.begin());
}

double vtkPointFittingFilter::RangeUnit(int argument)
{
  const bool angle = argument == ANGLE || argument == DIRECTIONAL_CURVATURE;
  return angle ? vtkMath::RadiansFromDegrees(1.0) : 1.0;
}

void vtkPointFittingFilter::Configure(sd::PointDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  auto& operation = std::get<sd::TwoStageSettings>(settings.Operator);
  this->Open->Take("NumberOfPointIterations", this->NumberOfPointIterations,
    operation.PointIterations);
  operation.Update.Scheme = static_cast<sd::PointScheme>(this->PositionScheme);
  operation.Update.Step = this->PositionStep;
  operation.Points.Norm = static_cast<sd::NormId>(this->PositionNorm);
  operation.Points.Argument = CoreArgument(this->PositionArgument);
  this->Open->Take("PositionRangeScale", this->PositionRangeScale, operation.Points.NormScale,
    RangeUnit(this->PositionArgument), 1e-6);
  this->Open->TakeSpatial("PositionSpatialScale", this->PositionSpatialScale,
    operation.Points.SpatialScale);
  operation.Points.IncludeOwn = this->PositionIncludeOwn;
  operation.Update.EigenvalueCut = this->EigenvalueCut;
  operation.DensityWeights = this->DensityWeights;
  operation.Unoriented = this->UnorientedNormals;
}

void vtkPointFittingFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfPointIterations: " << this->NumberOfPointIterations << "\n";
  os << indent << "PositionScheme: " << this->PositionScheme << "\n";
  os << indent << "PositionStep: " << this->PositionStep << "\n";
  os << indent << "PositionNorm: " << vtkPointFittingFilter::GetNormName(this->PositionNorm)
     << "\n";
  os << indent << "PositionArgument: " << this->PositionArgument << "\n";
  os << indent << "PositionRangeScale: " << this->PositionRangeScale << "\n";
  os << indent << "PositionSpatialScale: " << this->PositionSpatialScale << "\n";
  os << indent << "PositionIncludeOwn: " << this->PositionIncludeOwn << "\n";
  os << indent << "EigenvalueCut: " << this->EigenvalueCut << "\n";
  os << indent << "DensityWeights: " << this->DensityWeights << "\n";
  os << indent << "UnorientedNormals: " << this->UnorientedNormals << "\n";
}
