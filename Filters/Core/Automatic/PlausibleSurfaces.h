// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PlausibleSurfaces.h
 * @brief Surfaces that a noisy mesh may have been before the noise, and how plausible they are.
 *
 * Each is what a chain makes of the noisy mesh y: T. Noise is added to it again, along the normals
 * or in random directions, as much as makes the lower quartile of the angles between adjacent faces
 * that of y. On coarse curved surfaces weak noise flattens as many edges as it bends: if the lower
 * quartile of T alone is above 0.8 times that of y, the upper ones are tried as well, and what is
 * nearer to y in M2 below is taken. There are many T, of chains that round edges and of chains that
 * make some, and each is put to a test (indirect inference: C. Gourieroux, A. Monfort, E. Renault,
 * Journal of Applied Econometrics 8, 1993):
 *
 *   misfit = (mean |log(m_T / m_y)| over m in M1 + the same over M2) / 2.
 *
 * Methods move vertices along the surface too. Thin faces become fatter, and noise bends those less
 * than it did those of y: if the vertices of T moved back along T to where those of y are, see
 * TrialSample::Resampled, bring M2 nearer by 0.03, that is T.
 *
 * M1 are the mean angles between the mesh and what four quick chains make of it, each with each,
 * M2 quantiles (10, 25, 50, 75, 90%) of the angles between adjacent faces. Noise that is left in T
 * is not told from shape by that, so that smooth T are preferred: to the misfit is added the share
 * of folded edges of T and 0.05 times the median angle between its adjacent faces over that of y.
 * Nor is shape that T has lost told from noise; but noise is white, and lost shape is not: 0.05
 * times the correlation of the residuals y - T of adjacent vertices is added too, if it is
 * positive. What chains that smooth much make is no T at all if that correlation is above 0.05.
 *
 * Surfaces without noise have hardly any folded edges (adjacent faces turned by 120 degrees or
 * more), and what has more of them than y is no T. From 1% on, chains for folds are worth a trial.
 * If 5% of those of y are, it is noise that folds them, and from 4% on chains that leave them so
 * make no T.
 */

#ifndef SurfaceDenoising_PlausibleSurfaces_h
#define SurfaceDenoising_PlausibleSurfaces_h

#include "CandidateChains.h"
#include "TrialSample.h"

#include <cmath>
#include <limits>

namespace SurfaceDenoising
{

/// Angles below are as good as none, in degrees.
constexpr double SofteningAngle = 0.1;

inline double LogarithmOfAngles(double angle, double over)
{
  return std::log((angle + SofteningAngle) / (over + SofteningAngle));
}

/// What a chain makes of the sample.
struct ChainOutcome
{
  bool Known = false; ///< the chain has been run
  double Folds = 0.0; ///< share of the edges that are folded afterwards
  TrialResidual Removed;
};

struct PlausibleSurface
{
  SurfaceType Type = SurfaceType::Any; ///< what the chain that made it is for
  TrialNoise Kind = TrialNoise::AlongNormals;
  double Misfit = 0.0; ///< with the folds, if noise makes folds
  double Sum = 0.0;    ///< misfit and the rest: less is more plausible
  Buffer<Vec3> Normals;
  TriangleMesh Surface;
  double Deviation = 0.0; ///< of the noise, a length
};

class PlausibleSurfaces
{
public:
  /// The sample must outlive this.
  explicit PlausibleSurfaces(const TrialSample& sample);

  /// What the candidates that make truths find, by ascending Sum. Returns false if the execution
  /// asked to stop.
  bool Find(const std::vector<const CandidateChain*>& candidates, Execution& execution);

  const std::vector<PlausibleSurface>& BySum() const { return this->Surfaces; }
  /// That with the least misfit; there must be one.
  const PlausibleSurface& BestFitting() const;
  /// False if the misfits of all are too large. Where noise folds faces, none is.
  bool AnyFits() const;

  /// The surface with strength times the noise that was found for it.
  TriangleMesh WithNoise(const PlausibleSurface& truth, double strength,
    Execution& execution) const;

  /// The share of the edges of the sample that are folded.
  double ShareOfFolds() const { return this->FoldsBefore; }
  /// For each candidate; those that make no truths have not been run.
  const std::vector<ChainOutcome>& Outcomes() const { return this->OutcomesOfCandidates; }
  /// That of a chain that has made this surface of the sample.
  ChainOutcome OutcomeOf(const TriangleMesh& surface, Execution& execution) const;
  /// False for a chain for folds if hardly an edge of the sample is folded.
  bool IsWorthATrial(const CandidateChain& chain) const;
  /// 0 if clean meshes have as many folds, 1 if only noise makes as many.
  double FoldsAreNoise() const { return this->Folding; }

private:
  using Measures = std::vector<double>;

  struct Fit
  {
    PlausibleSurface Truth; ///< without Misfit and Sum
    double Difference;      ///< that of M2
    double Roughness;       ///< the median bend over that of the sample
  };

  bool MakesTruth(const CandidateChain& chain) const;
  bool Add(const TriangleMesh& surface, SurfaceType type, double correlation, Execution& execution);
  Fit FitNoise(const TriangleMesh& surface, TrialNoise kind, Execution& execution) const;
  bool Judge(Fit fit, double colour, Execution& execution);
  double DeviationFor(std::size_t quartile, const TriangleMesh& surface, const Buffer<Vec3>& noise,
    Execution& execution) const;
  bool MeasureProbes(const TriangleMesh& mesh, Measures& angles, Execution& execution) const;

  const TrialSample& Sample;
  Measures ProbesBefore; ///< M1 of the sample
  Measures BendsBefore;  ///< M2 of the sample
  double FoldsBefore = 0.0;
  double Folding = 0.0;
  std::vector<ChainOutcome> OutcomesOfCandidates;
  std::vector<PlausibleSurface> Surfaces;
  double LeastMisfit;
  double LeastSum[2]; ///< per kind of noise
};

}

#endif
