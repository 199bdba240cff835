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
#include "SurfaceSides.h"
#include "vtkSurfaceComparison.h"

#include <memory>
#include <string>

struct vtkSurfaceComparison::Work
{
  SurfaceDenoising::ComparedSurface Result;
  SurfaceDenoising::ComparedSurface Reference;
  SurfaceDenoising::SMPExecution Execution;
  std::string Error;
  /// Face of the reference nearest to each face of the result.
  SurfaceDenoising::Buffer<SurfaceDenoising::Index> Partner;
  /// Face of the reference nearest to each point of the result; point if the reference is a cloud.
  SurfaceDenoising::Buffer<SurfaceDenoising::Index> PointPartner;
  SurfaceDenoising::Buffer<double> Distances;    ///< of the points of the result
  SurfaceDenoising::Buffer<double> NormalAngles; ///< of the faces of the result
  /// Of the points of the result; empty if there is nothing to compare.
  SurfaceDenoising::Buffer<double> PointNormalAngles;
  /// 1 for each face of the reference near features.
  SurfaceDenoising::Buffer<unsigned char> NearFaces;
  std::unique_ptr<SurfaceDenoising::SurfaceSides> Sides; ///< of the reference, if it is a surface

  explicit Work(vtkAlgorithm* algorithm)
    : Execution(algorithm)
  {
  }
};

#endif
