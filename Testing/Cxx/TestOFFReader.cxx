// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
// vtkOFFReader reads every spelling of the format that it promises to read; a broken file raises an
// error that says where and leaves the output empty.

#include "ReaderTester.h"

#include "vtkOFFReader.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <clocale>
#include <cstdint>
#include <cstring>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

namespace
{
ReaderTester<vtkOFFReader> Tester("TestOFFReader.off");

//------------------------------------------------------------------------------
void TestSpellings()
{
  const std::string points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n.5 +.5 1e0\n";
  const std::string faces = "4 3 2 1 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n";
  const std::vector<std::string> spellings = {
    "OFF\n5 5 8\n" + points + faces,
    "OFF 5 5 8\n" + points + faces,
    "OFF5 5 8\n" + points + faces,
    "OFF\n5 5\n" + points + faces,
    "\xEF\xBB\xBFOFF\n5 5 0\n" + points + faces,
    "# made by hand\n\n  OFF # pyramid\n#\n\n5 5 8 # counts\n\n" + points + "\n# faces\n" + faces,
    "OFF\r\n5 5 8\r\n0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 0\r\n.5\t.5 1\r\n" + faces,
    "OFF\n5 5 8\n0 0 0 1 0 0 1 1 0 0 1 0\n.5 .5 1\n" + faces,
    "OFF\n5 5 8\n" + points + faces.substr(0, faces.size() - 1),
  };
  for (const std::string& spelling : spellings)
  {
    const auto pyramid = Tester.Read(spelling);
    Tester.Expect(pyramid->GetNumberOfPoints() == 5 && pyramid->GetNumberOfPolys() == 5 &&
        pyramid->GetPolys()->GetNumberOfConnectivityIds() == 16,
      "counts of\n" + spelling);
    if (pyramid->GetNumberOfPoints() == 5)
    {
      Tester.ExpectTuple(pyramid->GetPoints()->GetData(), 4, { 0.5, 0.5, 1.0 },
        "apex of\n" + spelling);
    }
  }
  Tester.Expect(Tester.Read(spellings[0])->GetPoints()->GetDataType() == VTK_DOUBLE,
    "double points");

  const auto mixed = Tester.Read("OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 7\n2 0 1 8\n1 2 9\n");
  Tester.Expect(mixed->GetNumberOfVerts() == 1 && mixed->GetNumberOfLines() == 1 &&
      mixed->GetNumberOfPolys() == 1,
    "faces of one and two corners");
  Tester.ExpectTuple(mixed->GetCellData()->GetScalars(), 0, { 9 },
    "color index of the vertex cell");
  Tester.ExpectTuple(mixed->GetCellData()->GetScalars(), 2, { 7 }, "color index of the triangle");

  const auto cloud = Tester.Read("OFF\n2 0 0\n0 0 0\n1 2 3\n");
  Tester.Expect(cloud->GetNumberOfPoints() == 2 && cloud->GetNumberOfVerts() == 2, "point cloud");
  Tester.Expect(Tester.Read("OFF 0 0 0")->GetNumberOfPoints() == 0, "empty surface");
}

//------------------------------------------------------------------------------
void TestAttributes()
{
  const std::string face = "3 0 1 2";
  const auto byteColors =
    Tester.Read("COFF\n3 1 0\n0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n" + face);
  Tester.ExpectTuple(byteColors->GetPointData()->GetScalars(), 1, { 0, 255, 0 },
    "three byte components");

  const auto fractions =
    Tester.Read("COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 0 0.5 0 1\n0 1 0 0 0 1 .2\n" + face);
  Tester.ExpectTuple(fractions->GetPointData()->GetScalars(), 2, { 0, 0, 255, 51 },
    "four fractions");

  const auto decimals =
    Tester.Read("COFF\n3 1 0\n0 0 0 255.0 0 0\n1 0 0 1.0 0 0\n0 1 0 0 0 9.0\n" + face);
  Tester.ExpectTuple(decimals->GetPointData()->GetScalars(), 1, { 1, 0, 0 },
    "bytes with decimal points");

  const auto normals = Tester.Read("NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 1 0\n0 1 0 1 0 0\n" + face);
  Tester.ExpectTuple(normals->GetPointData()->GetNormals(), 1, { 0, 1, 0 }, "normals");

  const auto all =
    Tester.Read("STCNOFF\n3 1 0\n0 0 0 0 0 1 9 8 7 6 .5 .25\n1 0 0 0 0 1 1 2 3 4 0 1\n"
                "0 1 0 0 0 1 5 5 5 5 1 1\n" +
      face + " 0.2 0.4 0.6 # faces may have colors as well\n");
  Tester.ExpectTuple(all->GetPointData()->GetNormals(), 2, { 0, 0, 1 },
    "normals beside the others");
  Tester.ExpectTuple(all->GetPointData()->GetScalars(), 0, { 9, 8, 7, 6 },
    "colors beside the others");
  Tester.ExpectTuple(all->GetPointData()->GetTCoords(), 0, { 0.5, 0.25 }, "texture coordinates");
  Tester.ExpectTuple(all->GetCellData()->GetScalars(), 0, { 51, 102, 153 },
    "fractional face colors");

  const std::string header = "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n";
  const auto uniform = Tester.Read(header + "3 0 1 2 10 20 30\n3 2 1 0 40 50 60\n");
  Tester.ExpectTuple(uniform->GetCellData()->GetArray("Colors"), 1, { 40, 50, 60 }, "face colors");
  const auto partly = Tester.Read(header + "3 0 1 2 10 20 30\n3 2 1 0\n");
  Tester.Expect(!partly->GetCellData()->GetScalars(), "no array if a face has no color");
}

//------------------------------------------------------------------------------
/// What the file holds is what was written, bit for bit, in any locale.
void TestRoundTrip()
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(40);
  source->SetPhiResolution(40);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  vtkPolyData* const sphere = source->GetOutput();

  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "OFF\n" << sphere->GetNumberOfPoints() << ' ' << sphere->GetNumberOfPolys() << " 0\n";
  text << std::setprecision(17);
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    const double* const x = sphere->GetPoint(i);
    text << x[0] << ' ' << x[1] << ' ' << x[2] << '\n';
  }
  for (vtkIdType i = 0; i < sphere->GetNumberOfPolys(); ++i)
  {
    vtkIdType size;
    const vtkIdType* ids;
    sphere->GetPolys()->GetCellAtId(i, size, ids);
    text << size << ' ' << ids[0] << ' ' << ids[1] << ' ' << ids[2] << '\n';
  }

  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  for (const char* name : { "de_DE.UTF-8", "C" })
  {
    std::setlocale(LC_NUMERIC, name); // keeps the old one where German is not installed
    const auto copy = Tester.Read(text.str());
    bool equal = copy->GetNumberOfPoints() == sphere->GetNumberOfPoints() &&
      copy->GetNumberOfPolys() == sphere->GetNumberOfPolys();
    for (vtkIdType i = 0; equal && i < sphere->GetNumberOfPoints(); ++i)
    {
      double x[3];
      copy->GetPoint(i, x);
      equal = std::memcmp(x, sphere->GetPoint(i), sizeof(x)) == 0;
    }
    Tester.Expect(equal, std::string("round trip in locale ") + name);
  }
  std::setlocale(LC_NUMERIC, before.c_str());
}

