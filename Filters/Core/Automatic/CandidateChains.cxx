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

/// Takes the worst of strong noise away; few steps of the vertices leave features to what follows.
Part Calming()
{
  Part part = Diffusion(90.0, 1);
  part.Settings.VertexIterations = 3;
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

/// Sorts faces into sides that meet at edges sharper than the scale.
Part Sides(double scale, int outer, double relaxation)
{
  Part part{ Method::TukeyBilateralNormal, SettingsOf(Method::TukeyBilateralNormal) };
  part.Settings.NormScale = scale;
  part.Settings.OuterIterations = outer;
  part.Settings.Vertices.Relaxation = relaxation;
  return part;
}

/// A scale that leaves no edges but sharp ones.
Part Wide(int outer, double relaxation) { return Sides(1.0, outer, relaxation); }

/// Smooth normals, which the vertices follow for long: faces turn back that noise has folded over.
Part Following() { return Bilateral(1.0, 20, 20); }

/// Flattens sides and rounds what is sharper than 50 degrees or so.
Part Cosine()
{
  Part part{ Method::ThresholdedCosine, SettingsOf(Method::ThresholdedCosine) };
  part.Settings.NormScale = 0.6;
  part.Settings.OuterIterations = 1;
  part.Settings.NormalIterations = 10;
  part.Settings.VertexIterations = 10;
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
  TruthUse truth = TruthUse::Never)
{
  CandidateChain chain;
  chain.Type = type;
  chain.Purpose = purpose;
  chain.Truth = truth;
  for (const Part& part : parts)
  {
    chain.Methods.push_back(part.Id);
    chain.Steps.push_back(part.Settings);
  }
  return chain;
}

CandidateChain Unfolding(const std::vector<Part>& parts, TruthUse truth)
{
  CandidateChain chain =
    Chain(SurfaceType::Any, "narrow faces that noise has folded over", parts, truth);
  chain.ForFolds = true;
  return chain;
}

}

const std::vector<CandidateChain>& CandidateChains()
{
  static const char* const fine = "fine detail under weak noise";
  static const char* const organic = "curved surface";
  static const char* const mixed = "curved surface with edges";
  static const char* const blunt = "flat sides with blunt edges";
  static const char* const sides = "flat sides with sharp edges";
  static const char* const strong = "flat sides with sharp edges under strong noise";
  static const std::vector<CandidateChain> chains = {
    Chain(SurfaceType::Any, fine, { Bilateral(0.2, 5, 10) }),
    Chain(SurfaceType::Any, fine, { Bilateral(0.35, 5, 10) }, TruthUse::Always),
    Chain(SurfaceType::Any, mixed, { Bilateral(0.5, 10, 10) }, TruthUse::WithoutFolds),
    Chain(SurfaceType::Any, mixed, { Cosine() }, TruthUse::WithoutFolds),
    Chain(SurfaceType::Sharp, blunt, { Sides(0.5, 10, 0.2), Narrow() }, TruthUse::Always),
    Chain(SurfaceType::Curved, organic, { Mean(2) }, TruthUse::Always),
    Chain(SurfaceType::Curved, organic, { Mean(5) }),
    Chain(SurfaceType::Curved, organic, { CurvatureDiffusion() }, TruthUse::Always),
    Chain(SurfaceType::Curved, organic, { Diffusion(90.0, 1) }),
    Chain(SurfaceType::Curved, organic, { Diffusion(90.0, 2) }, TruthUse::Always),
    Chain(SurfaceType::Curved, organic, { Diffusion(90.0, 3) }),
    Chain(SurfaceType::Curved, organic, { Diffusion(90.0, 5) }),
    Chain(SurfaceType::Curved, organic, { Diffusion(90.0, 15) }),
    Chain(SurfaceType::Curved, organic, { Diffusion(90.0, 30) }, TruthUse::Always),
    Chain(SurfaceType::Curved, organic, { Wide(10, 0.2), Diffusion(90.0, 3) }),
    Chain(SurfaceType::Any, mixed, { Sides(0.35, 30, 0.05) }, TruthUse::Always),
    Chain(SurfaceType::Any, mixed, { Wide(15, 0.05) }),
    Chain(SurfaceType::Any, mixed, { Wide(60, 0.2) }, TruthUse::Always),
    Unfolding({ Wide(10, 0.2), Following() }, TruthUse::IfWhite),
    Unfolding({ Wide(10, 0.2), Following(), Wide(10, 0.2), Following() }, TruthUse::IfWhite),
    Unfolding({ Wide(10, 0.2), Following(), Wide(15, 0.2), Narrow() }, TruthUse::Never),
    Chain(SurfaceType::Sharp, blunt, { Sides(0.5, 15, 0.05), Narrow() }),
    Chain(SurfaceType::Sharp, blunt, { Diffusion(40.0, 2), Sides(0.4, 10, 0.05), Narrow() }),
    Chain(SurfaceType::Sharp, sides, { Wide(15, 0.05), Narrow() }, TruthUse::Always),
    Chain(SurfaceType::Sharp, strong, { Wide(10, 0.2), Wide(15, 0.05), Narrow() }),
    Chain(SurfaceType::Sharp, strong, { Calming(), Wide(15, 0.05), Narrow() }),
    Chain(SurfaceType::Sharp, strong, { Diffusion(90.0, 1), Wide(30, 0.05), Narrow() }),
    Chain(SurfaceType::Sharp, strong, { Diffusion(90.0, 2), Wide(30, 0.05), Narrow() },
      TruthUse::Always),
  };
  return chains;
}

MethodChain PilotChain() { return { Diffusion(90.0, 2).Settings }; }

const std::vector<MethodChain>& ProbeChains()
{
  static const std::vector<MethodChain> chains = { { Bilateral(0.35, 5, 10).Settings },
    { Mean(2).Settings }, { CurvatureDiffusion().Settings }, PilotChain() };
  return chains;
}

}
