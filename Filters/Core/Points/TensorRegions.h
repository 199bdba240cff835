// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file TensorRegions.h
 * @brief Plane fits to the part of the neighbourhood that lies on one face.
 *
 * M. K. Park, S. J. Lee, I. Y. Jang, Y. Y. Lee, K. H. Lee, "Feature-aware filtering for point-set
 * surface denoising", Computers and Graphics 37(6), 2013. Partly reconstructed.
 */

#ifndef SurfaceDenoising_TensorRegions_h
#define SurfaceDenoising_TensorRegions_h

#include "PointOperator.h"

namespace SurfaceDenoising
{

struct TensorRegionsSettings
{
  double Range = 4.0;             ///< sigma, in spacings: exp(-(s^2 + c kappa^2) / sigma^2)
  double BendFactor = 11.198431;  ///< c over the fourth power of the spacing
  double FeatureThreshold = 0.1;  ///< tau_f of 1.5 (l2 + l3)
  double RegionThreshold = 0.6;   ///< the least weight of a member of the region
  int LeastMembers = 5;           ///< of the region
  bool QuadricAtFeatures = false; ///< feature points go to the quadric fit of their neighbours
};

std::unique_ptr<PointOperator> MakeTensorRegions(const TensorRegionsSettings& settings);

}

#endif
