// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file GlobalSolve.h
 * @brief All filtered normals at once: the implicit scheme of bilateral normal filtering.
 *
 * With the weights of the normal filter divided by their sums, W, and L = I - W, the normals N
 * minimise
 *
 *   (1 - lambda) sum_i D_i |(L N)_i|^2  +  lambda sum_i D_i |N_i - n_i|^2
 *
 * and are then normalised. Y. Zheng, H. Fu, O. K.-C. Au, C.-L. Tai, "Bilateral normal filtering for
 * mesh denoising", IEEE TVCG 17(10), 2011. The system ((1 - lambda) L^T D L + lambda D) N = lambda
 * D n is symmetric and positive definite. It is solved by conjugate gradients without ever being
 * formed: any factorisation fills in and takes hundreds of times as long.
 */

#ifndef SurfaceDenoising_GlobalSolve_h
#define SurfaceDenoising_GlobalSolve_h

#include "NormalFilter.h"

namespace SurfaceDenoising
{

struct GlobalSolveSettings
{
  double Fidelity = 0.01;  ///< lambda in (0, 1]: the smaller, the smoother
  bool AreaEnergy = true;  ///< D_i = area of site i over the mean area; otherwise 1
  double Tolerance = 1e-8; ///< of the residual, relative to the right-hand side
  int MaximumIterations = 5000;
};

/**
 * Solves for all sites. Those with area 0 are no part of the energy; they take the weighted mean of
 * their solved neighbours. A site whose neighbours have no weight is held by its own normal alone.
 * kept counts the sites that keep their current normal because the solution vanishes there. Returns
 * false if the execution asked to stop. iterations is increased by the number of steps.
 */
bool SolveForNormals(const NormalFilter& filter, const NormalFilter::Fields& fields,
  const Buffer<double>& areas, const GlobalSolveSettings& settings, Buffer<Vec3>& filtered,
  std::size_t& kept, std::size_t& iterations, Execution& execution, double first, double last);

}

#endif
