// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
// What tests of readers share: files of given content, read well or refused.

#ifndef ReaderTester_h
#define ReaderTester_h

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTestErrorObserver.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

/// Counts what fails, and says what.
template <typename Reader>
class ReaderTester
{
public:
  static constexpr unsigned long AnyCode = ~0ul;

  /// \p fileName is that of the file that is written again and again.
  explicit ReaderTester(const char* fileName)
    : FileName(fileName)
  {
  }

  void Expect(bool condition, const std::string& what)
  {
    if (!condition)
    {
      std::cerr << "FAILED: " << what << "\n";
      ++this->Failures;
    }
  }

  void Write(const std::string& content)
  {
    std::ofstream(this->FileName, std::ios::binary) << content;
  }

  /// \p set changes the reader before it reads.
  template <typename Set>
  vtkSmartPointer<vtkPolyData> Read(const std::string& content, const Set& set)
  {
    this->Write(content);
    vtkNew<Reader> reader;
    reader->SetFileName(this->FileName);
    set(reader.Get());
    reader->Update();
    this->Expect(reader->GetErrorCode() == vtkErrorCode::NoError, "no error for\n" + content);
    return reader->GetOutput();
  }

  vtkSmartPointer<vtkPolyData> Read(const std::string& content)
  {
    return this->Read(content, [](Reader*) {});
  }

  /// The array has these values in a tuple; all NaN are equal here.
  void ExpectTuple(vtkDataArray* array, vtkIdType tuple, const std::vector<double>& values,
    const std::string& what)
  {
    bool equal = array && array->GetNumberOfComponents() == static_cast<int>(values.size()) &&
      tuple < array->GetNumberOfTuples();
    for (std::size_t i = 0; equal && i < values.size(); ++i)
    {
      const double value = array->GetComponent(tuple, static_cast<int>(i));
      equal = value == values[i] || (std::isnan(value) && std::isnan(values[i]));
    }
    this->Expect(equal, what);
  }

  template <typename Set>
  void ExpectError(const std::string& content, const std::string& message, unsigned long code,
    const Set& set)
  {
    this->Write(content);
    vtkNew<Reader> reader;
    vtkNew<vtkTest::ErrorObserver> observer;
    vtkNew<vtkTest::ErrorObserver> silence; // the pipeline repeats that the reader failed
    reader->AddObserver(vtkCommand::ErrorEvent, observer);
    reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
    reader->SetFileName(this->FileName);
    set(reader.Get());
    reader->Update();
    const std::string raised = observer->GetErrorMessage();
    this->Expect(raised.find(message) != std::string::npos,
      "error '" + message + "' for\n" + content + "\nbut it says: " + raised);
    this->Expect(code == AnyCode ? reader->GetErrorCode() != vtkErrorCode::NoError
                                 : reader->GetErrorCode() == code,
      "error code for\n" + content);
    this->Expect(reader->GetOutput()->GetNumberOfPoints() == 0, "empty output for\n" + content);
  }

  void ExpectError(const std::string& content, const std::string& message, unsigned long code)
  {
    this->ExpectError(content, message, code, [](Reader*) {});
  }

  /// Names of files that are none; a reader recovers from its error. \p content has one point.
  void TestFileNames(const std::string& content)
  {
    const char* const missing = "there-is-no-such-file";
    vtkNew<vtkTest::ErrorObserver> observer;
    vtkNew<Reader> reader;
    reader->AddObserver(vtkCommand::ErrorEvent, observer);
    reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
    reader->Update();
    this->Expect(reader->GetErrorCode() == vtkErrorCode::NoFileNameError, "no file name");
    reader->SetFileName(missing);
    reader->Update();
    this->Expect(reader->GetErrorCode() == vtkErrorCode::FileNotFoundError, "missing file");
    reader->SetFileName(".");
    reader->Update();
    this->Expect(reader->GetErrorCode() == vtkErrorCode::CannotOpenFileError, "a folder");

    this->Write(content);
    reader->SetFileName(this->FileName);
    reader->Update();
    this->Expect(reader->GetErrorCode() == vtkErrorCode::NoError &&
        reader->GetOutput()->GetNumberOfPoints() == 1,
      "a reader recovers from an error");

    for (const char* name : { missing, ".", static_cast<const char*>(nullptr) })
    {
      this->Expect(Reader::CanReadFile(name) == 0, "cannot read what is not");
    }
  }

  /// Progress rises from 0 to 1; an abort ends the work and leaves nothing behind. \p content is
  /// long and has so many points.
  void TestProgress(const std::string& content, vtkIdType points)
  {
    this->Write(content);
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
          auto* const reader = Reader::SafeDownCast(caller);
          w.Fractions.push_back(reader->GetProgress());
          reader->SetAbortExecute(w.Abort && reader->GetProgress() > 0.3);
        });
      vtkNew<Reader> reader;
      reader->SetFileName(this->FileName);
      reader->AddObserver(vtkCommand::ProgressEvent, command);
      reader->Update();
      const std::vector<double>& fractions = watch.Fractions;
      this->Expect(fractions.size() > (abort ? 2u : 6u) && fractions.front() < 0.01 &&
          std::is_sorted(fractions.begin(), fractions.end()) && fractions.back() <= 1.0,
        "progress");
      this->Expect(reader->GetOutput()->GetNumberOfPoints() == (abort ? 0 : points), "abort");
      this->Expect(reader->GetErrorCode() == vtkErrorCode::NoError, "an abort is no error");
    }
  }

  void ExpectCanRead(bool can, const std::string& content)
  {
    this->Write(content);
    this->Expect(Reader::CanReadFile(this->FileName) == (can ? 1 : 0),
      (can ? "can read\n" : "cannot read\n") + content);
  }

  int Result() const { return this->Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE; }

private:
  const char* FileName;
  int Failures = 0;
};

#endif
