// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CandidateChains.h"

#include <cmath>

namespace SurfaceDenoising
{

namespace
{

/// A method with the settings of the table but for these.
struct Part
{
  Method Id;
  MeshDenoisingSettings Settings;
};

Part Bilateral(double scale, int normal, int vertex)
{
  Part part{ Method::BilateralNormal, SettingsOf(Method::BilateralNormal) };
  part.Settings.NormScale = scale;
  part.Settings.NormalIterations = normal;
  part.Settings.VertexIterations = vertex;
  return part;
}

Part Diffusion(double degrees, int outer)
{
  Part part{ Method::NormalDiffusion, SettingsOf(Method::NormalDiffusion) };
  part.Settings.Neighborhood = FaceNeighborhood::VertexSharing;
  part.Settings.NormScale = degrees * (3.14159265358979323846 / 180.0) / std::sqrt(2.0);
  part.Settings.OuterIterations = outer;
  part.Settings.VertexIterations = 10;
  return part;
}

Part Mean(int outer)
{
  Part part{ Method::MeanNormal, SettingsOf(Method::MeanNormal) };
  part.Settings.OuterIterations = outer;
  return part;
}

/// Edges stay where the surface bends along them alone.
Part CurvatureDiffusion()
{
  Part part{ Method::CurvatureNormalDiffusion, SettingsOf(Method::CurvatureNormalDiffusion) };
  part.Settings.NormScale = 1.0 / std::sqrt(2.0);
  part.Settings.OuterIterations = 3;
  return part;
}

/// A wide scale, which sorts faces into sides.
Part Wide(int outer, double relaxation)
{
  Part part{ Method::TukeyBilateralNormal, SettingsOf(Method::TukeyBilateralNormal) };
  part.Settings.NormScale = 1.0;
  part.Settings.OuterIterations = outer;
  part.Settings.Vertices.Relaxation = relaxation;
  return part;
}

/// A narrow scale, which flattens each side.
Part Narrow()
{
  Part part{ Method::ThresholdedCosine, SettingsOf(Method::ThresholdedCosine) };
  part.Settings.NormScale = 0.2;
  return part;
}

CandidateChain Chain(SurfaceType type, const char* purpose, const std::vector<Part>& parts,
  bool unfolds = false)
{
  CandidateChain chain;
  chain.Type = type;
  chain.Purpose = purpose;
  chain.Unfolds = unfolds;
  for (const Part& part : parts)
  {
    chain.Methods.push_back(part.Id);
    chain.Steps.push_back(part.Settings);
  }
  return chain;
}

}

const std::vector<CandidateChain>& CandidateChains()
{
  static const char* const fine = "fine detail under weak noise";
  static const char* const organic = "curved surface";
  static const char* const sides = "flat sides with sharp edges";
  static const char* const folded = "flat sides with sharp edges, folded by strong noise";
  static const std::vector<CandidateChain> chains = {
    Chain(SurfaceType::Curved, fine, { Bilateral(0.2, 5, 10) }),
    Chain(SurfaceType::Curved, fine, { Bilateral(0.35, 5, 10) }),
    Chain(SurfaceType::Curved, organic, { Bilateral(0.5, 4, 7) }),
    Chain(SurfaceType::Curved, organic, { Mean(2) }),
    Chain(SurfaceType::Curved, organic, { Mean(5) }),
    Chain(SurfaceType::Curved, organic, { CurvatureDiffusion() }),
    Chain(SurfaceType::Curved, organic, { Diffusion(90.0, 1) }),
    Chain(SurfaceType::Curved, organic, { Diffusion(90.0, 2) }),
    Chain(SurfaceType::Curved, organic, { Diffusion(90.0, 3) }),
    Chain(SurfaceType::Curved, organic, { Diffusion(90.0, 5) }),
    Chain(SurfaceType::Curved, organic, { Diffusion(90.0, 8) }),
    Chain(SurfaceType::Curved, organic, { Diffusion(90.0, 15) }),
    Chain(SurfaceType::Any, "curved surface with edges",
      { Diffusion(90.0, 3), Diffusion(40.0, 3) }),
    Chain(SurfaceType::Any, "curved surface with edges", { Wide(10, 0.2) }),
    Chain(SurfaceType::Sharp, sides, { Wide(15, 0.05), Narrow() }),
    Chain(SurfaceType::Sharp, folded, { Wide(15, 0.1), Narrow() }, true),
    Chain(SurfaceType::Sharp, folded, { Wide(10, 0.2), Wide(15, 0.05), Narrow() }, true),
    Chain(SurfaceType::Sharp, folded, { Diffusion(90.0, 2), Wide(15, 0.05), Narrow() }, true),
  };
  return chains;
}

MethodChain PilotChain() { return { Diffusion(90.0, 2).Settings }; }

}
