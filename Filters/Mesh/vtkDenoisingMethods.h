// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkDenoisingMethods
 * @brief   the table of methods: who published what, and which filter does it
 *
 * A row per published method for surfaces with faces. Menus, comparisons and tables are made from
 * it, and NewFilter makes the filters. Numbers outside [0, GetNumberOfMethods()) get null or false.
 */

#ifndef vtkDenoisingMethods_h
#define vtkDenoisingMethods_h

#include "vtkObject.h"
#include "vtkSurfaceDenoisingMeshModule.h" // for export macro

class vtkMeshDenoisingFilter;

class VTKSURFACEDENOISINGMESH_EXPORT vtkDenoisingMethods : public vtkObject
{
public:
  static vtkDenoisingMethods* New();
  vtkTypeMacro(vtkDenoisingMethods, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  static int GetNumberOfMethods();

  /// For example "Guided Normal".
  static const char* GetName(int method);

  /// Authors and year.
  static const char* GetPaper(int method);

  /// The class that does it by default, without "vtk": the name of the proxy in ParaView.
  static const char* GetFilter(int method);

  /// Filters normals and then moves points; the others move points at once, lose volume or edges,
  /// and are there to compare with.
  static bool IsTwoStage(int method);

  /// A preset of vtkRobustNormalFilter.
  static bool IsComposed(int method);

  /// A filter that is set to the method with the numbers of its paper. The caller owns it.
  VTK_NEWINSTANCE
  static vtkMeshDenoisingFilter* NewFilter(int method);

protected:
  vtkDenoisingMethods();
  ~vtkDenoisingMethods() override;

private:
  vtkDenoisingMethods(const vtkDenoisingMethods&) = delete;
  void operator=(const vtkDenoisingMethods&) = delete;
};

#endif
