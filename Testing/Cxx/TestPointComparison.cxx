// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSurfaceComparison judges point clouds, and the points of surfaces.

#include "SurfaceChecks.h"
#include "TestSurfaces.h"
#include "vtkSurfaceComparison.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <limits>

using namespace SurfaceChecks;

namespace
{

const double NotANumber = std::numeric_limits<double>::quiet_NaN();
using Points = std::vector<Point>;

vtkSmartPointer<vtkSurfaceComparison> Compare(vtkPolyData* result, vtkPolyData* reference,
  int rings = 2)
{
  auto comparison = vtkSmartPointer<vtkSurfaceComparison>::New();
  vtkNew<Messages> messages;
  messages->Watch(comparison);
  comparison->SetInputData(result);
  comparison->SetReferenceData(reference);
  comparison->SetFeatureRings(rings);
  comparison->Update();
  Check(Silent(messages), "nothing to complain about: " + messages->Errors + messages->Warnings);
  return comparison;
}

vtkSmartPointer<vtkPolyData> Cloud(const Points& points) { return MakeSurface(points, {}); }

/// Gives the points normals, active or not.
vtkSmartPointer<vtkPolyData> WithNormals(vtkPolyData* data, const Points& normals,
  bool active = true)
{
  vtkSmartPointer<vtkPolyData> copy = DeepCopy(data);
  vtkNew<vtkDoubleArray> array;
  array->SetName("Normals");
  array->SetNumberOfComponents(3);
  for (const Point& n : normals)
  {
    array->InsertNextTuple(n.data());
  }
  copy->GetPointData()->AddArray(array);
  if (active)
  {
    copy->GetPointData()->SetNormals(array);
  }
  return copy;
}

double PointValue(vtkSurfaceComparison* comparison, const char* name, vtkIdType point)
{
  return comparison->GetOutput()->GetPointData()->GetArray(name)->GetTuple1(point);
}

bool HasPointArray(vtkSurfaceComparison* comparison, const char* name)
{
  return comparison->GetOutput()->GetPointData()->HasArray(name) != 0;
}

// The example: three points near a plane, and the corners of a square in it.
const Points Near{ { 0, 0, 0.1 }, { 1, 0, -0.2 }, { 0, 1, 0.05 } };
const Points NearNormals{ { 0, 0, -1 }, { 0.1, 0, 1 }, { 1, 0, 1 } };
const Points Corners{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } };
const Points Up(4, { 0, 0, 1 });

vtkSmartPointer<vtkPolyData> BigSquare()
{
  return MakeSurface({ { -9, -9, 0 }, { 10, -9, 0 }, { 10, 8, 0 }, { -9, 8, 0 } },
    { { 0, 1, 2, 3 } });
}

void CheckExampleNormals(vtkSurfaceComparison* c)
{
  CheckNear(PointValue(c, "PointNormalAngleError", 0), 0.0, 1e-6, "first normal");
  CheckNear(PointValue(c, "PointNormalAngleError", 1), 5.710593, 1e-6, "second normal");
  CheckNear(PointValue(c, "PointNormalAngleError", 2), 45.0, 1e-6, "third normal");
  CheckNear(c->GetMeanPointNormalAngle(), 16.903531, 1e-6, "mean angle of normals");
  CheckNear(c->GetRMSPointNormalAngle(), 26.189125, 1e-6, "RMS angle of normals");
  CheckNear(c->GetSharePointNormalsWithin10(), 0.666667, 1e-6, "share of good normals");
  Check(c->GetFlippedPointNormals() == 1.0, "one normal is flipped");
}

void CheckNoNormals(vtkSurfaceComparison* c)
{
  CheckNaN(c->GetMeanPointNormalAngle(), "mean angle without normals");
  CheckNaN(c->GetRMSPointNormalAngle(), "RMS angle without normals");
  CheckNaN(c->GetSharePointNormalsWithin10(), "share without normals");
  CheckNaN(c->GetFlippedPointNormals(), "flips without normals");
  Check(!HasPointArray(c, "PointNormalAngleError"), "no array without normals");
}

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

