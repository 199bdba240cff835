// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSurfaceComparison tells errors near the edges of a cube from those in the middle of its sides.

#include "SurfaceChecks.h"
#include "vtkSurfaceComparison.h"

#include "vtkFieldData.h"
#include "vtkTable.h"

#include <map>

using namespace SurfaceChecks;

namespace
{

/// A cube of 6 x 6 cells of size 1 on every side, two triangles each. The diagonals of a side all
/// run the same way.
class Cube
{
public:
  static constexpr int Size = 6;

  Cube()
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int i = 0; i < Size; ++i)
      {
        for (int j = 0; j < Size; ++j)
        {
          this->AddCell(axis, i, j, 0, true);
          this->AddCell(axis, i, j, Size, false);
        }
      }
    }
  }

  vtkSmartPointer<vtkPolyData> Surface() const
  {
    return MakeSurface(this->Points, this->Triangles);
  }

  /// The cube with the lattice point p at q.
  vtkSmartPointer<vtkPolyData> Moved(const Point& p, const Point& q) const
  {
    std::vector<Point> points = this->Points;
    points[static_cast<std::size_t>(this->Ids.at(p))] = q;
    return MakeSurface(points, this->Triangles);
  }

private:
  std::vector<Point> Points;
  std::vector<std::vector<vtkIdType>> Triangles;
  std::map<Point, vtkIdType> Ids;

  vtkIdType Id(const Point& p)
  {
    const auto [place, isNew] = this->Ids.emplace(p, static_cast<vtkIdType>(this->Points.size()));
    if (isNew)
    {
      this->Points.push_back(p);
    }
    return place->second;
  }

  void AddCell(int axis, int i, int j, int level, bool turned)
  {
    std::vector<vtkIdType> ids;
    for (const auto& [a, b] : { std::array<int, 2>{ 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } })
    {
      Point p;
      p[axis] = level;
      p[(axis + 1) % 3] = i + a;
      p[(axis + 2) % 3] = j + b;
      ids.push_back(this->Id(p));
    }
    this->Triangles.push_back({ ids[0], ids[1], ids[2] });
    this->Triangles.push_back({ ids[0], ids[2], ids[3] });
    for (std::size_t t = this->Triangles.size() - 2; turned && t < this->Triangles.size(); ++t)
    {
      std::swap(this->Triangles[t][0], this->Triangles[t][1]);
    }
  }
};

vtkSmartPointer<vtkSurfaceComparison> Compare(vtkPolyData* result, vtkPolyData* reference,
  int rings)
{
  auto comparison = vtkSmartPointer<vtkSurfaceComparison>::New();
  comparison->SetInputData(result);
  comparison->SetReferenceData(reference);
  comparison->SetFeatureRings(rings);
  comparison->Update();
  return comparison;
}

/// Raising a point of a flat side by one cell turns six triangles: two, of which it is the right
/// angle, slope along their diagonal, the other four along a leg.
const double SumOfAngles = 4.0 * 45.0 + 2.0 * std::atan(std::sqrt(2.0)) * 180.0 / std::acos(-1.0);

