// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Every setting of every filter changes the result: none is accepted and then ignored.

#include "MeshTestTools.h"

#include "vtkBilateralNormalFilter.h"
#include "vtkNormalVertexUpdate.h"
#include "vtkRobustNormalFilter.h"

#include <cstdlib>
#include <functional>
#include <sstream>

namespace
{

using MeshTest::PointDistance;

/// An open surface with noise and edges, so that borders and scales matter.
vtkSmartPointer<vtkPolyData> Roof()
{
  auto grid = MeshTest::QuadGrid(24, 0.25);
  vtkPoints* points = grid->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    p[0] += 0.15 * MeshTest::Wobble(7 * i);
    p[1] += 0.15 * MeshTest::Wobble(9 * i);
    p[2] += 3.0 - 0.8 * std::abs(p[1] - 12.0);
    points->SetPoint(i, p);
  }
  return grid;
}

template <typename Filter>
class Changes
{
public:
  explicit Changes(std::function<void(Filter*)> prepare = nullptr)
    : Prepare(prepare)
  {
    this->Expected->DeepCopy(this->Run(nullptr));
  }

  /// True if the setting makes a difference to the points.
  bool operator()(std::function<void(Filter*)> set)
  {
    return PointDistance(this->Expected, this->Run(set)) > 1e-9;
  }

private:
  vtkSmartPointer<vtkPolyData> Run(std::function<void(Filter*)> set)
  {
    vtkNew<Filter> filter;
    if (this->Prepare)
    {
      this->Prepare(filter);
    }
    const vtkMTimeType before = filter->GetMTime();
    if (set)
    {
      set(filter);
    }
    filter->SetInputData(this->Surface);
    filter->Update();
    return set && filter->GetMTime() == before ? this->Expected.Get() : filter->GetOutput();
  }

  vtkSmartPointer<vtkPolyData> Surface = Roof();
  std::function<void(Filter*)> Prepare;
  vtkNew<vtkPolyData> Expected;
};

template <typename Filter>
void TestVertexSettings(Changes<Filter>& changes, int& failures)
{
  CHECK(changes([](Filter* f) { f->SetNumberOfVertexIterations(9); }));
  CHECK(changes([](Filter* f) { f->SetNumberOfVertexIterations(0); }));
  CHECK(changes([](Filter* f) { f->SetVertexSchemeToConstantStep(); }));
  CHECK(changes([](Filter* f) { f->SetVertexSchemeToAreaWeighted(); }));
  CHECK(changes([](Filter* f) { f->SetVertexSchemeToIntegralFit(); }));
  CHECK(changes([](Filter* f) { f->SetBoundaryHandlingToSlide(); }));
  CHECK(changes([](Filter* f) { f->SetBoundaryHandlingToFree(); }));
  CHECK(changes([](Filter* f) { f->SetMaximumDisplacement(0.05); }));
}

void TestBilateral(int& failures)
{
  using Filter = vtkBilateralNormalFilter;
  Changes<Filter> changes;
  CHECK(!changes([](Filter* f) { f->SetRangeScale(0.35); }));
  CHECK(changes([](Filter* f) { f->SetRangeScale(0.36); }));
  CHECK(changes([](Filter* f) { f->SetRangeScale(0.0); }));
  CHECK(changes([](Filter* f) { f->SetSpatialScale(2.0); }));
  CHECK(changes([](Filter* f) { f->SetSpatialScale(0.0); }));
  CHECK(changes([](Filter* f) { f->SetNeighborhoodToEdgeAdjacent(); }));
  CHECK(changes([](Filter* f) { f->SetNumberOfNormalIterations(19); }));
  CHECK(changes([](Filter* f) { f->UpdateVerticesOff(); }));
  TestVertexSettings(changes, failures);
}

