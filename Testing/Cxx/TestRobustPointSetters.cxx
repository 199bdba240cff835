// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Every setting of the composer for point sets changes the result; setters keep to their ranges,
// numbers beyond all clouds do no harm, and all is printed.

#include "PointSetters.h"

#include "vtkNormalPointUpdate.h"
#include "vtkRobustPointNormalFilter.h"

#include <cstdlib>
#include <sstream>

namespace
{

using namespace PointTest;

/// Settings of the stage that moves points.
template <typename Filter>
void TestUpdateSettings(Changes<Filter>& changes, int& failures)
{
  vtkNew<Filter> defaults;
  CHECK(changes([](Filter* f) { f->SetNumberOfPointIterations(13); }));
  CHECK(changes([](Filter* f) { f->SetNumberOfPointIterations(-1); }));
  for (int scheme = Filter::OWN_HEIGHT; scheme <= Filter::QUADRIC_FIT; ++scheme)
  {
    CHECK(changes([=](Filter* f) { f->SetPositionScheme(scheme); }) ==
      (scheme != defaults->GetPositionScheme()));
  }
  for (int norm = Filter::L2; norm <= Filter::CENTIN; ++norm)
  {
    CHECK(changes([=](Filter* f) { f->SetPositionNorm(norm); }) ==
      (norm != defaults->GetPositionNorm()));
  }
  for (int argument = Filter::CHORD; argument <= Filter::BENT_ARC; ++argument)
  {
    CHECK(changes([=](Filter* f) { f->SetPositionArgument(argument); }) ==
      (argument != defaults->GetPositionArgument()));
  }
  CHECK(changes([](Filter* f) { f->SetPositionStep(0.5); }));
  CHECK(changes([](Filter* f) { f->SetPositionRangeScale(0.5); }));
  CHECK(changes([](Filter* f) { f->SetPositionSpatialScale(2.0); }));
  CHECK(changes([](Filter* f) { f->SetPositionSpatialScale(-1.0); }));
  CHECK(changes([](Filter* f) { f->PositionIncludeOwnOn(); }));
  CHECK(changes([](Filter* f) { f->DensityWeightsOn(); }));
  CHECK(changes([](Filter* f) { f->LocalScaleOn(); }));
}

void TestComposer(int& failures)
{
  using Robust = vtkRobustPointNormalFilter;
  TestCommonSettings<Robust>(failures);
  TestNormalSettings<Robust>(failures);
  TestNeighborhoodSettings<Robust>(failures);
  Changes<Robust> robust(nullptr, Cloud());
  TestUpdateSettings(robust, failures);
  for (int norm = Robust::L2; norm <= Robust::CENTIN; ++norm)
  {
    CHECK(robust([=](Robust* f) { f->SetNorm(norm); }) == (norm != Robust::GAUSSIAN));
  }
  for (int argument = Robust::CHORD; argument <= Robust::BENT_ARC; ++argument)
  {
    CHECK(robust([=](Robust* f) { f->SetArgument(argument); }) == (argument != Robust::CHORD));
  }
  for (int kind = Robust::AVERAGE; kind <= Robust::PLANE_NORMAL; ++kind)
  {
    CHECK(robust([=](Robust* f) { f->SetOperator(kind); }) == (kind != Robust::AVERAGE));
  }
  for (int guidance = Robust::NO_GUIDANCE; guidance <= Robust::ROLLING; ++guidance)
  {
    CHECK(
      robust([=](Robust* f) { f->SetGuidance(guidance); }) == (guidance != Robust::NO_GUIDANCE));
  }
  for (int preset = 0; preset < Robust::GetNumberOfPresets(); ++preset)
  {
    CHECK(robust([=](Robust* f) { f->SetPreset(preset); }) == (preset != Robust::CUSTOM));
  }
  CHECK(robust([](Robust* f) { f->SetRangeScale(0.5); }));
  CHECK(robust([](Robust* f) { f->SetRangeScale(0.0); }));
  CHECK(robust([](Robust* f) { f->SetSpatialScale(2.0); }));
  CHECK(robust([](Robust* f) { f->SetSpatialScale(-1.0); }));
  CHECK(robust([](Robust* f) { f->SetNumberOfNormalIterations(7); }));
  CHECK(robust([](Robust* f) { f->SetNumberOfNormalIterations(-1); }));
  CHECK(robust([](Robust* f) { f->SetDataSourceToOriginal(); }));
  CHECK(robust([](Robust* f) { f->IncludeOwnOff(); }));
  Changes<Robust> quadric([](Robust* f) { f->SetPositionSchemeToQuadricFit(); }, Cloud());
  CHECK(quadric([](Robust* f) { f->SetEigenvalueCut(0.5); }));
  Changes<Robust> diffusion([](Robust* f) { f->SetOperatorToDiffusion(); }, Cloud());
  CHECK(diffusion([](Robust* f) { f->SetStepLength(0.2); }));
  CHECK(diffusion([](Robust* f) { f->SetStepLength(0.0); }));
  CHECK(!robust([](Robust* f) { f->SetNumberOfPatchNeighbors(4); }));
  Changes<Robust> patches([](Robust* f) { f->SetGuidanceToPatch(); }, Cloud());
  CHECK(patches([](Robust* f) { f->SetNumberOfPatchNeighbors(4); }));
  CHECK(patches([](Robust* f) { f->SetPatchAgreement(0.95); }));
  CHECK(patches([](Robust* f) { f->SetMemberAgreement(0.95); }));
  CHECK(patches([](Robust* f) { f->SetMemberAgreement(-1.0); }));
  Changes<Robust> signs([](Robust* f) { f->SetNormalOrientationToKeep(); }, CloudWithNormals());
  CHECK(signs([](Robust* f) { f->UnorientedNormalsOn(); }));

  using Update = vtkNormalPointUpdate;
  Changes<Update> update(nullptr, CloudWithNormals());
  TestUpdateSettings(update, failures);
}

template <typename Number, typename Filter>
bool Clamps(Filter* filter, void (Filter::*set)(Number), Number (Filter::*get)(), Number value,
  Number expected)
{
  (filter->*set)(value);
  return (filter->*get)() == expected;
}

/// A test in Python goes through all settings; here are those that would do harm.
void TestRanges(int& failures)
{
  using Base = vtkPointDenoisingFilter;
  vtkNew<vtkRobustPointNormalFilter> robust;
  Base* base = robust;
  CHECK(Clamps(base, &Base::SetNormalSource, &Base::GetNormalSource, 99, 3));
  CHECK(Clamps(base, &Base::SetNormalSource, &Base::GetNormalSource, -1, 0));
  CHECK(Clamps(base, &Base::SetNormalOrientation, &Base::GetNormalOrientation, 99, 2));
  CHECK(Clamps(base, &Base::SetNumberOfNormalNeighbors, &Base::GetNumberOfNormalNeighbors, -5, 0));
  CHECK(Clamps(base, &Base::SetNumberOfOuterIterations, &Base::GetNumberOfOuterIterations, -5, -1));
  CHECK(Clamps(base, &Base::SetMaximumDisplacement, &Base::GetMaximumDisplacement, -1.0, 0.0));
  CHECK(Clamps(base, &Base::SetNumberOfThreads, &Base::GetNumberOfThreads, -1, 0));
  using Neighbors = vtkPointNeighborhoodFilter;
  Neighbors* neighbors = robust;
  CHECK(
    Clamps(neighbors, &Neighbors::SetNumberOfNeighbors, &Neighbors::GetNumberOfNeighbors, -2, 0));
  CHECK(Clamps(neighbors, &Neighbors::SetRadius, &Neighbors::GetRadius, -2.0, 0.0));

  // Numbers beyond all clouds are allowed and do no harm.
  auto cloud = SphereCloud(60);
  for (const PointFilter& about : AllPointFilters())
  {
    PointFilterTester test(about);
    test.Filter->SetNumberOfNormalNeighbors(VTK_INT_MAX);
    test.Filter->SetMaximumDisplacement(VTK_DOUBLE_MAX);
    if (auto* rows = Neighbors::SafeDownCast(test.Filter))
    {
      rows->SetNumberOfNeighbors(VTK_INT_MAX);
      rows->SetMaximumNumberOfNeighbors(VTK_INT_MAX);
      CHECK(test.Quiet(cloud));
      rows->SetNeighborhoodToBall();
      for (const double radius : { 0.0, 0.1, 1e10, VTK_DOUBLE_MAX })
      {
        rows->SetRadius(radius);
        CHECK(test.Quiet(cloud));
      }
    }
    CHECK(test.Quiet(cloud));
  }
}

void TestPrint(int& failures)
{
  std::ostringstream text;
  for (const PointFilter& filter : AllPointFilters())
  {
    filter.MakeDefault()->Print(text);
  }
  for (const char* name : { "NormalSource: 0", "NumberOfThreads: 0", "MeanSpacing: 0",
         "Neighborhood: 1", "PositionScheme: 3", "Preset: Bilateral Point", "Preset: Custom",
         "RangeScale: ", "MemberAgreement: 0.65", "Norm: Gaussian", "HeightScale: 1",
         "NormalAngle: ", "FilterScale: ", "LeastAngle: ", "BundleAngle: ", "NumberOfRolls: 4",
         "Degree: 2", "MinimumRegionSize: ", "AsReleased: 1" })
  {
    CHECK(text.str().find(name) != std::string::npos);
  }
}

}

int TestRobustPointSetters(int, char*[])
{
  int failures = 0;
  TestComposer(failures);
  TestRanges(failures);
  TestPrint(failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
