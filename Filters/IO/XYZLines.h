// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef XYZLines_h
#define XYZLines_h

#include "FileContent.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace SurfaceDenoising
{

/**
 * Gives the lines of a text of points one after the other, and the columns of each. Columns are
 * separated by blanks, or by a comma or a semicolon with or without blanks around it.
 */
class XYZLines
{
public:
  explicit XYZLines(std::string_view text);

  /// Go to the next line that holds more than blanks, if only a comment; false at the end.
  bool Next();

  /// What stands behind '#' or '//' on the line, without more of these and blanks at its beginning.
  std::string_view GetComment() const { return this->Comment; }

  /// What stands before the comment.
  std::string_view GetContent() const { return this->Content; }

  /// The next column of the line, empty behind the last one; throws if a column is left empty.
  std::string_view NextColumn();

  /// The number of columns from the next one on.
  std::size_t CountColumns();

  /// All columns of a text of names: may be in double quotes, which are left out.
  static std::vector<std::string_view> SplitNames(std::string_view names);

  /// Lines that are still to come are not more.
  std::size_t CountLineEnds() const;
  std::size_t GetRemainingBytes() const { return this->Text.size() - this->Position; }
  std::size_t GetSize() const { return this->Text.size(); }

  [[noreturn]] void Fail(const std::string& what,
    unsigned long code = vtkErrorCode::FileFormatError) const;

private:
  std::string_view Text;
  std::size_t Position;        ///< where the next line begins
  std::size_t Line = 0;        ///< from 1 on
  std::string_view Content;    ///< of this line, without blanks at its ends
  std::string_view Comment;    ///< of this line
  std::size_t ColumnBegin = 0; ///< of the next column, in Content
};

}

#endif
