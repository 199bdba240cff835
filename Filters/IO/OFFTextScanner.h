// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OFFTextScanner_h
#define OFFTextScanner_h

#include "OFFColors.h"

#include "vtkType.h"

#include <cstddef>
#include <string>
#include <string_view>

/**
 * Reads the numbers of an ASCII OFF file one after the other. Each call names what it expects; it
 * returns that or throws a FileError. OFFBinaryScanner has the same calls.
 */
class OFFTextScanner
{
public:
  OFFTextScanner(std::string_view text, std::size_t offset);

  vtkIdType ReadInteger(const char* what);
  double ReadReal(const char* what);
  OFFColor ReadVertexColor(bool textureCoordinatesFollow);
  OFFColor ReadFaceColor();
  void SkipEdgeCount();

  /// Fewest bytes a vertex with \p reals numbers or a face takes.
  static std::size_t MinimumVertexBytes(std::size_t reals) { return 2 * reals; }
  static constexpr std::size_t MinimumFaceBytes = 4;

  std::size_t RemainingBytes() const { return this->Text.size() - this->Position; }
  [[noreturn]] void Fail(const std::string& what) const;

private:
  std::string_view NextToken();
  std::string_view NextTokenOnLine();
  OFFColor ReadColorOnLine(std::size_t mostComponents);
  double ParseReal(std::string_view token, const char* what) const;
  [[noreturn]] void FailAtEnd(const char* what) const;

  std::string_view Text;
  std::size_t Position;
  std::size_t Line = 1;
};

#endif
