// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSurfaceNoise moves points by what it promises, in edge lengths of the polygons, and nothing
// else.

#include "SurfaceChecks.h"
#include "vtkSurfaceNoise.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkStripper.h"
#include "vtkTriangleFilter.h"

#include <limits>

using namespace SurfaceChecks;

namespace
{

constexpr double Step = 1.0 / 64; // exact in float, and so are its multiples
constexpr int NumberOfPoints = 65 * 65;

/// 64 x 64 quads in the plane z = 0.
vtkSmartPointer<vtkPolyData> MakePlane()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0.0, 0.0, 0.0);
  plane->SetPoint1(1.0, 0.0, 0.0);
  plane->SetPoint2(0.0, 1.0, 0.0);
  plane->SetResolution(64, 64);
  plane->Update();
  return plane->GetOutput();
}

/// The points alone, with normals (0, 0, 2).
vtkSmartPointer<vtkPolyData> MakePointSet()
{
  auto points = vtkSmartPointer<vtkPolyData>::New();
  points->SetPoints(MakePlane()->GetPoints());
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Measured");
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    normals->InsertNextTuple3(0.0, 0.0, 2.0);
  }
  points->GetPointData()->SetNormals(normals);
  return points;
}

/// How the points of a plane moved.
struct Movement
{
  double Mean = 0.0;      ///< of the z coordinates
  double Deviation = 0.0; ///< root mean square of the length
  double Largest = 0.0;
  int Moved = 0;
  bool Sideways = false;
};

Movement Measure(vtkPolyData* before, vtkPolyData* after)
{
  Movement movement;
  const int n = static_cast<int>(before->GetNumberOfPoints());
  for (vtkIdType i = 0; i < n; ++i)
  {
    Point p, q;
    before->GetPoint(i, p.data());
    after->GetPoint(i, q.data());
    const double length = std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
    movement.Mean += (q[2] - p[2]) / n;
    movement.Deviation += length * length / n;
    movement.Largest = std::max(movement.Largest, length);
    movement.Moved += length > 0.0;
    movement.Sideways |= p[0] != q[0] || p[1] != q[1];
  }
  movement.Deviation = std::sqrt(movement.Deviation);
  return movement;
}

void TestAmplitudes()
{
  vtkSmartPointer<vtkPolyData> plane = MakePlane();
  vtkNew<vtkSurfaceNoise> noise;
  noise->SetInputData(plane);
  noise->SetSize(0.3);
  const double deviation = 0.3 * Step;
  const double error = 5.0 / std::sqrt(double(NumberOfPoints)); // five standard errors of the mean

  noise->Update();
  Movement m = Measure(plane, noise->GetOutput());
  CheckNear(noise->GetUnitLength(), Step, 1e-15, "edge length of quads, without diagonals");
  CheckNear(m.Mean, 0.0, deviation * error, "mean of Gaussian noise");
  CheckNear(m.Deviation, deviation, deviation * error / std::sqrt(2.0), "size of Gaussian noise");
  Check(!m.Sideways, "noise along normals is along normals");
  CheckNear(noise->GetOutput()->GetFieldData()->GetArray("NoiseDeviation")->GetTuple1(0), deviation,
    1e-15, "NoiseDeviation");

  noise->SetNoiseTypeToUniform();
  noise->Update();
  m = Measure(plane, noise->GetOutput());
  CheckNear(m.Deviation, deviation, deviation * error, "size of uniform noise");
  CheckNear(m.Largest, std::sqrt(3.0) * deviation, 1e-2 * deviation, "bound of uniform noise");

  noise->SetNoiseTypeToImpulsive();
  noise->SetFraction(0.1);
  noise->Update();
  m = Measure(plane, noise->GetOutput());
  Check(m.Moved == NumberOfPoints / 10, "number of impulses");

  noise->SetNoiseTypeToGaussian();
  noise->SetDirectionToRandom();
  noise->Update();
  m = Measure(plane, noise->GetOutput());
  Check(m.Sideways, "random directions go sideways");
  CheckNear(m.Deviation, deviation, deviation * error, "size of noise in random directions");

  noise->SetSize(0.0);
  noise->Update();
  Check(SamePoints(plane, noise->GetOutput()), "no noise of size 0");
}

