// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// The table of methods for point sets, the filters that it makes, and the presets of the composer
// agree: presets by name, and with the filters of the same name by result.

#include "PointFilterTester.h"

#include "vtkPointDenoisingMethods.h"
#include "vtkRobustPointNormalFilter.h"

#include <cstdlib>
#include <set>
#include <sstream>

namespace
{

using namespace PointTest;
using Methods = vtkPointDenoisingMethods;
using Robust = vtkRobustPointNormalFilter;

vtkSmartPointer<vtkPointDenoisingFilter> FilterOf(const std::string& method)
{
  for (int i = 0; i < Methods::GetNumberOfMethods(); ++i)
  {
    if (Methods::GetName(i) == method)
    {
      return vtkSmartPointer<vtkPointDenoisingFilter>::Take(Methods::NewFilter(i));
    }
  }
  return nullptr;
}

void TestTable(int& failures)
{
  CHECK(Methods::GetNumberOfMethods() >= 9);
  std::set<std::string> names;
  std::set<std::string> classes;
  for (const PointFilter& filter : AllPointFilters())
  {
    CHECK(names.insert(filter.Name).second);
  }
  names.clear();
  for (int i = 0; i < Methods::GetNumberOfMethods(); ++i)
  {
    const std::string name = Methods::GetName(i);
    auto filter = FilterOf(name);
    CHECK(filter && filter->GetClassName() == std::string("vtk") + Methods::GetFilter(i));
    CHECK(names.insert(name).second && classes.insert(filter->GetClassName()).second);
    CHECK(std::string(Methods::GetPaper(i)).find_first_of("0123456789") != std::string::npos);
  }
  for (const int none : { -1, Methods::GetNumberOfMethods() })
  {
    CHECK(!Methods::GetName(none) && !Methods::GetPaper(none) && !Methods::GetFilter(none));
    CHECK(!Methods::IsComposed(none) && Methods::NewFilter(none) == nullptr);
  }
  std::ostringstream text;
  vtkNew<Methods> methods;
  methods->Print(text);
  CHECK(text.str().find("Bilateral Point: Digne") != std::string::npos);
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
  CHECK(preset == Robust::ROLLING_POINT_NORMAL);
  CHECK(!Robust::GetPresetName(-1) && !Robust::GetPresetName(preset + 1));
  CHECK(Robust::GetNumberOfNorms() == Robust::CENTIN + 1);
  CHECK(std::string(Robust::GetNormName(Robust::TUKEY)) == "Tukey");
  CHECK(!Robust::GetNormName(-1) && !Robust::GetNormName(Robust::GetNumberOfNorms()));
}

/// A preset, its copy and the filter of the method give the same, whatever normals they start from.
void TestPreset(int preset, vtkPolyData* cloud, int& failures)
{
  for (const int source : { Robust::AUTOMATIC, Robust::PLANE_FIT })
  {
    auto own = FilterOf(Robust::GetPresetName(preset));
    auto chosen = vtkSmartPointer<Robust>::New();
    chosen->SetPreset(preset);
    auto copied = vtkSmartPointer<Robust>::New();
    // What a preset takes the place of does not matter.
    for (Robust* filter : { chosen.Get(), copied.Get() })
    {
      filter->SetNorm(Robust::L1);
      filter->SetOperatorToDiffusion();
      filter->SetNumberOfOuterIterations(7);
      filter->SetNumberOfNeighbors(5);
      filter->SetRadius(1.0);
      filter->SetPositionSchemeToQuadricFit();
      filter->SetMaximumDisplacement(1e-6);
      filter->UnorientedNormalsOn();
      filter->LocalScaleOn();
    }
    vtkSmartPointer<vtkPolyData> expected;
    const std::vector<vtkSmartPointer<vtkPointDenoisingFilter>> three{ own, chosen, copied };
    for (vtkPointDenoisingFilter* filter : three)
    {
      filter->SetNormalSource(source);
      filter->SetNormalOrientationToSpanningTree();
      filter->SetNumberOfNormalNeighbors(12);
      if (filter == copied)
      {
        copied->CopyPreset(preset);
        CHECK(copied->GetPreset() == Robust::CUSTOM);
      }
      filter->SetInputData(cloud);
      filter->Update();
      vtkPolyData* output = filter->GetOutput();
      if (!expected)
      {
        expected = Copy(output);
        CHECK(PointDistance(cloud, expected) > 1e-2 * filter->GetMeanSpacing());
      }
      CHECK(PointDistance(expected, output) < 1e-9 * cloud->GetLength());
      vtkDataArray* normals = output->GetPointData()->GetNormals();
      double largest = 0.0;
      for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
      {
        double m[3];
        double n[3];
        expected->GetPointData()->GetNormals()->GetTuple(i, m);
        normals->GetTuple(i, n);
        largest = std::max(largest, std::sqrt(vtkMath::Distance2BetweenPoints(m, n)));
      }
      CHECK(largest < 1e-8);
    }
  }
}

void TestPresets(int& failures)
{
  auto sphere = SphereCloud();
  sphere->GetPointData()->SetNormals(SphereNormals(sphere, "Normals", 0.1));
  auto cube = CubeCloud();
  for (int preset = Robust::CUSTOM + 1; preset < Robust::GetNumberOfPresets(); ++preset)
  {
    const int before = failures;
    TestPreset(preset, sphere, failures);
    TestPreset(preset, cube, failures);
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
  filter->CopyPreset(Robust::BILATERAL_POINT);
  CHECK(filter->GetMTime() > stamp && filter->GetOperator() == Robust::PLANE_NORMAL);
}

}

int TestPointMethods(int, char*[])
{
  int failures = 0;
  TestTable(failures);
  TestNames(failures);
  TestPresets(failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
