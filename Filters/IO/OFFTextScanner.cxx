// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OFFTextScanner.h"

#include "FileContent.h"
#include "TextNumbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace SurfaceDenoising;

namespace
{
bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

/// Position of the first character that is neither space nor comment; counts the lines passed.
std::size_t SkipSpace(std::string_view text, std::size_t position, std::size_t& line)
{
  for (; position < text.size(); ++position)
  {
    if (text[position] == '#')
    {
      position = std::min(text.find('\n', position), text.size());
    }
    if (position == text.size())
    {
      break;
    }
    if (text[position] == '\n')
    {
      ++line;
    }
    else if (!IsBlank(text[position]))
    {
      break;
    }
  }
  return position;
}
}

//------------------------------------------------------------------------------
OFFTextScanner::OFFTextScanner(std::string_view text, std::size_t offset)
  : Text(text)
  , Position(offset)
  , Line(1 + std::count(text.begin(), text.begin() + offset, '\n'))
{
}

//------------------------------------------------------------------------------
void OFFTextScanner::Fail(const std::string& what) const
{
  throw FileError("line " + std::to_string(this->Line) + ": " + what);
}

//------------------------------------------------------------------------------
void OFFTextScanner::FailAtEnd(const char* what) const
{
  throw FileError("line " + std::to_string(this->Line) + ": the file ends where " + what +
      " should stand",
    vtkErrorCode::PrematureEndOfFileError);
}

//------------------------------------------------------------------------------
std::string_view OFFTextScanner::NextToken()
{
  this->Position = SkipSpace(this->Text, this->Position, this->Line);
  return this->NextTokenOnLine();
}

//------------------------------------------------------------------------------
std::string_view OFFTextScanner::NextTokenOnLine()
{
  const auto at = [this](std::size_t i) { return i < this->Text.size() ? this->Text[i] : '\n'; };
  while (IsBlank(at(this->Position)))
  {
    ++this->Position;
  }
  const std::size_t begin = this->Position;
  while (!IsBlank(at(this->Position)) && at(this->Position) != '\n' && at(this->Position) != '#')
  {
    ++this->Position;
  }
  return this->Text.substr(begin, this->Position - begin);
}

//------------------------------------------------------------------------------
vtkIdType OFFTextScanner::ReadInteger(const char* what)
{
  const std::string_view token = this->NextToken();
  if (token.empty())
  {
    this->FailAtEnd(what);
  }
  vtkIdType value = 0;
  if (!ToInteger(token, value))
  {
    this->Fail(Quote(token) + " stands where " + what + ", a whole number, should");
  }
  return value;
}

//------------------------------------------------------------------------------
double OFFTextScanner::ReadReal(const char* what)
{
  const std::string_view token = this->NextToken();
  if (token.empty())
  {
    this->FailAtEnd(what);
  }
  return this->ParseReal(token, what);
}

//------------------------------------------------------------------------------
double OFFTextScanner::ParseReal(std::string_view token, const char* what) const
{
  double value = 0.0;
  if (!ToReal(token, value) || !std::isfinite(value))
  {
    this->Fail(Quote(token) + " stands where " + what + ", a finite number, should");
  }
  return value;
}

//------------------------------------------------------------------------------
OFFColor OFFTextScanner::ReadColorOnLine(std::size_t mostComponents)
{
  OFFColor color;
  while (color.Size < mostComponents)
  {
    const std::string_view token = this->NextTokenOnLine();
    if (token.empty())
    {
      break;
    }
    const double component = this->ParseReal(token, "a color component");
    if (color.Size < color.Components.size())
    {
      color.Components[color.Size] = component;
    }
    ++color.Size;
    color.Fractional |= token.find_first_of(".eE") != std::string_view::npos;
  }
  return color;
}

//------------------------------------------------------------------------------
OFFColor OFFTextScanner::ReadFaceColor()
{
  return this->ReadColorOnLine(std::numeric_limits<std::size_t>::max());
}

//------------------------------------------------------------------------------
OFFColor OFFTextScanner::ReadVertexColor(bool textureCoordinatesFollow)
{
  // The format asks for four components. Many files hold three, which only the line's end tells.
  const OFFColor color =
    textureCoordinatesFollow ? this->ReadColorOnLine(4) : this->ReadFaceColor();
  if (color.Size != 4 && (color.Size != 3 || textureCoordinatesFollow))
  {
    this->Fail("the color of a vertex must end its line with 3 or 4 components");
  }
  return color;
}

//------------------------------------------------------------------------------
void OFFTextScanner::SkipEdgeCount()
{
  this->NextTokenOnLine(); // no program needs it, some do not write it
}