void TestCells()
{
  vtkSmartPointer<vtkPolyData> plane = MakePlane();
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(plane);
  vtkNew<vtkStripper> strips;
  strips->SetInputConnection(triangles->GetOutputPort());
  // 2 * 64 * 65 sides and 64 * 64 diagonals.
  const double sides = 2.0 * 64 * 65;
  const double diagonals = 64.0 * 64;
  const double length = Step * (sides + std::sqrt(2.0) * diagonals) / (sides + diagonals);
  for (vtkAlgorithm* source :
    { static_cast<vtkAlgorithm*>(triangles), static_cast<vtkAlgorithm*>(strips) })
  {
    vtkNew<vtkSurfaceNoise> noise;
    noise->SetInputConnection(source->GetOutputPort());
    noise->Update();
    const std::string name = source->GetClassName();
    CheckNear(noise->GetUnitLength(), length, 1e-7 * Step, "mean edge length after " + name);
    Check(!Measure(plane, noise->GetOutput()).Sideways, "normals after " + name);
  }

  // At a corner of a cube of quads, three equal faces meet. Were the normals those of triangles,
  // the corners where four or five triangles meet would move along other lines.
  vtkSmartPointer<vtkPolyData> cube = MakeCube();
  vtkNew<vtkSurfaceNoise> noise;
  noise->SetInputData(cube);
  noise->Update();
  CheckNear(noise->GetUnitLength(), 1.0, 1e-15, "edge length of a cube");
  for (vtkIdType i = 0; i < 8; ++i)
  {
    Point p, q;
    cube->GetPoint(i, p.data());
    noise->GetOutput()->GetPoint(i, q.data());
    for (int c = 0; c < 3; ++c)
    {
      const double along = (q[c] - p[c]) * (p[c] > 0.0 ? 1.0 : -1.0);
      const double reference = (q[0] - p[0]) * (p[0] > 0.0 ? 1.0 : -1.0);
      CheckNear(along, reference, 1e-15, "corners move along diagonals");
    }
  }
}

void TestReproducible()
{
  vtkSmartPointer<vtkPolyData> plane = MakePlane();
  vtkNew<vtkSurfaceNoise> a;
  a->SetInputData(plane);
  a->SetSeed(5);
  a->Update();
  vtkNew<vtkSurfaceNoise> b;
  b->SetInputData(plane);
  b->SetSeed(5);
  b->Update();
  Check(SamePoints(a->GetOutput(), b->GetOutput()), "the same seed gives the same noise");
  b->SetSeed(6);
  b->Update();
  Check(!SamePoints(a->GetOutput(), b->GetOutput()), "another seed gives other noise");
  b->SetSeed(-6);
  b->Update();
  Check(Measure(plane, b->GetOutput()).Moved == NumberOfPoints, "seeds may be negative");
}

void TestWhatStays()
{
  vtkSmartPointer<vtkPolyData> plane = MakePlane(); // has point normals and texture coordinates
  vtkNew<vtkDoubleArray> ids;
  ids->SetName("Ids");
  ids->SetNumberOfTuples(plane->GetNumberOfCells());
  ids->FillValue(3.0);
  plane->GetCellData()->SetScalars(ids);
  vtkNew<vtkDoubleArray> note;
  note->SetName("Note");
  plane->GetFieldData()->AddArray(note);
  vtkSmartPointer<vtkPolyData> copy = DeepCopy(plane);

  vtkNew<vtkSurfaceNoise> noise;
  noise->SetInputData(plane);
  noise->Update();
  vtkPolyData* output = noise->GetOutput();
  Check(SamePoints(plane, copy), "the input does not move");
  Check(plane->GetFieldData()->GetNumberOfArrays() == 1, "the input gets no arrays");
  Check(plane->GetPointData()->GetNormals() != nullptr, "the input keeps its normals");
  Check(output->GetPoints()->GetDataType() == VTK_FLOAT, "float points stay float");
  Check(output->GetPolys() == plane->GetPolys(), "cells are shared");
  Check(output->GetCellData()->GetScalars() == ids, "cell arrays pass");
  Check(output->GetFieldData()->GetArray("Note") == note, "field data pass");
  Check(output->GetPointData()->GetArray("TextureCoordinates") != nullptr, "point arrays pass");
  Check(output->GetPointData()->GetArray("Normals") != nullptr, "normals pass");
  Check(output->GetPointData()->GetNormals() == nullptr, "old normals are not active");

  noise->SetInputData(MakeCube());
  noise->Update();
  Check(noise->GetOutput()->GetPoints()->GetDataType() == VTK_DOUBLE, "double points stay double");

  // Points without polygons have no normal, but they can move at random.
  vtkSmartPointer<vtkPolyData> cube = MakeCube();
  const vtkIdType lonely = cube->GetPoints()->InsertNextPoint(3.0, 3.0, 3.0);
  noise->SetInputData(cube);
  noise->Update();
  Check(noise->GetOutput()->GetPoint(lonely)[0] == 3.0, "a point without normal stays");
  noise->SetDirectionToRandom();
  noise->Update();
  Check(noise->GetOutput()->GetPoint(lonely)[0] != 3.0, "a point without normal moves at random");
}

