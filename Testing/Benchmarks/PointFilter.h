// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PointFilter.h
 * @brief The point methods as benchmarks compare them: 16 neighbours, one outer iteration.
 */

#ifndef PointFilter_h
#define PointFilter_h

#include <vtkPointDenoisingFilter.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

/// Neighbours of every point, in the methods as in what they are compared with.
constexpr int BenchmarkNeighbors = 16;

/// The methods of the table and "Robust Point Normal", the composer.
std::vector<std::string> PointFilterNames();

/// The filter of a method, or null. Other settings are those of the method.
vtkSmartPointer<vtkPointDenoisingFilter> PointFilter(const std::string& name);

#endif
