// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSurfaceComparison finds the differences that are known by construction.

#include "SurfaceChecks.h"
#include "vtkSurfaceComparison.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"
#include "vtkTable.h"
#include "vtkTriangleFilter.h"

#include <limits>

using namespace SurfaceChecks;

namespace
{

const double NotANumber = std::numeric_limits<double>::quiet_NaN();

vtkSmartPointer<vtkSurfaceComparison> Compare(vtkPolyData* result, vtkPolyData* reference)
{
  auto comparison = vtkSmartPointer<vtkSurfaceComparison>::New();
  comparison->SetInputData(result);
  comparison->SetReferenceData(reference);
  comparison->Update();
  return comparison;
}

double CellError(vtkSurfaceComparison* comparison, vtkIdType cell)
{
  return comparison->GetOutput()->GetCellData()->GetArray("NormalAngleError")->GetTuple1(cell);
}

double DistanceOf(vtkSurfaceComparison* comparison, vtkIdType point)
{
  return comparison->GetOutput()->GetPointData()->GetArray("Distance")->GetTuple1(point);
}

/// Two unit squares side by side, the right one turned up by the angle in degrees.
vtkSmartPointer<vtkPolyData> MakeWedge(double angle)
{
  const double x = 1.0 + std::cos(angle * std::acos(-1.0) / 180.0);
  const double z = std::sin(angle * std::acos(-1.0) / 180.0);
  return MakeSurface(
    { { 0, 0, 0 }, { 1, 0, 0 }, { x, 0, z }, { 0, 1, 0 }, { 1, 1, 0 }, { x, 1, z } },
    { { 0, 1, 4, 3 }, { 1, 2, 5, 4 } });
}

vtkSmartPointer<vtkPolyData> MakePlane(int resolution)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(resolution, resolution);
  plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  plane->Update();
  return plane->GetOutput();
}

void TestIdentical()
{
  vtkSmartPointer<vtkPolyData> cube = MakeCube();
  auto c = Compare(cube, DeepCopy(cube));
  Check(c->GetSameConnectivity() == 1.0, "a copy has the same connectivity");
  Check(c->GetMaximumNormalAngle() == 0.0, "no angle to a copy");
  Check(c->GetPositionError() == 0.0 && c->GetHausdorffDistance() == 0.0, "no distance to a copy");
  Check(c->GetFlippedFaces() == 0.0 && c->GetUncomparedFaces() == 0.0, "all faces agree");
  CheckNear(c->GetVolume(), 1.0, 1e-15, "volume of a cube");
  Check(c->GetRelativeVolumeChange() == 0.0, "volume of a copy");
  Check(c->GetReferenceFeatureEdges() == 12.0, "edges of a cube");
  Check(c->GetFoundFeatureEdges() == 12.0 && c->GetMissedFeatureEdges() == 0.0 &&
      c->GetInventedFeatureEdges() == 0.0,
    "features of a copy");
  CheckNear(c->GetReferenceDiagonal(), std::sqrt(3.0), 1e-15, "diagonal of a cube");
  CheckNear(c->GetTriangleQuality(), std::sqrt(0.5), 1e-15, "quality of half squares");
}

void TestMovedCube()
{
  for (const double far : { 0.0, 1048576.0 }) // far from the origin, digits must not get lost
  {
    vtkSmartPointer<vtkPolyData> cube = Transformed(MakeCube(), 1.0, { far, -far, far });
    auto c = Compare(Transformed(cube, 1.0, { 0.0, 0.0, 0.25 }), cube);
    Check(c->GetMaximumNormalAngle() == 0.0, "moving turns nothing");
    // The lower corners are on the sides of the reference, the upper ones above its top.
    CheckNear(DistanceOf(c, 0), 0.0, 1e-14, "distance to the surface, not to its points");
    CheckNear(DistanceOf(c, 7), 0.25, 1e-14, "distance of an upper corner");
    CheckNear(c->GetMeanDistance(), 0.125, 1e-14, "mean distance");
    CheckNear(c->GetRelativeMeanDistance(), 0.125 / std::sqrt(3.0), 1e-14, "relative distance");
    CheckNear(c->GetPositionError(), 0.25 * std::sqrt(0.5), 1e-14, "E_v: half of all face corners");
    CheckNear(c->GetRelativePositionError(), 0.25 * std::sqrt(0.5 / 3.0), 1e-14, "relative E_v");
    CheckNear(c->GetHausdorffToReference(), 0.25, 1e-14, "Hausdorff distance to the reference");
    CheckNear(c->GetHausdorffFromReference(), 0.25, 1e-14, "Hausdorff distance back");
    CheckNear(c->GetRelativeHausdorffDistance(), 0.25 / std::sqrt(3.0), 1e-14,
      "relative Hausdorff");
    CheckNear(c->GetRelativeVolumeChange(), 0.0, 1e-14, "moving keeps the volume");
  }

  auto c = Compare(Transformed(MakeCube(), 1.1, { 0.0, 0.0, 0.0 }), MakeCube());
  CheckNear(c->GetVolume(), 1.331, 1e-14, "volume of a larger cube");
  CheckNear(c->GetRelativeVolumeChange(), 0.331, 1e-14, "change of volume");
  c = Compare(MakeCube(), Transformed(MakeCube(), -1.0, { 0.0, 0.0, 0.0 }));
  CheckNear(c->GetReferenceVolume(), -1.0, 1e-14, "a mirrored cube is inside out");
  CheckNear(c->GetRelativeVolumeChange(), -2.0, 1e-14, "change against a negative volume");
}

