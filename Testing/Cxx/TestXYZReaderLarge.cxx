// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
// Many points: vtkXYZReader reads all of them with all their digits, says how far it is, and stops
// when it is told to.

#include "ReaderTester.h"

#include "vtkXYZReader.h"

#include "vtkPointData.h"

#include <clocale>
#include <cmath>
#include <cstring>
#include <iomanip>
#include <random>
#include <sstream>

namespace
{
const char* const FileName = "TestXYZReaderLarge.xyz";
ReaderTester<vtkXYZReader> Tester(FileName);

//------------------------------------------------------------------------------
/// What the file holds is what was written, bit for bit, in any locale; and a large file is read.
void TestRoundTrip()
{
  const vtkIdType count = 100000;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<double> numbers(6 * count);
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(17);
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    numbers[i] = std::ldexp(uniform(random), static_cast<int>(random() % 60) - 30);
    text << numbers[i] << (i % 6 == 5 ? '\n' : ' ');
  }

  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  for (const char* name : { "de_DE.UTF-8", "C" })
  {
    std::setlocale(LC_NUMERIC, name); // keeps the old one where German is not installed
    const auto cloud = Tester.Read(text.str());
    vtkDataArray* const normals = cloud->GetPointData()->GetNormals();
    bool equal = cloud->GetNumberOfPoints() == count && cloud->GetNumberOfVerts() == count &&
      normals && normals->GetNumberOfTuples() == count;
    for (vtkIdType i = 0; equal && i < count; ++i)
    {
      double row[6];
      cloud->GetPoint(i, row);
      normals->GetTuple(i, row + 3);
      equal = std::memcmp(row, &numbers[6 * i], sizeof(row)) == 0;
    }
    Tester.Expect(equal, std::string("round trip in locale ") + name);
  }
  std::setlocale(LC_NUMERIC, before.c_str());
}
}

//------------------------------------------------------------------------------
int TestXYZReaderLarge(int, char*[])
{
  TestRoundTrip();
  std::string text;
  for (int i = 0; i < 100000; ++i)
  {
    text += "1 2 3\n# so much for that\n";
  }
  Tester.TestProgress(text, 100000);
  return Tester.Result();
}
