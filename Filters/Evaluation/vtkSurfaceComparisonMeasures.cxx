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
  if (!this->ReadSurfaces(work) || !this->MeasureDistances(work) || !this->MeasurePointSets(work))
  {
    return false;
  }
  this->CompareShapes(work);
  if (!work.Reference.IsCloud())
  {
    this->CompareNormals(work);
    this->CompareFeatures(work);
    this->MeasureSides(work);
  }
  this->ComparePointNormals(work);
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
  if (same)
  {
    TriangulateAlike(reference.View, result.View);
  }
  // From here on in the coordinates of the reference, or of the result if that alone is a surface.
  const Vec3 shift = result.View.Centre - reference.View.Centre;
  if (reference.IsCloud())
  {
    reference.Shift(-shift);
  }
  else
  {
    result.Shift(shift);
  }
  result.Analyze(work.Execution);
  reference.Analyze(work.Execution);
  if (!reference.HasArea())
  {
    reference.BecomeCloud(work.Execution);
  }
  if (!reference.HasPoints())
  {
    work.Error = "The reference has no point with finite coordinates.";
    return false;
  }
  this->SameConnectivity = same && !reference.IsCloud();
  return work.Execution.Proceed(0.1);
}

bool vtkSurfaceComparison::MeasureDistances(Work& work)
{
  const ComparedSurface& result = work.Result;
  const ComparedSurface& reference = work.Reference;
  SMPExecution& execution = work.Execution;

  const TriangleTree referenceFaces = reference.MakeTree();
  auto findNearest = [&](const Buffer<Vec3>& positions)
  {
    return reference.IsCloud() ? FindNearestPoints(reference.Points, positions, execution)
                               : FindNearest(referenceFaces, positions, execution);
  };
  NearestElements vertices = findNearest(result.View.Mesh.Positions);
  if (!execution.Proceed(0.2))
  {
    return false;
  }
  NearestElements centroids = findNearest(result.Geometry.Centroids);
  if (!execution.Proceed(0.3))
  {
    return false;
  }
  work.Distances = std::move(vertices.Distances);
  work.PointPartner = std::move(vertices.Numbers);
  work.Partner = std::move(centroids.Numbers);
  const Statistics distances = result.SummarizeVertices(work.Distances, execution);
  this->MeanDistance = distances.Mean;
  this->RMSDistance = distances.RootMeanSquare;
  this->MaximumDistance = distances.Maximum;
  this->HausdorffToReference =
    std::fmax(distances.Maximum, Summarize(centroids.Distances, {}, execution).Maximum);

  // The way back. Without faces in the result all distances are NaN.
  const TriangleTree resultFaces = result.MakeTree();
  vertices = FindNearest(resultFaces, reference.View.Mesh.Positions, execution);
  if (!execution.Proceed(0.4))
  {
    return false;
  }
  centroids = FindNearest(resultFaces, reference.Geometry.Centroids, execution);
  this->HausdorffFromReference =
    std::fmax(reference.SummarizeVertices(vertices.Distances, execution).Maximum,
      Summarize(centroids.Distances, {}, execution).Maximum);
  this->HausdorffDistance = Larger(this->HausdorffToReference, this->HausdorffFromReference);
  return execution.Proceed(0.5);
}

void vtkSurfaceComparison::CompareNormals(Work& work)
{
  if (work.Result.IsCloud()) // not even a number of flipped faces
  {
    return;
  }
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
  work.NearFaces = FacesNearFeatures(work.Reference.View.Mesh, work.Reference.Stars, edges,
    work.Reference.Geometry.Normals, this->FeatureAngle, this->FeatureRings, work.Execution);
  if (this->SameConnectivity == 0.0)
  {
    return;
  }
  const FeatureAgreement features = CompareFeatureEdges(edges, work.Result.Geometry.Normals,
    work.Reference.Geometry.Normals, this->FeatureAngle, work.Execution);
  this->ReferenceFeatureEdges = static_cast<double>(features.Reference);
  this->FoundFeatureEdges = static_cast<double>(features.Found);
  this->MissedFeatureEdges = static_cast<double>(features.Missed());
  this->InventedFeatureEdges = static_cast<double>(features.Invented);

  const Buffer<unsigned char>& near = work.NearFaces;
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
  auto relative = [this](double length) // a single point has no diagonal
  { return this->ReferenceDiagonal > 0.0 ? length / this->ReferenceDiagonal : Undefined; };
  this->PositionError =
    AreaWeightedDistance(result.View.Mesh, result.Geometry.Areas, work.Distances, work.Execution);
  this->RelativePositionError = relative(this->PositionError);
  this->RelativeMeanDistance = relative(this->MeanDistance);
  this->RelativeRMSDistance = relative(this->RMSDistance);
  this->RelativeMaximumDistance = relative(this->MaximumDistance);
  this->RelativeHausdorffDistance = relative(this->HausdorffDistance);

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