/// The Hausdorff distance has two sides that differ.
void TestHausdorffSides()
{
  auto c = Compare(MakePlane(2), Transformed(MakePlane(2), 3.0, { 0.0, 0.0, 0.0 }));
  CheckNear(c->GetHausdorffToReference(), 0.0, 1e-14, "the small plane lies in the large one");
  CheckNear(c->GetHausdorffFromReference(), std::sqrt(2.0), 1e-14, "corners of the large plane");
  CheckNear(c->GetHausdorffDistance(), std::sqrt(2.0), 1e-14, "the larger of the two");
}

void TestAngles()
{
  vtkSmartPointer<vtkPolyData> flat = MakeWedge(0.0);
  vtkSmartPointer<vtkPolyData> wedge = MakeWedge(80.0);
  auto c = Compare(wedge, flat);
  CheckNear(CellError(c, 0), 0.0, 1e-12, "the left square is right");
  CheckNear(CellError(c, 1), 80.0, 1e-12, "the right square is not");
  CheckNear(c->GetMeanNormalAngle(), 40.0, 1e-12, "mean angle");
  CheckNear(c->GetRMSNormalAngle(), 80.0 / std::sqrt(2.0), 1e-12, "RMS angle");
  CheckNear(c->GetMedianNormalAngle(), 40.0, 1e-12, "median angle");
  CheckNear(c->GetPercentile95NormalAngle(), 80.0, 1e-12, "95th percentile");
  CheckNear(c->GetMaximumNormalAngle(), 80.0, 1e-12, "maximum angle");
  CheckNear(c->GetAreaWeightedNormalAngle(), 40.0, 1e-12, "area-weighted angle");
  CheckNaN(c->GetRelativeVolumeChange(), "volume of an open surface");
  Check(c->GetReferenceFeatureEdges() == 0.0 && c->GetInventedFeatureEdges() == 1.0,
    "an edge is invented");
  c = Compare(flat, wedge);
  Check(c->GetReferenceFeatureEdges() == 1.0 && c->GetMissedFeatureEdges() == 1.0 &&
      c->GetInventedFeatureEdges() == 0.0,
    "an edge is missed");
  c->SetFeatureAngle(81.0);
  c->Update();
  Check(c->GetReferenceFeatureEdges() == 0.0, "a smaller angle is no feature");

  c = Compare(MakeWedge(100.0), flat);
  Check(c->GetFlippedFaces() == 2.0, "beyond 90 degrees faces are turned over");
}

/// VTK cuts quads along the shorter diagonal; both surfaces must be cut alike.
void TestQuadsAreCutAlike()
{
  auto reference =
    MakeSurface({ { -1, 0, 0 }, { 0, -2, 0 }, { 1, 0, 0 }, { 0, 2, 0 } }, { { 0, 1, 2, 3 } });
  auto result =
    MakeSurface({ { -1, 0, 0 }, { 0, -0.5, 0.5 }, { 1, 0, 0 }, { 0, 0.5, 0 } }, { { 0, 1, 2, 3 } });
  auto c = Compare(result, reference);
  CheckNear(c->GetMeanNormalAngle(), 22.5, 1e-12, "one half is turned by 45 degrees");
  CheckNear(c->GetMaximumNormalAngle(), 45.0, 1e-12, "the other is not");
  const double weight = std::sqrt(0.5) / (std::sqrt(0.5) + 0.5);
  CheckNear(CellError(c, 0), 45.0 * weight, 1e-12, "mean of the halves by area");
}

