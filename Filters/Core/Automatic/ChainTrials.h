// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file ChainTrials.h
 * @brief How wrong a denoised surface is, without knowing the right one.
 *
 * A parametric bootstrap (B. Efron, R. Tibshirani, "An Introduction to the Bootstrap", 1993). The
 * surface T that a chain makes of the noisy mesh y is taken for the truth, and noise is added to it
 * again, along the normals or in random directions, as much as makes the lower quartile of the
 * angles between adjacent faces that of y. What a chain makes of this mesh is compared with T.
 *
 * The error is that on y as far as T and the noise are like the real ones. There are many T, of
 * chains that round edges and of chains that make some, and each is put to a test (indirect
 * inference: C. Gourieroux, A. Monfort, E. Renault, Journal of Applied Econometrics 8, 1993):
 *
 *   misfit = (mean |log(m_T / m_y)| over m in M1 + the same over M2) / 2.
 *
 * M1 are the mean angles between the mesh and what four quick chains make of it, each with each,
 * M2 quantiles (10, 25, 50, 75, 90%) of the angles between adjacent faces. Noise that is left in T
 * is not told from shape by that, so that smooth T are preferred: to the misfit is added the share
 * of folded edges of T and 0.05 times the median angle between its adjacent faces over that of y.
 * The three T with the least sum s count, each by exp(-s / 0.01).
 */

#ifndef SurfaceDenoising_ChainTrials_h
#define SurfaceDenoising_ChainTrials_h

#include "CandidateChains.h"
#include "TrialSample.h"

#include <limits>

namespace SurfaceDenoising
{

/// What is expected of a candidate.
struct TrialResult
{
  std::size_t Best = 0; ///< number of the candidate with the least error
  /// The mean angle to the true normals that it leaves over that of the input: the geometric mean
  /// over the truths. Infinite if no truth fits at all.
  double Error = std::numeric_limits<double>::infinity();
  /**
   * True if the error is certain to be less than that of the input. Detail that fits no truth can
   * be taken for weak noise, hardly for strong noise: with d from 1 if the noise turns faces by 20
   * degrees on average to 0 if by 35, Error must be below 0.62 exp(-10 d misfit), or below 0.9 if d
   * is 0.
   */
  bool Certain = false;
};

class ChainTrials
{
public:
  /// All must outlive this.
  ChainTrials(const TrialSample& sample, const std::vector<const CandidateChain*>& candidates);
  ~ChainTrials();

  /**
   * Finds the candidate with the least expected error, the first of several; if d > 0 and it leaves
   * more than 0.7 for the truth with the least misfit, smooth or not, the best for that one.
   * strength scales the noise that is added; it is above 0. Returns false if the execution asked to
   * stop.
   */
  bool Run(double strength, TrialResult& result, Execution& execution);

private:
  using Measures = std::vector<double>;
  struct Truth;

  bool FindTruths(Execution& execution);
  bool Add(const TriangleMesh& surface, Execution& execution);
  bool MeasureProbes(const TriangleMesh& mesh, Measures& angles, Execution& execution) const;
  TriangleMesh WithNoise(const Truth& truth, double strength) const;
  double AngleTo(const Truth& truth, const TriangleMesh& mesh, Execution& execution) const;
  bool AngleAfter(const MethodChain& chain, const Truth& truth, const TriangleMesh& noisy,
    double& angle, Execution& execution) const;

  const TrialSample& Sample;
  const std::vector<const CandidateChain*>& Candidates;
  Measures ProbesBefore; ///< M1 of the sample
  Measures BendsBefore;  ///< M2 of the sample
  std::vector<Truth> Truths;
  double LeastMisfit = std::numeric_limits<double>::infinity();
  double LeastSum[2]; ///< per kind of noise
};

}

#endif