//------------------------------------------------------------------------------
template <typename T>
std::string BigEndian(T value)
{
  static_assert(sizeof(T) == 4, "OFF stores 32-bit numbers");
  std::uint32_t bits;
  std::memcpy(&bits, &value, 4);
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8)
  {
    bytes += static_cast<char>(bits >> shift & 0xff);
  }
  return bytes;
}

std::string BinaryTriangle()
{
  std::string content = "COFF BINARY\n";
  for (std::int32_t count : { 3, 1, 3 })
  {
    content += BigEndian(count);
  }
  for (float number : { 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, /**/ 1.5f, 0.f, 0.f, 0.f, 1.f, 0.f, 1.f,
         /**/ 0.f, -2.f, 0.f, 0.f, 0.f, 1.f, 1.f })
  {
    content += BigEndian(number);
  }
  for (std::int32_t number : { 3, 0, 1, 2, /* no color */ 0 })
  {
    content += BigEndian(number);
  }
  return content;
}

void TestBinary()
{
  const auto triangle = Tester.Read(BinaryTriangle());
  Tester.Expect(triangle->GetNumberOfPoints() == 3 && triangle->GetNumberOfPolys() == 1,
    "binary counts");
  Tester.ExpectTuple(triangle->GetPoints()->GetData(), 1, { 1.5, 0, 0 }, "binary point");
  Tester.ExpectTuple(triangle->GetPointData()->GetScalars(), 2, { 0, 0, 255, 255 }, "binary color");
}

