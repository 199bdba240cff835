// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef XYZLayout_h
#define XYZLayout_h

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace SurfaceDenoising
{

/// What the columns of a text of points are; columns count from 0.
struct XYZLayout
{
  using Triple = std::array<std::size_t, 3>;

  Triple Position{ 0, 1, 2 };
  std::optional<Triple> Normal;
  std::optional<Triple> Color;
  std::optional<std::size_t> Intensity;
  std::vector<std::pair<std::string, std::size_t>> Others; ///< by their names

  /// Normals or colors, which only the numbers tell: none of both is set.
  std::optional<Triple> NormalOrColor;
};

/// By the names in a header; none if x, y and z are not among them, once each.
std::optional<XYZLayout> LayoutByNames(const std::vector<std::string_view>& names);

/// By the number of columns alone; none if it has no usual meaning.
std::optional<XYZLayout> LayoutByCount(std::size_t columns);

/// Whether NormalOrColor of the rows of numbers is a color.
bool AreColors(const std::vector<double>& rows, std::size_t columns,
  const XYZLayout::Triple& triple);

}

#endif
