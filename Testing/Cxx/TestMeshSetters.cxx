// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Every setting of every filter of two stages changes the result: none is accepted and then
// ignored. TestRobustSetters has those of the composer, TestOneStageFilters those of the other
// filters.

#include "SetterChanges.h"

#include "vtkBilateralNormalFilter.h"
#include "vtkCurvatureNormalDiffusionFilter.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFuzzyVectorMedianNormalFilter.h"
#include "vtkGeometricFidelityNormalFilter.h"
#include "vtkGuidedNormalFilter.h"
#include "vtkHuberNormalFilter.h"
#include "vtkMeanNormalFilter.h"
#include "vtkMedianNormalFilter.h"
#include "vtkNormalDiffusionFilter.h"
#include "vtkNormalVertexUpdate.h"
#include "vtkNormalVotingTensorFilter.h"
#include "vtkTukeyBilateralNormalFilter.h"

#include <cstdlib>
#include <sstream>

namespace
{

using namespace MeshTest;

/// Settings of the stage that moves points.
template <typename Filter>
void TestVertexSettings(Changes<Filter>& changes, int& failures)
{
  vtkNew<Filter> defaults;
  CHECK(changes([](Filter* f) { f->SetNumberOfVertexIterations(13); }));
  CHECK(changes([](Filter* f) { f->SetNumberOfVertexIterations(-1); }));
  for (int scheme = Filter::FACE_MEAN; scheme <= Filter::EDGE_WEIGHTED; ++scheme)
  {
    CHECK(changes([=](Filter* f) { f->SetVertexScheme(scheme); }) ==
      (scheme != defaults->GetVertexScheme()));
  }
  CHECK(changes([](Filter* f) { f->SetBoundaryHandlingToSlide(); }));
  CHECK(changes([](Filter* f) { f->SetBoundaryHandlingToFree(); }));
  CHECK(changes([](Filter* f) { f->SetMaximumDisplacement(0.02); }));
}

/// Settings that all filters of two stages have. fold makes a filter move points a lot.
template <typename Filter>
void TestCommonSettings(int& failures, std::function<void(Filter*)> fold = nullptr)
{
  const int before = failures;
  Changes<Filter> changes;
  TestVertexSettings(changes, failures);
  CHECK(changes([](Filter* f) { f->SetNumberOfOuterIterations(5); }));
  CHECK(changes([](Filter* f) { f->SetNumberOfOuterIterations(-1); }));
  CHECK(changes([](Filter* f) { f->SetNumberOfNormalIterations(5); }));
  CHECK(changes([](Filter* f) { f->SetNumberOfNormalIterations(-1); }));
  CHECK(changes([](Filter* f) { f->UpdateVerticesOff(); }));
  Changes<Filter> relaxed([](Filter* f) { f->SetVertexSchemeToEdgeWeighted(); });
  CHECK(relaxed([](Filter* f) { f->SetRelaxation(0.1); }));
  CHECK(relaxed([](Filter* f) { f->SetRelaxation(0.0); }));
  // Faces fold where there is enough noise.
  Changes<Filter> folded(
    [fold](Filter* f)
    {
      f->SetVertexSchemeToFaceMean();
      f->SetNumberOfVertexIterations(20);
      if (fold)
      {
        fold(f);
      }
    },
    Roof(16, 1.5));
  CHECK(folded([](Filter* f) { f->PreventFlipsOff(); }));
  if (failures > before)
  {
    std::cerr << "  by: " << vtkSmartPointer<Filter>::New()->GetClassName() << "\n";
  }
}

void TestBilateral(int& failures)
{
  using Filter = vtkBilateralNormalFilter;
  TestCommonSettings<Filter>(failures);
  Changes<Filter> local;
  CHECK(!local([](Filter* f) { f->SetRangeScale(0.35); }));
  CHECK(local([](Filter* f) { f->SetRangeScale(0.36); }));
  CHECK(local([](Filter* f) { f->SetRangeScale(0.0); }));
  CHECK(local([](Filter* f) { f->SetSpatialScale(2.0); }));
  CHECK(local([](Filter* f) { f->SetSpatialScale(-1.0); }));
  CHECK(local([](Filter* f) { f->SetNeighborhoodToEdgeAdjacent(); }));
  CHECK(local([](Filter* f) { f->SetSchemeToGlobal(); }));
  Changes<Filter> global([](Filter* f) { f->SetSchemeToGlobal(); });
  CHECK(global([](Filter* f) { f->SetRangeScale(0.36); }));
  CHECK(global([](Filter* f) { f->SetRangeScale(0.0); }));
  CHECK(global([](Filter* f) { f->SetSpatialScale(2.0); }));
  CHECK(global([](Filter* f) { f->SetSpatialScale(-1.0); }));
  CHECK(global([](Filter* f) { f->SetNeighborhoodToEdgeAdjacent(); }));
  CHECK(global([](Filter* f) { f->SetFidelity(0.02); }));
  CHECK(global([](Filter* f) { f->AreaEnergyOff(); }));
  CHECK(global([](Filter* f) { f->SetNumberOfOuterIterations(2); }));
  // One solution is the solution.
  CHECK(!global([](Filter* f) { f->SetNumberOfNormalIterations(7); }));
}

void TestMeansAndMedians(int& failures)
{
  TestCommonSettings<vtkMeanNormalFilter>(failures);
  CHECK(Changes<vtkMeanNormalFilter>()([](vtkMeanNormalFilter* f) { f->IncludeOwnOff(); }));

  using Filter = vtkMedianNormalFilter;
  TestCommonSettings<Filter>(failures);
  Changes<Filter> angular;
  CHECK(angular([](Filter* f) { f->SetMedianTypeToWeighted(); }));
  CHECK(angular([](Filter* f) { f->SetMedianTypeToDirectional(); }));
  CHECK(angular([](Filter* f) { f->SetMedianTypeToGeometric(); }));
  Changes<Filter> weighted([](Filter* f) { f->SetMedianTypeToWeighted(); });
  CHECK(weighted([](Filter* f) { f->SetEdgeRepetitions(3); }));
  CHECK(weighted([](Filter* f) { f->SetEdgeRepetitions(0); }));
  CHECK(weighted([](Filter* f) { f->SetVertexRepetitions(2); }));
  CHECK(weighted([](Filter* f) { f->SetVertexRepetitions(0); }));
  // With all faces alike it is the angular one, for which repetitions do not matter.
  CHECK(!angular(
    [](Filter* f)
    {
      f->SetMedianTypeToWeighted();
      f->SetEdgeRepetitions(1);
    }));
  CHECK(!angular([](Filter* f) { f->SetEdgeRepetitions(5); }));
  // However often faces count, the sum is a number: who counts this much is alone in the end.
  Changes<Filter> edges(
    [](Filter* f)
    {
      f->SetMedianTypeToWeighted();
      f->SetVertexRepetitions(0);
    },
    NoisySphere(12));
  CHECK(!edges(
    [](Filter* f)
    {
      f->SetEdgeRepetitions(VTK_INT_MAX);
      f->SetVertexRepetitions(1);
    }));
  Changes<Filter> geometric([](Filter* f) { f->SetMedianTypeToGeometric(); });
  CHECK(geometric([](Filter* f) { f->SetRegularization(0.1); }));
}

void TestEarlyMethods(int& failures)
{
  using Diffusion = vtkNormalDiffusionFilter;
  TestCommonSettings<Diffusion>(failures);
  Changes<Diffusion> diffusion;
  CHECK(diffusion([](Diffusion* f) { f->SetRangeScale(34.0); }));
  CHECK(diffusion([](Diffusion* f) { f->SetRangeScale(0.0); }));
  CHECK(diffusion([](Diffusion* f) { f->SetNeighborhoodToVertexSharing(); }));
  CHECK(diffusion([](Diffusion* f) { f->IncludeOwnOff(); }));

  using Huber = vtkHuberNormalFilter;
  TestCommonSettings<Huber>(failures);
  Changes<Huber> huber;
  CHECK(huber([](Huber* f) { f->SetRangeScale(0.11); }));
  CHECK(huber([](Huber* f) { f->SetRangeScale(0.0); }));
  CHECK(huber([](Huber* f) { f->SetSpatialScale(1.0); }));
  CHECK(huber([](Huber* f) { f->SetDataSourceToOriginal(); }));

  using Fuzzy = vtkFuzzyVectorMedianNormalFilter;
  TestCommonSettings<Fuzzy>(failures);
  Changes<Fuzzy> fuzzy;
  CHECK(fuzzy([](Fuzzy* f) { f->SetRangeScale(0.36); }));
  CHECK(fuzzy([](Fuzzy* f) { f->SetRangeScale(0.0); }));
  CHECK(fuzzy([](Fuzzy* f) { f->AreaWeightingOn(); }));

  using Curvature = vtkCurvatureNormalDiffusionFilter;
  TestCommonSettings<Curvature>(failures);
  Changes<Curvature> curvature;
  CHECK(curvature([](Curvature* f) { f->SetRangeScale(0.51); }));
  CHECK(curvature([](Curvature* f) { f->SetRangeScale(0.0); }));
  CHECK(curvature([](Curvature* f) { f->SetStepLength(0.4); }));
  CHECK(curvature([](Curvature* f) { f->SetStepLength(0.0); }));
}

void TestLateMethods(int& failures)
{
  using Tensor = vtkNormalVotingTensorFilter;
  TestCommonSettings<Tensor>(failures);
  Changes<Tensor> tensor;
  CHECK(tensor([](Tensor* f) { f->SetRangeScale(40.0); }));
  CHECK(tensor([](Tensor* f) { f->SetRangeScale(0.0); }));
  CHECK(tensor([](Tensor* f) { f->SetRadius(3.0); }));
  CHECK(tensor([](Tensor* f) { f->SetTensorThreshold(0.1); }));
  CHECK(tensor([](Tensor* f) { f->SetDamping(1.0); }));
  CHECK(tensor([](Tensor* f) { f->RotateVotesOn(); }));

  using Guided = vtkGuidedNormalFilter;
  TestCommonSettings<Guided>(failures);
  Changes<Guided> guided;
  CHECK(guided([](Guided* f) { f->SetRangeScale(0.36); }));
  CHECK(guided([](Guided* f) { f->SetRangeScale(0.0); }));
  CHECK(guided([](Guided* f) { f->SetSpatialScale(2.0); }));
  CHECK(guided([](Guided* f) { f->SetSpatialScale(-1.0); }));
  CHECK(guided([](Guided* f) { f->SetRadius(3.0); }));

  using Fidelity = vtkGeometricFidelityNormalFilter;
  TestCommonSettings<Fidelity>(failures, [](Fidelity* f) { f->SetRangeScale(10.0); });
  for (const int type : { Fidelity::FACE, Fidelity::EDGE })
  {
    Changes<Fidelity> fidelity([type](Fidelity* f) { f->SetCurvatureType(type); });
    CHECK(fidelity([type](Fidelity* f) { f->SetCurvatureType(1 - type); }));
    CHECK(fidelity([](Fidelity* f) { f->SetRangeScale(0.11); }));
    CHECK(fidelity([](Fidelity* f) { f->SetRangeScale(0.0); }));
    CHECK(fidelity([](Fidelity* f) { f->SetStepLength(0.4); }));
    CHECK(fidelity([](Fidelity* f) { f->SetFidelityWeight(0.1); }));
  }

  using Tukey = vtkTukeyBilateralNormalFilter;
  TestCommonSettings<Tukey>(failures);
  Changes<Tukey> tukey;
  CHECK(tukey([](Tukey* f) { f->SetRangeScale(0.4); }));
  CHECK(tukey([](Tukey* f) { f->SetRangeScale(0.0); }));
  CHECK(tukey([](Tukey* f) { f->SetSpatialScale(2.0); }));
  CHECK(tukey([](Tukey* f) { f->SetSpatialScale(-1.0); }));
  CHECK(tukey([](Tukey* f) { f->SetRadius(3.0); }));
  CHECK(tukey([](Tukey* f) { f->AsReleasedOn(); }));
  Changes<Tukey> released([](Tukey* f) { f->AsReleasedOn(); });
  CHECK(released([](Tukey* f) { f->SetRangeScale(0.4); }));
  CHECK(released([](Tukey* f) { f->SetRelaxation(0.1); }));
  CHECK(released([](Tukey* f) { f->SetNumberOfOuterIterations(5); }));
  // Of the others, its documentation says so.
  CHECK(!released([](Tukey* f) { f->SetSpatialScale(2.0); }));
  CHECK(!released([](Tukey* f) { f->SetRadius(3.0); }));
  CHECK(!released([](Tukey* f) { f->SetBoundaryHandlingToFree(); }));
}

void TestVertexUpdate(int& failures)
{
  auto surface = Roof(16);
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("FilteredNormals");
  normals->SetNumberOfComponents(3);
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    normals->InsertNextTuple3(0.3, 0.2 * Wobble(cell), 1.0);
  }
  surface->GetCellData()->AddArray(normals);
  vtkNew<vtkDoubleArray> others;
  others->DeepCopy(normals);
  others->SetName("Others");
  others->FillComponent(0, -0.3);
  surface->GetCellData()->AddArray(others);
  using Filter = vtkNormalVertexUpdate;
  Changes<Filter> changes(nullptr, surface);
  TestVertexSettings(changes, failures);
  CHECK(changes([](Filter* f)
    { f->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Others"); }));
}

void TestPrint(int& failures)
{
  std::ostringstream text;
  for (const MeshFilter& filter : AllMeshFilters())
  {
    filter.MakeDefault()->Print(text);
  }
  vtkNew<vtkNormalVertexUpdate> update;
  update->Print(text);
  for (const char* name : { "Norm: Gaussian", "RangeScale: 0.35", "PreventFlips: 1",
         "Preset: Guided Normal", "TimeStep: 0.2", "FixBoundary: 1" })
  {
    CHECK(text.str().find(name) != std::string::npos);
  }
}

}

int TestMeshSetters(int, char*[])
{
  int failures = 0;
  TestBilateral(failures);
  TestMeansAndMedians(failures);
  TestEarlyMethods(failures);
  TestLateMethods(failures);
  TestVertexUpdate(failures);
  TestPrint(failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
