// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkPointDenoisingMethods
 * @brief   the table of methods for point sets: who published what, and which filter does it
 *
 * A row per published method for point sets. Menus, comparisons and tables are made from
 * it, and NewFilter makes the filters. Numbers outside [0, GetNumberOfMethods()) get null or false.
 */

#ifndef vtkPointDenoisingMethods_h
#define vtkPointDenoisingMethods_h

#include "vtkObject.h"
#include "vtkSurfaceDenoisingPointsModule.h" // for export macro

class vtkPointDenoisingFilter;

class VTKSURFACEDENOISINGPOINTS_EXPORT vtkPointDenoisingMethods : public vtkObject
{
public:
  static vtkPointDenoisingMethods* New();
  vtkTypeMacro(vtkPointDenoisingMethods, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  static int GetNumberOfMethods();

  /// For example "Guided Point Normal".
  static const char* GetName(int method);

  /// Authors and year.
  static const char* GetPaper(int method);

  /// The class that does it by default, without "vtk": the name of the proxy in ParaView.
  static const char* GetFilter(int method);

  /// A preset of vtkRobustPointNormalFilter.
  static bool IsComposed(int method);

  /// A filter that is set to the method with the numbers of its paper. The caller owns it.
  VTK_NEWINSTANCE
  static vtkPointDenoisingFilter* NewFilter(int method);

protected:
  vtkPointDenoisingMethods();
  ~vtkPointDenoisingMethods() override;

private:
  vtkPointDenoisingMethods(const vtkPointDenoisingMethods&) = delete;
  void operator=(const vtkPointDenoisingMethods&) = delete;
};

#endif
