// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TunedClouds.h"

#include "Points/PointMethods.h"

#include <initializer_list>

using namespace SurfaceDenoising;

namespace
{

class Sweep
{
public:
  /// Values are what the name shows, in the order of the settings that are varied.
  void Add(const std::string& name, std::initializer_list<double> values,
    PointDenoisingSettings settings)
  {
    TunedCloud tuned;
    tuned.Name = name;
    for (const double value : values)
    {
      char text[32];
      std::snprintf(text, sizeof(text), "%s%.3g", tuned.Name == name ? " " : "/", value);
      tuned.Name += text;
    }
    settings.Normals.Source = NormalSource::RobustFit;
    tuned.Settings = settings;
    this->All.push_back(tuned);
  }

  std::vector<TunedCloud> All;
};

/// For the normals to start with.
const std::initializer_list<int> FewAndMany = { 16, 24, 48, 96 };

void AddComposed(Sweep& sweep)
{
  for (const int forNormals : FewAndMany)
  {
    for (const double range : { 0.2, 0.35, 0.5, 1.0 })
    {
      for (const auto& [normalSteps, pointSteps] : { std::pair(1, 2), { 3, 5 }, { 10, 10 } })
      {
        for (const double spatial : { 1.5, 3.0 })
        {
          PointDenoisingSettings settings = ComposedPoints();
          settings.Normals.NumberOfNeighbors = forNormals;
          settings.Neighborhood.Count = spatial > 2.0 ? 40 : 16;
          auto& stages = std::get<TwoStageSettings>(settings.Operator);
          stages.Normals.NormScale = stages.Points.NormScale = range;
          stages.Normals.SpatialScale = stages.Points.SpatialScale = spatial;
          stages.NormalIterations = normalSteps;
          stages.PointIterations = pointSteps;
          sweep.Add("Robust Point Normal",
            { double(forNormals), range, double(normalSteps), spatial }, settings);
        }
      }
    }
  }
}

void AddProjections(Sweep& sweep)
{
  for (const int count : { 8, 16, 30, 60, 100, 200 })
  {
    PointDenoisingSettings settings = SettingsOf(PointMethod::MovingLeastSquares);
    settings.Neighborhood.Count = count;
    sweep.Add("Moving Least Squares", { double(count) }, settings);
  }
  for (const int forNormals : FewAndMany)
  {
    for (const double filter : { 3.0, 5.0, 8.0 })
    {
      for (const double scale : { 0.3, 0.75 })
      {
        PointDenoisingSettings settings = SettingsOf(PointMethod::RobustImplicitMLS);
        settings.Normals.NumberOfNeighbors = forNormals;
        auto& surface = std::get<RobustImplicitMLSSettings>(settings.Operator);
        surface.FilterScale = filter;
        surface.NormalScale = scale;
        sweep.Add("Robust Implicit MLS", { double(forNormals), filter, scale }, settings);
      }
    }
    for (const int count : { 16, 30, 60 })
    {
      for (const int iterations : { 1, 3, 5 })
      {
        PointDenoisingSettings settings = SettingsOf(PointMethod::MovingRobustPCA);
        settings.Normals.NumberOfNeighbors = forNormals;
        settings.Neighborhood.Count = count;
        settings.OuterIterations = iterations;
        sweep.Add("Moving Robust PCA", { double(forNormals), double(count), double(iterations) },
          settings);
      }
    }
  }
}

void AddGuided(Sweep& sweep)
{
  for (const int forNormals : FewAndMany)
  {
    for (const double range : { 0.2, 0.35, 0.5 })
    {
      for (const auto& [normalSteps, pointSteps] : { std::pair(1, 3), { 5, 10 } })
      {
        PointDenoisingSettings settings = SettingsOf(PointMethod::GuidedPointNormal);
        settings.Normals.NumberOfNeighbors = forNormals;
        auto& bundles = std::get<NormalBundlesSettings>(settings.Operator);
        bundles.RangeScale = range;
        bundles.NormalIterations = normalSteps;
        bundles.PointIterations = pointSteps;
        sweep.Add("Guided Point Normal", { double(forNormals), range, double(normalSteps) },
          settings);
      }
    }
    for (const int rolls : { 2, 4, 6 })
    {
      PointDenoisingSettings settings = SettingsOf(PointMethod::RollingPointNormal);
      settings.Normals.NumberOfNeighbors = forNormals;
      std::get<TwoStageSettings>(settings.Operator).NormalIterations = rolls;
      sweep.Add("Rolling Point Normal", { double(forNormals), double(rolls) }, settings);
    }
  }
}

void AddTensors(Sweep& sweep)
{
  for (const int forNormals : FewAndMany)
  {
    for (const int iterations : { 3, 8 })
    {
      for (const PointMethod method : { PointMethod::VotingTensorPoint, PointMethod::TensorPoint,
             PointMethod::FeatureAwarePoint })
      {
        PointDenoisingSettings settings = SettingsOf(method);
        settings.Normals.NumberOfNeighbors = forNormals;
        settings.OuterIterations = iterations;
        sweep.Add(PointMethods()[static_cast<std::size_t>(method)].Name,
          { double(forNormals), double(iterations) }, settings);
      }
    }
  }
}

}

std::vector<TunedCloud> TunedClouds()
{
  Sweep sweep;
  AddComposed(sweep);
  AddProjections(sweep);
  AddGuided(sweep);
  AddTensors(sweep);
  return sweep.All;
}
