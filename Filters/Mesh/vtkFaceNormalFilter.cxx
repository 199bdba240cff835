// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkFaceNormalFilter.h"

#include "Automatic/MeshTuning.h"
#include "Methods.h"
#include "SurfaceWork.h"

#include "vtkMath.h"

#include <cmath>

namespace sd = SurfaceDenoising;

static_assert(static_cast<int>(sd::FaceNeighborhood::EdgeRadius) ==
    static_cast<int>(vtkFaceNormalFilter::EDGE_RADIUS),
  "The neighbourhoods of the filter are those of the core.");

vtkFaceNormalFilter::vtkFaceNormalFilter(sd::Method method)
  : Row(method)
{
  this->TakeSchedule(this->Defaults());
}

vtkFaceNormalFilter::~vtkFaceNormalFilter() = default;

const sd::MeshDenoisingSettings& vtkFaceNormalFilter::Defaults() const
{
  return sd::SettingsOf(this->Row);
}

double vtkFaceNormalFilter::RangeUnit() const { return 1.0; }

void vtkFaceNormalFilter::TakeRangeScale(double rangeScale, double& normScale)
{
  this->Open->Take("RangeScale", rangeScale, normScale, this->RangeUnit());
}

double vtkFaceNormalFilter::RangeScaleOf(double normScale) const
{
  return std::round(normScale / this->RangeUnit() * 1e9) / 1e9;
}

void vtkFaceNormalFilter::TakeRadius(double property, double& radius)
{
  // Larger ones take minutes.
  constexpr double most = 6.0;
  this->Open->TakeRadius("Radius", property, radius, most);
}

void vtkFaceNormalFilter::TakeSchedule(const sd::MeshDenoisingSettings& settings)
{
  this->NumberOfOuterIterations = settings.OuterIterations;
  this->NumberOfNormalIterations = settings.NormalIterations;
  this->NumberOfVertexIterations = settings.VertexIterations;
  this->VertexScheme = static_cast<int>(settings.Vertices.Scheme);
  this->Relaxation = settings.Vertices.Relaxation;
  this->MaximumDisplacement = settings.Vertices.MaximumDisplacement;
}

vtkMeshDenoisingFilter::Outcome vtkFaceNormalFilter::Denoise(sd::SurfaceWork& work)
{
  this->Residual = 0.0;
  if (this->StopAtNoise)
  {
    sd::SurfaceNoise noise;
    if (!sd::MeasureNoise(work.View.Mesh, noise, work.Exec))
    {
      return STOPPED;
    }
    this->Residual = sd::IsNoisy(noise) ? vtkMath::RadiansFromDegrees(noise.NormalAngle) : -1.0;
    work.Report.Add("Noise Of Normals", noise.NormalAngle);
  }
  const Outcome outcome = this->Superclass::Denoise(work);
  if (outcome == FINISHED && this->Residual < 0.0 && !this->Open->Any()) // else that was said
  {
    vtkWarningMacro(<< "The surface has no noise to stop at; it passes through unchanged.");
  }
  return outcome;
}

void vtkFaceNormalFilter::Configure(sd::MeshDenoisingSettings& settings)
{
  static_cast<sd::FaceFilterSettings&>(settings) = this->Defaults();
  settings.Residual = std::max(0.0, this->Residual);
  settings.OuterIterations = this->Defaults().OuterIterations;
  this->Open->Take("NumberOfOuterIterations",
    this->Residual < 0.0 ? -1 : this->NumberOfOuterIterations, settings.OuterIterations);
  this->Open->Take("NumberOfNormalIterations", this->NumberOfNormalIterations,
    settings.NormalIterations);
  settings.VertexIterations = this->UpdateVertices ? this->Defaults().VertexIterations : 0;
  if (this->UpdateVertices)
  {
    this->Open->Take("NumberOfVertexIterations", this->NumberOfVertexIterations,
      settings.VertexIterations);
  }
}

void vtkFaceNormalFilter::TakeReport(const sd::MeshDenoisingReport& report)
{
  this->Superclass::TakeReport(report);
  this->UsedRangeScale = report.NormScale / this->RangeUnit();
  this->NumberOfUnfilteredFaces = static_cast<vtkIdType>(report.UnfilteredFaces);
}

void vtkFaceNormalFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfOuterIterations: " << this->NumberOfOuterIterations << "\n";
  os << indent << "NumberOfNormalIterations: " << this->NumberOfNormalIterations << "\n";
  os << indent << "StopAtNoise: " << this->StopAtNoise << "\n";
  os << indent << "UpdateVertices: " << this->UpdateVertices << "\n";
  os << indent << "UsedRangeScale: " << this->UsedRangeScale << "\n";
  os << indent << "NumberOfUnfilteredFaces: " << this->NumberOfUnfilteredFaces << "\n";
}
