// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file CloudNoise.h
 * @brief How noisy the points of a surface are, from the points alone.
 *
 * Deviations from polynomials through the k = 9, 20 and 40 nearest points of every point
 * (LocalFits.h) are those of noise and shape. Edges, corners and detail make them larger, hardly
 * ever smaller; so the noise is read off the lowest tenth (k = 9) or fifth of the points, divided
 * by what that quantile is for normally distributed residuals (Wilson and Hilferty 1931). Squares
 * of residuals that are shape grow with a power of k + 1, those that are noise stay: what grows is
 * taken off. Of strong noise small neighbourhoods lose their frame: between a quarter and 0.6 of a
 * spacing, k = 20 takes over from 9, and k = 40 beyond that.
 *
 * Noise with heavy tails (a length times a random direction, or of a scanner that sees some places
 * better than others) is stronger than those quiet points show: from the kurtosis K of residuals on
 * smooth places follows a factor of 1 + (K - 3.15) / 4, at most 1.375, less where shape is more
 * than noise.
 *
 * Of clouds in rows, as scanners leave them, all this is done with w times as many neighbours and
 * lengths in sqrt(w) spacings, where w is the least power of two up to 16 for which neighbourhoods
 * are patches of surface. If residuals do not look like noise then, or no w is enough, w = 1.
 *
 * **Bias and spread.** The estimate over the known deviation, for noise of 0.05, 0.1, 0.2, 0.35,
 * 0.5, 0.7 and 1 spacings along the normals: TestCloudNoise holds it to 0.95..1.05 on a sphere
 * (measured 0.98..1.01), 0.95..1.16 on a cube (1.01..1.13), 0.9..1.12 on a wedge and 0.8..1.16 on
 * waves six spacings wide; with heavy tails 0.85..1.1 on a sphere, 0.85..1.3 on a cube and
 * 0.85..1.2 on a wedge, from 0.1 to 0.4 (measured 0.96..1.06, 0.96..1.23, 0.97..1.11). On the
 * points of models: Fandisk 1.05..1.10, Bunny 0.80..1.01 (least for the strongest noise),
 * Armadillo 1.00..1.18 from 0.1 on, 1.36 below, anchor_dense 1.08..1.23. On models whose detail is
 * as small as their spacing, such as Elephant, 0.05 may be anything from 0 to 2; from 0.1 on
 * 0.97..1.17. In rows 5 to 20 times as far apart as their points: torus, cylinder and wedge
 * 0.92..1.04 up to half a spacing, 0.83..0.95 beyond, 0.65..0.91 for noise of two; scan lines on
 * Bunny 0.96..1.10 from 0.1 on, but 0.37..0.66 of a whole spacing, as noise hides that neighbours
 * lie in a row. Of a thin blade in rows 14 times as far apart, noise is found from two thirds of a
 * spacing on: 0.84..1.06, before it cannot be told from the sides. Where w = 16 is not enough, as
 * for the vertices of bare CAD models, no noise is found.
 */

#ifndef SurfaceDenoising_CloudNoise_h
#define SurfaceDenoising_CloudNoise_h

#include "Execution.h"
#include "Types.h"

namespace SurfaceDenoising
{

struct CloudNoise
{
  double Spacing = 0.0; ///< s, a length: see PointSet.h. Noise of a whole spacing raises it by 1/7
  double Deviation = 0.0; ///< standard deviation along the normal, a length
  /// How many times as many neighbours as usual it takes to reach beyond a row of points: 1, or
  /// more for points in rows. See LocalFits.h.
  std::size_t Widening = 1;
  std::size_t Finite = 0; ///< points with three finite coordinates
  std::size_t Far = 0;    ///< outliers far from everything
  std::size_t Off = 0;    ///< outliers near the surface, but clearly off it

  /// 1 for outliers, else 0; per point.
  Buffer<unsigned char> Outliers;

  /// Noise below this level is none.
  static constexpr double LeastLevel = 1e-4;

  bool IsNoisy() const { return this->Level() > LeastLevel; }

  /// The deviation in spacings; 0 if there is none.
  double Level() const { return this->Spacing > 0.0 ? this->Deviation / this->Spacing : 0.0; }

  /// Outliers among the finite points, in [0, 1].
  double OutlierShare() const
  {
    return static_cast<double>(this->Far + this->Off) /
      static_cast<double>(std::max<std::size_t>(1, this->Finite));
  }
};

/**
 * Far is a point whose spacing is more than 2.5 times s, and as much more than the median of those
 * of its neighbours, unless the polynomial of its 20 nearest others passes within a tenth of its
 * spacing: it lies on their surface. If neighbours lie all around (deviations from the polynomial
 * of 0.3 spacings) theirs may be as large, but not in a cloud whose neighbourhoods are hardly ever
 * patches of surface, such as the vertices of a bare CAD model.
 * Off the surface is one that is more than max(6 sigma, 3 s) above or below the polynomial of its
 * 20 nearest others, three times as far as the median of these, and has 1.4 times their spacing.
 * Off are also the points that impulsive noise has moved (CloudImpulses.h), which is looked for
 * where heights over the polynomial have heavy tails. The deviation is that of the other points.
 * Points that are not finite are left out. Too few points for a fit have no noise. Neither the
 * order of points nor the number of threads matters. If the execution asks to stop, what comes back
 * is of no use.
 */
CloudNoise EstimateNoise(const Buffer<Vec3>& points, Execution& execution);

}

#endif
