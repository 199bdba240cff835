// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FileContent_h
#define FileContent_h

#include "vtkErrorCode.h"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace SurfaceDenoising
{

/// Says where and what is wrong with a file; Code is one of vtkErrorCode.
struct FileError : std::runtime_error
{
  FileError(const std::string& what, unsigned long code = vtkErrorCode::FileFormatError)
    : std::runtime_error(what)
    , Code(code)
  {
  }
  unsigned long Code;
};

/// The first \p most bytes of a file, or all of it; throws if it cannot be opened or read.
std::string LoadFile(const char* name, std::size_t most = std::string::npos);

/// How many bytes the mark takes with which some editors begin a text in UTF-8.
std::size_t ByteOrderMarkLength(std::string_view text);

}

#endif
