// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileContent.h"

#include <vtksys/FStream.hxx>
#include <vtksys/SystemTools.hxx>

#include <algorithm>

namespace SurfaceDenoising
{

//------------------------------------------------------------------------------
std::string LoadFile(const char* name, std::size_t most)
{
  vtksys::ifstream file(name, std::ios::in | std::ios::binary);
  if (!file || vtksys::SystemTools::FileIsDirectory(name))
  {
    const bool exists = vtksys::SystemTools::FileExists(name);
    throw FileError("the file cannot be opened",
      exists ? vtkErrorCode::CannotOpenFileError : vtkErrorCode::FileNotFoundError);
  }
  file.seekg(0, std::ios::end);
  const std::streamoff size = file.tellg(); // -1 for what has no size, such as a pipe
  std::string bytes(size < 0 ? 0 : std::min(most, static_cast<std::size_t>(size)), '\0');
  file.seekg(0, std::ios::beg);
  if (size < 0 || !file.read(&bytes[0], static_cast<std::streamsize>(bytes.size())))
  {
    throw FileError("the file cannot be read", vtkErrorCode::CannotOpenFileError);
  }
  return bytes;
}

//------------------------------------------------------------------------------
std::size_t ByteOrderMarkLength(std::string_view text)
{
  const std::string_view mark = "\xEF\xBB\xBF";
  return text.substr(0, mark.size()) == mark ? mark.size() : 0;
}

}
