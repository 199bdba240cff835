// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkVotingTensorPointFilter.h"

#include "Automatic/OpenSettings.h"
#include "PointAdapter.h"
#include "Points/PointMethods.h"
#include "Points/ReleasedVotingTensor.h"
#include "Stopwatch.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkVotingTensorPointFilter);

vtkVotingTensorPointFilter::vtkVotingTensorPointFilter()
  : vtkPointNeighborhoodFilter(sd::PointMethod::VotingTensorPoint)
{
  const auto& operation = std::get<sd::VotingTensorPointsSettings>(this->Defaults().Operator);
  this->AngleThreshold = Rounded(vtkMath::DegreesFromRadians(operation.AngleThreshold));
  this->EigenvalueThreshold = operation.EigenvalueThreshold;
  this->Damping = operation.Damping;
  this->Step = operation.Step;
  this->PlaneScale = operation.PlaneScale;
  this->HeightMode =
    operation.FlatScheme == sd::PointScheme::OwnHeight ? OWN_HEIGHT : BALANCED_HEIGHT;
  this->NormalScale = operation.FlatNormalScale;
  this->SpatialScale = operation.FlatSpatialScale;
  this->EigenvalueCut = operation.EigenvalueCut;
  this->UnorientedNormals = operation.Unoriented;
}

vtkVotingTensorPointFilter::~vtkVotingTensorPointFilter() = default;

int vtkVotingTensorPointFilter::RequestData(vtkInformation* request,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->AsReleased &&
    (!(this->AngleThreshold > 0.0) || this->NumberOfOuterIterations == 0 || this->StopAtNoise))
  {
    this->ForgetReport();
    vtkErrorMacro(<< "The released program takes nothing from the data: AngleThreshold and "
                     "NumberOfOuterIterations must not be 0, and StopAtNoise must be off.");
    return 0;
  }
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

void vtkVotingTensorPointFilter::Configure(sd::PointDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  auto& operation = std::get<sd::VotingTensorPointsSettings>(settings.Operator);
  const double degree = vtkMath::RadiansFromDegrees(1.0);
  this->Open->Take("AngleThreshold", this->AngleThreshold, operation.AngleThreshold, degree,
    degree);
  operation.EigenvalueThreshold = this->EigenvalueThreshold;
  operation.Damping = this->Damping;
  operation.Step = this->Step;
  operation.PlaneScale = this->PlaneScale;
  operation.FlatScheme =
    this->HeightMode == OWN_HEIGHT ? sd::PointScheme::OwnHeight : sd::PointScheme::BalancedHeight;
  this->Open->Take("NormalScale", this->NormalScale, operation.FlatNormalScale, 1.0, 0.01);
  this->Open->Take("SpatialScale", this->SpatialScale, operation.FlatSpatialScale, 1.0, 0.1);
  operation.EigenvalueCut = this->EigenvalueCut;
  operation.Unoriented = this->UnorientedNormals;
  if (this->AsReleased)
  {
    // What has no counterpart in the program is neither looked for nor missed.
    this->Open->Clear();
    settings.Normals.Source = sd::NormalSource::Automatic;
  }
}

/// The released program works in the coordinates of the model and in the order of its points.
bool vtkVotingTensorPointFilter::Denoise(sd::PointView& view,
  const sd::PointDenoisingSettings& settings, sd::PointDenoisingReport& report,
  sd::Execution& execution)
{
  if (!this->AsReleased)
  {
    return this->Superclass::Denoise(view, settings, report, execution);
  }
  const sd::Stopwatch stopwatch(report.FilterSeconds);
  sd::ReleasedVotingTensorSettings released;
  released.Iterations = settings.OuterIterations;
  released.Similarity = std::cos(vtkMath::RadiansFromDegrees(this->AngleThreshold));
  released.EigenvalueThreshold = this->EigenvalueThreshold;
  released.Damping = this->Damping;
  released.Step = this->Step;
  if (this->MaximumDisplacement > 0.0)
  {
    released.Limit = this->MaximumDisplacement;
  }

  sd::PointCloud& cloud = view.Cloud;
  sd::Buffer<std::size_t> finite;
  sd::Buffer<sd::Vec3> positions;
  sd::Buffer<sd::Vec3> normals;
  for (std::size_t i = 0; i < cloud.Positions.size(); ++i)
  {
    if (cloud.Positions[i].allFinite())
    {
      finite.push_back(i);
      positions.push_back(cloud.Positions[i] + view.Centre);
      if (!cloud.Normals.empty())
      {
        normals.push_back(cloud.Normals[i]);
      }
    }
  }
  const sd::Buffer<sd::Vec3> start = positions;
  report.EstimatedNormals = normals.empty() ? finite.size() : 0;
  sd::ReleasedVotingTensorReport done;
  if (!sd::DenoiseAsReleased(positions, normals, released, done, execution))
  {
    return false;
  }
  cloud.Normals.resize(cloud.Positions.size(), sd::Vec3(0.0, 0.0, 0.0));
  cloud.Status.assign(cloud.Positions.size(), sd::PointStatus::NotFinite);
  cloud.Classes.assign(cloud.Positions.size(), sd::FeatureClass::Flat);
  for (std::size_t k = 0; k < finite.size(); ++k)
  {
    const std::size_t i = finite[k];
    const bool moved = positions[k] != start[k];
    if (moved) // else it keeps its bits
    {
      cloud.Positions[i] = positions[k] - view.Centre;
    }
    cloud.Normals[i] = normals[k];
    cloud.Status[i] =
      moved || released.Iterations == 0 ? sd::PointStatus::Filtered : sd::PointStatus::Kept;
    cloud.Classes[i] = done.Classes[k];
  }
  report.Spacing = done.Spacing;
  report.OuterIterations = released.Iterations;
  report.Kept = static_cast<std::size_t>(
    std::count(cloud.Status.begin(), cloud.Status.end(), sd::PointStatus::Kept));
  report.NotFinite = cloud.Positions.size() - finite.size();
  return true;
}

void vtkVotingTensorPointFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AngleThreshold: " << this->AngleThreshold << "\n";
  os << indent << "EigenvalueThreshold: " << this->EigenvalueThreshold << "\n";
  os << indent << "Damping: " << this->Damping << "\n";
  os << indent << "Step: " << this->Step << "\n";
  os << indent << "PlaneScale: " << this->PlaneScale << "\n";
  os << indent << "HeightMode: " << this->HeightMode << "\n";
  os << indent << "NormalScale: " << this->NormalScale << "\n";
  os << indent << "SpatialScale: " << this->SpatialScale << "\n";
  os << indent << "EigenvalueCut: " << this->EigenvalueCut << "\n";
  os << indent << "UnorientedNormals: " << this->UnorientedNormals << "\n";
  os << indent << "AsReleased: " << this->AsReleased << "\n";
}
