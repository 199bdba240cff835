// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TunedChains.h"

#include "Methods.h"

#include <cmath>
#include <cstdio>

using namespace SurfaceDenoising;

namespace
{

struct Tuned
{
  Method Id;
  MeshDenoisingSettings Settings;
};

Tuned With(Method method, double scale, int outer, int normal, int vertex)
{
  Tuned tuned{ method, SettingsOf(method) };
  tuned.Settings.NormScale = scale;
  tuned.Settings.OuterIterations = outer;
  tuned.Settings.NormalIterations = normal;
  tuned.Settings.VertexIterations = vertex;
  return tuned;
}

Tuned Diffusion(double degrees, int outer, FaceNeighborhood neighborhood)
{
  const double radians = degrees * (3.14159265358979323846 / 180.0);
  Tuned tuned = With(Method::NormalDiffusion, radians / std::sqrt(2.0), outer, 1, 10);
  tuned.Settings.Neighborhood = neighborhood;
  return tuned;
}

Tuned Tukey(double scale, int outer, double relaxation)
{
  Tuned tuned = With(Method::TukeyBilateralNormal, scale, outer, 1, 1);
  tuned.Settings.Vertices.Relaxation = relaxation;
  return tuned;
}

Tuned Global(double scale, double fidelity)
{
  Tuned tuned = With(Method::GlobalBilateralNormal, scale, 1, 1, 10);
  tuned.Settings.Global.Fidelity = fidelity;
  return tuned;
}

}

std::vector<TunedChain> TunedChains()
{
  const FaceNeighborhood edges = FaceNeighborhood::EdgeAdjacent;
  const FaceNeighborhood vertices = FaceNeighborhood::VertexSharing;
  std::vector<std::vector<Tuned>> chains;
  const double scales[] = { 0.2, 0.35, 0.5, 1.0 };
  for (const double scale : scales)
  {
    for (const int iterations : { 3, 5, 10, 20 })
    {
      chains.push_back({ With(Method::BilateralNormal, scale, 1, iterations, 10) });
    }
  }
  for (const int outer : { 1, 2, 3, 5, 8, 15 })
  {
    chains.push_back({ Diffusion(90.0, outer, vertices) });
    chains.push_back({ Diffusion(40.0, outer, vertices) });
  }
  chains.push_back({ Diffusion(40.0, 40, edges) });
  const Tuned narrow = With(Method::ThresholdedCosine, 0.2, 1, 20, 50);
  for (const double scale : { 0.35, 0.5, 1.0 })
  {
    for (const int outer : { 10, 15, 30, 60 })
    {
      for (const double relaxation : { 0.05, 0.2 })
      {
        chains.push_back({ Tukey(scale, outer, relaxation) });
        chains.push_back({ Tukey(scale, outer, relaxation), narrow });
      }
    }
  }
  chains.push_back({ With(Method::ThresholdedCosine, 1.0, 1, 15, 12) });
  chains.push_back({ With(Method::ThresholdedCosine, 1.3, 1, 4, 5) });
  chains.push_back({ With(Method::ThresholdedCosine, 0.6, 1, 10, 10) });
  chains.push_back({ With(Method::FuzzyVectorMedian, 0.18, 20, 1, 5) });
  chains.push_back({ With(Method::FuzzyVectorMedian, 0.8, 2, 1, 10) });
  chains.push_back({ With(Method::CurvatureNormalDiffusion, 0.42, 15, 10, 20) });
  chains.push_back({ With(Method::CurvatureNormalDiffusion, 0.7, 3, 25, 20) });
  chains.push_back({ With(Method::GuidedNormal, 0.2, 50, 1, 10) });
  chains.push_back({ With(Method::GuidedNormal, 0.6, 6, 1, 3) });
  chains.push_back({ Global(0.35, 0.0003) });
  chains.push_back({ Global(1.0, 0.03) });
  chains.push_back({ With(Method::MeanNormal, 1.0, 2, 1, 1) });
  chains.push_back({ With(Method::MeanNormal, 1.0, 5, 1, 1) });

  std::vector<TunedChain> named;
  for (const std::vector<Tuned>& chain : chains)
  {
    TunedChain entry;
    for (const Tuned& tuned : chain)
    {
      char text[96];
      std::snprintf(text, sizeof(text), "%s%s %.2g/%d/%d", entry.Name.empty() ? "" : ", ",
        Methods()[static_cast<std::size_t>(tuned.Id)].Name, tuned.Settings.NormScale,
        tuned.Settings.OuterIterations, tuned.Settings.NormalIterations);
      entry.Name += text;
      entry.Steps.push_back(tuned.Settings);
    }
    named.push_back(entry);
  }
  return named;
}
