// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file SurfaceWork.h
 * @brief What vtkMeshDenoisingFilter hands to its subclasses, and what it gets back.
 */

#ifndef SurfaceDenoising_SurfaceWork_h
#define SurfaceDenoising_SurfaceWork_h

#include "DenoisingReport.h"
#include "SurfaceAdapter.h"

namespace SurfaceDenoising
{

struct SurfaceWork
{
  vtkPolyData* Input;
  Execution& Exec;
  MeshView View; ///< of the input; its positions are moved

  Buffer<Vec3> FaceNormals; ///< the filtered normals, one per triangle, if there are any
  DenoisingReport Report;
};

}

#endif
