// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OFFKeyword_h
#define OFFKeyword_h

#include <cstddef>
#include <string_view>

/// Which values follow the three coordinates of a vertex, and how the file is written.
struct OFFKeyword
{
  bool TextureCoordinates = false;
  bool Colors = false;
  bool Normals = false;
  bool Binary = false;
  std::size_t Length = 0; ///< where the text behind the keyword begins
};

/// Read the keyword at the beginning of a file; throws a FileError if this is no OFF file or not a
/// readable one.
OFFKeyword ReadOFFKeyword(std::string_view text);

#endif
