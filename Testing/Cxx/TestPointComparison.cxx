// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSurfaceComparison judges point clouds, and the points of surfaces, by their distances.

#include "PointComparisonExample.h"

using namespace PointComparison;

namespace
{

void CheckNoFaces(vtkSurfaceComparison* c)
{
  Check(c->GetSameConnectivity() == 0.0, "clouds have no faces that correspond");
  for (const char* name : { "UncomparedFaces", "MeanNormalAngle", "FlippedFaces", "Volume",
         "RelativeVolumeChange", "FeatureFaces", "ReferenceFeatureEdges", "SmoothNormalAngle" })
  {
    CheckNaN(c->GetTable()->GetValueByName(0, name).ToDouble(), std::string(name) + " of a cloud");
  }
}

void TestCloudAgainstSurface()
{
  auto c = Compare(WithNormals(Cloud(Near), NearNormals), BigSquare());
  CheckNear(c->GetMeanDistance(), 0.116667, 1e-6, "mean distance");
  CheckNear(c->GetRMSDistance(), 0.132288, 1e-6, "RMS distance");
  CheckNear(c->GetMaximumDistance(), 0.2, 1e-6, "maximum distance");
  CheckNear(c->GetMeanSignedDistance(), -0.016667, 1e-6, "mean signed distance");
  const double diagonal = std::hypot(19.0, 17.0);
  CheckNear(c->GetReferenceDiagonal(), diagonal, 1e-14, "diagonal of the square");
  CheckNear(c->GetRelativeRMSDistance(), c->GetRMSDistance() / diagonal, 1e-15, "relative RMS");
  CheckNear(c->GetRelativeMaximumDistance(), 0.2 / diagonal, 1e-15, "relative maximum");
  CheckNear(c->GetHausdorffToReference(), 0.2, 1e-14, "Hausdorff distance to the surface");
  CheckNaN(c->GetHausdorffDistance(), "there are no faces to come back to");
  Check(c->GetFeaturePoints() == 0.0, "a plane has no features");
  CheckNaN(c->GetFeatureDistance(), "nothing is near features");
  CheckNear(c->GetSmoothDistance(), c->GetMeanDistance(), 1e-15, "all are elsewhere");
  CheckExampleNormals(c);
  CheckNoFaces(c);
}

void TestCloudAgainstCloud()
{
  auto c = Compare(WithNormals(Cloud(Near), NearNormals), WithNormals(Cloud(Corners), Up));
  CheckNear(PointValue(c, "Distance", 1), 0.2, 1e-15, "distance to the nearest point");
  CheckNear(c->GetMeanDistance(), 0.116667, 1e-6, "mean distance");
  CheckNear(c->GetRMSDistance(), 0.132288, 1e-6, "RMS distance");
  CheckNear(c->GetMaximumDistance(), 0.2, 1e-6, "maximum distance");
  CheckNear(c->GetChamferDistance(), 0.227239, 1e-6, "Chamfer distance");
  CheckNear(c->GetSquaredChamferDistance(), 0.281250, 1e-6, "squared Chamfer distance");
  CheckNear(c->GetPointHausdorffToReference(), 0.2, 1e-6, "Hausdorff distance of points");
  CheckNear(c->GetPointHausdorffFromReference(), 1.001249, 1e-6, "Hausdorff distance back");
  CheckNear(c->GetPointHausdorffDistance(), 1.001249, 1e-6, "larger Hausdorff distance");
  CheckNear(c->GetReferenceDiagonal(), std::sqrt(2.0), 1e-15, "diagonal of points");
  CheckNear(c->GetRelativeMaximumDistance(), 0.2 / std::sqrt(2.0), 1e-14, "relative maximum");
  Check(c->GetReferenceSpacingVariation() == 0.0, "the corners are even");
  CheckExampleNormals(c);
  for (const double undefined : { c->GetMeanSignedDistance(), c->GetFeaturePoints(),
         c->GetFeatureDistance(), c->GetSmoothDistance(), c->GetHausdorffDistance() })
  {
    CheckNaN(undefined, "what needs faces of the reference");
  }
  CheckNoFaces(c);
  CheckNoFaces(Compare(Cloud(Corners), Cloud(Corners))); // as many points
}

void TestSpacing()
{
  // Spacings 1, 1, 2, 5: mean 9/4, variance 31/4 - 81/16.
  auto c =
    Compare(Cloud({ { 0, 0, 0 }, { 1, 0, 0 }, { 3, 0, 0 }, { 8, 0, 0 } }), Cloud({ { 0, 0, 0 } }));
  CheckNear(c->GetSpacingVariation(), std::sqrt(43.0) / 9.0, 1e-14, "spacing");
  CheckNaN(c->GetReferenceSpacingVariation(), "spacing of a single point");
}

/// A surface against a cloud, and a cloud in the guise of a surface.
void TestSurfaceAgainstCloud()
{
  vtkSmartPointer<vtkPolyData> cube = MakeCube();
  cube->GetPoints()->InsertNextPoint(9.0, 0.0, 0.0); // in no polygon
  auto c = Compare(cube, Cloud({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 3, 0 } }));
  CheckNear(PointValue(c, "Distance", 4), 1.0, 1e-15, "distance of a corner to the nearest point");
  CheckNear(PointValue(c, "Distance", 8), 8.0, 1e-15, "all points have a distance");
  CheckNear(c->GetMaximumDistance(), std::sqrt(2.0), 1e-15, "but only those of polygons count");
  CheckNear(c->GetPointHausdorffToReference(), std::sqrt(2.0), 1e-15, "here as well");
  CheckNear(c->GetPointHausdorffFromReference(), 2.0, 1e-15, "from a point to the corners");
  CheckNear(c->GetHausdorffFromReference(), 2.0, 1e-14, "from a point to the faces");
  CheckNear(c->GetHausdorffToReference(), std::sqrt(2.0), 1e-14, "from the corners");
  CheckNear(c->GetVolume(), 1.0, 1e-15, "the result has a volume");
  CheckNear(c->GetTriangleQuality(), std::sqrt(0.5), 1e-15, "and triangles");
  CheckNaN(c->GetFlippedFaces(), "but nothing to compare its faces with");
  CheckNaN(c->GetOutput()->GetCellData()->GetArray("NormalAngleError")->GetTuple1(0), "angle");

