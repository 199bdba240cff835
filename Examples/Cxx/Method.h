// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef Method_h
#define Method_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkPolyDataAlgorithm;
struct Options;

/// "Truncated L2" becomes "truncated-l2".
std::string OptionName(std::string name);

/// All methods, those for surfaces first.
std::vector<std::string> MethodNames();

/// True for a method that filters points, with polygons or without.
bool IsForPoints(const std::string& method);

/// Where to start: the method for surfaces or, without polygons, for points.
std::string DefaultMethod(bool hasPolygons);

/// The filter that the options describe; null with a message if an option does not suit the method.
vtkSmartPointer<vtkPolyDataAlgorithm> MakeFilter(const Options& options, std::string& message);

#endif
