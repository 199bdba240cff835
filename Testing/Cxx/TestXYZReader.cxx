// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
// vtkXYZReader reads every spelling of texts of points that it promises to read, and makes of their
// columns what it says.

#include "ReaderTester.h"

#include "vtkXYZReader.h"

#include "vtkCellArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <limits>
#include <sstream>

namespace
{
ReaderTester<vtkXYZReader> Tester("TestXYZReader.xyz");

using Tuple = std::vector<double>;

const double NaN = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

/// The points are these, and a vertex cell for each.
void ExpectPoints(vtkPolyData* cloud, const std::vector<Tuple>& points, const std::string& what)
{
  const auto count = static_cast<vtkIdType>(points.size());
  Tester.Expect(cloud->GetNumberOfPoints() == count && cloud->GetNumberOfVerts() == count &&
      cloud->GetNumberOfCells() == count,
    "counts of\n" + what);
  for (vtkIdType i = 0; i < count && cloud->GetPoints(); ++i)
  {
    Tester.ExpectTuple(cloud->GetPoints()->GetData(), i, points[i],
      "point " + std::to_string(i) + " of\n" + what);
  }
  for (vtkIdType i = 0; i < cloud->GetNumberOfVerts(); ++i)
  {
    vtkIdType size;
    const vtkIdType* ids;
    cloud->GetVerts()->GetCellAtId(i, size, ids);
    Tester.Expect(size == 1 && ids[0] == i, "vertex cell of\n" + what);
  }
}

vtkDataArray* PointArray(vtkPolyData* cloud, const char* name)
{
  return cloud->GetPointData()->GetArray(name);
}

/// The cloud has these point arrays and no others.
void ExpectArrays(vtkPolyData* cloud, const std::vector<const char*>& names, const char* what)
{
  Tester.Expect(cloud->GetPointData()->GetNumberOfArrays() == static_cast<int>(names.size()), what);
  for (const char* name : names)
  {
    Tester.Expect(PointArray(cloud, name) != nullptr, std::string(name) + " of " + what);
  }
}

//------------------------------------------------------------------------------
void TestSpellings()
{
  for (const std::string spelling : {
         "1 2 3\n-.5 +.5 1e2\n",
         "1 2 3\n-.5 +.5 1e2",
         "1\t2\t3\n-0.5\t0.5\t1.E+02\n",
         "1,2,3\n-.5,.5,100\n",
         "1.0, 2.0, 3.0\n-.5 ,.5 ,100\n",
         "1, 2, 3\n-.5 , .5 ,100\n",
         "1;2;3;\n-.5;.5;100;\n",
         "  1   2\t3  \n\n \t \n-.5,\t.5; 100  \n\n",
         "1 2 3\r\n-.5 .5 100\r\n",
         "1;2;3\r\n\r\n-.5;.5;100;\r\n",
         "\xEF\xBB\xBF"
         "1 2 3\n-.5 .5 100\n",
         "\xEF\xBB\xBF# points\n1 2 3\n-.5 .5 100\n",
         "# a comment, x y\n1 2 3 # the first\n // 4 5 6\n-.5 .5 100// the last\n#",
         "2\n1 2 3\n-.5 .5 100\n",
         "2\n1 2 3\n# between\n-.5 .5 100\n",
         "\n# points\n 2 \r\n1 2 3\n-.5 .5 100\n",
         "x y z\n1 2 3\n-.5 .5 100\n",
         "X,Y,Z\n1,2,3\n-.5,.5,100\n",
         "\"X\";\"Y\";\"Z\"\n1;2;3\n-.5;.5;100\n",
         "//X Y Z\n2\n1 2 3\n-.5 .5 100\n",
         "2\nx y z\n1 2 3\n-.5 .5 100\n",
         "East North H\xC3\xB6he\n1 2 3\n-.5 .5 100\n",
         "z y x\n3 2 1\n100 .5 -.5\n",
         "# z x y\n3 1 2\n100 -.5 .5\n",
         "# x y z and more of them\n1 2 3\n-.5 .5 100\n",
         "# z y x\nx y z\n1 2 3\n-.5 .5 100\n",
       })
  {
    const auto cloud = Tester.Read(spelling);
    ExpectPoints(cloud, { { 1, 2, 3 }, { -0.5, 0.5, 100 } }, spelling);
    ExpectArrays(cloud, {}, spelling.c_str());
  }
  Tester.Expect(Tester.Read("1 2 3\n")->GetPoints()->GetDataType() == VTK_DOUBLE, "double points");
  ExpectPoints(Tester.Read("1 2 3"), { { 1, 2, 3 } }, "one point");
  for (const char* empty : { "0", "0\n", "0\nx y z nx ny nz\n", "# none\n0\n# here\n" })
  {
    ExpectPoints(Tester.Read(empty), {}, empty);
  }
  ExpectPoints(Tester.Read("nan -inf 1e-400\nNaN Infinity -1e-999\n+nan inf 4.9e-324\n"),
    { { NaN, -Infinity, 0 }, { NaN, Infinity, 0 }, { NaN, Infinity, 4.9e-324 } }, "not finite");
}

//------------------------------------------------------------------------------
void TestColumns()
{
  const auto intensity = Tester.Read("1 2 3 -4.5\n5 6 7 1e3\n");
  ExpectPoints(intensity, { { 1, 2, 3 }, { 5, 6, 7 } }, "four columns");
  ExpectArrays(intensity, { "Intensity" }, "four columns");
  Tester.ExpectTuple(PointArray(intensity, "Intensity"), 0, { -4.5 }, "intensity");
  Tester.Expect(intensity->GetPointData()->GetScalars() == PointArray(intensity, "Intensity"),
    "intensities are the scalars");

  const auto leica = Tester.Read("2\n1 2 3 -2047 255 0 1\n5 6 7 2048 2 3 4\n");
  ExpectPoints(leica, { { 1, 2, 3 }, { 5, 6, 7 } }, "seven columns");
  ExpectArrays(leica, { "Intensity", "RGB" }, "seven columns");
  Tester.ExpectTuple(PointArray(leica, "Intensity"), 0, { -2047 }, "intensity of seven");
  Tester.ExpectTuple(PointArray(leica, "RGB"), 0, { 255, 0, 1 }, "color of seven");
  Tester.ExpectTuple(PointArray(leica, "RGB"), 1, { 2, 3, 4 }, "color of seven");
  Tester.Expect(leica->GetPointData()->GetScalars() == PointArray(leica, "RGB") &&
      vtkUnsignedCharArray::SafeDownCast(PointArray(leica, "RGB")),
    "colors are bytes and the scalars");

  const auto normals = Tester.Read("1 2 3 0.6 0 -.8\n5 6 7 0 0 1\n");
  ExpectPoints(normals, { { 1, 2, 3 }, { 5, 6, 7 } }, "normals");
  ExpectArrays(normals, { "Normals" }, "normals");
  Tester.ExpectTuple(normals->GetPointData()->GetNormals(), 0, { 0.6, 0, -0.8 }, "normal");
  Tester.ExpectTuple(normals->GetPointData()->GetNormals(), 1, { 0, 0, 1 }, "normal");
}

//------------------------------------------------------------------------------
void TestSixColumns()
{
  const auto set = [](int type) { return [type](vtkXYZReader* r) { r->SetSixColumns(type); }; };
  const auto normal = [](vtkPolyData* cloud) { return cloud->GetPointData()->GetNormals(); };
  struct Case
  {
    const char* Last; ///< three columns of the second and last point
    bool AreColors;   ///< in the eyes of Automatic
  };
  for (const Case& c : { Case{ "0 0 2", true }, Case{ "255 128 0", true }, Case{ "1 1 1", false },
         Case{ "0 0 0", false }, Case{ "0 1 0", false }, Case{ "0 0 -2", false },
         Case{ "0 0 256", false }, Case{ "3 4.5 0", false }, Case{ "nan 255 255", false },
         Case{ "0.5 0.5 0.5", false }, Case{ "2.0 1e1 3.", true } })
  {
    const auto cloud = Tester.Read(std::string("1 2 3 0 0 1\n5 6 7 ") + c.Last + "\n");
    ExpectArrays(cloud, { c.AreColors ? "RGB" : "Normals" }, c.Last);
    Tester.Expect((normal(cloud) != nullptr) == !c.AreColors, c.Last);
  }
  // What comes late counts as much.
  std::string late;
  for (int i = 0; i < 40000; ++i)
  {
    late += "1 2 3 10 20 30\n";
  }
  ExpectArrays(Tester.Read(late), { "RGB" }, "many colors");
  ExpectArrays(Tester.Read(late + "1 2 3 0 0 -1\n"), { "Normals" }, "many and a last one");

  const auto forced = Tester.Read("1 2 3 10 20 30\n", set(vtkXYZReader::Normals));
  ExpectArrays(forced, { "Normals" }, "normals by request");
  Tester.ExpectTuple(normal(forced), 0, { 10, 20, 30 }, "normals stay as they are");
  const auto dark = Tester.Read("1 2 3 0 0 1\n", set(vtkXYZReader::Colors));
  ExpectArrays(dark, { "RGB" }, "colors by request");
  Tester.ExpectTuple(PointArray(dark, "RGB"), 0, { 0, 0, 1 }, "whole numbers are no fractions");
  const auto fractions = Tester.Read("1 2 3 0 0.2 1\n4 5 6 1 1 0\n", set(vtkXYZReader::Colors));
  Tester.ExpectTuple(PointArray(fractions, "RGB"), 0, { 0, 51, 255 }, "fractions");
  Tester.ExpectTuple(PointArray(fractions, "RGB"), 1, { 255, 255, 0 }, "fractions");
  const auto rounded = Tester.Read("1 2 3 1.5 254.4 254.6\n", set(vtkXYZReader::Colors));
  Tester.ExpectTuple(PointArray(rounded, "RGB"), 0, { 2, 254, 255 }, "rounded");
  // It is about six columns without names only.
  ExpectArrays(Tester.Read("x y z r g b\n1 2 3 0 0 1\n", set(vtkXYZReader::Normals)), { "RGB" },
    "names count more");
  ExpectArrays(Tester.Read("1 2 3 4 5 6 7\n", set(vtkXYZReader::Normals)), { "Intensity", "RGB" },
    "seven columns are not six");

  vtkNew<vtkXYZReader> reader;
  Tester.Expect(reader->GetSixColumns() == vtkXYZReader::Automatic, "default");
  reader->SetSixColumns(7);
  Tester.Expect(reader->GetSixColumns() == vtkXYZReader::Colors, "clamped");
  reader->SetSixColumnsToNormals();
  std::ostringstream text;
  reader->Print(text);
  Tester.Expect(text.str().find("SixColumns: 1") != std::string::npos, "printed");
}

//------------------------------------------------------------------------------
void TestNames()
{
  const std::string row = "1 2 3 4 5 6 7 8 9 0.25 11\n";
  for (const std::string header : {
         "nz ny nx z y x B g Red i Time\n",
         "# Normal_Z,normal_y,NORMAL_X,Z,Y,X,blue,GREEN,R,Intensity,Time\n",
         "//nz;ny;nx;z;y;x;b;g;r;\"intensity\";\"Time\"\n",
         "\"nz\",\"ny\",\"nx\",\"z\",\"y\",\"x\",\"b\",\"g\",\"r\",\"I\",\"Time\"\r\n",
       })
  {
    const auto cloud = Tester.Read(header + row);
    ExpectPoints(cloud, { { 6, 5, 4 } }, header);
    ExpectArrays(cloud, { "Normals", "RGB", "Intensity", "Time" }, header.c_str());
    Tester.ExpectTuple(cloud->GetPointData()->GetNormals(), 0, { 3, 2, 1 }, "normal by " + header);
    Tester.ExpectTuple(PointArray(cloud, "RGB"), 0, { 9, 8, 7 }, "color by " + header);
    Tester.ExpectTuple(PointArray(cloud, "Intensity"), 0, { 0.25 }, "intensity by " + header);
    Tester.ExpectTuple(PointArray(cloud, "Time"), 0, { 11 }, "another column by " + header);
    Tester.Expect(cloud->GetPointData()->GetScalars() == PointArray(cloud, "RGB"), "scalars");
  }
  const auto spaces = Tester.Read("x,y,z,\"Scan angle, rank\"\n1,2,3,4\n");
  Tester.ExpectTuple(PointArray(spaces, "Scan angle, rank"), 0, { 4 }, "name of words");
  const auto other = Tester.Read("x y z nx ny rgb\n1 2 3 4 5 6\n");
  ExpectArrays(other, { "nx", "ny", "rgb" }, "a normal is more than two columns");
  ExpectArrays(Tester.Read("x y z r r b\n1 2 3 40 50 60\n"), { "r", "b" }, "the last r");
  ExpectPoints(Tester.Read("x y z\n# y x z\n1 2 3\n"), { { 1, 2, 3 } }, "a line before a comment");
  ExpectArrays(Tester.Read("# x y z q\n1 2 3 4\n"), { "q" }, "named by a comment");
  ExpectArrays(Tester.Read("# x x y z\n1 2 3 4\n"), { "Intensity" }, "no names");
  ExpectArrays(Tester.Read("a b c d\n1 2 3 4\n"), { "Intensity" }, "words without x, y and z");
  ExpectArrays(Tester.Read("1 2 3 4\n# x y z q\n5 6 7 8\n"), { "Intensity" }, "names too late");
}
}

//------------------------------------------------------------------------------
int TestXYZReader(int, char*[])
{
  TestSpellings();
  TestColumns();
  TestSixColumns();
  TestNames();
  return Tester.Result();
}
