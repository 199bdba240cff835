// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OFFBinaryScanner_h
#define OFFBinaryScanner_h

#include "OFFColors.h"

#include "vtkType.h"

#include <cstddef>
#include <string>
#include <string_view>

/// Reads the numbers of a binary OFF file, with the calls of OFFTextScanner.
class OFFBinaryScanner
{
public:
  OFFBinaryScanner(std::string_view bytes, std::size_t offset)
    : Bytes(bytes)
    , Position(offset)
  {
  }

  vtkIdType ReadInteger(const char* what);
  double ReadReal(const char* what);
  OFFColor ReadVertexColor(bool textureCoordinatesFollow);
  OFFColor ReadFaceColor();
  void SkipEdgeCount() { this->ReadInteger("the number of edges"); }

  static std::size_t MinimumVertexBytes(std::size_t reals) { return 4 * reals; }
  static constexpr std::size_t MinimumFaceBytes = 12; ///< corner count, corner, color count

  std::size_t RemainingBytes() const { return this->Bytes.size() - this->Position; }
  [[noreturn]] void Fail(const std::string& what) const;

private:
  template <typename T>
  T ReadBigEndian(const char* what);
  OFFColor ReadColor(std::size_t numberOfComponents);

  std::string_view Bytes;
  std::size_t Position;
};

#endif