void TestPointSets()
{
  vtkSmartPointer<vtkPolyData> points = MakePointSet();
  vtkNew<vtkSurfaceNoise> noise;
  vtkNew<Messages> messages;
  messages->Watch(noise);
  noise->SetInputData(points);
  noise->Update();
  const Movement m = Measure(points, noise->GetOutput());
  CheckNear(noise->GetUnitLength(), Step, 1e-15, "distance to the nearest point");
  Check(!m.Sideways && m.Moved == NumberOfPoints, "points move along the normals given");
  CheckNear(m.Deviation, 0.2 * Step, 0.02 * Step, "size of noise on points");
  Check(noise->GetOutput()->GetPointData()->GetNormals() != nullptr,
    "normals of points stay active");

  vtkSmartPointer<vtkPolyData> named = DeepCopy(points);
  named->GetPointData()->SetActiveNormals(nullptr);
  named->GetPointData()->GetArray("Measured")->SetName("Normals");
  vtkNew<vtkSurfaceNoise> byName;
  byName->SetInputData(named);
  byName->Update();
  Check(SamePoints(noise->GetOutput(), byName->GetOutput()), "an array Normals will do");

  const double nan = std::numeric_limits<double>::quiet_NaN();
  points->GetPoints()->SetPoint(7, nan, 0.0, 0.0);
  points->Modified();
  Check(Silent(messages), "no message for a good point set");
  noise->Update();
  Check(messages->Warnings.find("1 points are not finite") != std::string::npos, "NaN is reported");
  Check(std::isnan(noise->GetOutput()->GetPoint(7)[0]), "NaN stays");
  Check(noise->GetOutput()->GetPoint(8)[2] != 0.0, "the others move");
  CheckNear(noise->GetUnitLength(), Step, 1e-15, "NaN is nobody's neighbour");

  vtkDataArray* normals = points->GetPointData()->GetNormals();
  for (const vtkIdType count : { NumberOfPoints - 1, NumberOfPoints + 1, 0 })
  {
    messages->Errors.clear();
    normals->SetNumberOfTuples(count);
    points->Modified();
    noise->Update();
    Check(messages->Errors.find("Array Measured is no field of point normals") != std::string::npos,
      "there is a normal for every point");
    Check(noise->GetOutput()->GetNumberOfPoints() == 0, "no output without");
  }

  points->GetPointData()->SetNormals(nullptr);
  noise->Update();
  Check(messages->Errors.find("needs point normals") != std::string::npos, "normals are missing");

  vtkNew<vtkSurfaceNoise> random;
  random->SetDirectionToRandom();
  random->SetInputData(points);
  random->Update();
  Check(Measure(points, random->GetOutput()).Sideways, "random directions need no normals");
}

void TestBadInput()
{
  vtkNew<vtkSurfaceNoise> noise;
  vtkNew<Messages> messages;
  messages->Watch(noise);
  noise->SetInputData(vtkSmartPointer<vtkPolyData>::New());
  noise->Update();
  Check(noise->GetOutput()->GetNumberOfPoints() == 0 && Silent(messages), "empty in, empty out");

  noise->SetDirectionToRandom();
  noise->SetInputData(MakeSurface({ { 1, 2, 3 } }, {}));
  noise->Update();
  Check(noise->GetOutput()->GetPoint(0)[2] == 3.0, "a single point stays");
  Check(messages->Warnings.find("no length to measure it in") != std::string::npos,
    "and is reported");
  messages->Warnings.clear();
  noise->SetInputData(MakeSurface({ { 1, 2, 3 }, { 1, 2, 3 }, { 1, 2, 3 } }, { { 0, 1, 2 } }));
  noise->Update();
  Check(noise->GetOutput()->GetPoint(0)[2] == 3.0, "a surface without extent stays");
  Check(messages->Warnings.find("no length to measure it in") != std::string::npos,
    "and is reported");

  Check(messages->Errors.empty(), "no error so far");
  noise->SetInputData(MakeSurface({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 9 } }));
  noise->Update();
  Check(messages->Errors.find("does not exist") != std::string::npos, "a bad cell is an error");
  Check(noise->GetOutput()->GetNumberOfPoints() == 0, "no output after an error");
}

}

int TestSurfaceNoise(int, char*[])
{
  TestAmplitudes();
  TestCells();
  TestReproducible();
  TestWhatStays();
  TestPointSets();
  TestBadInput();
  return ExitCode();
}