  // No area: the polygon is forgotten, and the point that it does not use counts.
  vtkSmartPointer<vtkPolyData> line =
    MakeSurface({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 2, 0, 7 } }, { { 0, 1, 2 } });
  c = Compare(Cloud({ { 0.5, 0, 0 }, { 2, 0, 5 } }), line);
  CheckNear(PointValue(c, "Distance", 0), 0.5, 1e-15, "distance to a point, not to the line");
  CheckNear(PointValue(c, "Distance", 1), 2.0, 1e-15, "distance to a point outside the polygon");
  CheckNear(c->GetReferenceDiagonal(), std::sqrt(53.0), 1e-14, "diagonal of all points");
  CheckNoFaces(Compare(line, line));
}

/// Digits must not get lost far from the origin: a surface is equal to its own points.
void TestFarAway()
{
  const vtkSmartPointer<vtkPolyData> box = MeshTest::NoisyBox(3, 0.1);
  for (const auto& surface : { box, Transformed(MakeCube(), 1.0 / 3.0, { 1e6, -3e6, 1e7 }) })
  {
    vtkSmartPointer<vtkPolyData> points = DeepCopy(surface);
    points->SetPolys(nullptr);
    Check(Compare(surface, points)->GetMaximumDistance() == 0.0, "a surface has its points");
    for (const auto& c :
      { Compare(surface, points), Compare(points, surface), Compare(points, points) })
    {
      Check(c->GetPointHausdorffDistance() == 0.0, "the points are the same");
    }
  }
  // Without rounding of the input.
  auto c = Compare(Transformed(Cloud(Near), 1.0, { 1048576, 1048576, 0 }),
    Transformed(BigSquare(), 1.0, { 1048576, 1048576, 0 }));
  CheckNear(c->GetMeanSignedDistance(), -0.05 / 3.0, 1e-15, "signed distance far away");
}

void TestFewPoints()
{
  auto c = Compare(Cloud({ { 0, 0, 1 } }), Cloud({ { 0, 3, 5 } }));
  CheckNear(c->GetMeanDistance(), 5.0, 1e-15, "a point from a point");
  CheckNear(c->GetSquaredChamferDistance(), 50.0, 1e-13, "there and back");
  Check(c->GetReferenceDiagonal() == 0.0, "a point has no size");
  CheckNaN(c->GetRelativeMeanDistance(), "relative to the size of a point");
  CheckNaN(c->GetRelativeRMSDistance(), "relative to the size of a point");
  CheckNaN(c->GetRelativeMaximumDistance(), "relative to the size of a point");
  CheckNaN(c->GetSpacingVariation(), "spacing of a point");

  // Points that are nowhere do not count, on either side.
  Points points(Near);
  points.insert(points.begin(), { NotANumber, 0, 0 });
  points.push_back({ 0, -std::numeric_limits<double>::infinity(), 0 });
  Points corners(Corners);
  corners.insert(corners.begin() + 1, { 0, 0, NotANumber });
  c = Compare(Cloud(points), Cloud(corners));
  CheckNaN(PointValue(c, "Distance", 0), "distance of a point that is nowhere");
  CheckNear(c->GetMeanDistance(), 0.116667, 1e-6, "mean distance of the others");
  CheckNear(c->GetChamferDistance(), 0.227239, 1e-6, "Chamfer distance of the others");
  CheckNear(c->GetReferenceDiagonal(), std::sqrt(2.0), 1e-15, "diagonal of the others");
  CheckNear(c->GetReferenceSpacingVariation(), 0.0, 1e-15, "spacing of the others");

  // A result without any has no distances.
  c = Compare(Cloud({ { NotANumber, 0, 0 } }), MakeCube());
  for (const double undefined :
    { c->GetMeanDistance(), c->GetRMSDistance(), c->GetMaximumDistance(),
      c->GetMeanSignedDistance(), c->GetChamferDistance(), c->GetPointHausdorffDistance() })
  {
    CheckNaN(undefined, "distance of nothing");
  }
  Check(c->GetFeaturePoints() == 0.0, "no points, none near features");
}

}

int TestPointComparison(int, char*[])
{
  TestCloudAgainstSurface();
  TestCloudAgainstCloud();
  TestSpacing();
  TestSurfaceAgainstCloud();
  TestFarAway();
  TestFewPoints();
  return ExitCode();
}
