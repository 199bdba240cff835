// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file FilterTester.h
 * @brief Runs a filter of the list on surfaces and listens to what it says.
 */

#ifndef FilterTester_h
#define FilterTester_h

#include "AllMeshFilters.h"
#include "TestSurfaces.h"

namespace MeshTest
{

class FilterTester
{
public:
  explicit FilterTester(const MeshFilter& about)
    : About(about)
    , Filter(about.Make())
  {
    this->Seen->Watch(this->Filter);
  }

  vtkPolyData* Denoise(vtkPolyData* input) { return Run(this->Filter, input, this->Seen); }

  /// No error, and no warning but those that the filter is known for.
  bool SaidNothing() const
  {
    const std::string& warnings = this->Seen->Warnings;
    auto known = [&](Exception exception, const char* text)
    { return this->About.Is(exception) && warnings.find(text) != std::string::npos; };
    return this->Seen->Errors.empty() &&
      (warnings.empty() || known(NEEDS_NOISE, "have no noise") ||
        known(WHOLE_VOLUME, "not closed or lost its volume"));
  }

  /// The result is finite and nothing was said.
  bool Quiet(vtkPolyData* input)
  {
    vtkPolyData* output = this->Denoise(input);
    return this->SaidNothing() && output->GetNumberOfCells() == input->GetNumberOfCells() &&
      std::isfinite(PointDistance(input, output)) &&
      (!this->About.IsTwoStage() || input->GetNumberOfPoints() == 0 ||
        NormalDistance(output, output) == 0.0);
  }

  /// One error that contains the text, and no output.
  bool Refuses(vtkPolyData* input, const std::string& text)
  {
    vtkPolyData* output = this->Denoise(input);
    return this->Seen->Errors.find(text) != std::string::npos && output->GetNumberOfPoints() == 0;
  }

  const MeshFilter& About;
  vtkSmartPointer<vtkMeshDenoisingFilter> Filter;
  vtkNew<Messages> Seen;
};

}

#endif
