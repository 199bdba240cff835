// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file SurfaceWork.h
 * @brief What vtkMeshDenoisingFilter hands to its subclasses, and what it gets back.
 */

#ifndef SurfaceDenoising_SurfaceWork_h
#define SurfaceDenoising_SurfaceWork_h

#include "SurfaceAdapter.h"

#include <utility>
#include <vector>

class vtkInformationVector;

namespace SurfaceDenoising
{

/// An entry of the report.
using Figure = std::pair<const char*, double>;

struct SurfaceWork
{
  vtkInformationVector** InputVector;
  vtkPolyData* Input;
  Execution& Exec;
  MeshView View; ///< of the input; its positions are moved

  Buffer<Vec3> FaceNormals; ///< the filtered normals, one per triangle, if there are any
  std::vector<Figure> Figures;

  /// Names are literals.
  template <typename Number>
  void Add(const char* name, Number value)
  {
    this->Figures.emplace_back(name, static_cast<double>(value));
  }
};

}

#endif
