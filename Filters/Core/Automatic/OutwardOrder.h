// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file OutwardOrder.h
 * @brief An order of points that does not depend on how they are numbered, turned or scaled.
 */

#ifndef SurfaceDenoising_OutwardOrder_h
#define SurfaceDenoising_OutwardOrder_h

#include "Execution.h"
#include "Types.h"

namespace SurfaceDenoising
{

/// The mean of the points; zero without any.
Vec3 MeanOf(const Buffer<Vec3>& points, Execution& execution);

/// The numbers of the elements by ascending key, of equal keys by ascending number.
Buffer<Index> OrderBy(const Buffer<double>& keys);

/// The numbers of the points by their distance from their mean.
Buffer<Index> OutwardOrder(const Buffer<Vec3>& points, Execution& execution);

}

#endif
