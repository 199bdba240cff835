// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
// What vtkSurfaceComparison measures of points.

#include "LineAngles.h"
#include "SurfaceComparisonWork.h"

#include <cmath>

using namespace SurfaceDenoising;

bool vtkSurfaceComparison::MeasurePointSets(Work& work)
{
  const ComparedSurface& result = work.Result;
  const ComparedSurface& reference = work.Reference;
  SMPExecution& execution = work.Execution;

  const NearestElements there = FindNearestPoints(reference.Points, result.Points, execution);
  if (!execution.Proceed(0.6))
  {
    return false;
  }
  const NearestElements back = FindNearestPoints(result.Points, reference.Points, execution);
  const PointSetDistances distances = ComparePointSets(there.Distances, back.Distances, execution);
  this->ChamferDistance = distances.Chamfer;
  this->SquaredChamferDistance = distances.SquaredChamfer;
  this->PointHausdorffToReference = distances.ToReference;
  this->PointHausdorffFromReference = distances.FromReference;
  this->PointHausdorffDistance = distances.Hausdorff;
  if (!execution.Proceed(0.7))
  {
    return false;
  }
  this->SpacingVariation = Variation(NearestSpacings(result.Points, execution), execution);
  this->ReferenceSpacingVariation =
    Variation(NearestSpacings(reference.Points, execution), execution);
  return execution.Proceed(0.8);
}

void vtkSurfaceComparison::MeasureSides(Work& work)
{
  const ComparedSurface& result = work.Result;
  const ComparedSurface& reference = work.Reference;
  const Buffer<Vec3>& positions = result.View.Mesh.Positions;
  work.Sides = std::make_unique<SurfaceSides>(reference.View.Mesh, reference.Census,
    reference.Geometry, work.Execution);

  Buffer<double> distances(work.Distances);
  result.LeaveOutUnused(distances);
  const Buffer<unsigned char> near =
    MarkPositions(*work.Sides, positions, work.PointPartner, work.NearFaces, work.Execution);
  const DividedMean means = MeansByMark(distances, near, work.Execution);
  this->FeatureDistance = means.Inside;
  this->SmoothDistance = means.Outside;
  this->FeaturePoints = 0.0;
  for (std::size_t v = 0; v < near.size(); ++v)
  {
    this->FeaturePoints += near[v] != 0 && !std::isnan(distances[v]);
  }

  if (work.Sides->AgreeOnOutside())
  {
    work.Execution.For(distances.size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t v = begin; v < end; ++v)
        {
          distances[v] =
            work.Sides->SignedDistance(positions[v], work.PointPartner[v], distances[v]);
        }
      });
    this->MeanSignedDistance = Summarize(distances, {}, work.Execution).Mean;
  }
}

void vtkSurfaceComparison::ComparePointNormals(Work& work)
{
  const ComparedSurface& result = work.Result;
  const ComparedSurface& reference = work.Reference;
  Buffer<Vec3> normals;
  Buffer<Vec3> expected;
  if (!result.ReadPointNormals(normals, work.Execution) ||
    (reference.IsCloud() && !reference.ReadPointNormals(expected, work.Execution)))
  {
    return;
  }
  LineAngles angles = reference.IsCloud()
    ? CompareWithPoints(normals, work.PointPartner, expected, work.Execution)
    : CompareWithFaces(normals, result.View.Mesh.Positions, work.PointPartner, *work.Sides,
        reference.Geometry.Normals, work.Execution);
  work.PointNormalAngles = angles.Degrees;
  result.LeaveOutUnused(angles.Degrees);
  const LineAngleSummary summary = Summarize(angles, work.Execution);
  this->MeanPointNormalAngle = summary.Mean;
  this->RMSPointNormalAngle = summary.RootMeanSquare;
  this->SharePointNormalsWithin10 = summary.ShareWithin10;
  this->FlippedPointNormals = summary.Flipped;
}
