// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "AllPointFilters.h"

#include "vtkGuidedPointNormalFilter.h"
#include "vtkNormalPointUpdate.h"
#include "vtkPointDenoisingMethods.h"
#include "vtkRobustImplicitMLSFilter.h"
#include "vtkRobustPointNormalFilter.h"
#include "vtkRollingPointNormalFilter.h"
#include "vtkVotingTensorPointFilter.h"

#include <algorithm>
#include <set>

namespace PointTest
{

namespace
{

using Methods = vtkPointDenoisingMethods;
using Robust = vtkRobustPointNormalFilter;
using Voting = vtkVotingTensorPointFilter;

unsigned TraitsOf(const std::string& method)
{
  static const std::set<std::string> classes = { "Guided Point Normal", "Tensor Point",
    "Voting Tensor Point" };
  static const std::set<std::string> unsignedOnes = { "Moving Robust PCA", "Feature Aware Point",
    "Tensor Point", "Bilateral Point", "Moving Least Squares" };
  static const std::set<std::string> positional = { "Bilateral Point", "Moving Least Squares" };
  return (classes.count(method) ? TELLS_CLASSES : 0u) |
    (unsignedOnes.count(method) ? IGNORES_SIGNS : 0u) |
    (positional.count(method) ? IGNORES_NORMALS : 0u) |
    (method == "Tensor Point" ? MAKES_FACETS : 0u);
}

template <typename Filter>
PointFilter Entry(const std::string& name, unsigned traits, std::function<void(Filter*)> set)
{
  auto make = [set]
  {
    auto filter = vtkSmartPointer<Filter>::New();
    set(filter);
    return filter;
  };
  return { name, "", make, traits };
}

std::vector<PointFilter> MakeList()
{
  std::vector<PointFilter> all;
  for (int i = 0; i < Methods::GetNumberOfMethods(); ++i)
  {
    const std::string name = Methods::GetName(i);
    auto make = [i]
    { return vtkSmartPointer<vtkPointDenoisingFilter>::Take(Methods::NewFilter(i)); };
    all.push_back({ name, name, make, TraitsOf(name) });
  }
  for (int preset = Robust::CUSTOM + 1; preset < Robust::GetNumberOfPresets(); ++preset)
  {
    const std::string name = Robust::GetPresetName(preset);
    all.push_back(Entry<Robust>("Preset " + name, OWN_SETTINGS | TraitsOf(name),
      [preset](Robust* f) { f->SetPreset(preset); }));
  }
  all.push_back(Entry<Robust>("Robust", 0, [](Robust*) {}));
  all.push_back(Entry<Robust>("Robust by Data", NEEDS_NOISE,
    [](Robust* f)
    {
      f->SetScaleSourceToDataMAD();
      f->SetNormToHuber();
      f->SetArgumentToAngle();
    }));
  all.push_back(Entry<Robust>("Robust Tensor with Patches", 0,
    [](Robust* f)
    {
      f->SetOperatorToVotingTensor();
      f->SetGuidanceToPatch();
      f->SetPositionSchemeToQuadricFit();
    }));
  all.push_back(Entry<Robust>("Robust Diffusion with Medians", 0,
    [](Robust* f)
    {
      f->SetOperatorToDiffusion();
      f->SetGuidanceToVectorMedian();
      f->SetDataSourceToOriginal();
      f->SetNeighborhoodToBall();
      f->SetPositionSchemeToBalancedHeight();
      f->LocalScaleOn();
      f->DensityWeightsOn();
    }));
  all.push_back(Entry<Robust>("Robust Planes", 0,
    [](Robust* f)
    {
      f->SetOperatorToPlaneNormal();
      f->SetPositionSchemeToNeighborHeight();
    }));
  all.push_back(Entry<Voting>("Voting Tensor as Released", TELLS_CLASSES | AS_RELEASED,
    [](Voting* f) { f->AsReleasedOn(); }));
  // Any normals will do in most tests.
  all.push_back(Entry<vtkNormalPointUpdate>("Normal Point Update", 0,
    [](vtkNormalPointUpdate* f) { f->SetNormalSourceToAutomatic(); }));
  return all;
}

}

vtkSmartPointer<vtkPointDenoisingFilter> PointFilter::Make() const
{
  vtkSmartPointer<vtkPointDenoisingFilter> filter = this->MakeDefault();
  LimitIterations(filter, 3);
  return filter;
}

const std::vector<PointFilter>& AllPointFilters()
{
  static const std::vector<PointFilter> all = MakeList();
  return all;
}

void LimitIterations(vtkPointDenoisingFilter* filter, int limit)
{
  filter->SetNumberOfOuterIterations(std::min(limit, filter->GetNumberOfOuterIterations()));
  if (auto* fitting = vtkPointFittingFilter::SafeDownCast(filter))
  {
    fitting->SetNumberOfPointIterations(std::min(limit, fitting->GetNumberOfPointIterations()));
  }
  if (auto* robust = Robust::SafeDownCast(filter))
  {
    robust->SetNumberOfNormalIterations(std::min(limit, robust->GetNumberOfNormalIterations()));
  }
  else if (auto* guided = vtkGuidedPointNormalFilter::SafeDownCast(filter))
  {
    guided->SetNumberOfNormalIterations(std::min(limit, guided->GetNumberOfNormalIterations()));
    guided->SetNumberOfPointIterations(std::min(limit, guided->GetNumberOfPointIterations()));
  }
  else if (auto* rolling = vtkRollingPointNormalFilter::SafeDownCast(filter))
  {
    rolling->SetNumberOfRolls(std::min(limit, rolling->GetNumberOfRolls()));
    rolling->SetNumberOfPointIterations(std::min(limit, rolling->GetNumberOfPointIterations()));
  }
}

void IgnoreSigns(vtkPointDenoisingFilter* filter)
{
  if (auto* fitting = vtkPointFittingFilter::SafeDownCast(filter))
  {
    fitting->UnorientedNormalsOn();
  }
  else if (auto* implicit = vtkRobustImplicitMLSFilter::SafeDownCast(filter))
  {
    implicit->UnorientedNormalsOn();
  }
  else if (auto* guided = vtkGuidedPointNormalFilter::SafeDownCast(filter))
  {
    guided->UnorientedNormalsOn();
  }
  else if (auto* rolling = vtkRollingPointNormalFilter::SafeDownCast(filter))
  {
    rolling->UnorientedNormalsOn();
  }
  else if (auto* voting = Voting::SafeDownCast(filter))
  {
    voting->UnorientedNormalsOn();
  }
}

}
