// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "XYZTable.h"

#include "FileContent.h"
#include "TextNumbers.h"
#include "XYZLines.h"

#include <algorithm>
#include <string>

namespace SurfaceDenoising
{

namespace
{
/// What stands before the first point.
struct Preamble
{
  std::optional<vtkIdType> Count;              ///< the number of points
  std::vector<std::string_view> Header;        ///< words on a line of their own
  std::vector<std::string_view> CommentHeader; ///< words of a comment that may name columns
};

/// "1 point", "2 points".
std::string Count(std::size_t number, const char* what)
{
  return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
}

bool IsNumber(std::string_view token)
{
  double value;
  return ToReal(token, value);
}

/// A line of words, not one of numbers with a slip in it and not the bytes of a binary file.
bool AreWords(std::string_view content)
{
  const auto isControl = [](unsigned char c) { return (c < ' ' && c != '\t') || c == 127; };
  const auto isNoWord = [](std::string_view token)
  {
    return IsNumber(token) ||
      (!token.empty() &&
        std::string_view("+-.0123456789").find(token[0]) != std::string_view::npos);
  };
  const std::vector<std::string_view> tokens = XYZLines::SplitNames(content);
  return !tokens.empty() && std::none_of(content.begin(), content.end(), isControl) &&
    std::none_of(tokens.begin(), tokens.end(), isNoWord);
}

/// A line such as "C 0.0 0.7 0.0", of the other kind of text that goes by the name .xyz.
bool IsAtom(std::string_view content)
{
  const std::vector<std::string_view> tokens = XYZLines::SplitNames(content);
  const auto isLetter = [](char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z'); };
  return tokens.size() >= 4 && tokens[0].size() <= 2 &&
    std::all_of(tokens[0].begin(), tokens[0].end(), isLetter) &&
    std::all_of(tokens.begin() + 1, tokens.begin() + 4, IsNumber);
}

/// Throw if this line, which is neither preamble nor point, or the next one is an atom.
void RefuseAtoms(XYZLines lines)
{
  const bool isAtom = IsAtom(lines.GetContent());
  if (isAtom || (lines.Next() && IsAtom(lines.GetContent())))
  {
    lines.Fail("this is a file of atoms, not of points");
  }
}

/// "1,5 2,5 3,5" would be six columns.
bool HasDecimalCommas(std::string_view content)
{
  const auto ends = [](char c) { return c == ' ' || c == '\t' || c == ';'; };
  std::size_t words = 0;
  bool found = false;
  for (auto i = content.begin(); i != content.end();)
  {
    const auto begin = std::find_if_not(i, content.end(), ends);
    const auto end = std::find_if(begin, content.end(), ends);
    found |= end - begin > 2 && std::count(begin, end, ',') == 1 &&
      std::count(begin + 1, end - 1, ',') == 1;
    words += begin != end;
    i = end;
  }
  return found && words > 1;
}

/// Read what stands before the first point and leave \p lines there; false if there is no point.
bool ReadPreamble(XYZLines& lines, Preamble& preamble)
{
  while (lines.Next())
  {
    const std::string_view content = lines.GetContent();
    vtkIdType count;
    if (content.empty())
    {
      const auto names = XYZLines::SplitNames(lines.GetComment());
      if (LayoutByNames(names))
      {
        preamble.CommentHeader = names;
      }
    }
    else if (!preamble.Count && ToInteger(content, count))
    {
      if (count < 0)
      {
        lines.Fail("the number of points is " + std::to_string(count));
      }
      preamble.Count = count;
    }
    else if (preamble.Header.empty() && AreWords(content))
    {
      preamble.Header = XYZLines::SplitNames(content);
    }
    else
    {
      return true;
    }
  }
  return false;
}

XYZLayout ChooseLayout(const XYZLines& lines, const Preamble& preamble, std::size_t columns)
{
  const std::string counted = Count(columns, "column");
  if (const auto layout = LayoutByNames(preamble.Header))
  {
    if (preamble.Header.size() != columns)
    {
      lines.Fail(counted + ", the header names " + std::to_string(preamble.Header.size()));
    }
    return *layout;
  }
  if (preamble.CommentHeader.size() == columns) // a comment may speak of anything else as well
  {
    return *LayoutByNames(preamble.CommentHeader);
  }
  const auto layout = LayoutByCount(columns);
  if (!layout)
  {
    lines.Fail(counted + ", which no header names; without one, points have 3, 4, 6 or 7 columns");
  }
  return *layout;
}

/// Append the numbers of a line.
void ReadRow(XYZLines& lines, XYZTable& table)
{
  std::size_t columns = 0;
  for (auto token = lines.NextColumn(); !token.empty(); token = lines.NextColumn(), ++columns)
  {
    double value;
    if (columns == table.Columns)
    {
      columns += 1 + lines.CountColumns();
      break;
    }
    if (!ToReal(token, value))
    {
      lines.Fail(Quote(token) + " stands where a number should");
    }
    table.Values.push_back(value);
  }
  if (columns != table.Columns)
  {
    lines.Fail(Count(columns, "column") + ", the first point has " + std::to_string(table.Columns));
  }
}

/// The first point tells what the others must look like.
void StartTable(const XYZLines& lines, const Preamble& preamble, XYZTable& table)
{
  XYZLines first = lines;
  if (!IsNumber(first.NextColumn()))
  {
    RefuseAtoms(lines);
  }
  if (HasDecimalCommas(lines.GetContent()))
  {
    lines.Fail("these seem to be numbers with decimal commas, which cannot be read");
  }
  first = lines;
  XYZLines row = lines;
  table.Columns = first.CountColumns();
  // What is no number is worse than a number of columns that has no meaning.
  ReadRow(row, table);
  table.Values.clear();
  table.Layout = ChooseLayout(lines, preamble, table.Columns);

  // A line takes a byte at least per number and separator: no file makes this large for its size.
  const std::size_t rows =
    std::min(lines.CountLineEnds() + 1, lines.GetRemainingBytes() / (2 * table.Columns) + 1);
  table.Values.reserve((rows + 1) * table.Columns);
}

void CheckCount(const XYZLines& lines, const Preamble& preamble, std::size_t rows)
{
  if (rows == 0 && !preamble.Count)
  {
    throw FileError("the file holds no points", vtkErrorCode::PrematureEndOfFileError);
  }
  const auto announced = static_cast<std::size_t>(preamble.Count.value_or(0));
  if (preamble.Count && announced != rows)
  {
    lines.Fail("the file ends after " + Count(rows, "point") + ", it announces " +
        std::to_string(announced),
      rows < announced ? vtkErrorCode::PrematureEndOfFileError : vtkErrorCode::FileFormatError);
  }
}
}

//------------------------------------------------------------------------------
XYZTable ReadXYZTable(std::string_view text, const std::function<bool(double)>& proceed,
  std::size_t most)
{
  XYZTable table;
  XYZLines lines(text);
  Preamble preamble;
  std::size_t rows = 0;
  if (ReadPreamble(lines, preamble))
  {
    StartTable(lines, preamble, table);
    do
    {
      if (lines.GetContent().empty())
      {
        continue; // a comment
      }
      if (rows % 16384 == 0 &&
        !proceed(1.0 - static_cast<double>(lines.GetRemainingBytes()) / lines.GetSize()))
      {
        table.Stopped = true;
        return table;
      }
      ReadRow(lines, table);
      ++rows;
    } while (rows < most && lines.Next());
  }
  if (rows < most)
  {
    CheckCount(lines, preamble, rows);
  }
  return table;
}

}