//------------------------------------------------------------------------------
void TestBrokenFiles()
{
  const unsigned long type = vtkErrorCode::UnrecognizedFileTypeError;
  const unsigned long format = vtkErrorCode::FileFormatError;
  const unsigned long early = vtkErrorCode::PrematureEndOfFileError;
  const std::string points = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";

  Tester.ExpectError("", "not an OFF file", type);
  Tester.ExpectError("ply\nformat ascii 1.0\n", "not an OFF file", type);
  Tester.ExpectError("OFFSET 3\n", "not an OFF file", type);
  Tester.ExpectError("4OFF\n1 0 0\n0 0 0 0\n", "more than three dimensions", format);
  Tester.ExpectError("OFF\n", "line 2: the file ends where the number of vertices", early);
  Tester.ExpectError("OFF\n3 x 0\n", "line 2: 'x' stands where the number of faces", format);
  Tester.ExpectError("OFF\n-3 1 0\n", "announces -3 vertices", format);
  Tester.ExpectError("OFF\n2000000000 4000000000 0\n0 0 0\n", "do not fit into the rest", format);
  Tester.ExpectError("OFF\n9223372036854775807 1 0\n0 0 0\n", "do not fit into the rest", format);
  Tester.ExpectError("OFF\n92233720368547758079 1 0\n0 0 0\n", "a whole number", format);
  Tester.ExpectError("OFF\n1 0 0\n0 0 zero\n", "line 3: 'zero' stands where a coordinate", format);
  Tester.ExpectError("OFF\n1 0 0\n0 0 1e999\n", "a finite number", format);
  Tester.ExpectError("OFF\n1 0 0\n0 nan 0\n", "line 3: 'nan'", format);
  Tester.ExpectError("OFF\n2 0 0\n0.25 0.25 0.25\n1 1\n", "line 5: the file ends where a coord",
    early);
  Tester.ExpectError(points + "3 0 1 3\n", "line 6: face 0 refers to vertex 3", format);
  Tester.ExpectError(points + "3 0 -1 2\n", "face 0 refers to vertex -1", format);
  Tester.ExpectError(points + "3 0 1.5 2\n", "'1.5' stands where the index of a corner", format);
  Tester.ExpectError(points + "0 0 1 2\n", "face 0 has 0 corners", format);
  Tester.ExpectError(points + "30 0 1 2\n", "face 0 has 30 corners", format);
  Tester.ExpectError(points + "3 0 1  \n", "the file ends where the index of a corner", early);
  Tester.ExpectError(points + "3 0 1 2 red\n", "line 6: 'red' stands where a color component",
    format);
  Tester.ExpectError("COFF\n1 0 0\n0 0 0 1 2\n", "line 3: the color of a vertex", format);

  const std::string binary = BinaryTriangle();
  for (std::size_t size = 13; size < binary.size(); ++size)
  {
    Tester.ExpectError(binary.substr(0, size), "byte ", Tester.AnyCode);
  }
  std::string wrongIndex = binary;
  wrongIndex[wrongIndex.size() - 5] = 9;
  Tester.ExpectError(wrongIndex, "refers to vertex 9", format);
}

//------------------------------------------------------------------------------
void TestFiles()
{
  Tester.TestFileNames("OFF\n1 0 0\n1 2 3\n");
  Tester.ExpectCanRead(true, "OFF\n1 0 0\n1 2 3\n");
  Tester.ExpectCanRead(true, "# comment\nSTCNOFF BINARY\n");
  for (const char* content : { "", "O", "solid off", "nOFF 3", "OFFICE" })
  {
    Tester.ExpectCanRead(false, content);
  }
}

//------------------------------------------------------------------------------
/// While it reads vertices, and while it reads faces.
void TestProgress()
{
  std::string vertices = "OFF\n100000 1 0\n";
  std::string faces = "OFF\n3 100000 0\n0 0 0\n1 0 0\n0 1 0\n";
  for (int i = 0; i < 100000; ++i)
  {
    vertices += "1 2 3\n";
    faces += "3 0 1 2\n";
  }
  Tester.TestProgress(vertices + "3 0 1 2\n", 100000);
  Tester.TestProgress(faces, 3);
}
}

//------------------------------------------------------------------------------
int TestOFFReader(int, char*[])
{
  TestSpellings();
  TestAttributes();
  TestRoundTrip();
  TestBinary();
  TestBrokenFiles();
  TestFiles();
  TestProgress();
  return Tester.Result();
}
