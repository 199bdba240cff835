// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file MethodFilter.h
 * @brief The VTK filter of a row of the table of methods.
 */

#ifndef MethodFilter_h
#define MethodFilter_h

#include "Methods.h"

#include <vtkMeshDenoisingFilter.h>
#include <vtkSmartPointer.h>

#include <string>

/**
 * The filter with the settings of the method, but at most that many outer iterations, or steps of a
 * method of one stage. Null for a method that is not known here.
 */
vtkSmartPointer<vtkMeshDenoisingFilter> MethodFilter(SurfaceDenoising::Method method,
  int outerIterations);

/// The row with this name, or null.
const SurfaceDenoising::MethodRow* FindMethod(const std::string& name);

#endif