void TestRobust(int& failures)
{
  using Filter = vtkRobustNormalFilter;
  Changes<Filter> changes;
  for (int norm = 0; norm < Filter::GetNumberOfNorms(); ++norm)
  {
    CHECK(norm == Filter::GAUSSIAN || changes([norm](Filter* f) { f->SetNorm(norm); }));
  }
  CHECK(Filter::GetNormName(-1) == nullptr && Filter::GetNormName(Filter::CENTIN + 1) == nullptr);
  CHECK(std::string(Filter::GetNormName(Filter::TUKEY)) == "Tukey");
  CHECK(changes([](Filter* f) { f->SetArgumentToAngle(); }));
  CHECK(changes([](Filter* f) { f->SetArgumentToDirectionalCurvature(); }));
  CHECK(changes([](Filter* f) { f->SetScaleSourceToGiven(); }));
  CHECK(changes([](Filter* f) { f->SetScaleSourceToDataRayleigh(); }));
  CHECK(changes([](Filter* f) { f->SetScaleSourceToDataHalfNormal(); }));
  CHECK(changes([](Filter* f) { f->SetSpatialScale(2.0); }));
  CHECK(changes([](Filter* f) { f->SetFaceWeightingToUniform(); }));
  CHECK(changes([](Filter* f) { f->IncludeOwnOff(); }));
  CHECK(changes([](Filter* f) { f->SetNeighborhoodToEdgeAdjacent(); }));
  CHECK(changes([](Filter* f) { f->SetNeighborhoodToRadius(); }));
  CHECK(changes([](Filter* f) { f->SetDataSourceToOriginal(); }));
  CHECK(changes([](Filter* f) { f->SetNumberOfOuterIterations(10); }));
  TestVertexSettings(changes, failures);

  Changes<Filter> given([](Filter* f) { f->SetScaleSourceToGiven(); });
  CHECK(given([](Filter* f) { f->SetRangeScale(0.3); }));
  Changes<Filter> radius([](Filter* f) { f->SetNeighborhoodToRadius(); });
  CHECK(radius([](Filter* f) { f->SetRadius(3.0); }));
  Changes<Filter> alternating([](Filter* f) { f->SetNumberOfOuterIterations(10); });
  CHECK(alternating([](Filter* f) { f->SetNumberOfOuterIterations(9); }));

  // 20 degrees are 20 degrees, as an angle or as a chord, for a norm that only asks for more or
  // less.
  const double degrees = 40.0;
  Changes<Filter> chord(
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

void TestBadSettings(int& failures)
{
  vtkNew<vtkRobustNormalFilter> filter;
  vtkNew<MeshTest::Messages> seen;
  seen->Watch(filter);
  filter->SetScaleSourceToGiven();
  auto surface = Roof();
  for (const double scale : { 0.0, -1.0, vtkMath::Nan() })
  {
    filter->SetRangeScale(scale);
    MeshTest::Run(filter, surface, seen);
    CHECK(seen->Errors.find("must be positive") != std::string::npos);
  }

  // Without noise there is no scale to take from it.
  filter->SetScaleSourceToDataMAD();
  auto flat = MeshTest::QuadGrid(6, 0.0);
  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
  {
    flat->GetPoints()->SetPoint(i, static_cast<double>(i % 7), static_cast<double>(i / 7), 0.0);
  }
  vtkPolyData* output = MeshTest::Run(filter, flat, seen);
  CHECK(seen->Errors.empty() && seen->Warnings.find("no noise") != std::string::npos);
  CHECK(PointDistance(flat, output) == 0.0);
}

void TestPrint(int& failures)
{
  std::ostringstream text;
  vtkNew<vtkRobustNormalFilter> robust;
  robust->Print(text);
  vtkNew<vtkBilateralNormalFilter> bilateral;
  bilateral->Print(text);
  vtkNew<vtkNormalVertexUpdate> update;
  update->Print(text);
  for (const char* name : { "Norm: Gaussian", "RangeScale: 0.35", "PreventFlips: 1" })
  {
    CHECK(text.str().find(name) != std::string::npos);
  }
}

}

int TestMeshSetters(int, char*[])
{
  int failures = 0;
  TestBilateral(failures);
  TestRobust(failures);
  TestBadSettings(failures);
  TestPrint(failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