void TestMiddleOfSide()
{
  const Cube cube;
  vtkSmartPointer<vtkPolyData> reference = cube.Surface();
  vtkSmartPointer<vtkPolyData> result = cube.Moved({ 3, 3, 6 }, { 3, 3, 7 });

  // Two rings leave the 2 x 2 cells in the middle of each side, that is, 8 of 72 triangles.
  auto c = Compare(result, reference, 2);
  Check(c->GetReferenceFeatureEdges() == 72.0, "edges of the cube");
  Check(c->GetFeatureFaces() == 6 * 64, "faces of two rings");
  CheckNear(c->GetFeatureNormalAngle(), 0.0, 1e-12, "angle near the edges");
  CheckNear(c->GetSmoothNormalAngle(), SumOfAngles / 48.0, 1e-12, "angle elsewhere");
  CheckNear(c->GetMeanNormalAngle(), SumOfAngles / 432.0, 1e-12, "angle over all faces");
  CheckNear(c->GetTable()->GetValueByName(0, "SmoothNormalAngle").ToDouble(), SumOfAngles / 48.0,
    1e-12, "value in the table");
  vtkFieldData* fields = c->GetOutput()->GetFieldData();
  CheckNear(fields->GetArray("FeatureNormalAngle")->GetTuple1(0), 0.0, 1e-12, "field value");
  Check(fields->GetArray("FeatureFaces")->GetTuple1(0) == 384.0, "number in the field data");

  c = Compare(result, reference, 1);
  Check(c->GetFeatureFaces() == 6 * 40, "one ring is the cells along the edges");
  CheckNear(c->GetSmoothNormalAngle(), SumOfAngles / (6 * 32), 1e-12, "angle elsewhere");

  c = Compare(result, reference, 3);
  Check(c->GetFeatureFaces() == 432.0, "three rings are all of the cube");
  CheckNear(c->GetFeatureNormalAngle(), SumOfAngles / 432.0, 1e-12, "angle over all faces");
  CheckNaN(c->GetSmoothNormalAngle(), "angle of no faces");

  // Features are those of the reference: a spike in the middle of a side counts only there.
  vtkSmartPointer<vtkPolyData> spike = cube.Moved({ 3, 3, 6 }, { 3, 3, 9 });
  c = Compare(spike, reference, 1);
  Check(c->GetFeatureFaces() == 6 * 40, "a spike of the result is no feature");
  c = Compare(reference, spike, 1);
  Check(c->GetFeatureFaces() > 6 * 40, "a spike of the reference is one");
}

void TestAtEdge()
{
  const Cube cube;
  auto c = Compare(cube.Moved({ 1, 1, 6 }, { 1, 1, 7 }), cube.Surface(), 2);
  CheckNear(c->GetFeatureNormalAngle(), SumOfAngles / 384.0, 1e-12, "angle near the edges");
  CheckNear(c->GetSmoothNormalAngle(), 0.0, 1e-12, "angle elsewhere");
}

void TestWithoutFeatures()
{
  const Cube cube;
  vtkSmartPointer<vtkPolyData> reference = cube.Surface();
  auto c = vtkSmartPointer<vtkSurfaceComparison>::New();
  c->SetInputData(cube.Moved({ 3, 3, 6 }, { 3, 3, 7 }));
  c->SetReferenceData(reference);
  c->SetFeatureAngle(100.0);
  c->Update();
  Check(c->GetFeatureRings() == 2, "two rings by default");
  Check(c->GetFeatureFaces() == 0.0, "no faces near features");
  CheckNaN(c->GetFeatureNormalAngle(), "angle of no faces");
  CheckNear(c->GetSmoothNormalAngle(), SumOfAngles / 432.0, 1e-12, "angle over all faces");

  // Nearest faces do not tell which ring they are in.
  c = Compare(MakeCube(), reference, 2);
  Check(c->GetSameConnectivity() == 0.0, "six quads are not 432 triangles");
  CheckNaN(c->GetFeatureFaces(), "faces near features of other connectivity");
  CheckNaN(c->GetFeatureNormalAngle(), "angle near features of other connectivity");
  CheckNaN(c->GetSmoothNormalAngle(), "angle elsewhere of other connectivity");

  // Of the coarse cube every face touches an edge.
  c = Compare(MakeCube(), MakeCube(), 1);
  Check(c->GetFeatureFaces() == 12.0 && c->GetFeatureNormalAngle() == 0.0, "a cube of six quads");
  CheckNaN(c->GetSmoothNormalAngle(), "angle of no faces");
  c->SetFeatureRings(0);
  Check(c->GetFeatureRings() == 1, "at least one ring");
}

}

int TestFeatureAngles(int, char*[])
{
  TestMiddleOfSide();
  TestAtEdge();
  TestWithoutFeatures();
  return ExitCode();
}