void TestOtherConnectivity()
{
  auto c = Compare(MakePlane(3), MakePlane(7));
  Check(c->GetSameConnectivity() == 0.0, "other connectivity is noticed");
  CheckNear(c->GetMaximumNormalAngle(), 0.0, 1e-12, "planes agree however they are cut");
  CheckNear(c->GetHausdorffDistance(), 0.0, 1e-14, "and have no distance");
  CheckNaN(c->GetFoundFeatureEdges(), "features of other connectivity");

  // A finer wedge, near enough to its flanks for every face to find the right one.
  c = Compare(MakeWedge(0.0), Transformed(MakePlane(4), 4.0, { 0.0, 0.0, 0.0 }));
  Check(c->GetSameConnectivity() == 0.0 && c->GetMeanNormalAngle() == 0.0, "flat on flat");
  c = Compare(MakeWedge(30.0), Transformed(MakePlane(4), 4.0, { 0.0, 0.0, 0.0 }));
  CheckNear(CellError(c, 0), 0.0, 1e-12, "nearest face below the left square");
  CheckNear(CellError(c, 1), 30.0, 1e-12, "nearest face below the right square");

  vtkSmartPointer<vtkPolyData> turned = MakeCube();
  turned->GetPolys()->ReplaceCellAtId(0, { 2, 3, 1, 0 });
  c = Compare(turned, MakeCube());
  Check(c->GetSameConnectivity() == 0.0, "a cell that starts elsewhere is another one");
  CheckNear(c->GetMaximumNormalAngle(), 0.0, 1e-12, "but has the same nearest face");
}

void TestCells()
{
  // Vertices and lines come before the polygons and have no normals.
  vtkSmartPointer<vtkPolyData> wedge = MakeWedge(30.0);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  wedge->SetVerts(vertices);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  wedge->SetLines(lines);
  auto c = Compare(wedge, MakeWedge(0.0));
  Check(c->GetSameConnectivity() == 1.0, "vertices and lines do not count");
  CheckNaN(CellError(c, 0), "angle of a vertex");
  CheckNaN(CellError(c, 1), "angle of a line");
  CheckNear(CellError(c, 2), 0.0, 1e-12, "the left square after them");
  CheckNear(CellError(c, 3), 30.0, 1e-12, "the right square after them");

  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkStripper> strips;
  strips->SetInputConnection(sphere->GetOutputPort());
  strips->Update();
  sphere->Update();
  Check(strips->GetOutput()->GetNumberOfStrips() > 0, "there are strips");
  c = Compare(strips->GetOutput(), sphere->GetOutput());
  CheckNear(c->GetMaximumNormalAngle(), 0.0, 1e-5, "strips of a sphere");
  CheckNear(c->GetRelativeVolumeChange(), 0.0, 1e-12, "volume of a sphere in strips");

  // A face without area is counted and left out; so is a point that no face uses.
  vtkSmartPointer<vtkPolyData> cube = MakeCube();
  cube->GetPolys()->InsertNextCell({ 0, 1, 1 });
  cube->GetPoints()->InsertNextPoint(9.0, 0.0, 0.0);
  c = Compare(cube, DeepCopy(cube));
  Check(c->GetUncomparedFaces() == 1.0 && c->GetMaximumNormalAngle() == 0.0, "a face without area");
  CheckNaN(CellError(c, 6), "angle of a face without area");
  CheckNear(c->GetReferenceDiagonal(), std::sqrt(3.0), 1e-15, "diagonal of the faces");
  CheckNear(DistanceOf(c, 8), 8.0, 1e-14, "distance of an unused point");
  Check(c->GetHausdorffDistance() == 0.0, "an unused point does not count");
}

void TestPointSet()
{
  auto c = Compare(MakeSurface({ { 0.5, 0.5, 1.5 }, { 0.5, 0.5, 2.0 }, { NotANumber, 0, 0 } }, {}),
    MakeCube());
  CheckNear(DistanceOf(c, 1), 1.0, 1e-14, "distance of a point");
  CheckNaN(DistanceOf(c, 2), "distance of a point that is nowhere");
  CheckNear(c->GetMeanDistance(), 0.75, 1e-14, "mean distance of points");
  CheckNear(c->GetHausdorffToReference(), 1.0, 1e-14, "largest distance of points");
  CheckNaN(c->GetHausdorffDistance(), "distance back from a surface to points");
  CheckNaN(c->GetMeanNormalAngle(), "angle of points");
  CheckNaN(c->GetPositionError(), "E_v of points");
}

