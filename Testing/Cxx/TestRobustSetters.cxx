// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Every part of the composer can be chosen and matters, with those that it belongs to; choices that
// make no filter are refused.

#include "SetterChanges.h"

#include "vtkRobustNormalFilter.h"

#include <cstdlib>

namespace
{

using namespace MeshTest;
using Filter = vtkRobustNormalFilter;
using FilterChanges = Changes<vtkRobustNormalFilter>;

void TestNorms(int& failures)
{
  FilterChanges changes;
  for (int norm = 0; norm < Filter::GetNumberOfNorms(); ++norm)
  {
    CHECK(changes([norm](Filter* f) { f->SetNorm(norm); }) == (norm != Filter::GAUSSIAN));
  }
  CHECK(Filter::GetNormName(-1) == nullptr && Filter::GetNormName(Filter::CENTIN + 1) == nullptr);
  CHECK(std::string(Filter::GetNormName(Filter::TUKEY)) == "Tukey");
}

void TestWeights(int& failures)
{
  FilterChanges changes;
  CHECK(changes([](Filter* f) { f->SetArgumentToAngle(); }));
  CHECK(changes([](Filter* f) { f->SetArgumentToDirectionalCurvature(); }));
  CHECK(changes([](Filter* f) { f->SetArgumentToNormalGradient(); }));
  CHECK(changes([](Filter* f) { f->SetArgumentToFaceCurvature(); }));
  CHECK(changes([](Filter* f) { f->SetGuidanceToPatch(); }));
  CHECK(changes([](Filter* f) { f->SetGuidanceToVectorMedian(); }));
  CHECK(changes([](Filter* f) { f->SetScaleSourceToGiven(); }));
  CHECK(changes([](Filter* f) { f->SetScaleSourceToDataRayleigh(); }));
  CHECK(changes([](Filter* f) { f->SetScaleSourceToDataHalfNormal(); }));
  CHECK(changes([](Filter* f) { f->SetSpatialScale(2.0); }));
  CHECK(changes([](Filter* f) { f->SetSpatialScale(-1.0); }));
  CHECK(changes([](Filter* f) { f->LocalSpatialScaleOn(); }));
  CHECK(changes([](Filter* f) { f->SetFaceWeightingToUniform(); }));
  CHECK(changes([](Filter* f) { f->SetFaceWeightingToCoupling(); }));
  CHECK(changes([](Filter* f) { f->IncludeOwnOff(); }));
  CHECK(changes([](Filter* f) { f->SetDataSourceToOriginal(); }));

  FilterChanges given([](Filter* f) { f->SetScaleSourceToGiven(); });
  CHECK(given([](Filter* f) { f->SetRangeScale(0.3); }));
  for (const int argument :
    { Filter::DIRECTIONAL_CURVATURE, Filter::NORMAL_GRADIENT, Filter::FACE_CURVATURE })
  {
    FilterChanges curvature(
      [argument](Filter* f)
      {
        f->SetArgument(argument);
        f->SetScaleSourceToGiven();
        f->SetRangeScale(argument == Filter::DIRECTIONAL_CURVATURE ? 20.0 : 0.35);
      });
    CHECK(curvature([](Filter* f) { f->SetCurvatureUnitToEdgeLength(); }));
    CHECK(curvature([](Filter* f) { f->SetRangeScale(1.1 * f->GetRangeScale()); }));
  }

  // 40 degrees are 40 degrees, as an angle or as a chord, for a norm that only asks for more or
  // less.
  const double degrees = 40.0;
  FilterChanges chord(
    [degrees](Filter* f)
    {
      f->SetNorm(Filter::TRUNCATED_L2);
      f->SetScaleSourceToGiven();
      f->SetRangeScale(2.0 * std::sin(vtkMath::RadiansFromDegrees(0.5 * degrees)));
    });
  CHECK(!chord(
    [degrees](Filter* f)
    {
      f->SetArgumentToAngle();
      f->SetRangeScale(degrees);
    }));
}

void TestNeighborhoods(int& failures)
{
  FilterChanges changes;
  CHECK(changes([](Filter* f) { f->SetNeighborhoodToEdgeAdjacent(); }));
  CHECK(changes([](Filter* f) { f->SetNeighborhoodToRadius(); }));
  CHECK(changes([](Filter* f) { f->SetNeighborhoodToEdgeRadius(); }));
  for (const int neighborhood : { Filter::RADIUS, Filter::EDGE_RADIUS })
  {
    FilterChanges ball(
      [neighborhood](Filter* f)
      {
        f->SetNeighborhood(neighborhood);
        f->SetNumberOfOuterIterations(3);
      });
    CHECK(ball([](Filter* f) { f->SetRadius(3.0); }));
    CHECK(ball([](Filter* f) { f->RenewNeighborhoodOff(); }));
    CHECK(ball(
      [=](Filter* f) { f->SetNeighborhood(Filter::RADIUS + Filter::EDGE_RADIUS - neighborhood); }));
  }
}

void TestOperators(int& failures)
{
  FilterChanges changes;
  CHECK(changes([](Filter* f) { f->SetOperatorToDiffusion(); }));
  CHECK(changes([](Filter* f) { f->SetOperatorToGlobalSolve(); }));
  FilterChanges diffusion([](Filter* f) { f->SetOperatorToDiffusion(); });
  CHECK(diffusion([](Filter* f) { f->SetStepLength(0.4); }));
  CHECK(diffusion([](Filter* f) { f->TangentialFluxOn(); }));
  FilterChanges global([](Filter* f) { f->SetOperatorToGlobalSolve(); });
  CHECK(global([](Filter* f) { f->SetFidelity(0.02); }));
  CHECK(global([](Filter* f) { f->AreaEnergyOff(); }));
}

void TestSchedule(int& failures)
{
  FilterChanges changes;
  CHECK(changes([](Filter* f) { f->SetNumberOfOuterIterations(10); }));
  CHECK(changes([](Filter* f) { f->SetNumberOfNormalIterations(5); }));
  CHECK(changes([](Filter* f) { f->SetNumberOfVertexIterations(5); }));
  CHECK(changes([](Filter* f) { f->UpdateVerticesOff(); }));
  CHECK(changes([](Filter* f) { f->SetVertexSchemeToConstantStep(); }));
  CHECK(changes([](Filter* f) { f->SetVertexSchemeToAreaWeighted(); }));
  CHECK(changes([](Filter* f) { f->SetVertexSchemeToIntegralFit(); }));
  CHECK(changes([](Filter* f) { f->SetVertexSchemeToEdgeWeighted(); }));
  CHECK(changes([](Filter* f) { f->SetBoundaryHandlingToSlide(); }));
  CHECK(changes([](Filter* f) { f->SetBoundaryHandlingToFree(); }));
  CHECK(changes([](Filter* f) { f->SetMaximumDisplacement(0.02); }));
  FilterChanges alternating([](Filter* f) { f->SetNumberOfOuterIterations(10); });
  CHECK(alternating([](Filter* f) { f->SetNumberOfOuterIterations(9); }));
  FilterChanges relaxed([](Filter* f) { f->SetVertexSchemeToEdgeWeighted(); });
  CHECK(relaxed([](Filter* f) { f->SetRelaxation(0.1); }));
  FilterChanges folded([](Filter* f) { f->SetNumberOfVertexIterations(20); }, Roof(16, 1.5));
  CHECK(folded([](Filter* f) { f->PreventFlipsOff(); }));
}

/// A preset takes the place of all but these.
void TestPresets(int& failures)
{
  FilterChanges changes;
  for (int preset = Filter::CUSTOM + 1; preset < Filter::GetNumberOfPresets(); ++preset)
  {
    CHECK(changes([preset](Filter* f) { f->SetPreset(preset); }));
    CHECK(changes([preset](Filter* f) { f->CopyPreset(preset); }));
  }
  FilterChanges guided([](Filter* f) { f->SetPreset(Filter::GUIDED_NORMAL); });
  CHECK(guided([](Filter* f) { f->SetBoundaryHandlingToFree(); }));
  CHECK(guided([](Filter* f) { f->UpdateVerticesOff(); }));
  CHECK(guided([](Filter* f) { f->SetPreset(Filter::CUSTOM); }));
  CHECK(!guided([](Filter* f) { f->SetNorm(Filter::L2); }));
}

void TestBadSettings(int& failures)
{
  vtkNew<Filter> filter;
  vtkNew<Messages> seen;
  seen->Watch(filter);
  filter->SetScaleSourceToGiven();
  auto surface = Roof(16);
  for (const double scale : { -1.0, vtkMath::Nan() })
  {
    filter->SetRangeScale(0.0);
    Run(filter, surface, seen);
    CHECK(filter->GetMeanEdgeLength() > 0.0 && filter->GetChosenValue("RangeScale") > 0.0);
    filter->SetRangeScale(scale);
    Run(filter, surface, seen);
    CHECK(seen->Errors.find("must not be negative") != std::string::npos);
    // What was found before is not said of this.
    CHECK(filter->GetMeanEdgeLength() == 0.0 && filter->GetMeanCentroidDistance() == 0.0);
    CHECK(std::isnan(filter->GetChosenValue("RangeScale")));
  }

  // Without noise there is no scale to take from it.
  filter->SetScaleSourceToDataMAD();
  auto flat = QuadGrid(6, 0.0);
  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
  {
    flat->GetPoints()->SetPoint(i, static_cast<double>(i % 7), static_cast<double>(i / 7), 0.0);
  }
  vtkPolyData* output = Run(filter, flat, seen);
  CHECK(seen->Errors.empty() && seen->Warnings.find("no noise") != std::string::npos);
  CHECK(PointDistance(flat, output) == 0.0);
}

}

int TestRobustSetters(int, char*[])
{
  int failures = 0;
  TestNorms(failures);
  TestWeights(failures);
  TestNeighborhoods(failures);
  TestOperators(failures);
  TestSchedule(failures);
  TestPresets(failures);
  TestBadSettings(failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
