// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// The table of methods, the list of filters that the tests run on, and the presets of the composer
// agree: presets by name, and with the filters of the same name by result.

#include "FilterTester.h"

#include "vtkDenoisingMethods.h"
#include "vtkRobustNormalFilter.h"

#include <cstdlib>
#include <set>
#include <sstream>

namespace
{

using namespace MeshTest;
using Methods = vtkDenoisingMethods;
using Robust = vtkRobustNormalFilter;

/// The filter of the list for a row of the table.
const MeshFilter* Find(const std::string& method)
{
  for (const MeshFilter& filter : AllMeshFilters())
  {
    if (filter.Method == method)
    {
      return &filter;
    }
  }
  return nullptr;
}

void TestList(int& failures)
{
  CHECK(Methods::GetNumberOfMethods() >= 18);
  std::set<std::string> names;
  for (const MeshFilter& filter : AllMeshFilters())
  {
    CHECK(names.insert(filter.Name).second);
  }
  for (int i = 0; i < Methods::GetNumberOfMethods(); ++i)
  {
    const std::string name = Methods::GetName(i);
    const MeshFilter* filter = Find(name);
    if (!filter)
    {
      std::cerr << "AllMeshFilters.cxx lacks " << name << "\n";
      ++failures;
      continue;
    }
    CHECK(filter->MakeDefault()->GetClassName() == std::string("vtk") + Methods::GetFilter(i));
    CHECK(filter->IsTwoStage() == Methods::IsTwoStage(i));
    CHECK(std::string(Methods::GetPaper(i)).find_first_of("0123456789") != std::string::npos);
  }
  for (const int none : { -1, Methods::GetNumberOfMethods() })
  {
    CHECK(!Methods::GetName(none) && !Methods::GetPaper(none) && !Methods::GetFilter(none));
    CHECK(!Methods::IsTwoStage(none) && !Methods::IsComposed(none));
  }
  std::ostringstream text;
  vtkNew<Methods> methods;
  methods->Print(text);
  CHECK(text.str().find("Guided Normal: Zhang") != std::string::npos);
}

/// Presets are the composed methods in the order of the table.
void TestNames(int& failures)
{
  int preset = Robust::CUSTOM;
  CHECK(std::string(Robust::GetPresetName(preset)) == "Custom");
  for (int i = 0; i < Methods::GetNumberOfMethods(); ++i)
  {
    if (Methods::IsComposed(i))
    {
      const char* name = Robust::GetPresetName(++preset);
      CHECK(name && std::string(name) == Methods::GetName(i));
    }
  }
  CHECK(preset + 1 == Robust::GetNumberOfPresets());
  CHECK(preset == Robust::THRESHOLDED_COSINE);
  CHECK(!Robust::GetPresetName(-1) && !Robust::GetPresetName(preset + 1));
}

/// A preset, its copy and the filter of the method give the same, whatever borders and flips do.
void TestPreset(int preset, vtkPolyData* surface, int& failures)
{
  const MeshFilter* method = Find(Robust::GetPresetName(preset));
  if (!method)
  {
    ++failures;
    return;
  }
  for (const int boundary : { Robust::FIXED, Robust::SLIDE, Robust::FREE })
  {
    const bool guard = boundary != Robust::SLIDE;
    vtkSmartPointer<vtkMeshDenoisingFilter> own = method->MakeDefault();
    vtkNew<Robust> chosen;
    chosen->SetPreset(preset);
    vtkNew<Robust> copied;
    copied->CopyPreset(preset);
    CHECK(copied->GetPreset() == Robust::CUSTOM);
    // What a preset takes the place of does not matter.
    chosen->SetNorm(Robust::L1);
    chosen->SetScaleSourceToDataRayleigh();
    chosen->SetNumberOfOuterIterations(7);
    chosen->SetVertexSchemeToConstantStep();
    chosen->SetMaximumDisplacement(1e-6);

    vtkSmartPointer<vtkPolyData> expected;
    for (vtkMeshDenoisingFilter* each : { own.Get(), static_cast<vtkMeshDenoisingFilter*>(chosen),
           static_cast<vtkMeshDenoisingFilter*>(copied) })
    {
      auto* filter = vtkFaceNormalFilter::SafeDownCast(each);
      filter->SetBoundaryHandling(boundary);
      filter->SetPreventFlips(guard);
      filter->SetInputData(surface);
      filter->Update();
      if (!expected)
      {
        expected = Copy(filter->GetOutput());
        CHECK(PointDistance(surface, expected) > 1e-2 * filter->GetMeanEdgeLength());
      }
      CHECK(PointDistance(expected, filter->GetOutput()) < 1e-9 * surface->GetLength());
      CHECK(NormalDistance(expected, filter->GetOutput()) < 1e-9);
    }
    CHECK(std::abs(chosen->GetUsedRangeScale() / copied->GetUsedRangeScale() - 1.0) < 1e-9);
  }
}

void TestPresets(int& failures)
{
  vtkNew<vtkTransform> identity;
  auto sphere = Moved(NoisySphere(20, 0.012), identity);
  auto box = NoisyBox(6, 0.15);
  for (int preset = Robust::CUSTOM + 1; preset < Robust::GetNumberOfPresets(); ++preset)
  {
    const int before = failures;
    TestPreset(preset, sphere, failures);
    TestPreset(preset, box, failures);
    if (failures > before)
    {
      std::cerr << "  by: " << Robust::GetPresetName(preset) << "\n";
    }
  }

  // Numbers that are no preset copy nothing.
  vtkNew<Robust> filter;
  const vtkMTimeType stamp = filter->GetMTime();
  for (const int none : { -1, int(Robust::CUSTOM), Robust::GetNumberOfPresets() })
  {
    filter->CopyPreset(none);
  }
  CHECK(filter->GetMTime() == stamp);
  filter->CopyPreset(Robust::HUBER_NORMAL);
  CHECK(filter->GetMTime() > stamp && filter->GetNorm() == Robust::HUBER);
}

/// The weight of a face cancels in an average without it, which would be silently wrong.
void TestCurvatureOfFaces(int& failures)
{
  auto surface = NoisySphere(12, 0.02);
  vtkNew<Robust> filter;
  vtkNew<Messages> seen;
  seen->Watch(filter);
  filter->SetArgumentToFaceCurvature();
  CHECK(PointDistance(surface, Run(filter, surface, seen)) > 1e-4 && seen->Errors.empty());
  filter->IncludeOwnOff();
  CHECK(Run(filter, surface, seen)->GetNumberOfPoints() == 0);
  CHECK(seen->Errors.find("its curvature cancels") != std::string::npos);
  filter->SetOperatorToDiffusion();
  CHECK(PointDistance(surface, Run(filter, surface, seen)) > 1e-4 && seen->Errors.empty());
  filter->SetOperatorToAverage();
  filter->SetPreset(Robust::GEOMETRIC_FIDELITY); // takes the place of all that
  CHECK(PointDistance(surface, Run(filter, surface, seen)) > 1e-4 && seen->Errors.empty());
}

}

int TestDenoisingMethods(int, char*[])
{
  int failures = 0;
  TestList(failures);
  TestNames(failures);
  TestPresets(failures);
  TestCurvatureOfFaces(failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
