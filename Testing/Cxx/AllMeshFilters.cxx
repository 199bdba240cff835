// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "AllMeshFilters.h"

#include "vtkAnisotropicMeanCurvatureFilter.h"
#include "vtkBilateralNormalFilter.h"
#include "vtkBilateralVertexFilter.h"
#include "vtkCurvatureNormalDiffusionFilter.h"
#include "vtkFuzzyVectorMedianNormalFilter.h"
#include "vtkGeometricFidelityNormalFilter.h"
#include "vtkGuidedNormalFilter.h"
#include "vtkHuberNormalFilter.h"
#include "vtkMeanCurvatureFlowFilter.h"
#include "vtkMeanNormalFilter.h"
#include "vtkMedianNormalFilter.h"
#include "vtkNonIterativeBilateralFilter.h"
#include "vtkNormalDiffusionFilter.h"
#include "vtkNormalVotingTensorFilter.h"
#include "vtkRobustNormalFilter.h"
#include "vtkTukeyBilateralNormalFilter.h"

#include <algorithm>

namespace MeshTest
{

namespace
{

template <typename Filter>
MeshFilter Entry(const std::string& name, const std::string& method, unsigned exceptions = 0,
  std::function<void(Filter*)> set = nullptr)
{
  auto make = [set]
  {
    auto filter = vtkSmartPointer<Filter>::New();
    if (set)
    {
      set(filter);
    }
    return filter;
  };
  return { name, method, make, exceptions };
}

/// The filter of a method as it is, which has the method's name.
template <typename Filter>
MeshFilter Entry(const std::string& method, unsigned exceptions = 0)
{
  return Entry<Filter>(method, method, exceptions);
}

std::vector<MeshFilter> MakeList()
{
  using Bilateral = vtkBilateralNormalFilter;
  using Median = vtkMedianNormalFilter;
  using Fidelity = vtkGeometricFidelityNormalFilter;
  using Tukey = vtkTukeyBilateralNormalFilter;
  using Robust = vtkRobustNormalFilter;
  using Flow = vtkMeanCurvatureFlowFilter;
  using Anisotropic = vtkAnisotropicMeanCurvatureFilter;
  std::vector<MeshFilter> all = {
    Entry<vtkNormalDiffusionFilter>("Normal Diffusion"),
    Entry<vtkMeanNormalFilter>("Mean Normal"),
    Entry<Median>("Median Normal"),
    Entry<Median>("Weighted Median Normal", "Weighted Median Normal", 0,
      [](Median* f) { f->SetMedianTypeToWeighted(); }),
    Entry<Median>("Directional Median", "", 0, [](Median* f) { f->SetMedianTypeToDirectional(); }),
    Entry<Median>("Geometric Median", "", 0,
      [](Median* f)
      {
        f->SetMedianTypeToGeometric();
        f->SetNumberOfNormalIterations(30);
      }),
    Entry<vtkHuberNormalFilter>("Huber Normal"),
    Entry<vtkNormalVotingTensorFilter>("Normal Voting Tensor"),
    Entry<vtkFuzzyVectorMedianNormalFilter>("Fuzzy Vector Median"),
    Entry<vtkCurvatureNormalDiffusionFilter>("Curvature Normal Diffusion"),
    Entry<Fidelity>("Geometric Fidelity"),
    Entry<Fidelity>("Geometric Fidelity by Edges", "", 0,
      [](Fidelity* f) { f->SetCurvatureTypeToEdge(); }),
    Entry<Bilateral>("Bilateral Normal"),
    Entry<Bilateral>("Global Bilateral Normal", "Global Bilateral Normal", 0,
      [](Bilateral* f) { f->SetSchemeToGlobal(); }),
    Entry<vtkGuidedNormalFilter>("Guided Normal"),
    Entry<Tukey>("Tukey Bilateral Normal"),
    Entry<Tukey>("Tukey as Released", "", AS_RELEASED, [](Tukey* f) { f->AsReleasedOn(); }),
    Entry<Robust>("Robust", "", NEEDS_NOISE),
    Entry<Flow>("Mean Curvature Flow"),
    Entry<Flow>("Mean Curvature Flow with Volume", "", WHOLE_VOLUME,
      [](Flow* f) { f->RestoreVolumeOn(); }),
    Entry<Anisotropic>("Anisotropic Mean Curvature"),
    Entry<Anisotropic>("Prescribed Mean Curvature", "", 0,
      [](Anisotropic* f) { f->PrescribeCurvatureOn(); }),
    Entry<vtkBilateralVertexFilter>("Bilateral Vertex"),
    Entry<vtkNonIterativeBilateralFilter>("Non Iterative Bilateral", ONE_PASS),
  };
  for (int preset = Robust::CUSTOM + 1; preset < Robust::GetNumberOfPresets(); ++preset)
  {
    const std::string name = Robust::GetPresetName(preset);
    const bool only = preset == Robust::THRESHOLDED_COSINE; // has no class of its own
    all.push_back(Entry<Robust>("Preset " + name, only ? name : "", OWN_ITERATIONS,
      [preset](Robust* f) { f->SetPreset(preset); }));
  }
  return all;
}

}

vtkSmartPointer<vtkMeshDenoisingFilter> MeshFilter::Make() const
{
  vtkSmartPointer<vtkMeshDenoisingFilter> filter = this->MakeDefault();
  LimitIterations(filter, 4);
  return filter;
}

bool MeshFilter::IsTwoStage() const
{
  return vtkFaceNormalFilter::SafeDownCast(this->MakeDefault()) != nullptr;
}

const std::vector<MeshFilter>& AllMeshFilters()
{
  static const std::vector<MeshFilter> all = MakeList();
  return all;
}

void LimitIterations(vtkMeshDenoisingFilter* filter, int limit)
{
  if (auto* normals = vtkFaceNormalFilter::SafeDownCast(filter))
  {
    normals->SetNumberOfOuterIterations(std::min(limit, normals->GetNumberOfOuterIterations()));
    normals->SetNumberOfNormalIterations(std::min(limit, normals->GetNumberOfNormalIterations()));
    normals->SetNumberOfVertexIterations(std::min(limit, normals->GetNumberOfVertexIterations()));
  }
  else if (auto* flow = vtkMeanCurvatureFlowFilter::SafeDownCast(filter))
  {
    flow->SetNumberOfIterations(std::min(limit, flow->GetNumberOfIterations()));
  }
  else if (auto* anisotropic = vtkAnisotropicMeanCurvatureFilter::SafeDownCast(filter))
  {
    anisotropic->SetNumberOfIterations(std::min(limit, anisotropic->GetNumberOfIterations()));
  }
  else if (auto* vertices = vtkBilateralVertexFilter::SafeDownCast(filter))
  {
    vertices->SetNumberOfIterations(std::min(limit, vertices->GetNumberOfIterations()));
  }
}

}
