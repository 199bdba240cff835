// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "XYZLayout.h"

#include <algorithm>
#include <cmath>

namespace SurfaceDenoising
{

namespace
{
using Names = std::vector<std::string>;

std::string ToLower(std::string_view text)
{
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
    [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return result;
}

/// The column that has one of two names, if there is exactly one.
std::optional<std::size_t> Find(const Names& names, const char* name, const char* other)
{
  const auto matches = [name, other](const std::string& n) { return n == name || n == other; };
  const auto found = std::find_if(names.begin(), names.end(), matches);
  if (found == names.end() || std::any_of(found + 1, names.end(), matches))
  {
    return {};
  }
  return static_cast<std::size_t>(found - names.begin());
}

std::optional<XYZLayout::Triple> FindTriple(const Names& names,
  const std::array<const char*, 3>& wanted, const std::array<const char*, 3>& others)
{
  XYZLayout::Triple triple;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::optional<std::size_t> column = Find(names, wanted[i], others[i]);
    if (!column)
    {
      return {};
    }
    triple[i] = *column;
  }
  return triple;
}
}

//------------------------------------------------------------------------------
std::optional<XYZLayout> LayoutByNames(const std::vector<std::string_view>& names)
{
  Names lower;
  std::transform(names.begin(), names.end(), std::back_inserter(lower), ToLower);

  const auto position = FindTriple(lower, { "x", "y", "z" }, { "x", "y", "z" });
  if (!position)
  {
    return {};
  }
  XYZLayout layout;
  layout.Position = *position;
  layout.Normal = FindTriple(lower, { "nx", "ny", "nz" }, { "normal_x", "normal_y", "normal_z" });
  layout.Color = FindTriple(lower, { "r", "g", "b" }, { "red", "green", "blue" });
  layout.Intensity = Find(lower, "i", "intensity");

  std::vector<bool> used(names.size(), false);
  for (const auto& triple : { position, layout.Normal, layout.Color })
  {
    for (std::size_t i = 0; triple && i < 3; ++i)
    {
      used[(*triple)[i]] = true;
    }
  }
  if (layout.Intensity)
  {
    used[*layout.Intensity] = true;
  }
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    if (!used[i])
    {
      layout.Others.emplace_back(names[i], i);
    }
  }
  return layout;
}

//------------------------------------------------------------------------------
std::optional<XYZLayout> LayoutByCount(std::size_t columns)
{
  XYZLayout layout;
  switch (columns)
  {
    case 3:
      return layout;
    case 4:
      layout.Intensity = 3;
      return layout;
    case 6:
      layout.NormalOrColor = { 3, 4, 5 };
      return layout;
    case 7:
      layout.Intensity = 3;
      layout.Color = { 4, 5, 6 };
      return layout;
    default:
      return {};
  }
}

//------------------------------------------------------------------------------
bool AreColors(const std::vector<double>& rows, std::size_t columns,
  const XYZLayout::Triple& triple)
{
  // Unit vectors along the axes are whole numbers as well, but have none above 1.
  bool anyAboveOne = false;
  for (std::size_t row = 0; row < rows.size(); row += columns)
  {
    for (const std::size_t column : triple)
    {
      const double value = rows[row + column];
      if (!(0.0 <= value && value <= 255.0 && value == std::floor(value)))
      {
        return false;
      }
      anyAboveOne |= value > 1.0;
    }
  }
  return anyAboveOne;
}

}
