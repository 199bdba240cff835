// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file TextbookFlows.h
 * @brief Denoising that moves the points at once, without filtered normals.
 *
 * All points move together and those at a boundary stay. Lengths are relative to the mean edge
 * length of the input where not stated otherwise.
 */

#ifndef TextbookFlows_h
#define TextbookFlows_h

#include "Textbook.h"

namespace Textbook
{

/**
 * Implicit mean curvature flow with cotangents. The time step is in squared mean edge lengths. To
 * restore the volume scales a mesh without boundary after every step, about the mean of its points.
 */
void MeanCurvatureFlow(Mesh& mesh, double timeStep, int steps, bool restoreVolume);

/// Explicit flow by the curvatures of edges, which weigh less above the threshold.
void AnisotropicMeanCurvature(Mesh& mesh, double threshold, double timeStep, double sharpness,
  int steps);

/**
 * Bilateral filter of the heights of points. The spatial factor is per shortest edge of the point,
 * the range factor per standard deviation of the heights around it.
 */
void BilateralVertices(Mesh& mesh, int steps, double spatialFactor, double rangeFactor);

/// One pass of robust estimation from the planes of faces around, whose normals are mollified.
void NonIterativeBilateral(Mesh& mesh, double spatialScale, double rangeScale);

}

#endif
