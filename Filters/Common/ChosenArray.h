// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file ChosenArray.h
 * @brief The array that the user of a filter told it to work with.
 */

#ifndef SurfaceDenoising_ChosenArray_h
#define SurfaceDenoising_ChosenArray_h

#include <string>

class vtkAlgorithm;
class vtkDataArray;
class vtkDataObject;

namespace SurfaceDenoising
{

/// What SetInputArrayToProcess(0, ...) chose.
struct ArrayChoice
{
  bool Made = false;             ///< false if nothing was chosen, or "None"
  vtkDataArray* Array = nullptr; ///< null if the input has no such array
  std::string Name;              ///< empty if it was chosen as the active array of a kind
};

/// The choice among the arrays of an association (see vtkDataObject): an array of points is none of
/// cells, however many there are of either. (GetInputArrayToProcess takes it as it comes.)
ArrayChoice ChosenArray(vtkAlgorithm* algorithm, vtkDataObject* input, int association);

}

#endif
