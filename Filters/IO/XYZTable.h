// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef XYZTable_h
#define XYZTable_h

#include "XYZLayout.h"

#include <cstddef>
#include <functional>
#include <limits>
#include <string_view>
#include <vector>

namespace SurfaceDenoising
{

/// The numbers of a text of points.
struct XYZTable
{
  XYZLayout Layout;
  std::size_t Columns = 3;
  std::vector<double> Values; ///< row by row
  bool Stopped = false;       ///< before the end, by what was asked whether to go on

  std::size_t GetNumberOfRows() const { return this->Values.size() / this->Columns; }
};

/**
 * Read a text of points, which the documentation of vtkXYZReader describes, or the first \p most of
 * them. Throws a FileError that names the line of what is wrong. \p proceed gets the fraction of
 * the text that is read and says whether to go on.
 */
XYZTable ReadXYZTable(std::string_view text, const std::function<bool(double)>& proceed,
  std::size_t most = std::numeric_limits<std::size_t>::max());

}

#endif
