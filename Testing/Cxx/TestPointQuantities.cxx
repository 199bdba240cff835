// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSurfaceComparison compares the normals of points, tells those near features from others and
// inside from outside, and does not depend on how a model is turned and numbered.

#include "PointComparisonExample.h"

#include "vtkFloatArray.h"

using namespace PointComparison;

namespace
{

void CheckNoNormals(vtkSurfaceComparison* c)
{
  CheckNaN(c->GetMeanPointNormalAngle(), "mean angle without normals");
  CheckNaN(c->GetRMSPointNormalAngle(), "RMS angle without normals");
  CheckNaN(c->GetSharePointNormalsWithin10(), "share without normals");
  CheckNaN(c->GetFlippedPointNormals(), "flips without normals");
  Check(!HasPointArray(c, "PointNormalAngleError"), "no array without normals");
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

}

int TestPointQuantities(int, char*[])
{
  TestNormals();
  TestFeatures();
  TestShrinkage();
  TestInvariance();
  return ExitCode();
}
