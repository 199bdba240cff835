// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
// What vtkSurfaceComparison measures.

#include "SurfaceComparisonWork.h"

#include <cmath>
#include <limits>

using namespace SurfaceDenoising;

namespace
{

constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();

/// Larger of two numbers; NaN if one of them is NaN.
double Larger(double a, double b) { return std::isnan(a) || a > b ? a : b; }

}

bool vtkSurfaceComparison::Compare(Work& work)
{
  if (!this->ReadSurfaces(work) || !this->MeasureDistances(work))
  {
    return false;
  }
  this->CompareNormals(work);
  this->CompareShapes(work);
  if (this->SameConnectivity != 0.0)
  {
    this->CompareFeatures(work);
  }
  return work.Execution.Proceed(1.0);
}

bool vtkSurfaceComparison::ReadSurfaces(Work& work)
{
  ComparedSurface& result = work.Result;
  ComparedSurface& reference = work.Reference;
  std::string why;
  if (!ReadSurface(result.Data, result.View, why, work.Execution))
  {
    work.Error = "The input cannot be compared. " + why;
    return false;
  }
  if (!ReadSurface(reference.Data, reference.View, why, work.Execution))
  {
    work.Error = "The reference cannot be compared with. " + why;
    return false;
  }
  const bool same = HaveSameFaces(result.Data, reference.Data);
  this->SameConnectivity = same;
  if (same)
  {
    TriangulateAlike(reference.View, result.View);
  }
  // From here on in the coordinates of the reference.
  const Vec3 shift = result.View.Centre - reference.View.Centre;
  for (Vec3& position : result.View.Mesh.Positions)
  {
    position += shift;
  }
  result.Analyze(work.Execution);
  reference.Analyze(work.Execution);
  if (!reference.HasArea())
  {
    work.Error = "The reference is no surface: it has no polygon or strip with an area.";
    return false;
  }
  return work.Execution.Proceed(0.1);
}

bool vtkSurfaceComparison::MeasureDistances(Work& work)
{
  const ComparedSurface& result = work.Result;
  const ComparedSurface& reference = work.Reference;
  SMPExecution& execution = work.Execution;

  const TriangleTree referenceFaces = reference.MakeTree();
  NearestFaces vertices = FindNearest(referenceFaces, result.View.Mesh.Positions, execution);
  if (!execution.Proceed(0.3))
  {
    return false;
  }
  NearestFaces centroids = FindNearest(referenceFaces, result.Geometry.Centroids, execution);
  if (!execution.Proceed(0.5))
  {
    return false;
  }
  work.Distances = std::move(vertices.Distances);
  work.Partner = std::move(centroids.Faces);
  const Statistics distances = result.SummarizeVertices(work.Distances, execution);
  this->MeanDistance = distances.Mean;
  this->HausdorffToReference =
    std::fmax(distances.Maximum, Summarize(centroids.Distances, {}, execution).Maximum);

  // The way back. Without faces in the result all distances are NaN.
  const TriangleTree resultFaces = result.MakeTree();
  vertices = FindNearest(resultFaces, reference.View.Mesh.Positions, execution);
  if (!execution.Proceed(0.7))
  {
    return false;
  }
  centroids = FindNearest(resultFaces, reference.Geometry.Centroids, execution);
  this->HausdorffFromReference =
    std::fmax(reference.SummarizeVertices(vertices.Distances, execution).Maximum,
      Summarize(centroids.Distances, {}, execution).Maximum);
  this->HausdorffDistance = Larger(this->HausdorffToReference, this->HausdorffFromReference);
  return execution.Proceed(0.9);
}

void vtkSurfaceComparison::CompareNormals(Work& work)
{
  const Buffer<Vec3>& normals = work.Result.Geometry.Normals;
  const Buffer<Vec3>& expected = work.Reference.Geometry.Normals;
  const bool same = this->SameConnectivity != 0.0;
  Buffer<double>& angles = work.NormalAngles;
  angles.resize(normals.size());
  work.Execution.For(angles.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t f = begin; f < end; ++f)
      {
        const Index partner = same ? static_cast<Index>(f) : work.Partner[f];
        angles[f] = partner == NoIndex ? Undefined : AngleBetween(normals[f], expected[partner]);
      }
    });

  const Statistics angle = Summarize(angles, work.Result.Geometry.Areas, work.Execution);
  this->UncomparedFaces = static_cast<double>(angles.size() - angle.Count);
  this->MeanNormalAngle = angle.Mean;
  this->RMSNormalAngle = angle.RootMeanSquare;
  this->MedianNormalAngle = angle.Median;
  this->Percentile95NormalAngle = angle.Percentile95;
  this->MaximumNormalAngle = angle.Maximum;
  this->AreaWeightedNormalAngle = angle.WeightedMean;
  this->FlippedFaces = static_cast<double>(
    std::count_if(angles.begin(), angles.end(), [](double a) { return a > 90.0; }));
}

void vtkSurfaceComparison::CompareFeatures(Work& work)
{
  const NeighborGraph edges =
    EdgeAdjacentFaces(work.Reference.View.Mesh, work.Reference.Stars, work.Execution);
  const FeatureAgreement features = CompareFeatureEdges(edges, work.Result.Geometry.Normals,
    work.Reference.Geometry.Normals, this->FeatureAngle, work.Execution);
  this->ReferenceFeatureEdges = static_cast<double>(features.Reference);
  this->FoundFeatureEdges = static_cast<double>(features.Found);
  this->MissedFeatureEdges = static_cast<double>(features.Missed());
  this->InventedFeatureEdges = static_cast<double>(features.Invented);

  const Buffer<unsigned char> near =
    FacesNearFeatures(work.Reference.View.Mesh, work.Reference.Stars, edges,
      work.Reference.Geometry.Normals, this->FeatureAngle, this->FeatureRings, work.Execution);
  this->FeatureFaces = static_cast<double>(std::count(near.begin(), near.end(), 1));
  const DividedMean angles = MeansByMark(work.NormalAngles, near, work.Execution);
  this->FeatureNormalAngle = angles.Inside;
  this->SmoothNormalAngle = angles.Outside;
}

void vtkSurfaceComparison::CompareShapes(Work& work)
{
  const ComparedSurface& result = work.Result;
  const ComparedSurface& reference = work.Reference;
  this->ReferenceDiagonal = reference.Diagonal();
  this->PositionError =
    AreaWeightedDistance(result.View.Mesh, result.Geometry.Areas, work.Distances, work.Execution);
  this->RelativePositionError = this->PositionError / this->ReferenceDiagonal;
  this->RelativeMeanDistance = this->MeanDistance / this->ReferenceDiagonal;
  this->RelativeHausdorffDistance = this->HausdorffDistance / this->ReferenceDiagonal;

  this->Volume = result.EnclosedVolume(work.Execution);
  this->ReferenceVolume = reference.EnclosedVolume(work.Execution);
  this->RelativeVolumeChange = this->ReferenceVolume == 0.0
    ? Undefined
    : (this->Volume - this->ReferenceVolume) / this->ReferenceVolume;

  this->TriangleQuality =
    SurfaceDenoising::TriangleQuality(result.View.Mesh, result.Geometry.Areas, work.Execution);
  this->ReferenceTriangleQuality = SurfaceDenoising::TriangleQuality(reference.View.Mesh,
    reference.Geometry.Areas, work.Execution);
}
