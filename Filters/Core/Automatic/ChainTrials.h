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
 * The error is that on y as far as T and the noise are like the real ones. Of many T, see
 * PlausibleSurfaces, the three with the least sum s count, no more than two of them of chains for
 * the same type of surface, each by exp(-s / 0.01).
 *
 * One thing can be seen on y itself: the share of folded edges, which are wrong for certain if
 * noise has made them (3 to 5% and more of y). What a chain leaves of them on y beyond what it
 * leaves of those of T with noise is an error that T did not foretell: it adds 250 degrees times
 * this share to the mean angle. The same holds for those of y itself.
 */

#ifndef SurfaceDenoising_ChainTrials_h
#define SurfaceDenoising_ChainTrials_h

#include "PlausibleSurfaces.h"

#include <limits>

namespace SurfaceDenoising
{

/// What is expected of a candidate.
struct TrialResult
{
  std::size_t Best = 0; ///< number of the candidate with the least error
  /// The mean angle to the true normals that it leaves over that of the input: the mean over the
  /// truths. Infinite if no truth fits at all.
  double Error = std::numeric_limits<double>::infinity();
  /**
   * True if the error is certain to be less than that of the input. Detail that fits no truth can
   * be taken for weak noise, hardly for strong noise or if noise folds faces: with d from 1 if the
   * noise turns faces by 20 degrees on average to 0 if by 35, Error must be below
   *
   *   0.9 exp(-d (10 m + z + 4 c)).
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
  using Measures = std::vector<double>;

  double AngleTo(const PlausibleSurface& truth, const TriangleMesh& mesh, double folds,
    Execution& execution) const;
  bool AngleAfter(std::size_t candidate, const PlausibleSurface& truth, const TriangleMesh& noisy,
    double& angle, Execution& execution);
  bool AskWitness(const PlausibleSurface& witness, double strength, TrialResult& result,
    Execution& execution);
  bool Surplus(std::size_t candidate, const PlausibleSurface& truth, double& surplus,
    Execution& execution);
  bool Try(const PlausibleSurface& truth, double strength, double limit, double weight,
    Measures& errors, Execution& execution);

  const TrialSample& Sample;
  const std::vector<const CandidateChain*>& Candidates;
  PlausibleSurfaces Surfaces;
  Measures FoldsAfter; ///< see PlausibleSurfaces; filled in as candidates are run
};

}

#endif
