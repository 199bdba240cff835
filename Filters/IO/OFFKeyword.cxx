// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OFFKeyword.h"

#include "FileContent.h"

#include <algorithm>
#include <cstring>

using namespace SurfaceDenoising;

namespace
{
bool StartsWith(std::string_view text, std::string_view prefix)
{
  return text.substr(0, prefix.size()) == prefix;
}

/// Position of the first character that is neither space nor comment.
std::size_t SkipSpace(std::string_view text, std::size_t position)
{
  position = text.find_first_not_of(" \t\r\n\v\f", position);
  while (position < text.size() && text[position] == '#')
  {
    position = text.find_first_not_of(" \t\r\n\v\f", text.find('\n', position));
  }
  return std::min(position, text.size());
}
}

//------------------------------------------------------------------------------
OFFKeyword ReadOFFKeyword(std::string_view text)
{
  OFFKeyword keyword;
  std::size_t position = SkipSpace(text, ByteOrderMarkLength(text));

  const auto accept = [&](std::string_view word)
  {
    const bool found = StartsWith(text.substr(position), word);
    position += found ? word.size() : 0;
    return found;
  };

  // Some programs write the prefixes in an order of their own.
  bool moreDimensions = false;
  while (!accept("OFF"))
  {
    if (accept("ST"))
    {
      keyword.TextureCoordinates = true;
    }
    else if (accept("C"))
    {
      keyword.Colors = true;
    }
    else if (accept("N"))
    {
      keyword.Normals = true;
    }
    else if (accept("4") || accept("n"))
    {
      moreDimensions = true;
    }
    else
    {
      throw FileError("this is not an OFF file: the keyword OFF is missing",
        vtkErrorCode::UnrecognizedFileTypeError);
    }
  }
  // Digits may follow at once: "OFF490 518 0" is a widespread slip.
  if (position < text.size() && !std::strchr(" \t\r\n\v\f#0123456789", text[position]))
  {
    throw FileError("this is not an OFF file: the keyword OFF does not stand alone",
      vtkErrorCode::UnrecognizedFileTypeError);
  }
  if (moreDimensions)
  {
    throw FileError("OFF files with more than three dimensions (4OFF, nOFF) cannot be read");
  }

  const std::size_t next = std::min(text.find_first_not_of(" \t", position), text.size());
  if (StartsWith(text.substr(next), "BINARY"))
  {
    keyword.Binary = true;
    const std::size_t lineEnd = text.find('\n', next);
    position = lineEnd == std::string_view::npos ? text.size() : lineEnd + 1;
  }
  keyword.Length = position;
  return keyword;
}
