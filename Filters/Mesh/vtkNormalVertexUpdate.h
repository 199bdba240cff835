// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkNormalVertexUpdate
 * @brief   moves the points of a surface so that its faces have given normals
 *
 * The second stage of two-stage denoising on its own. The normals are a cell array with three
 * components, by default "FilteredNormals", which all normal filters of this module write; choose
 * another one with SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, name).
 * Lengths of the vectors do not matter, zero vectors are ignored. An array that is missing, belongs
 * to points, has another shape or is not finite is an error.
 *
 * The schemes and options are those of vtkNormalFittingFilter. Points move along the given normals;
 * in flat regions the triangles keep their shape.
 */

#ifndef vtkNormalVertexUpdate_h
#define vtkNormalVertexUpdate_h

#include "vtkNormalFittingFilter.h"

class VTKSURFACEDENOISINGMESH_EXPORT vtkNormalVertexUpdate : public vtkNormalFittingFilter
{
public:
  static vtkNormalVertexUpdate* New();
  vtkTypeMacro(vtkNormalVertexUpdate, vtkNormalFittingFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkNormalVertexUpdate();
  ~vtkNormalVertexUpdate() override;

  void Configure(SurfaceDenoising::MeshDenoisingSettings& settings) override;
  bool NeedsStartNormals() const override { return true; }

private:
  vtkNormalVertexUpdate(const vtkNormalVertexUpdate&) = delete;
  void operator=(const vtkNormalVertexUpdate&) = delete;
};

#endif