void TestNormals()
{
  // Inactive normals of a cloud are taken, those of a surface are what a filter left over.
  CheckExampleNormals(Compare(WithNormals(Cloud(Near), NearNormals, false), BigSquare()));
  CheckNoNormals(Compare(WithNormals(BigSquare(), Up, false), BigSquare()));
  auto c = Compare(WithNormals(BigSquare(), Up), BigSquare());
  Check(c->GetMeanPointNormalAngle() == 0.0, "active normals of a surface");

  CheckNoNormals(Compare(Cloud(Near), WithNormals(Cloud(Corners), Up)));
  CheckNoNormals(Compare(WithNormals(Cloud(Near), NearNormals), Cloud(Corners)));

  // Some cannot be compared: zero, not finite, nowhere, or without a good normal at the other end.
  Points points(Near);
  Points normals(NearNormals);
  points.insert(points.end(), { { 1, 1, 0 }, { 1, 1, 0.5 }, { NotANumber, 0, 0 } });
  normals.insert(normals.end(), { { 0, 0, 0 }, { NotANumber, 0, 1 }, { 1, 0, 0 } });
  c = Compare(WithNormals(Cloud(points), normals), BigSquare());
  CheckExampleNormals(c);
  CheckNaN(PointValue(c, "PointNormalAngleError", 3), "angle of a zero normal");
  CheckNaN(PointValue(c, "PointNormalAngleError", 4), "angle of a normal that is none");
  CheckNaN(PointValue(c, "PointNormalAngleError", 5), "angle of a point that is nowhere");
  points.push_back({ 5, 5, 5 });
  normals.push_back({ 1, 0, 0 });
  Points corners(Corners);
  corners.push_back({ 5, 5, 5 });
  Points up(Up);
  up.push_back({ 0, 0, 0 });
  CheckExampleNormals(
    Compare(WithNormals(Cloud(points), normals), WithNormals(Cloud(corners), up)));

  // Lengths do not matter, even those of which the squares are no numbers.
  normals = NearNormals;
  for (Point& n : normals)
  {
    n = { 1e200 * n[0], 1e200 * n[1], 1e200 * n[2] };
  }
  CheckExampleNormals(Compare(WithNormals(Cloud(Near), normals), BigSquare()));

  // A point that no polygon uses has an angle but does not count.
  vtkSmartPointer<vtkPolyData> square = BigSquare();
  square->GetPoints()->InsertNextPoint(0.0, 0.0, 1.0);
  Points five(Up);
  five.push_back({ 1, 0, 0 });
  c = Compare(WithNormals(square, five), BigSquare());
  CheckNear(PointValue(c, "PointNormalAngleError", 4), 90.0, 1e-12, "angle of an unused point");
  Check(c->GetMeanPointNormalAngle() == 0.0, "unused points do not count");

  // What is no array of normals.
  vtkSmartPointer<vtkPolyData> cloud = Cloud(Near);
  vtkNew<vtkFloatArray> wrong;
  wrong->SetName("Normals");
  wrong->SetNumberOfTuples(3);
  wrong->FillValue(1.0f);
  cloud->GetPointData()->AddArray(wrong);
  CheckNoNormals(Compare(cloud, BigSquare()));
}

/// Strips of a roof along its ridge x = 0, each one ring: points are near the ridge or not.
vtkSmartPointer<vtkPolyData> Roof()
{
  Points points;
  std::vector<std::vector<vtkIdType>> quads;
  for (int i = -4; i <= 4; ++i)
  {
    points.push_back({ double(i), 0.0, -std::abs(i) * 1.0 });
    points.push_back({ double(i), 1.0, -std::abs(i) * 1.0 });
  }
  for (vtkIdType a = 0; a + 3 < 18; a += 2)
  {
    quads.push_back({ a, a + 2, a + 3, a + 1 });
  }
  return MakeSurface(points, quads);
}

void TestFeatures()
{
  const double up = std::sqrt(0.5); // of the normals (-up, 0, up) and (up, 0, up)
  auto above = [&](double x, double height) -> Point {
    return { x + (x < 0 ? -up : up) * height, 0.5, -std::abs(x) + up * height };
  };
  const Points points{ { 0, 0.5, 0.3 }, above(0.5, 0.1), above(-0.5, 0.3), above(1.5, -0.2),
    above(-2.5, 0.5), above(3.5, 0.6), { NotANumber, 0, 0 } };
  auto check = [&](int rings, int count, double feature, double smooth)
  {
    auto c = Compare(Cloud(points), Roof(), rings);
    Check(c->GetFeaturePoints() == count, "points near the ridge");
    CheckNear(c->GetFeatureDistance(), feature, 1e-14, "mean distance near the ridge");
    CheckNear(c->GetSmoothDistance(), smooth, 1e-14, "mean distance elsewhere");
    CheckNear(c->GetMeanDistance(), 2.0 / 6.0, 1e-14, "mean distance");
    CheckNear(c->GetMeanSignedDistance(), 1.6 / 6.0, 1e-14, "mean signed distance");
  };
  check(1, 3, 0.7 / 3.0, 1.3 / 3.0);
  check(2, 4, 0.9 / 4.0, 1.1 / 2.0);
  check(3, 5, 1.4 / 5.0, 0.6);

  // A surface of another connectivity, and points that no polygon uses.
  auto patch = MakeSurface({ above(0.5, 0.1), above(0.6, 0.2), above(3.5, 0.4), above(3.5, 0.9) },
    { { 0, 1, 2 } });
  auto c = Compare(patch, Roof(), 1);
  Check(c->GetSameConnectivity() == 0.0 && c->GetFeaturePoints() == 2.0, "points of a surface");
  CheckNear(c->GetFeatureDistance(), 0.15, 1e-14, "mean distance of a surface near the ridge");
  CheckNear(c->GetSmoothDistance(), 0.4, 1e-14, "mean distance of a surface elsewhere");
  CheckNaN(c->GetFeatureFaces(), "faces near features need the same connectivity");

  c = Compare(patch, Roof(), 9);
  Check(c->GetFeaturePoints() == 3.0, "a point that no polygon uses is not near features");
  CheckNaN(c->GetSmoothDistance(), "nothing is elsewhere");

  // A point above the end of the first ring has faces of both kinds nearest.
  c = Compare(Cloud({ above(1.0, 0.1), above(-1.0, 0.2) }), Roof(), 1);
  Check(c->GetFeaturePoints() == 2.0, "on the border is near");
}

