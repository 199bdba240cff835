// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGuidedPointNormalFilter.h"

#include "Automatic/OpenSettings.h"
#include "Points/PointMethods.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

namespace sd = SurfaceDenoising;

vtkStandardNewMacro(vtkGuidedPointNormalFilter);

vtkGuidedPointNormalFilter::vtkGuidedPointNormalFilter()
  : vtkPointNeighborhoodFilter(sd::PointMethod::GuidedPointNormal)
{
  const auto& operation = std::get<sd::NormalBundlesSettings>(this->Defaults().Operator);
  this->RangeScale = operation.RangeScale;
  this->SpatialScale = operation.SpatialScale;
  this->NumberOfNormalIterations = operation.NormalIterations;
  this->NumberOfPointIterations = operation.PointIterations;
  this->CandidateThreshold = operation.CandidateThreshold;
  this->CandidateScale = operation.CandidateScale;
  this->UseSkeleton = operation.UseSkeleton;
  this->SkeletonRadius = operation.SkeletonRadius;
  this->BundleAngle = Rounded(vtkMath::DegreesFromRadians(operation.BundleAngle));
  this->MaximumNumberOfNormals = operation.MaximumBundles;
  this->NumberOfPatchNeighbors = operation.PatchNeighbors;
  this->PatchAgreement = operation.PatchAgreement;
  this->MemberAgreement = operation.PatchMemberAgreement;
  this->BundleReach = operation.BundleReach;
  this->FeaturePull = operation.FeaturePull;
  this->UnorientedNormals = operation.Unoriented;
}

vtkGuidedPointNormalFilter::~vtkGuidedPointNormalFilter() = default;

void vtkGuidedPointNormalFilter::Configure(sd::PointDenoisingSettings& settings)
{
  this->Superclass::Configure(settings);
  auto& operation = std::get<sd::NormalBundlesSettings>(settings.Operator);
  this->Open->Take("NumberOfNormalIterations", this->NumberOfNormalIterations,
    operation.NormalIterations);
  this->Open->Take("NumberOfPointIterations", this->NumberOfPointIterations,
    operation.PointIterations);
  this->Open->Take("RangeScale", this->RangeScale, operation.RangeScale, 1.0, 0.01);
  this->Open->Take("SpatialScale", this->SpatialScale, operation.SpatialScale, 1.0, 0.1);
  operation.CandidateThreshold = this->CandidateThreshold;
  operation.CandidateScale = this->CandidateScale;
  operation.UseSkeleton = this->UseSkeleton;
  operation.SkeletonRadius = this->SkeletonRadius;
  operation.BundleAngle = vtkMath::RadiansFromDegrees(this->BundleAngle);
  operation.MaximumBundles = this->MaximumNumberOfNormals;
  operation.PatchNeighbors = this->NumberOfPatchNeighbors;
  operation.PatchAgreement = this->PatchAgreement;
  operation.PatchMemberAgreement = this->MemberAgreement;
  operation.BundleReach = this->BundleReach;
  operation.FeaturePull = this->FeaturePull;
  operation.Unoriented = this->UnorientedNormals;
}

void vtkGuidedPointNormalFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RangeScale: " << this->RangeScale << "\n";
  os << indent << "SpatialScale: " << this->SpatialScale << "\n";
  os << indent << "NumberOfNormalIterations: " << this->NumberOfNormalIterations << "\n";
  os << indent << "NumberOfPointIterations: " << this->NumberOfPointIterations << "\n";
  os << indent << "CandidateThreshold: " << this->CandidateThreshold << "\n";
  os << indent << "CandidateScale: " << this->CandidateScale << "\n";
  os << indent << "UseSkeleton: " << this->UseSkeleton << "\n";
  os << indent << "SkeletonRadius: " << this->SkeletonRadius << "\n";
  os << indent << "BundleAngle: " << this->BundleAngle << "\n";
  os << indent << "MaximumNumberOfNormals: " << this->MaximumNumberOfNormals << "\n";
  os << indent << "NumberOfPatchNeighbors: " << this->NumberOfPatchNeighbors << "\n";
  os << indent << "PatchAgreement: " << this->PatchAgreement << "\n";
  os << indent << "MemberAgreement: " << this->MemberAgreement << "\n";
  os << indent << "BundleReach: " << this->BundleReach << "\n";
  os << indent << "FeaturePull: " << this->FeaturePull << "\n";
  os << indent << "UnorientedNormals: " << this->UnorientedNormals << "\n";
}
