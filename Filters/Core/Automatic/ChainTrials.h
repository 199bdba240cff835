// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file ChainTrials.h
 * @brief How wrong a denoised surface is, without knowing the right one.
 *
 * A parametric bootstrap (B. Efron, R. Tibshirani, "An Introduction to the Bootstrap", 1993). A
 * surface T that the noisy mesh y may have been is taken for the truth, and noise is added to it
 * again. What a chain makes of this mesh is compared with T.
 *
 * The error e is that on y as far as T and the noise are like the real ones. Of many T, see
 * PlausibleSurfaces, the two with the least sum s of those that chains for each type of surface
 * made count, each by exp(-s / 0.025), if s is at most 0.075 above the least. What they say of the
 * logarithm of the error is added up by TruncatedRegret: or a truth that is too smooth would decide
 * alone, on which smooth chains are many times better than others.
 *
 * What a chain removes from y beyond what it removes from T with noise is shape, whose loss T did
 * not foretell. With r the root mean square of what is removed, v how much larger r^2 is for y, c
 * how much more correlated what is removed is (TrialResidual), both at least 0, and n the deviation
 * of the noise, log(e) becomes
 *
 *   log(e^2 + 0.4^2 d v / n^2) / 2 + 0.75 d c,
 *
 * with d as in TrialResult::Certain: what strong noise hides is no shape.
 *
 * One thing can be seen on y itself: the share of folded edges, which are wrong for certain if
 * noise has made them (3 to 5% and more of y). What a chain leaves of them on y beyond what it
 * leaves of those of T with noise is an error that T did not foretell: it adds 250 degrees times
 * this share to the mean angle. The same holds for those of y itself.
 */

#ifndef SurfaceDenoising_ChainTrials_h
#define SurfaceDenoising_ChainTrials_h

#include "PlausibleSurfaces.h"
#include "TruncatedRegret.h"

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
   * be taken for weak noise, hardly for strong noise or if noise folds faces: with d from 1 if the
   * noise turns faces by 20 degrees on average to 0 if by 35, Error must be below
   *
   *   0.9 exp(-d (6 m + z + 4 c)).
   *
   * m is the least misfit, less 0.5 / sqrt(number of faces), which chance may have made. What the
   * candidate removes from the input is put beside what it removes from the best truth with noise:
   * z is how much larger it is, the ratio less 1, and c how much more correlated (TrialResidual),
   * if it is: shape, not noise.
   */
  bool Certain = false;
};

class ChainTrials
{
public:
  /// All must outlive this.
  ChainTrials(const TrialSample& sample, const std::vector<const CandidateChain*>& candidates);

  /**
   * Finds the candidate with the least expected error, the first of several; if d > 0 and it leaves
   * more than 0.7 for the truth with the least misfit, smooth or not, the best for that one.
   * strength scales the noise that is added; it is above 0. Returns false if the execution asked to
   * stop.
   */
  bool Run(double strength, TrialResult& result, Execution& execution);

private:
  /// What a candidate does to a truth with noise.
  struct Trial
  {
    double Angle = 0.0; ///< mean angle to the normals of the truth, with the cost of folds
    TrialResidual Removed;
  };

  /// By how much what is removed from the input is larger and more correlated, 0 if it is less.
  struct Surplus
  {
    double Size = 0.0; ///< the ratio less 1
    double Correlation = 0.0;
    double Deviation = 0.0; ///< the root of the difference of the squares, a length
  };

  /// What the trials say of the candidates.
  struct Scores
  {
    std::vector<double> Errors; ///< weighted sums of their logarithms
    TruncatedRegret Regrets;
  };

  /// A truth that candidates are tried on, and what it counts.
  struct WeightedTruth
  {
    const PlausibleSurface* Truth;
    double Weight;
  };

  double AngleTo(const PlausibleSurface& truth, const TriangleMesh& mesh, double folds,
    Execution& execution) const;
  bool Know(std::size_t candidate, Execution& execution);
  bool Try(std::size_t candidate, const PlausibleSurface& truth, const TriangleMesh& noisy,
    Trial& trial, Execution& execution);
  bool Compare(std::size_t candidate, const Trial& trial, Surplus& surplus, Execution& execution);
  bool CostOfShape(std::size_t candidate, const Trial& trial, double error, double deviation,
    double& cost, Execution& execution);
  bool TryAll(const PlausibleSurface& truth, double strength, double weight, Scores& scores,
    Execution& execution);
  std::vector<WeightedTruth> TruthsThatCount() const;
  bool Choose(double strength, TrialResult& result, Execution& execution);
  double DoubtAbout(const PlausibleSurface& truth, double strength, Execution& execution) const;
  bool AskWitness(const PlausibleSurface& witness, double strength, TrialResult& result,
    Execution& execution);

  const TrialSample& Sample;
  const std::vector<const CandidateChain*>& Candidates;
  PlausibleSurfaces Surfaces;
  std::vector<ChainOutcome> OnInput; ///< filled in as candidates are run
  double Doubt = 0.0;                ///< d of TrialResult::Certain
};

}

#endif
