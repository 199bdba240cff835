// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OFFColors_h
#define OFFColors_h

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <cstddef>
#include <vector>

/// The color of one vertex or face as it stands in the file.
struct OFFColor
{
  std::array<double, 4> Components{};
  std::size_t Size = 0;    ///< components found: 0 for none; those behind the fourth are dropped
  bool Fractional = false; ///< written with a decimal point, so probably in [0, 1], not [0, 255]
};

/// Collects the colors of vertices or faces; an array comes of it only if all are of one kind.
class OFFColors
{
public:
  void Append(const OFFColor& color);
  void Append(const OFFColors& others);

  /// An array "Colors" as the documentation of vtkOFFReader describes it, or nullptr.
  vtkSmartPointer<vtkDataArray> MakeArray() const;

private:
  std::vector<double> Values;
  std::size_t Components = 0;
  vtkIdType Size = 0;
  bool Uniform = true;
  bool Fractional = false;
};

#endif