void TestShrinkage()
{
  vtkSmartPointer<vtkPolyData> cube = Transformed(MakeCube(), 1.0, { -0.5, -0.5, -0.5 });
  auto c = Compare(Transformed(cube, 0.9, { 0, 0, 0 }), cube);
  CheckNear(c->GetMeanSignedDistance(), -0.05, 1e-15, "a smaller cube is inside");
  c = Compare(Transformed(cube, 1.2, { 0, 0, 0 }), cube);
  CheckNear(c->GetMeanSignedDistance(), 0.1 * std::sqrt(3.0), 1e-15, "a larger cube is outside");
  c = Compare(Transformed(cube, 1.2, { 0, 0, 0 }), MeshTest::Turned(cube));
  CheckNaN(c->GetMeanSignedDistance(), "sides that faces do not agree on");
}

/// Every quantity of a cloud and of a surface is the same for a turned model in another order.
void TestInvariance()
{
  const vtkSmartPointer<vtkPolyData> truth = MeshTest::NoisyBox(4, 0.05);
  const vtkSmartPointer<vtkPolyData> noisy = MeshTest::NoisyBox(4, 0.15);
  const MeshTest::Ids order = MeshTest::Shuffled(noisy->GetNumberOfPoints(), 5);
  const MeshTest::Ids cells = MeshTest::Shuffled(noisy->GetNumberOfCells(), 6);
  vtkNew<vtkTransform> turn;
  turn->Translate(3.0, -2.0, 5.0);
  turn->RotateWXYZ(50.0, 1.0, 2.0, -3.0);
  auto normalsOf = [&](vtkPolyData* data, vtkTransform* transform)
  {
    Points normals;
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      Point n{ MeshTest::Wobble(i), MeshTest::Wobble(5 * i), MeshTest::Wobble(9 * i) };
      if (transform)
      {
        transform->TransformVector(n.data(), n.data());
      }
      normals.push_back(n);
    }
    return normals;
  };
  auto permuted = [&](const Points& normals)
  {
    Points result(normals.size());
    for (std::size_t i = 0; i < normals.size(); ++i)
    {
      result[static_cast<std::size_t>(order[i])] = normals[i];
    }
    return result;
  };
  const auto turned = [&](vtkPolyData* data) { return MeshTest::Moved(data, turn); };

  for (const bool resultIsCloud : { false, true })
  {
    for (const bool referenceIsCloud : { false, true })
    {
      auto result = WithNormals(noisy, normalsOf(noisy, nullptr));
      auto reference = WithNormals(truth, normalsOf(truth, nullptr));
      auto otherResult = WithNormals(MeshTest::Permuted(turned(noisy), order, cells),
        permuted(normalsOf(noisy, turn)));
      auto otherReference = WithNormals(MeshTest::Permuted(turned(truth), order, cells),
        permuted(normalsOf(truth, turn)));
      for (vtkPolyData* data : { result.Get(), otherResult.Get() })
      {
        data->SetPolys(resultIsCloud ? nullptr : data->GetPolys());
      }
      for (vtkPolyData* data : { reference.Get(), otherReference.Get() })
      {
        data->SetPolys(referenceIsCloud ? nullptr : data->GetPolys());
      }
      auto comparison = Compare(result, reference);
      auto other = Compare(otherResult, otherReference);
      vtkTable* a = comparison->GetTable();
      vtkTable* b = other->GetTable();
      for (vtkIdType i = 0; i < a->GetNumberOfColumns(); ++i)
      {
        const double x = a->GetValue(0, i).ToDouble();
        const double y = b->GetValue(0, i).ToDouble();
        const std::string name = a->GetColumnName(i);
        // The bounding box is along the axes; the diagonal is that of something else.
        if (name.find("Relative") == std::string::npos && name != "ReferenceDiagonal" &&
          std::isnan(x) + std::isnan(y) < 2)
        {
          CheckNear(x, y, 1e-10 * std::max(1.0, std::abs(x)), name + " turned and shuffled");
        }
      }
    }
  }
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
  TestNormals();
  TestFeatures();
  TestShrinkage();
  TestInvariance();
  TestFewPoints();
  return ExitCode();
}
