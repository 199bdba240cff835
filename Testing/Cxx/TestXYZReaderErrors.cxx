// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
// A file that vtkXYZReader cannot read raises an error that says where and what is wrong, and
// leaves the output empty.

#include "ReaderTester.h"

#include "vtkXYZReader.h"

#include <random>

namespace
{
ReaderTester<vtkXYZReader> Tester("TestXYZReaderErrors.xyz");

const unsigned long Format = vtkErrorCode::FileFormatError;
const unsigned long Early = vtkErrorCode::PrematureEndOfFileError;

void TestNothing()
{
  for (const char* content : { "", " ", "\n", "\r\n\r\n", "\xEF\xBB\xBF", "# x y z\n", "x y z\n",
         "hello", "// nothing", "\"" })
  {
    Tester.ExpectError(content, "the file holds no points", Early);
  }
  Tester.ExpectError("3\n", "line 2: the file ends after 0 points, it announces 3", Early);
  Tester.ExpectError("3\n1 2 3\n4 5 6", "line 4: the file ends after 2 points, it announces 3",
    Early);
  Tester.ExpectError("1\n1 2 3\n4 5 6\n", "ends after 2 points, it announces 1", Format);
  Tester.ExpectError("0\n1 2 3\n", "ends after 1 point, it announces 0", Format);
  Tester.ExpectError("-1\n1 2 3\n", "line 1: the number of points is -1", Format);
  Tester.ExpectError("9223372036854775807\n1 2 3\n", "announces 9223372036854775807", Early);
  Tester.ExpectError("9223372036854775808\n1 2 3\n", "line 1: 1 column, ", Format);
}

void TestTokens()
{
  // Among them numbers as old programs for Windows and Fortran write them.
  for (const std::string token : { "zero", "1d5", "1D+5", "0x10", "1.2.3", "1e", "--1", "+-1",
         "1/2", "1_000", "1f", "1e999", "-1e999", ".", "-", "+", "1.#QNAN", "nano", "\xFF" })
  {
    const std::string message = "line 2: '" + token + "' stands where a number should";
    Tester.ExpectError("1 2 3\n4 " + token + " 6\n7 8 9\n", message, Format);
    Tester.ExpectError("# top\n1 2 " + token + "\n7 8 9\n", message, Format);
  }
  Tester.ExpectError("1d5 2d5 3d5\n", "line 1: '1d5' stands", Format);
  Tester.ExpectError("x y z\nx y z\n1 2 3\n", "line 2: 'x' stands", Format);
  Tester.ExpectError("1 2 3\nx y z\n", "line 2: 'x' stands", Format);
  Tester.ExpectError("1 2 3\n\"4\" 5 6\n", "line 2: '\"4\"' stands", Format);
  Tester.ExpectError("ply\nformat ascii 1.0\n", "line 2: 'format' stands", Format);
  Tester.ExpectError("ncols 4\nnrows 5\n", "line 1: 'ncols' stands", Format);
  Tester.ExpectError("1 2 " + std::string(50, 'x'), "'" + std::string(32, 'x') + "...'", Format);
}

void TestShapes()
{
  const std::string meaning = "no header names; without one, points have 3, 4, 6 or 7 columns";
  Tester.ExpectError("1.5\n", "line 1: 1 column, which " + meaning, Format);
  Tester.ExpectError("1 2\n", "line 1: 2 columns, which " + meaning, Format);
  Tester.ExpectError("# top\n1 2 3 4 5\n", "line 2: 5 columns, which " + meaning, Format);
  Tester.ExpectError("1 2 3 4 5 6 7 8\n", "8 columns, which " + meaning, Format);
  Tester.ExpectError("a b\n1 2\n", "2 columns, which " + meaning, Format);
  Tester.ExpectError("1\n2\n3\n", "line 2: 1 column, which " + meaning, Format);
  Tester.ExpectError("x y z\n1 2 3 4\n", "line 2: 4 columns, the header names 3", Format);
  Tester.ExpectError("x y z i\n1 2 3\n", "line 2: 3 columns, the header names 4", Format);

  Tester.ExpectError("1 2 3\n\n4 5\n", "line 3: 2 columns, the first point has 3", Format);
  Tester.ExpectError("1 2 3\n4 5 6 7 8\n", "line 2: 5 columns, the first", Format);
  Tester.ExpectError("1 2 3 0 0 1\n4 5 6\n", "line 2: 3 columns, the first", Format);
  Tester.ExpectError("1 2 3\n4 5 # 6\n", "line 2: 2 columns", Format);
  Tester.ExpectError("1 2 3\n4\n", "line 2: 1 column", Format);

  for (const std::string line :
    { "1,,3", "1,2,,3", ",1,2,3", ";", "1, ,2,3", "1;;2", "1,2,3,,", "," })
  {
    Tester.ExpectError("1 2 3\n" + line + "\n", "line 2: a column is empty", Format);
    Tester.ExpectError(line + "\n1 2 3\n", "line 1: a column is empty", Format);
  }
  for (const char* line : { "1,5 2,5 3,5", "1,5;2;3", "1,5\t2,5\t3,5", "-0,1 2 3" })
  {
    Tester.ExpectError(line, "line 1: these seem to be numbers with decimal commas", Format);
  }
}

void TestColors()
{
  const auto colors = [](vtkXYZReader* reader) { reader->SetSixColumnsToColors(); };
  Tester.ExpectError("1 2 3 0 0 1\n1 2 3 0 256 1\n",
    "point 1 has a color component of 256.000000, not between 0 and 255", Format, colors);
  Tester.ExpectError("1 2 3 0 0 -0.5\n", "point 0 has a color component of -0.5", Format, colors);
  Tester.ExpectError("1 2 3 9 0 nan 1\n", "point 0 has a color component of nan", Format);
  Tester.ExpectError("1 2 3 9 0 inf 1\n", "point 0 has a color component of inf", Format);
  Tester.ExpectError("1 2 3 9 1e300 0 1\n", "point 0 has a color component of 1", Format);
}

void TestAtoms()
{
  const std::string message = "this is a file of atoms, not of points";
  Tester.ExpectError("2\nwater\nO 0 0 0\nH 0 0 1\n", "line 3: " + message, Format);
  Tester.ExpectError("2\n\nO 0 0 0\nH 0 0 1\n", "line 3: " + message, Format);
  Tester.ExpectError("1\nenergy -12.5\nCl 0 0 0 7\n", "line 3: " + message, Format);
  Tester.ExpectError("C 0 0 0\n", "line 1: " + message, Format);
  Tester.ExpectCanRead(false, "2\nwater\nO 0 0 0\nH 0 0 1\n");
}

/// Whatever the bytes are, the reader says that they are no points.
void TestGarbage()
{
  std::mt19937 random(11);
  for (std::size_t size = 1; size < 400; ++size)
  {
    std::string bytes(size, '\0');
    for (char& byte : bytes)
    {
      // All bytes, or those that are most like a cloud.
      byte = size % 2 ? static_cast<char>(random() & 0xff) : "\n 0#/\",;-e\t\rx"[random() % 14];
    }
    Tester.ExpectError(bytes + "\n1 2 x3\n", "", Tester.AnyCode);
  }
  Tester.ExpectError(std::string("1 2 3\n4 \0 6\n", 12), "line 2: '?' stands", Format);
  Tester.ExpectError(std::string("\0\0\0\n", 4),
    "line 1: '?"
    "?"
    "?' stands",
    Format);
  Tester.ExpectError("\xFF\xFE\x31\n1 2 x\n", "", Tester.AnyCode);
  Tester.ExpectError(std::string(5000000, '7'), "line 1: '7777", Format);
  std::string line;
  for (int i = 0; i < 1000000; ++i)
  {
    line += "7 ";
  }
  Tester.ExpectError(line, "line 1: 1000000 columns", Format);
  Tester.ExpectError("1 2 3\n" + line, "line 2: 1000000 columns", Format);
}

void TestFiles()
{
  Tester.TestFileNames("1 2 3\n");
  for (const char* content : { "1 2 3", "# x\n2\nx y z\n1 2 3\n", "0", "1 2 3\nbroken later",
         "//X,Y,Z,Nx,Ny,Nz\n1,2,3,0,0,1\n", "5\n1 2 3\n" })
  {
    Tester.ExpectCanRead(true, content);
  }
  for (const char* content : { "", "OFF\nx\n", "ply\nformat ascii 1.0\n", "1 2\n", "1,5 2,5 3,5",
         "\x89PNG\r\n\x1a\n", "3\n" })
  {
    Tester.ExpectCanRead(false, content);
  }
  // Of a large file, whole lines within the first 64 KiB count.
  Tester.ExpectCanRead(false, "#" + std::string(65529, '-') + "\n1 2 3 4 5\n");
  Tester.ExpectCanRead(true, "#" + std::string(65000, '-') + "\n1 2 3\n" + std::string(999, '-'));
  std::string large;
  while (large.size() < 65536)
  {
    large += "# " + std::string(65530 - large.size() % 65530, '-') + "\n";
  }
  Tester.ExpectCanRead(false, large);
  Tester.ExpectCanRead(true, "1 2 3\n" + large + large);
}
}

//------------------------------------------------------------------------------
int TestXYZReaderErrors(int, char*[])
{
  TestNothing();
  TestTokens();
  TestShapes();
  TestColors();
  TestAtoms();
  TestGarbage();
  TestFiles();
  return Tester.Result();
}