void TestOutputs()
{
  vtkSmartPointer<vtkPolyData> result = MakeWedge(10.0);
  vtkNew<vtkDoubleArray> mine;
  mine->SetName("Mine");
  mine->SetNumberOfTuples(result->GetNumberOfPoints());
  mine->FillValue(1.0);
  result->GetPointData()->SetScalars(mine);
  vtkNew<vtkDoubleArray> note;
  note->SetName("Note");
  result->GetFieldData()->AddArray(note);

  auto c = Compare(result, MakeWedge(0.0));
  vtkPolyData* output = c->GetOutput();
  Check(result->GetFieldData()->GetNumberOfArrays() == 1 &&
      result->GetCellData()->GetNumberOfArrays() == 0,
    "the input gets no arrays");
  Check(output->GetPointData()->GetScalars() == mine, "point arrays pass and stay active");
  Check(output->GetFieldData()->GetArray("Note") == note, "field data pass");
  Check(output->GetPoints() == result->GetPoints(), "points pass");

  vtkTable* table = c->GetTable();
  Check(table && table->GetNumberOfRows() == 1, "a table of one row");
  CheckNear(table->GetValueByName(0, "MeanNormalAngle").ToDouble(), 5.0, 1e-12,
    "value in the table");
  CheckNear(output->GetFieldData()->GetArray("MeanNormalAngle")->GetTuple1(0), 5.0, 1e-12,
    "value in the field data");
}

void TestBadInput()
{
  vtkSmartPointer<vtkPolyData> cube = MakeCube();
  vtkSmartPointer<vtkPolyData> empty = vtkSmartPointer<vtkPolyData>::New();
  vtkSmartPointer<vtkPolyData> nowhere = MakeSurface({ { NotANumber, 0, 0 } }, {});
  vtkSmartPointer<vtkPolyData> broken =
    MakeSurface({ { 0, 0, 0 }, { 1, 0, 0 }, { NotANumber, 0, 0 } }, { { 0, 1, 2 } });
  const struct
  {
    vtkPolyData* Result;
    vtkPolyData* Reference;
    const char* Error;
  } cases[] = {
    { empty, cube, "surface to be judged, is empty" },
    { cube, empty, "reference is empty" },
    { cube, nowhere, "reference has no point with finite coordinates" },
    { nowhere, nowhere, "reference has no point with finite coordinates" },
    { empty, nowhere, "surface to be judged, is empty" },
    { broken, cube, "input cannot be compared" },
    { cube, broken, "reference cannot be compared with" },
  };
  vtkNew<vtkSurfaceComparison> c;
  vtkNew<Messages> messages;
  messages->Watch(c);
  c->SetInputData(MakeCube());
  c->SetReferenceData(MakeCube());
  c->Update();
  Check(Silent(messages), "good input is good");
  for (const auto& bad : cases)
  {
    messages->Errors.clear();
    c->SetInputData(bad.Result);
    c->SetReferenceData(bad.Reference);
    c->Update();
    Check(messages->Errors.find(bad.Error) != std::string::npos,
      std::string("error that contains: ") + bad.Error + "; it is: " + messages->Errors);
    CheckNaN(c->GetMeanNormalAngle(), "result after an error");
  }
  c->SetInputData(cube);
  c->SetReferenceConnection(nullptr);
  Check(c->GetExecutive()->Update() == 0, "a reference is required");
}

void TestAbort()
{
  vtkNew<vtkSurfaceComparison> c;
  vtkNew<Messages> messages;
  messages->Watch(c);
  c->SetInputData(MakePlane(20));
  c->SetReferenceData(MakePlane(20));
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  c->AddObserver(vtkCommand::ProgressEvent, stop);
  c->Update();
  Check(Silent(messages), "an abort is no error");
  CheckNaN(c->GetMeanDistance(), "result after an abort");
}

}

int TestSurfaceComparison(int, char*[])
{
  TestIdentical();
  TestMovedCube();
  TestHausdorffSides();
  TestAngles();
  TestQuadsAreCutAlike();
  TestOtherConnectivity();
  TestCells();
  TestPointSet();
  TestOutputs();
  TestBadInput();
  TestAbort();
  return ExitCode();
}
