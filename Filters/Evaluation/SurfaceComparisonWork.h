// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file SurfaceComparisonWork.h
 * @brief What vtkSurfaceComparison holds while it compares.
 */

#ifndef SurfaceDenoising_SurfaceComparisonWork_h
#define SurfaceDenoising_SurfaceComparisonWork_h

#include "ComparedSurface.h"
#include "SMPExecution.h"
#include "vtkSurfaceComparison.h"

#include <string>

struct vtkSurfaceComparison::Work
{
  SurfaceDenoising::ComparedSurface Result;
  SurfaceDenoising::ComparedSurface Reference;
  SurfaceDenoising::SMPExecution Execution;
  std::string Error;
  /// Face of the reference nearest to each face of the result.
  SurfaceDenoising::Buffer<SurfaceDenoising::Index> Partner;
  SurfaceDenoising::Buffer<double> Distances;    ///< of the points of the result
  SurfaceDenoising::Buffer<double> NormalAngles; ///< of the faces of the result

  explicit Work(vtkAlgorithm* algorithm)
    : Execution(algorithm)
  {
  }
};

#endif
