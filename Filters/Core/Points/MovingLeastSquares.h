// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file MovingLeastSquares.h
 * @brief Projects points onto a smooth surface fitted to their neighbours: the baseline.
 *
 * M. Alexa, J. Behr, D. Cohen-Or, S. Fleishman, D. Levin, C. Silva, "Computing and Rendering Point
 * Set Surfaces", IEEE TVCG 9(1), 2003. The reference plane by repeated weighted fits, then a
 * weighted least squares polynomial over it.
 */

#ifndef SurfaceDenoising_MovingLeastSquares_h
#define SurfaceDenoising_MovingLeastSquares_h

#include "PointOperator.h"

namespace SurfaceDenoising
{

struct MovingLeastSquaresSettings
{
  int Degree =
    2; ///< of the polynomial: 0 (the plane alone), 1 or 2; lower if there are too few points
  double Bandwidth =
    0.0; ///< h of exp(-d^2 / h^2) in spacings; 0: half the distance of the last neighbour
  int PlaneRounds = 5; ///< at most, of the reference plane
};

std::unique_ptr<PointOperator> MakeMovingLeastSquares(const MovingLeastSquaresSettings& settings);

}

#endif
