// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "XYZLines.h"

#include <algorithm>

namespace SurfaceDenoising
{

namespace
{
bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

bool IsSeparator(char c) { return c == ',' || c == ';'; }

std::string_view Trim(std::string_view text)
{
  while (!text.empty() && IsBlank(text.front()))
  {
    text.remove_prefix(1);
  }
  while (!text.empty() && IsBlank(text.back()))
  {
    text.remove_suffix(1);
  }
  return text;
}

std::size_t FindComment(std::string_view line)
{
  std::size_t hash = line.find('#');
  while (hash != 0 && hash < line.size() && line[hash - 1] == '.')
  {
    hash = line.find('#', hash + 1); // "1.#QNAN" is a bad number, not 1
  }
  return std::min({ hash, line.find("//"), line.size() });
}
}

//------------------------------------------------------------------------------
XYZLines::XYZLines(std::string_view text)
  : Text(text)
  , Position(ByteOrderMarkLength(text))
{
}

//------------------------------------------------------------------------------
bool XYZLines::Next()
{
  while (this->Position < this->Text.size())
  {
    const std::size_t end = std::min(this->Text.find('\n', this->Position), this->Text.size());
    const std::string_view line = this->Text.substr(this->Position, end - this->Position);
    this->Position = std::min(end + 1, this->Text.size());
    ++this->Line;

    const std::size_t comment = FindComment(line);
    const std::size_t text = std::min(line.find_first_not_of("#/ \t", comment), line.size());
    this->Content = Trim(line.substr(0, comment));
    this->Comment = Trim(line.substr(text));
    this->ColumnBegin = 0;
    if (!this->Content.empty() || comment < line.size())
    {
      return true;
    }
  }
  ++this->Line; // what is missing is missing behind the last line
  return false;
}

//------------------------------------------------------------------------------
std::string_view XYZLines::NextColumn()
{
  const std::string_view content = this->Content;
  const std::size_t begin = this->ColumnBegin;
  std::size_t end = begin;
  while (end < content.size() && !IsBlank(content[end]) && !IsSeparator(content[end]))
  {
    ++end;
  }
  if (begin == end && begin < content.size())
  {
    this->Fail("a column is empty");
  }

  std::size_t next = end;
  const auto skipBlanks = [content, &next]
  {
    while (next < content.size() && IsBlank(content[next]))
    {
      ++next;
    }
  };
  skipBlanks();
  if (next < content.size() && IsSeparator(content[next]))
  {
    ++next; // one at the end of the line has no column behind it
    skipBlanks();
  }
  this->ColumnBegin = next;
  return content.substr(begin, end - begin);
}

//------------------------------------------------------------------------------
std::size_t XYZLines::CountColumns()
{
  std::size_t count = 0;
  while (!this->NextColumn().empty())
  {
    ++count;
  }
  return count;
}

//------------------------------------------------------------------------------
std::vector<std::string_view> XYZLines::SplitNames(std::string_view names)
{
  std::vector<std::string_view> result;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const std::size_t begin = i;
    if (names[i] == '"')
    {
      i = std::min(names.find('"', begin + 1), names.size());
      result.push_back(Trim(names.substr(begin + 1, i - begin - 1)));
    }
    else if (!IsBlank(names[i]) && !IsSeparator(names[i]))
    {
      while (i < names.size() && !IsBlank(names[i]) && !IsSeparator(names[i]))
      {
        ++i;
      }
      result.push_back(names.substr(begin, i - begin));
    }
  }
  return result;
}

//------------------------------------------------------------------------------
std::size_t XYZLines::CountLineEnds() const
{
  return static_cast<std::size_t>(
    std::count(this->Text.begin() + this->Position, this->Text.end(), '\n'));
}

//------------------------------------------------------------------------------
void XYZLines::Fail(const std::string& what, unsigned long code) const
{
  throw FileError("line " + std::to_string(this->Line) + ": " + what, code);
}

}
