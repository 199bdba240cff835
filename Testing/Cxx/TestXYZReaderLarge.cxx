// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
// Many points: vtkXYZReader reads all of them with all their digits, says how far it is, and stops
// when it is told to.

#include "ReaderTester.h"

#include "vtkXYZReader.h"

#include "vtkCallbackCommand.h"
#include "vtkPointData.h"

#include <algorithm>
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

//------------------------------------------------------------------------------
/// Progress rises from 0 to 1; an abort ends the work and leaves nothing behind.
void TestProgress()
{
  std::string text;
  for (int i = 0; i < 100000; ++i)
  {
    text += "1 2 3\n# so much for that\n";
  }
  Tester.Write(text);
  for (const bool abort : { false, true })
  {
    struct Watch
    {
      std::vector<double> Fractions;
      bool Abort;
    } watch{ {}, abort };
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(&watch);
    command->SetCallback(
      [](vtkObject* caller, unsigned long, void* data, void*)
      {
        auto& w = *static_cast<Watch*>(data);
        auto* const reader = vtkXYZReader::SafeDownCast(caller);
        w.Fractions.push_back(reader->GetProgress());
        reader->SetAbortExecute(w.Abort && reader->GetProgress() > 0.3);
      });
    vtkNew<vtkXYZReader> reader;
    reader->SetFileName(FileName);
    reader->AddObserver(vtkCommand::ProgressEvent, command);
    reader->Update();
    const std::vector<double>& fractions = watch.Fractions;
    Tester.Expect(fractions.size() > (abort ? 2u : 6u) && fractions.front() < 0.01 &&
        std::is_sorted(fractions.begin(), fractions.end()) && fractions.back() <= 1.0,
      "progress");
    Tester.Expect(reader->GetOutput()->GetNumberOfPoints() == (abort ? 0 : 100000), "abort");
    Tester.Expect(reader->GetErrorCode() == vtkErrorCode::NoError, "an abort is no error");
  }
}
}

//------------------------------------------------------------------------------
int TestXYZReaderLarge(int, char*[])
{
  TestRoundTrip();
  TestProgress();
  return Tester.Result();
}
